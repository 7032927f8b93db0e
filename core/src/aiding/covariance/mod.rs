//! The covariance of an error state as factors, and the operations on them.
//!
//! P = U·D·Uᵀ with U unit upper triangular and D diagonal. A variance is a sum of squares times D, so it
//! cannot be negative, and single precision keeps what double precision would.
//!
//! | file | what it has |
//! |---|---|
//! | [`ud`] | the factors in one array, column by column |
//! | [`gram_schmidt`] | modified weighted Gram-Schmidt: factors of W·D·Wᵀ |
//! | [`thornton`] | the navigation errors and the biases over a step |
//! | [`congruence`] | a linear map of consecutive states |
//! | [`agee_turner`] | a term of rank one added |
//! | [`bierman`] | a scalar measurement |
//! | `unrolled` | loops over parts of columns |
//!
//! Source: Bierman, *Factorization Methods for Discrete Sequential Estimation*, 1977, ch. V and VI;
//! Thornton and Bierman, IEEE CDC 1977.
//!
//! ```
//! use schuler::aiding::covariance::ud::Ud;
//!
//! let mut ud = Ud::<f64, 2, 3>::diagonal([3.0, 4.0]);
//! // The sum of both is measured to 12: P = diag(9, 16) − (9, 16)ᵀ(9, 16)/(25 + 144).
//! ud.measure(&[1.0, 1.0], 144.0);
//! assert!((ud.variance(0) - (9.0 - 81.0 / 169.0)).abs() < 1e-14);
//! assert!((ud.covariance(0, 1) + 144.0 / 169.0).abs() < 1e-14);
//! ```

pub mod agee_turner;
pub mod bierman;
pub mod congruence;
pub mod gram_schmidt;
pub mod thornton;
pub mod ud;
mod unrolled;
