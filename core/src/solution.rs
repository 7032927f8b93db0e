//! The navigation solution: position, velocity and attitude.
//!
//! Every number is a [`Pair`], so that single precision passes on all of its digits.
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::math::vector::Vector;
//! use schuler::solution::{Euler, Solution};
//!
//! let attitude = Euler { roll: 0.1_f64, pitch: -0.2, yaw: 3.0 };
//! let at = Geodetic { latitude: 0.8, longitude: 0.1, altitude: 100.0 };
//! let solution = Solution::new(at, Vector::new(10.0, 0.0, 0.0), attitude);
//! assert!((solution.euler().yaw - 3.0).abs() < 1e-15);
//! let back = solution.to_earth_fixed().to_local();
//! assert!((back.velocity_ned.x.hi - 10.0).abs() < 1e-12);
//! ```

use crate::earth::{self, Geodetic, Radii};
use crate::math::compensated::{Pair, two_sum};
use crate::math::quaternion::Quaternion;
use crate::math::real::{Number, Real, Scalar};
use crate::math::vector::Vector;
use crate::record::{Record, record};

/// Attitude as three angles: C_nᵇ = Rx(roll)·Ry(pitch)·Rz(yaw), rad.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Euler<R> {
    /// Roll γ about forward.
    pub roll: R,
    /// Pitch θ about right.
    pub pitch: R,
    /// Yaw ψ about down, from north.
    pub yaw: R,
}

impl<R: Real> Euler<R> {
    /// The quaternion body → navigation frame.
    pub fn quaternion(self) -> Quaternion<R> {
        let half = |angle: R| (angle * R::HALF).sin_cos();
        about_axes([half(self.yaw), half(self.pitch), half(self.roll)])
    }

    /// The same to about twice the digits, to start from: rounding the quaternion alone would cost nanometres.
    /// |angle| ≤ 2π.
    pub fn quaternion_pair(self) -> Quaternion<Pair<R>> {
        let half = |angle: R| Pair::new(angle * R::HALF).sin_cos();
        about_axes([half(self.yaw), half(self.pitch), half(self.roll)])
    }

    /// From the quaternion body → navigation frame, of unit length or near it: with the angles within
    /// ±180°, the pitch within ±90°.
    ///
    /// At ±90° of pitch only ψ ∓ γ is determined. Rounding may choose any ψ and γ there, but the three
    /// angles always lead back to the same attitude. If the other combination is lost entirely, the roll is 0.
    pub fn from_quaternion(q: Quaternion<R>) -> Self {
        let Quaternion { w, v: Vector { x, y, z } } = q;
        // w + y = √2 cos(45° − ½θ) cos ½(ψ − γ),  z − x = √2 cos(45° − ½θ) sin ½(ψ − γ)
        // w − y = √2 cos(45° + ½θ) cos ½(ψ + γ),  z + x = √2 cos(45° + ½θ) sin ½(ψ + γ)
        let ([a, b], [c, d]) = ([w + y, z - x], [w - y, z + x]);
        let (up, down) = (a * a + b * b, c * c + d * d);
        let (half_difference, half_sum) = (b.atan2(a), d.atan2(c));
        // Below this there is only the rounding of q.
        let least = R::entry(1e-14, 1e-31);
        let (no_difference, no_sum) = (up.less(least), down.less(least));
        let difference = R::select(no_difference, half_sum, half_difference);
        let sum = R::select(no_sum, half_difference, half_sum);
        // sinθ = 2(wy − zx),  cosθ = √(1 + sinθ) √(1 − sinθ)
        let sine = w * y - z * x;
        Self {
            roll: wrapped_sum(sum, -difference),
            pitch: (sine + sine).atan2((up * down).sqrt()),
            yaw: wrapped_sum(sum, difference),
        }
    }
}

/// a + b within ±π, for |a|, |b| ≤ π, corrected for the rounding of the sum and of 2π.
fn wrapped_sum<R: Real>(a: R, b: R) -> R {
    const TURN: f64 = core::f64::consts::TAU;
    let (sum, rest) = two_sum(a, b);
    let turns = (sum / R::of(TURN)).round();
    (sum - turns * R::of(TURN)) + (rest - turns * R::residual(TURN))
}

