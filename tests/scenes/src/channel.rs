//! A trajectory's channels in the units of scene files.

use crate::units::DEGREE;
use core::f64::consts::TAU;
use schuler::trajectory::harmonic::{Channel, Harmonic};

/// A channel in files' units, each of so many radians or metres.
pub const fn channel(
    offset: f64,
    rate: f64,
    harmonics: &'static [Harmonic<f64>],
    unit: f64,
) -> Channel<'static, f64> {
    Channel { offset: offset * unit, rate: rate * unit, harmonics }
}

/// An amplitude in the channel's unit, a period in seconds, a phase in degrees.
pub const fn harmonic(amplitude: f64, period_s: f64, phase_deg: f64, unit: f64) -> Harmonic<f64> {
    Harmonic {
        amplitude: amplitude * unit,
        angular_rate: TAU / period_s,
        phase: phase_deg * DEGREE,
    }
}
