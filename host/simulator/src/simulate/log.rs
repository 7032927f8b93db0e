//! The log of a run: extremes over every instant, and some instants for curves.

use crate::flight::{Extremes, Instant, Nine};
use crate::high::Highest;
use crate::units::DEGREE;
use schuler::math::vector::Vector;

/// Points of the overview's curves, about.
const OVERVIEW: u64 = 3000;
/// Points of the first minute's, at most.
const FIRST_MINUTE: u64 = 3000;

/// What is kept of a run's instants.
pub struct Log {
    stride: u64,
    minute_stride: u64,
    minute: u64,
    samples: u64,
    /// The last one.
    pub last: Instant,
    /// Extremes over all.
    pub max: Extremes,
    /// Evenly over the run, the last included.
    pub overview: Vec<Instant>,
    /// Of the first minute.
    pub first_minute: Vec<Instant>,
    /// The place farthest from the ellipsoid.
    pub highest: Highest,
}

impl Log {
    /// Of a run of so many samples.
    pub fn new(samples: u64, rate_hz: f64) -> Self {
        let minute = ((60.0 * rate_hz).ceil() as u64).min(samples);
        Self {
            stride: samples.div_ceil(OVERVIEW).max(1),
            minute_stride: minute.div_ceil(FIRST_MINUTE).max(1),
            minute,
            samples,
            last: Instant::default(),
            max: Extremes::default(),
            overview: Vec::new(),
            first_minute: Vec::new(),
            highest: Highest::default(),
        }
    }

    /// Takes the next instant.
    pub fn add(&mut self, sample: u64, instant: &Instant) {
        let [latitude_deg, _, altitude_m] = instant.position;
        self.highest.reach(latitude_deg * DEGREE, altitude_m);
        let Nine { position_m, velocity_m_s, attitude_arcsec } = instant.drift;
        let max = &mut self.max;
        for (most, now) in [
            (&mut max.components.position_m, position_m),
            (&mut max.components.velocity_m_s, velocity_m_s),
            (&mut max.components.attitude_arcsec, attitude_arcsec),
        ] {
            for (most, now) in most.iter_mut().zip(now) {
                *most = largest(*most, now.abs());
            }
        }
        for (most, now) in max.norms.iter_mut().zip([position_m, velocity_m_s, attitude_arcsec]) {
            *most = largest(*most, Vector::from(now).norm());
        }
        if sample.is_multiple_of(self.stride) || sample == self.samples {
            self.overview.push(*instant);
        }
        if sample <= self.minute && sample.is_multiple_of(self.minute_stride) {
            self.first_minute.push(*instant);
        }
        self.last = *instant;
    }

    /// The end of a run, which may have come early: curves go as far as it.
    pub fn finish(&mut self) {
        if self.overview.last().is_none_or(|last| last.time_s < self.last.time_s) {
            self.overview.push(self.last);
        }
    }
}

/// The larger; a NaN is kept for everyone to see.
pub fn largest(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_is_the_largest() {
        assert_eq!([largest(1.0, 2.0), largest(2.0, 1.0)], [2.0, 2.0]);
        assert!(largest(f64::NAN, 1.0).is_nan() && largest(1.0, f64::NAN).is_nan());
    }
}
