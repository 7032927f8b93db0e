//! The units of data sheets and files, each in radians, metres and seconds.
//!
//! A value in a unit times the constant is the value in SI.
//!
//! ```
//! use schuler::units::{DEGREE_PER_HOUR, MICRO_G};
//!
//! // A gyro's bias of 0.01 °/h, rad/s, and an accelerometer's of 50 µg, m/s².
//! assert!((0.01 * DEGREE_PER_HOUR - 4.848e-8).abs() < 1e-11);
//! assert!((50.0 * MICRO_G - 4.903e-4).abs() < 1e-7);
//! ```

use core::f64::consts::PI;

/// 1°, rad.
pub const DEGREE: f64 = PI / 180.0;
/// 1″, rad.
pub const ARCSECOND: f64 = DEGREE / 3600.0;
/// 1 °/h, rad/s.
pub const DEGREE_PER_HOUR: f64 = DEGREE / 3600.0;
/// 1 °/√h, rad/√s: √3600 = 60.
pub const DEGREE_PER_ROOT_HOUR: f64 = DEGREE / 60.0;
/// 1 °/h/√h, rad/s/√s.
pub const DEGREE_PER_HOUR_PER_ROOT_HOUR: f64 = DEGREE_PER_HOUR / 60.0;
/// Standard gravity, 1 g, m/s².
pub const STANDARD_GRAVITY: f64 = 9.80665;
/// 1 µg, m/s².
pub const MICRO_G: f64 = 9.80665e-6;
/// 1 µg/√h, m/s²/√s.
pub const MICRO_G_PER_ROOT_HOUR: f64 = MICRO_G / 60.0;
/// 1 m/s/√h, m/s/√s.
pub const METRE_PER_SECOND_PER_ROOT_HOUR: f64 = 1.0 / 60.0;
/// 1 ppm.
pub const PART_PER_MILLION: f64 = 1e-6;
/// 1 °/h/g, rad/s per m/s².
pub const DEGREE_PER_HOUR_PER_G: f64 = DEGREE_PER_HOUR / STANDARD_GRAVITY;
