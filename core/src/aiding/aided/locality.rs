//! The Earth where the vehicle is, carried along with it: no trigonometry from step to step.

use crate::aiding::surroundings::Surroundings;
use crate::earth::Geodetic;
use crate::math::compensated::Pair;
use crate::math::real::Scalar;
use crate::math::vector::Vector;
use crate::record::{Record, record};

/// The largest change of latitude, rad, over which the series of sine and cosine serve.
const FARTHEST: f64 = 2e-3;

/// A latitude with its sine and cosine, from which those of latitudes nearby follow.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Reference<R> {
    latitude: R,
    sine: R,
    cosine: R,
}

impl<R: Scalar> Reference<R> {
    /// At a latitude.
    pub fn at(latitude: Pair<R>) -> Self {
        // As a pair: libm's functions of single precision compute in double.
        let (sine, cosine) = Pair::new(latitude.hi).sin_cos();
        Self { latitude: latitude.hi, sine: sine.hi, cosine: cosine.hi }
    }

    /// Sine and cosine of a latitude nearby.
    fn nearby(&self, latitude: Pair<R>) -> [R; 2] {
        // sin(φ + δ) = s + c(δ − δ³/6) − s·½δ²,  cos(φ + δ) = c − s(δ − δ³/6) − c·½δ²
        let change = latitude.hi - self.latitude;
        let square = change * change;
        let odd = change - change * square * R::ratio(1, 6);
        let even = square * R::HALF;
        let (s, c) = (self.sine, self.cosine);
        [s + (c * odd - s * even), c - (s * odd + c * even)]
    }

    /// The reference itself, or one at the position where that is too far from it.
    pub fn followed(&self, position: &Geodetic<Pair<R>>) -> Self {
        if (position.latitude.hi - self.latitude).is_within(R::of(FARTHEST)) {
            *self
        } else {
            Self::at(position.latitude)
        }
    }

    /// The Earth at a position.
    pub fn locality(&self, position: &Geodetic<Pair<R>>) -> Locality<R> {
        let reference = self.followed(position);
        let [sine, cosine] = reference.nearby(position.latitude);
        let here = Surroundings::from_latitude(sine, cosine, position.altitude.hi);
        Locality { here, reference }
    }
}

/// The Earth at the vehicle.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Locality<R> {
    /// Its rate, gravity and radii.
    pub here: Surroundings<R>,
    reference: Reference<R>,
}

impl<R: Scalar> Locality<R> {
    /// The way from one position to another near it, north, east, down, m: horizontal components of the chord, and
    /// the height lost.
    pub fn way(&self, from: &Geodetic<Pair<R>>, to: &Geodetic<Pair<R>>) -> Vector<R> {
        let [sine, cosine] = self.reference.nearby(from.latitude);
        let turn = Pair::of(core::f64::consts::TAU);
        let mut along = to.longitude - from.longitude;
        if along.hi > turn.hi * R::HALF {
            along = along - turn;
        } else if along.hi < -(turn.hi * R::HALF) {
            along = along + turn;
        }
        // D_N = R_M Δφ + ½R_N sinφ cosφ Δλ²,  D_E = R_N(cosφ − sinφ Δφ)Δλ
        let (north, along) = ((to.latitude - from.latitude).hi, along.hi);
        let [meridian, prime_vertical] = self.here.radii();
        let bent = prime_vertical * sine * cosine * along * along * R::HALF;
        Vector::new(
            north * meridian + bent,
            along * prime_vertical * (cosine - sine * north),
            (from.altitude - to.altitude).hi,
        )
    }
}

impl<R: Record> Record for Reference<R> {
    record!(latitude, sine, cosine);
}
