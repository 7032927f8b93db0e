//! A sensor identified by its Allan deviation.
//!
//! | file | what it has |
//! |---|---|
//! | [`shape`] | terms without their magnitudes |
//! | [`spread`] | the covariance of a record's points |
//! | [`matrix`], [`least_squares`] | Cholesky's factor, and unknowns that are not negative |
//! | [`fit`] | magnitudes with intervals, and χ² of what remains |

pub mod fit;
pub mod least_squares;
pub mod matrix;
pub mod shape;
pub mod spread;
