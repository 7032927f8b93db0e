//! Conversion to a narrower type with carried rounding: what rounding drops from a sample is added to the next.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//! use schuler::flight::carried::Carried;
//!
//! let sample = Increment { angle_b: Vector::new(0.1_f64, 0.0, 0.0), velocity_b: Vector::ZERO };
//! let (mut carried, mut sum) = (Carried::default(), 0.0);
//! for _ in 0..10_000 {
//!     sum += f64::from(carried.narrow::<f32>(&sample).angle_b.x);
//! }
//! // Rounding each sample alone would give 1000.0000149.
//! assert!((sum - 1000.0).abs() < 1e-8);
//! ```

use crate::math::real::Scalar;
use crate::math::vector::Vector;
use crate::record::{Record, record};
use crate::sample::Increment;

/// The sum of the increments taken in less that of the increments given out, for each axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Carried {
    /// Δθ, rad.
    pub angle_b: Vector<f64>,
    /// Δv, m/s.
    pub velocity_b: Vector<f64>,
}

impl Carried {
    /// The next increment in the type `R`.
    #[inline]
    pub fn narrow<R: Scalar>(&mut self, increment: &Increment<f64>) -> Increment<R> {
        Increment {
            angle_b: narrow(&mut self.angle_b, increment.angle_b),
            velocity_b: narrow(&mut self.velocity_b, increment.velocity_b),
        }
    }
}

#[inline]
fn narrow<R: Scalar>(carry: &mut Vector<f64>, increment: Vector<f64>) -> Vector<R> {
    // y = x + c,  out = round(y),  c ← y − out
    let exact = increment + *carry;
    let rounded = exact.map(R::narrow);
    *carry = exact - rounded.map(Scalar::widen);
    rounded
}

impl Record for Carried {
    record!(angle_b, velocity_b);
}
