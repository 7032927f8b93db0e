//! Where a path is between two manoeuvres, and how it moves there.
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::trajectory::segment::control::{Control, Controls};
//! use schuler::trajectory::segment::{flow::Track, state::State, step::Step};
//!
//! // A standing vehicle turns its heading by a right angle.
//! let at = Geodetic { latitude: 0.5, longitude: 0.1, altitude: 20.0 };
//! let state = State::at_rest(Track::new(at, 0.3));
//! let yaw = Step { start_s: 0.0, duration_s: 5.0, change: 1.0 };
//! let mut controls = state.steady(5.0);
//! controls.rotation[2] = Control::stepping(0.0, [yaw]);
//! let turned = state.after(&controls);
//! assert!((turned.track.course() - 1.3).abs() < 1e-15);
//! assert_eq!(turned.rotation, [0.0; 3]);
//! ```

use super::control::{Control, Controls};
use super::flow::Track;
use crate::math::real::Real;

/// A path between two manoeuvres.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct State {
    /// Where it is and where it leads.
    pub track: Track,
    /// Speed along the path, m/s; below 0 backwards.
    pub speed: f64,
    /// Climb angle, rad.
    pub climb: f64,
    /// Course rate, rad/s.
    pub course_rate: f64,
    /// Roll, pitch and yaw on top of the attitude that the rule gives, rad.
    pub rotation: [f64; 3],
}

impl State {
    /// At rest on a track.
    pub const fn at_rest(track: Track) -> Self {
        Self { track, speed: 0.0, climb: 0.0, course_rate: 0.0, rotation: [0.0; 3] }
    }

    /// Controls that go on as it is, for a time in s.
    pub fn steady(&self, duration_s: f64) -> Controls {
        Controls {
            climb: Control::steady(self.climb),
            course_rate: Control::steady(self.course_rate),
            rotation: self.rotation.map(Control::steady),
            ..Controls::steady(duration_s, self.speed)
        }
    }

    /// Whether controls begin as it is.
    pub fn goes_on(&self, controls: &Controls) -> bool {
        // The values come from sums, which round.
        let same = |a: f64, b: f64| (a - b).abs() <= 1e-12 * (1.0 + a.abs());
        let mut angles = self.rotation.iter().zip(&controls.rotation);
        same(self.speed, controls.speed.value)
            && same(self.climb, controls.climb.value)
            && same(self.course_rate, controls.course_rate.value)
            && angles.all(|(a, b)| same(*a, b.value))
    }

    /// Where controls lead.
    pub fn after(&self, controls: &Controls) -> Self {
        self.ended(controls, self.track.after(controls))
    }

    /// The state in which controls end on a track.
    ///
    /// A yaw of what stands turns its course with it, so that it moves off along its own nose.
    pub fn ended(&self, controls: &Controls, mut track: Track) -> Self {
        let mut rotation = controls.rotation.map(|angle| angle.after());
        let stands = controls.speed.value == 0.0 && controls.speed.is_steady();
        if let ([_, _, to], [_, _, from]) = (&mut rotation, self.rotation)
            && stands
            && *to != from
        {
            track = track.turned(*to - from);
            *to = from;
        }
        Self {
            track,
            speed: controls.speed.after(),
            climb: controls.climb.after(),
            course_rate: controls.course_rate.after(),
            rotation,
        }
    }
}

impl Track {
    /// With its course turned to the right by an angle, rad.
    #[must_use]
    pub fn turned(mut self, angle: f64) -> Self {
        // ĥ ← ĥ cosα + (ĥ × n̂) sinα
        let (s, c) = Real::sin_cos(angle);
        let n = self.normal_e.map(|n| n.hi);
        self.along_e = self.along_e * c + self.along_e.cross(n) * s;
        self
    }
}
