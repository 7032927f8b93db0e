//! The increments of an Earth-fixed state from a correction, anywhere on the Earth.
//!
//! Heights and axes of the two places are computed to twice the digits, so that their differences have the full
//! digits of `R`.

use super::{Correction, turn};
use crate::earth::{ECCENTRICITY_SQUARED, SEMI_MAJOR_AXIS};
use crate::math::compensated::Pair;
use crate::math::quaternion::Quaternion;
use crate::math::real::{Number, Real};
use crate::math::vector::Vector;
use crate::strapdown::frame::earth_fixed::root;
use crate::strapdown::frame::gravitation::Latitude;

/// The increments of an Earth-fixed state from a correction.
pub(crate) struct EarthFixedChange<R> {
    /// The latitude at the corrected position.
    pub latitude: Latitude<R>,
    /// Of the position, m.
    pub position: Vector<Pair<R>>,
    /// Of the velocity relative to the Earth, m/s.
    pub velocity: Vector<R>,
    /// Of the attitude: a factor from the left, less one.
    pub attitude: Quaternion<R>,
}

/// A place to twice the digits: its latitude, north, east, down and height.
struct Place<R> {
    latitude: [Pair<R>; 2],
    axes: [Vector<Pair<R>>; 3],
    altitude: Pair<R>,
}

impl<R: Real> Place<R> {
    /// At a position, by Newton's method from the sine and cosine of a latitude nearby.
    fn at([mut s, mut c]: [Pair<R>; 2], position_e: Vector<Pair<R>>) -> Self {
        const E2: f64 = ECCENTRICITY_SQUARED;
        let one = Pair::new(R::ONE);
        let a = Pair::of(SEMI_MAJOR_AXIS);
        let Vector { x, y, z } = position_e;
        let p = root(x * x + y * y);
        let mut altitude = Pair::default();
        for _ in 0..4 {
            // To unit length: times (3 − s² − c²)/2
            let scale = (Pair::of(3.0) - s * s - c * c) * Pair::new(R::HALF);
            (s, c) = (s * scale, c * scale);
            // W = √(1 − e²s²), N = a/W,  h = pc + zs − aW,  e = (cz − sp + e²N sc)/(R_M + h)
            let w = (one - Pair::of(E2) * s * s).sqrt();
            altitude = p * c + z * s - a * w;
            let along = c * z - s * p + Pair::of(E2) * a * w.reciprocal() * s * c;
            let meridian = R::of(SEMI_MAJOR_AXIS * (1.0 - E2)) / (w.hi * w.hi * w.hi);
            let error = Pair::new(along.hi / (meridian + altitude.hi));
            (s, c) = (s + error * c, c - error * s);
        }
        // At the pole any meridian will do.
        let pole = p.hi.less(R::of(1e-6));
        let inverse = Pair { hi: R::select(pole, R::ONE, p.hi), lo: p.lo }.reciprocal();
        let select = |yes: R, no: Pair<R>| Pair {
            hi: R::select(pole, yes, no.hi),
            lo: R::select(pole, R::ZERO, no.lo),
        };
        let (sl, cl) = (select(R::ZERO, y * inverse), select(R::ONE, x * inverse));
        let north = Vector::new(-(s * cl), -(s * sl), c);
        let east = Vector::new(-sl, cl, Pair::default());
        let down = Vector::new(-(c * cl), -(c * sl), -s);
        Self { latitude: [s, c], axes: [north, east, down], altitude }
    }

    /// The rotation from these axes to those of another place. Beyond 84° it is the rotation from this vertical
    /// to the other one.
    fn turn_to(&self, other: &Self) -> Quaternion<R> {
        let ([n, e, d], [n1, e1, d1]) = (self.axes, other.axes);
        let [along_n, along_e, along_d] = [n.dot(n1), e.dot(e1), d.dot(d1)].map(|x| x.hi);
        // sin θ·n = ½Σ a × a₁ of the three axes, 4cos² ½θ = 1 + Σ a·a₁;  of the vertical alone
        // sin θ·n = d × d₁, 2cos² ½θ = 1 + d·d₁
        let tilt = d.cross(d1);
        let whole = (n.cross(n1) + e.cross(e1) + tilt).map(|x| x.hi);
        let twice_cosine = (R::ONE + along_n + along_e + along_d).sqrt();
        let twice_cosine_of_tilt = (R::TWO + along_d + along_d).sqrt();
        let polar = turn::is_polar(self.latitude[0].hi);
        let whole = whole * (R::HALF / twice_cosine);
        let tilt = tilt.map(|x| x.hi) * (R::ONE / twice_cosine_of_tilt);
        turn::about(whole.zip(tilt, |whole, tilt| R::select(polar, tilt, whole)))
    }
}

/// Components along north, east and down in Earth-fixed axes.
fn resolved<T: Number>([north, east, down]: [Vector<T>; 3], ned: Vector<T>) -> Vector<T> {
    north * ned.x + east * ned.y + down * ned.z
}

/// From a position with its latitude, and the velocity relative to the Earth there.
#[inline(never)]
pub(crate) fn earth_fixed<R: Real>(
    latitude: &Latitude<R>,
    position_e: Vector<Pair<R>>,
    velocity_e: Vector<R>,
    correction: &Correction<R>,
) -> EarthFixedChange<R> {
    let here = Place::at([latitude.sine, latitude.cosine].map(Pair::new), position_e);
    let Vector { x: north, y: east, z: lost } = correction.position_ned.map(Pair::new);
    // The chord's third component, whose height is lost: each pass leaves some (|D|/R)² of what is missing.
    let mut down = lost;
    let moved = |down| resolved(here.axes, Vector::new(north, east, down));
    for _ in 0..2 {
        let there = Place::at(here.latitude, position_e + moved(down));
        down = down + (lost + (there.altitude - here.altitude));
    }
    let position = moved(down);
    let there = Place::at(here.latitude, position_e + position);

    let axes = here.axes.map(|axis| axis.map(|x| x.hi));
    let turned = here.turn_to(&there);
    let gained = resolved(axes, correction.velocity_ned);
    let rotation = turn::rotation(correction.attitude_ned);
    let rotation = Quaternion::new(rotation.w, resolved(axes, rotation.v));
    let [sine, cosine] = there.latitude.map(|x| x.hi);
    EarthFixedChange {
        latitude: Latitude { sine, cosine, change: latitude.change },
        position,
        velocity: gained + turned.turn_less_one(velocity_e + gained),
        attitude: turn::after(turned, rotation),
    }
}
