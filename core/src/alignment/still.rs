//! What a unit reads while it stands still: means, and how far the means of short pieces scatter.
//!
//! The pieces tell noise from motion, and how good the mean of all is.

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

/// What a still unit reads.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Readings<R> {
    /// Mean angular rate ω_ibᵇ, rad/s.
    pub rate_ib_b: Vector<R>,
    /// Mean specific force fᵇ, m/s².
    pub specific_force_b: Vector<R>,
    /// The mean sample interval, s.
    pub interval_s: R,
    /// Standard deviation of one axis of the mean angular rate, by its scatter, rad/s.
    pub rate_sigma: R,
    /// Standard deviation of one axis of the mean specific force, by its scatter, m/s².
    pub force_sigma: R,
    /// White noise of one axis of a piece's angular rate, from piece to piece, rad/s.
    pub rate_noise: R,
    /// White noise of one axis of a piece's specific force, from piece to piece, m/s².
    pub force_noise: R,
    /// How far the pieces' specific forces lie from their mean, rms of the vector, m/s².
    pub force_spread: R,
    /// How fast the body turns about level axes by the direction of specific force alone, rad/s.
    pub turn_b: Vector<R>,
}

impl<R: Scalar> Still<R> {
    /// Of pieces of a length, s. A piece ends with the sample that fills it.
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

    /// Takes a sample of an interval, s.
    pub fn add(&mut self, sample: &Increment<R>, interval_s: R) {
        self.whole.add(sample);
        self.samples = self.samples.saturating_add(1);
        self.seconds = self.seconds + interval_s;
        self.angle_b = self.angle_b + sample.angle_b;
        self.velocity_b = self.velocity_b + sample.velocity_b;
        self.filled_s = self.filled_s + interval_s;
        // Half a sample early is as near as half a sample late.
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
        // A body that turns sees a steady direction u of the vertical move: u̇ = −ω × u, so that
        // u × u̇ = −ω + u(u·ω): what turns about level axes, with its sign changed.
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
