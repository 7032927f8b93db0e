//! The textbook step in north, east and down.

use super::TextbookFrame;
use super::body::{Compensated, rotation};
use crate::earth::{self, Geodetic, Radii, gravity};
use crate::math::compensated::{Pair, Plain};
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::record::{Record, record};
use crate::solution::Solution;
use crate::strapdown::correction::{Correction, local_level};
use crate::strapdown::frame::meridian::{Meridian, curvature};
use crate::strapdown::limits::Rejected;
use crate::strapdown::place::{check_local, fold_longitude};
use crate::strapdown::plausible::{MOST_SPEED, Plausible, agree, is_attitude};
use core::f64::consts::{FRAC_PI_2, PI, TAU};

/// State in local-level axes.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LocalLevelTextbook<R> {
    position: Geodetic<R>,
    /// sinφ and cosφ.
    sine: R,
    cosine: R,
    /// North, east, down, m/s.
    velocity: Vector<R>,
    attitude: Quaternion<R>,
    /// Changes over the previous sample, to extrapolate half a sample ahead.
    velocity_change: Vector<R>,
    latitude_change: R,
    altitude_change: R,
}

/// Sine and cosine of an angle that is increased by a small one.
#[inline(always)]
fn advance<R: Real>(sine: R, cosine: R, angle: R) -> (R, R) {
    // sin(φ + d) = s + c sin d − s(1 − cos d)
    let square = angle * angle;
    let d = angle - angle * square * R::of(1.0 / 6.0);
    let versine = square * (R::HALF - square * R::of(1.0 / 24.0));
    (sine + (cosine * d - sine * versine), cosine - (sine * d + cosine * versine))
}

/// The longitude wrapped to ±180°.
#[inline(always)]
fn folded<R: Real>(position: Geodetic<R>) -> Geodetic<R> {
    let outside = R::of(PI).less(position.longitude.abs());
    let longitude = if R::any(outside) { turned(position.longitude) } else { position.longitude };
    Geodetic { longitude, ..position }
}

/// Out of line, because a step hardly ever needs it.
#[inline(never)]
fn turned<R: Real>(longitude: R) -> R {
    let mut longitude = Plain(longitude);
    fold_longitude(&mut longitude);
    longitude.0
}

impl<R: Real> TextbookFrame for LocalLevelTextbook<R> {
    type Real = R;
    type Output = Solution<R>;

    fn start(initial: &Solution<R>) -> Self {
        let position = folded(initial.position.map(|c| c.hi));
        // As a pair: libm's functions of single precision compute in double.
        let (sine, cosine) = Pair::new(position.latitude).sin_cos();
        Self {
            position,
            sine: sine.hi,
            cosine: cosine.hi,
            velocity: initial.velocity_ned.map(|c| c.hi),
            attitude: initial.attitude.map(|c| c.hi),
            velocity_change: Vector::ZERO,
            latitude_change: R::ZERO,
            altitude_change: R::ZERO,
        }
    }

    fn stretch(&mut self, factor: R) {
        self.velocity_change = self.velocity_change * factor;
        self.latitude_change = self.latitude_change * factor;
        self.altitude_change = self.altitude_change * factor;
    }

