//! The units of scene files, in radians, metres and seconds.

use schuler::math::vector::Vector;

pub use schuler::units::*;

/// 1 m.
pub const METRE: f64 = 1.0;

/// A value for each axis.
pub fn axes(x: f64, y: f64, z: f64, unit: f64) -> Vector<f64> {
    Vector::new(x * unit, y * unit, z * unit)
}

/// One value for all axes.
pub fn all(value: f64, unit: f64) -> Vector<f64> {
    axes(value, value, value, unit)
}
