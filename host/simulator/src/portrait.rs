//! What a flight is like: its length, and the extremes of its motion.

use crate::course::Course;
use crate::units::STANDARD_GRAVITY;
use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::solution::Solution;
use schuler::trajectory::Trajectory as _;

/// Looks per second, at least and at most.
const LOOKS_HZ: [f64; 2] = [20.0, 1000.0];
/// Looks at most.
const MOST_LOOKS: f64 = 2e6;

/// The least and the greatest of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// The least.
    pub least: f64,
    /// The greatest.
    pub most: f64,
}

/// A flight in numbers, in SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Portrait {
    /// Along the path, m.
    pub length_m: f64,
    /// Relative to the Earth, m/s.
    pub speed: Extremes,
    /// Upwards, m/s.
    pub climb: Extremes,
    /// Above the ellipsoid, m.
    pub altitude: Extremes,
    /// |f| in units of standard gravity.
    pub load: Extremes,
    /// Specific force to the right, m/s².
    pub lateral: Extremes,
    /// Of the velocity, relative to the Earth, m/s².
    pub acceleration: Extremes,
    /// Roll, rad.
    pub roll: Extremes,
    /// Pitch, rad.
    pub pitch: Extremes,
    /// Angular rates of the body relative to the Earth about its axes, rad/s.
    pub rates: [Extremes; 3],
    /// Where it begins.
    pub start: Geodetic<f64>,
    /// Where it ends.
    pub end: Geodetic<f64>,
}

impl Extremes {
    /// Before anything was seen.
    const NONE: Self = Self { least: f64::INFINITY, most: f64::NEG_INFINITY };

    fn see(&mut self, value: f64) {
        self.least = self.least.min(value);
        self.most = self.most.max(value);
    }

    /// The larger magnitude.
    pub fn size(&self) -> f64 {
        self.most.abs().max(self.least.abs())
    }
}

fn place(solution: &Solution<f64>) -> Geodetic<f64> {
    solution.position.map(|x| x.hi + x.lo)
}

impl Portrait {
    /// Of a motion from 0 to a time, s.
    pub fn new(course: &Course, duration_s: f64) -> Self {
        let [least, most] = LOOKS_HZ;
        let looks_hz = (4.0 * course.bound().bandwidth).clamp(least, most);
        // Even, for Simpson's rule.
        let looks = 2.0 * (0.5 * duration_s * looks_hz).ceil().clamp(100.0, 0.5 * MOST_LOOKS);
        let step_s = duration_s / looks;
        let start = place(&course.solution_at(Pair::new(0.0)));
        let end = place(&course.solution_at(Pair::new(duration_s)));
        let none = Extremes::NONE;
        let mut this = Self {
            length_m: 0.0,
            speed: none,
            climb: none,
            altitude: none,
            load: none,
            lateral: none,
            acceleration: none,
            roll: none,
            pitch: none,
            rates: [none; 3],
            start,
            end,
        };
        for look in 0..=looks as u64 {
            let time_s = Pair::new((look as f64 * step_s).min(duration_s));
            let at = course.kinematics_at(time_s);
            let euler = course.solution_at(time_s).euler();
            let speed = at.velocity_e.norm();
            let weight = match look {
                0 => 1.0,
                _ if look as f64 == looks => 1.0,
                _ if look % 2 == 1 => 4.0,
                _ => 2.0,
            };
            this.length_m += weight * speed * step_s / 3.0;
            this.speed.see(speed);
            this.climb.see(at.velocity_e.dot(at.normal_e));
            this.altitude.see(at.altitude);
            this.acceleration.see(at.acceleration_e.norm());
            let force = at.rates().specific_force_b;
            this.load.see(force.norm() / STANDARD_GRAVITY);
            this.lateral.see(force.y);
            this.roll.see(euler.roll);
            this.pitch.see(euler.pitch);
            for (extremes, rate) in this.rates.iter_mut().zip(at.rate_eb_b.into_array()) {
                extremes.see(rate);
            }
        }
        this
    }
}
