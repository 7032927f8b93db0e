//! Ground floor: the scalar seam, vectors, quaternions and sums with a carried remainder.

#[cfg(feature = "micromath")]
pub mod coarse;
pub mod compensated;
pub mod quaternion;
pub mod real;
pub mod twin;
pub mod vector;