/// q_bⁿ = q_z(ψ) ⊗ q_y(θ) ⊗ q_x(γ), from sine and cosine of half of each.
fn about_axes<T: Number>([(sz, cz), (sy, cy), (sx, cx)]: [(T, T); 3]) -> Quaternion<T> {
    // q_z ⊗ q_y = (cz cy; −sz sy, cz sy, sz cy)
    let (w, x, y, z) = (cz * cy, sz * sy, cz * sy, sz * cy);
    Quaternion::new(w * cx + x * sx, Vector::new(w * sx - x * cx, y * cx + z * sx, z * cx - y * sx))
}

/// Position, velocity and attitude in local axes: north, east, down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Solution<R> {
    /// Latitude and longitude in rad, altitude in m.
    pub position: Geodetic<Pair<R>>,
    /// Velocity relative to the Earth, north, east, down, m/s.
    pub velocity_ned: Vector<Pair<R>>,
    /// Body → north, east, down.
    pub attitude: Quaternion<Pair<R>>,
}

impl<R: Real> Solution<R> {
    /// From a geodetic position, a velocity and angles of at most 2π; the attitude to about twice the
    /// digits.
    pub fn new(position: Geodetic<R>, velocity_ned: Vector<R>, attitude: Euler<R>) -> Self {
        Self {
            position: position.map(Pair::new),
            velocity_ned: velocity_ned.map(Pair::new),
            attitude: attitude.quaternion_pair(),
        }
    }

    /// The attitude as angles.
    pub fn euler(&self) -> Euler<R> {
        Euler::from_quaternion(self.attitude.map(|c| c.hi))
    }

    /// The same state in Earth-fixed axes, to about twice the digits.
    pub fn to_earth_fixed(&self) -> EarthFixedSolution<R> {
        let (sl, cl) = self.position.longitude.sin_cos();
        let (s, c) = self.position.latitude.sin_cos();
        let literal = Pair::of;
        // R_N = a/√(1 − e² sin²φ)
        let e2 = literal(earth::ECCENTRICITY_SQUARED);
        let w = (Pair::new(R::ONE) - e2 * s * s).sqrt();
        let n = literal(earth::SEMI_MAJOR_AXIS) * w.reciprocal();
        let h = self.position.altitude;
        let axis_distance = (n + h) * c;
        let polar = (n - n * e2 + h) * s;
        let north = Vector::new(-(s * cl), -(s * sl), c);
        let east = Vector::new(-sl, cl, Pair::default());
        let down = Vector::new(-(c * cl), -(c * sl), -s);
        let v = self.velocity_ned;
        let half = Pair::new(R::HALF);
        let from_south = self.position.latitude + literal(core::f64::consts::FRAC_PI_2);
        let q_ne = ned_to_earth_fixed(
            (self.position.longitude * half).sin_cos(),
            (from_south * half).sin_cos(),
        );
        EarthFixedSolution {
            position_e: Vector::new(axis_distance * cl, axis_distance * sl, polar),
            velocity_e: north * v.x + east * v.y + down * v.z,
            attitude: q_ne * self.attitude,
        }
    }
}

/// q_nᵉ = q_z(λ) ⊗ q_y(−φ − 90°), from sine and cosine of ½λ and of ½(φ + 90°).
pub(crate) fn ned_to_earth_fixed<T: Number>((sl, cl): (T, T), (s, c): (T, T)) -> Quaternion<T> {
    Quaternion::new(c * cl, Vector::new(s * sl, -(s * cl), c * sl))
}

/// Position, velocity and attitude in Earth-fixed axes, which are singular nowhere.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EarthFixedSolution<R> {
    /// Position, m.
    pub position_e: Vector<Pair<R>>,
    /// Velocity relative to the Earth, m/s.
    pub velocity_e: Vector<Pair<R>>,
    /// Body → Earth-fixed axes.
    pub attitude: Quaternion<Pair<R>>,
}

