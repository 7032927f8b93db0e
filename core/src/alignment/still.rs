//! What a unit reads at rest: means, and the scatter of the means of short pieces.
//!
//! The pieces distinguish noise from motion, and give the variance of the mean of all.
//!
//! ```
//! use schuler::alignment::still::Still;
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//!
//! let mut still = Still::new(1.0_f64);
//! for _ in 0..1000 {
//!     let velocity_b = Vector::new(0.0, 0.0, -0.0980665);
//!     still.add(&Increment { angle_b: Vector::ZERO, velocity_b }, 0.01);
//! }
//! assert_eq!(still.pieces(), 10);
//! let readings = still.readings().unwrap();
//! assert!((readings.specific_force_b.norm() - 9.80665).abs() < 1e-6);
//! ```

use super::Alignment;
use super::scatter::Scatter;
use crate::math::real::Scalar;
use crate::math::vector::Vector;
use crate::sample::Increment;

/// Gathers samples, and cuts them into pieces.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Still<R> {
    whole: Alignment<R>,
    piece_s: R,
    /// Of the piece that is being filled: rad, m/s, s.
    angle_b: Vector<R>,
    velocity_b: Vector<R>,
    filled_s: R,
    seconds: R,
    samples: u32,
    rate: Scatter<R>,
    force: Scatter<R>,
}

/// What a unit reads at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Readings<R> {
    /// Mean angular rate ω_ibᵇ, rad/s.
    pub rate_ib_b: Vector<R>,
    /// Mean specific force fᵇ, m/s².
    pub specific_force_b: Vector<R>,
    /// The mean sample interval, s.
    pub interval_s: R,
    /// Standard deviation of one axis of the mean angular rate, from its scatter, rad/s.
    pub rate_sigma: R,
    /// Standard deviation of one axis of the mean specific force, from its scatter, m/s².
    pub force_sigma: R,
    /// White noise of one axis of a piece's angular rate, from piece to piece, rad/s.
    pub rate_noise: R,
    /// White noise of one axis of a piece's specific force, from piece to piece, m/s².
    pub force_noise: R,
    /// Rms distance of the pieces' specific forces from their mean, as vectors, m/s².
    pub force_spread: R,
    /// The body's rate about level axes, from the direction of specific force alone, rad/s.
    pub turn_b: Vector<R>,
}

impl<R: Scalar> Still<R> {
    /// With pieces of a length in seconds. A piece ends with the sample that fills it.
    pub fn new(piece_s: R) -> Self {
        Self {
            whole: Alignment::default(),
            piece_s,
            angle_b: Vector::ZERO,
            velocity_b: Vector::ZERO,
            filled_s: R::ZERO,
            seconds: R::ZERO,
            samples: 0,
            rate: Scatter::default(),
            force: Scatter::default(),
        }
    }

    /// Adds a sample with its interval in seconds.
    pub fn add(&mut self, sample: &Increment<R>, interval_s: R) {
        self.whole.add(sample);
        self.samples = self.samples.saturating_add(1);
        self.seconds = self.seconds + interval_s;
        self.angle_b = self.angle_b + sample.angle_b;
        self.velocity_b = self.velocity_b + sample.velocity_b;
        self.filled_s = self.filled_s + interval_s;
        // A piece may end half a sample early or late.
        if self.filled_s + interval_s * R::HALF > self.piece_s {
            let per_second = R::ONE / self.filled_s;
            self.rate.add(self.angle_b * per_second);
            self.force.add(self.velocity_b * per_second);
            (self.angle_b, self.velocity_b) = (Vector::ZERO, Vector::ZERO);
            self.filled_s = R::ZERO;
        }
    }

    /// The sums, for the attitude.
    pub fn alignment(&self) -> &Alignment<R> {
        &self.whole
    }

    /// Time gathered, s.
    pub fn seconds(&self) -> R {
        self.seconds
    }

    /// Whole pieces gathered.
    pub fn pieces(&self) -> u32 {
        self.rate.count()
    }

    /// What was read so far; `None` before the first sample.
    pub fn readings(&self) -> Option<Readings<R>> {
        if self.samples == 0 {
            return None;
        }
        let interval_s = self.seconds / R::count(self.samples);
        let (rate_ib_b, specific_force_b) = self.whole.mean(interval_s);
        let one_axis = |v: Vector<R>| ((v.x + v.y + v.z) * R::ratio(1, 3)).sqrt();
        let spread = self.force.variance();
        // In the axes of a body that turns, the steady direction u of the vertical moves: u̇ = −ω × u, so
        // u × u̇ = −ω + u(u·ω): the rate about level axes with the opposite sign.
        let norm = specific_force_b.norm();
        let turn_b = if norm > R::ZERO && self.force.count() > 0 {
            let piece_s = (self.seconds - self.filled_s) / R::count(self.force.count());
            let slope = self.force.slope() * (R::ONE / piece_s);
            -(specific_force_b.cross(slope) * (R::ONE / (norm * norm)))
        } else {
            Vector::ZERO
        };
        Some(Readings {
            rate_ib_b,
            specific_force_b,
            interval_s,
            rate_sigma: one_axis(self.rate.variance_of_mean()),
            force_sigma: one_axis(self.force.variance_of_mean()),
            rate_noise: one_axis(self.rate.step_variance()),
            force_noise: one_axis(self.force.step_variance()),
            force_spread: (spread.x + spread.y + spread.z).sqrt(),
            turn_b,
        })
    }
}
