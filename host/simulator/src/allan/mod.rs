//! A sensor identified by its Allan deviation.
//!
//! | file | what it has |
//! |---|---|
//! | [`record`], [`still`] | six axes of a scene or a recording, and whether it stood still |
//! | [`shape`] | terms without their magnitudes |
//! | [`spread`] | the covariance of a record's points |
//! | [`matrix`], [`least_squares`] | Cholesky's factor, and unknowns that are not negative |
//! | [`fit`] | magnitudes with intervals, and χ² of what remains |
//! | [`verdict`], [`identify`] | configured terms against it, and terms that nobody configured |
//! | [`section`] | what was found as a section of a scene |

pub mod fit;
pub mod identify;
pub mod least_squares;
pub mod matrix;
pub mod record;
pub mod section;
pub mod shape;
pub mod spread;
pub mod still;
pub mod verdict;

/// The triads, as a scene calls their tables.
pub const TRIADS: [&str; 2] = ["gyro", "accelerometer"];
