//! The error of the series of normal gravity at the heights of a flight.

use crate::units::MICRO_G;
use schuler::earth::closed_form::neglected_ned;
use serde::Serialize;

/// Height above or below the ellipsoid, m, beyond which it is said.
const SAID_ABOVE_M: f64 = 20_000.0;

/// The place farthest from the ellipsoid so far, and what gravity lacks there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Highest {
    latitude: f64,
    altitude_m: f64,
}

/// What is neglected at the highest place, for `summary.json`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Neglected {
    /// m.
    pub altitude_m: f64,
    /// Closed form less series, µg.
    pub north_ug: f64,
    /// Closed form less series, µg.
    pub down_ug: f64,
}

impl Highest {
    /// Takes a place: latitude in rad, altitude in m.
    pub fn reach(&mut self, latitude: f64, altitude_m: f64) {
        if altitude_m.abs() > self.altitude_m.abs() {
            *self = Self { latitude, altitude_m };
        }
    }

    /// What is neglected there, if it is to be said.
    pub fn neglected(&self) -> Option<Neglected> {
        let is_high = self.altitude_m.abs() > SAID_ABOVE_M;
        let lacks = neglected_ned(self.latitude, self.altitude_m);
        let altitude_m = self.altitude_m;
        let (north_ug, down_ug) = (lacks.x / MICRO_G, lacks.z / MICRO_G);
        is_high.then_some(Neglected { altitude_m, north_ug, down_ug })
    }
}

impl Neglected {
    /// As a line.
    pub fn line(&self) -> String {
        format!(
            "gravity's series of height: at {:.1} km normal gravity is {:+.1} µg down and {:+.1} µg north \
             of it (neglected)\n",
            self.altitude_m / 1e3,
            self.down_ug,
            self.north_ug
        )
    }
}
