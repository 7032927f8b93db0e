//! Numbers, vectors, quaternions and compensated sums.
//!
//! | file | what it has |
//! |---|---|
//! | [`real`] | the seam between the algorithms and a floating-point type |
//! | `scalar` | `f32` and `f64`: the one place that calls libm |
//! | [`twin`] | two numbers side by side |
//! | [`vector`], [`quaternion`] | vectors, rotations, matrices |
//! | [`compensated`] | sums that carry what rounding drops; products of two floats |
//! | `coarse` | single precision with micromath's functions |

#[cfg(feature = "micromath")]
pub mod coarse;
pub mod compensated;
pub mod quaternion;
pub mod real;
mod scalar;
pub mod twin;
pub mod vector;