    #[inline(always)]
    fn step(&mut self, h: R, body: &Compensated<R>) {
        // At the middle of the step, extrapolated by the change over the last one.
        let velocity = self.velocity + self.velocity_change * R::HALF;
        let (s, c) = advance(self.sine, self.cosine, self.latitude_change * R::HALF);
        let altitude = self.position.altitude + self.altitude_change * R::HALF;
        let radii = Radii::at(s, c);
        let north_radius = radii.meridian + altitude;
        let east_radius = radii.prime_vertical + altitude;
        // ω_ieⁿ = ω_ie(cosφ, 0, −sinφ),  ω_enⁿ = (v_E/(R_N + h), −v_N/(R_M + h), −v_E tanφ/(R_N + h))
        let earth_rate = earth::rotation_ned(s, c);
        let eastward = velocity.y / east_radius;
        let transport = Vector::new(eastward, -(velocity.x / north_radius), -(eastward * s / c));
        let frame_rate = earth_rate + transport;
        let turned = frame_rate * h;

        // v ← v + C u − ½ζ × C u + (g − (2ω_ie + ω_en) × v)h,  ζ = (ω_ie + ω_en)h
        let gained = self.attitude.matrix(R::ONE) * body.velocity;
        let mut pull = -(frame_rate + earth_rate).cross(velocity);
        pull.z = pull.z + gravity(s, altitude);
        let change = gained - turned.cross(gained) * R::HALF + pull * h;
        // φ̇ = v_N/(R_M + h),  λ̇ = v_E/((R_N + h)cosφ),  ḣ = −v_D, with the mean velocity
        let mean = self.velocity + change * R::HALF;
        self.velocity = self.velocity + change;
        self.velocity_change = change;
        self.latitude_change = h * mean.x / north_radius;
        self.altitude_change = -(h * mean.z);
        self.position.latitude = self.position.latitude + self.latitude_change;
        self.position.longitude = self.position.longitude + h * mean.y / (east_radius * c);
        self.position.altitude = self.position.altitude + self.altitude_change;
        self.position = folded(self.position);
        (self.sine, self.cosine) = advance(self.sine, self.cosine, self.latitude_change);

        // q ← q(−ζ) ⊗ q ⊗ q(φ)
        self.attitude = (rotation(-turned) * self.attitude * body.rotation).normalised();
    }

    fn hold_vertical(&mut self, altitude: R, down: R) {
        self.position.altitude = altitude;
        self.velocity.z = down;
    }

    fn correct(&mut self, correction: &Correction<R>) -> Result<(), Rejected> {
        let (s, c) = (self.sine, self.cosine);
        let meridian = Meridian::at(s, c, self.position.altitude, curvature(s));
        let change = local_level(&meridian, self.velocity, correction)?;
        let place = &change.place;
        let Geodetic { latitude, longitude, altitude } = self.position;
        self.position = folded(Geodetic {
            latitude: latitude + place.latitude,
            longitude: longitude + place.longitude,
            altitude: altitude - correction.position_ned.z,
        });
        self.sine = s + (c * place.sine + s * place.cosine_less_one);
        self.cosine = c + (c * place.cosine_less_one - s * place.sine);
        self.velocity = self.velocity + change.velocity;
        self.attitude = (self.attitude + change.attitude * self.attitude).normalised();
        self.check_place()
    }

    #[inline(always)]
    fn check_place(&self) -> Result<(), Rejected> {
        check_local(self.cosine, self.position.altitude)
    }

    fn output(&self) -> Solution<R> {
        Solution {
            position: self.position.map(Pair::new),
            velocity_ned: self.velocity.map(Pair::new),
            attitude: self.attitude.map(Pair::new),
        }
    }
}

impl<R: Real> Plausible for LocalLevelTextbook<R> {
    fn is_plausible(&self) -> bool {
        let Geodetic { latitude, longitude, altitude } = self.position;
        let in_range = latitude.is_within(R::of(FRAC_PI_2))
            & longitude.is_within(R::of(TAU))
            & self.velocity.is_within(R::of(MOST_SPEED))
            & self.velocity_change.is_within(R::of(MOST_SPEED))
            & self.latitude_change.is_within(R::ONE)
            & self.altitude_change.is_within(R::of(MOST_SPEED));
        if !in_range || check_local(self.cosine, altitude).is_err() || !is_attitude(self.attitude) {
            return false;
        }
        let (sine, cosine) = Pair::new(latitude).sin_cos();
        let carried = R::entry(1e-2, 1e-6);
        agree(self.sine, sine.hi, carried) & agree(self.cosine, cosine.hi, carried)
    }
}

impl<R: Record> Record for LocalLevelTextbook<R> {
    record!(
        position,
        sine,
        cosine,
        velocity,
        attitude,
        velocity_change,
        latitude_change,
        altitude_change
    );
}