impl<R: Real> EarthFixedSolution<R> {
    /// In local axes, to the digits of `R`.
    pub fn to_local(&self) -> Solution<R> {
        let position_e = self.position_e.map(|c| c.hi);
        let position = Geodetic::from_earth_fixed(position_e);
        let (sl, cl) = position.longitude.sin_cos();
        let (s, c) = position.latitude.sin_cos();
        let v = self.velocity_e.map(|c| c.hi);
        let outward = v.x * cl + v.y * sl;
        let velocity_ned =
            Vector::new(c * v.z - s * outward, v.y * cl - v.x * sl, -(c * outward) - s * v.z);
        let half = |x: R| (x * R::HALF).sin_cos();
        let q_ne = ned_to_earth_fixed(
            half(position.longitude),
            half(position.latitude + R::of(core::f64::consts::FRAC_PI_2)),
        );
        let attitude = q_ne.conjugate() * self.attitude.map(|c| c.hi);
        Solution {
            position: position.map(Pair::new),
            velocity_ned: velocity_ned.map(Pair::new),
            attitude: attitude.map(Pair::new),
        }
    }
}

impl<R: Real> EarthFixedSolution<R> {
    /// In local axes, the position to about twice the digits of `R`: in single precision those of an Earth-fixed
    /// position are a third of a metre apart. In double precision they suffice.
    pub fn to_local_precisely(&self) -> Solution<R> {
        let local = self.to_local();
        if !R::any(R::ZERO.less(R::residual(0.1).abs())) {
            return local;
        }
        let Geodetic { latitude, longitude, altitude } = local.position;
        let ((s, c), (sl, cl)) = (latitude.sin_cos(), longitude.sin_cos());
        // N = a/√(1 − e²s²);  x = (N + h)c,  z = (N(1 − e²) + h)s
        let e2 = Pair::of(earth::ECCENTRICITY_SQUARED);
        let one = Pair::new(R::ONE);
        let n = Pair::of(earth::SEMI_MAJOR_AXIS) * (one - e2 * s * s).sqrt().reciprocal();
        let axis_distance = (n + altitude) * c;
        let z = (n * (one - e2) + altitude) * s;
        let computed = Vector::new(axis_distance * cl, axis_distance * sl, z);
        let rest = (self.position_e - computed).map(|c| c.hi);
        let [s, c, sl, cl] = [s, c, sl, cl].map(|x| x.hi);
        let outwards = rest.x * cl + rest.y * sl;
        let radii = Radii::at(s, c);
        let pole = c.abs().less(R::of(1e-9));
        let divisor = R::select(pole, R::ONE, (radii.prime_vertical + altitude.hi) * c);
        let east = R::select(pole, R::ZERO, rest.y * cl - rest.x * sl);
        let north = (rest.z * c - outwards * s) / (radii.meridian + altitude.hi);
        Solution {
            position: Geodetic {
                latitude: latitude + Pair::new(north),
                longitude: longitude + Pair::new(east / divisor),
                altitude: altitude + Pair::new(outwards * c + rest.z * s),
            },
            ..local
        }
    }
}

impl<R: Scalar> Solution<R> {
    /// In double precision, exactly.
    pub fn widen(&self) -> Solution<f64> {
        Solution {
            position: self.position.map(Pair::widen_pair),
            velocity_ned: self.velocity_ned.map(Pair::widen_pair),
            attitude: self.attitude.map(Pair::widen_pair),
        }
    }

    /// From double precision, keeping twice the digits of `R`.
    pub fn narrow(wide: &Solution<f64>) -> Self {
        Self {
            position: wide.position.map(Pair::narrow),
            velocity_ned: wide.velocity_ned.map(Pair::narrow),
            attitude: wide.attitude.map(Pair::narrow),
        }
    }
}

impl<R: Scalar> EarthFixedSolution<R> {
    /// In double precision, exactly.
    pub fn widen(&self) -> EarthFixedSolution<f64> {
        EarthFixedSolution {
            position_e: self.position_e.map(Pair::widen_pair),
            velocity_e: self.velocity_e.map(Pair::widen_pair),
            attitude: self.attitude.map(Pair::widen_pair),
        }
    }
}

impl<R: Record> Record for Solution<R> {
    record!(position, velocity_ned, attitude);
}

impl<R: Record> Record for EarthFixedSolution<R> {
    record!(position_e, velocity_e, attitude);
}
