//! The textbook step in Earth-fixed axes.

use super::TextbookFrame;
use super::body::Compensated;
use crate::earth::ROTATION_RATE;
use crate::math::compensated::Pair;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::record::{Record, record};
use crate::solution::{EarthFixedSolution, Solution};
use crate::strapdown::correction::{Correction, earth_fixed};
use crate::strapdown::frame::block_time::small_turn;
use crate::strapdown::frame::gravitation::Latitude;
use crate::strapdown::limits::Rejected;
use crate::strapdown::place::check_earth_fixed;
use crate::strapdown::plausible::{MOST_SPEED, Plausible, is_attitude};

/// State in Earth-fixed axes.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EarthFixedTextbook<R> {
    position: Vector<R>,
    /// Relative to the Earth, m/s.
    velocity: Vector<R>,
    attitude: Quaternion<R>,
    /// Change of velocity over the previous sample, to extrapolate half a sample ahead.
    velocity_change: Vector<R>,
    latitude: Latitude<R>,
}

impl<R: Real> TextbookFrame for EarthFixedTextbook<R> {
    type Real = R;
    type Output = EarthFixedSolution<R>;

    fn start(initial: &Solution<R>) -> Self {
        let at = initial.to_earth_fixed();
        let (sine, cosine) = initial.position.latitude.hi.sin_cos();
        Self {
            position: at.position_e.map(|c| c.hi),
            velocity: at.velocity_e.map(|c| c.hi),
            attitude: at.attitude.map(|c| c.hi),
            velocity_change: Vector::ZERO,
            latitude: Latitude { sine, cosine, change: R::ZERO },
        }
    }

    fn stretch(&mut self, factor: R) {
        self.velocity_change = self.velocity_change * factor;
    }

    #[inline(always)]
    fn step(&mut self, h: R, body: &Compensated<R>) {
        let omega = R::of(ROTATION_RATE);
        let half = h * R::HALF;
        // At the middle of the step, extrapolated by the change over the last one.
        let velocity = self.velocity + self.velocity_change * R::HALF;
        let position = self.position + velocity * half;
        // gᵉ = G − ω × (ω × r)
        let mut pull = self.latitude.gravitation(position);
        pull.x = pull.x + omega * omega * position.x;
        pull.y = pull.y + omega * omega * position.y;
        // −2ω × v
        pull.x = pull.x + R::TWO * omega * velocity.y;
        pull.y = pull.y - R::TWO * omega * velocity.x;

        // v ← v + C u − ½ζ × C u + (g − 2ω × v)h,  ζ = ωh about z
        let turned = omega * h;
        let gained = self.attitude.matrix(R::ONE) * body.velocity;
        let rotated = Vector::new(-gained.y, gained.x, R::ZERO) * (turned * R::HALF);
        let change = gained - rotated + pull * h;
        // ṙ = v, with the mean velocity
        self.position = self.position + (self.velocity + change * R::HALF) * h;
        self.velocity = self.velocity + change;
        self.velocity_change = change;

        // q ← q_z(−ζ) ⊗ q ⊗ q(φ)
        let (sine, cosine_less_one) = small_turn(turned * R::HALF);
        let back = Quaternion::new(R::ONE + cosine_less_one, Vector::new(R::ZERO, R::ZERO, -sine));
        self.attitude = (back * self.attitude * body.rotation).normalised();
    }

    fn hold_vertical(&mut self, altitude: R, down: R) {
        // The latitude in the state is that of the sample's middle.
        let mut here = self.latitude;
        here.gravitation(self.position);
        let (up, lift) = here.vertical(self.position, altitude);
        self.position = self.position + up * lift;
        let climb = up.dot(self.velocity) + down;
        self.velocity = self.velocity - up * climb;
    }

    fn correct(&mut self, correction: &Correction<R>) -> Result<(), Rejected> {
        // The latitude carried is that of the sample's middle; from here on, that of its end.
        let position_e = self.position.map(Pair::new);
        let change = earth_fixed(&self.latitude, position_e, self.velocity, correction);
        self.position = self.position + change.position.map(|x| x.hi);
        self.velocity = self.velocity + change.velocity;
        self.attitude = (self.attitude + change.attitude * self.attitude).normalised();
        self.latitude = change.latitude;
        self.check_place()
    }

    #[inline(always)]
    fn check_place(&self) -> Result<(), Rejected> {
        check_earth_fixed(self.position)
    }

    fn output(&self) -> EarthFixedSolution<R> {
        EarthFixedSolution {
            position_e: self.position.map(Pair::new),
            velocity_e: self.velocity.map(Pair::new),
            attitude: self.attitude.map(Pair::new),
        }
    }
}

impl<R: Real> Plausible for EarthFixedTextbook<R> {
    fn is_plausible(&self) -> bool {
        check_earth_fixed(self.position).is_ok()
            && self.velocity.is_within(R::of(MOST_SPEED))
            && self.velocity_change.is_within(R::of(MOST_SPEED))
            && is_attitude(self.attitude)
            && self.latitude.belongs_to(self.position).is_some()
    }
}

impl<R: Record> Record for EarthFixedTextbook<R> {
    record!(position, velocity, attitude, velocity_change, latitude);
}
