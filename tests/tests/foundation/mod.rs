//! The floors that strapdown stands on: arithmetic, the Earth, motion, the perfect unit, alignment.

#![expect(clippy::excessive_precision, reason = "expected values keep their printed digits")]

mod alignment;
mod compensated;
mod earth;
mod formats;
mod imu;
mod normal_gravity;
mod piecewise;
mod plausible;
mod quaternion;
mod rates;
mod readout;
mod real;
mod solution;
mod trajectory;
