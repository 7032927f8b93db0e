//! A solution less the truth, without cancellation.
//!
//! All differences are taken between the two-float coordinates first, and everything else is a product with
//! such a difference. So 10⁻¹⁰ m is visible beside the Earth's radius.
//!
//! ```
//! use schuler::drift::compare::drift;
//! use schuler::earth::Geodetic;
//! use schuler::math::{compensated::Pair, vector::Vector};
//! use schuler::solution::{Euler, Solution};
//!
//! let at = Geodetic { latitude: 0.8_f64, longitude: 0.1, altitude: 100.0 };
//! let truth = Solution::new(at, Vector::ZERO, Euler::default());
//! let mut computed = truth;
//! computed.position.altitude = computed.position.altitude + Pair::new(1e-10);
//! // North, east, down: a height that is too large is a negative drift down.
//! assert!((drift(&computed, &truth).position_ned.z + 1e-10).abs() < 1e-16);
//! ```

pub use crate::earth::POLAR_SINE;
use crate::earth::{ECCENTRICITY_SQUARED, Radii, SEMI_MAJOR_AXIS};
use crate::math::compensated::Pair;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::solution::Solution;
use crate::strapdown::correction::Correction;

/// A solution less the truth: north, east, down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Drift<R = f64> {
    /// Position, m, along the true north, east and down: the horizontal components of the straight
    /// chord from the true to the computed position, and the loss of height.
    pub position_ned: Vector<R>,
    /// Velocity, m/s: v_computedⁿ − v_trueⁿ, each in the north, east and down of its own position; beyond
    /// 84° of true latitude see [`POLAR_SINE`].
    pub velocity_ned: Vector<R>,
    /// Attitude, rad: the rotation vector of C_bⁿ(computed)·C_bⁿ(true)ᵀ, each relative to the north, east
    /// and down of its own position; beyond 84° of true latitude see [`POLAR_SINE`].
    pub attitude_ned: Vector<R>,
}

impl<R> From<Drift<R>> for Correction<R> {
    /// Of the drift of what the state should be from what it is: `drift(&truth, &computed).into()`.
    fn from(drift: Drift<R>) -> Self {
        let Drift { position_ned, velocity_ned, attitude_ned } = drift;
        Self { position_ned, velocity_ned, attitude_ned }
    }
}

/// The computed solution less the truth; both with latitudes within ±90°.
pub fn drift(computed: &Solution<f64>, truth: &Solution<f64>) -> Drift {
    let (c, t) = (computed.position, truth.position);
    let (sin, cos) = Real::sin_cos(t.latitude.hi);
    let (half_sin, half_cos) = Real::sin_cos(0.5 * difference(c.latitude, t.latitude));
    let longitude = difference(c.longitude, t.longitude);
    let (half_sin_longitude, half_cos_longitude) = Real::sin_cos(0.5 * longitude);

    // sinφ_c − sinφ_t = cosφ_t sinΔφ − sinφ_t(1 − cosΔφ), and so for the cosine
    let (sin_step, cos_drop) = (2.0 * half_sin * half_cos, 2.0 * half_sin * half_sin);
    let sine_gain = cos * sin_step - sin * cos_drop;
    let sin_c = sin + sine_gain;
    let cos_c = cos - (sin * sin_step + cos * cos_drop);

    // N_c − N_t = e² N_c N_t (sin²φ_c − sin²φ_t)/a² · N_c N_t/(N_c + N_t)
    let n = Radii::at(sin, cos).prime_vertical;
    let n_c = Radii::at(sin_c, cos_c).prime_vertical;
    let product = n_c * n / SEMI_MAJOR_AXIS;
    let n_gain = ECCENTRICITY_SQUARED * product * product * sine_gain * (sin_c + sin) / (n_c + n);

    // north = (N_c + h_c)sinΔφ − e² cosφ_t(N_c sinφ_c − N_t sinφ_t) + sinφ_t·2(N_c + h_c)cosφ_c sin²½Δλ
    let radius = n_c + c.altitude.hi;
    let axis_distance = radius * cos_c;
    let north = radius * sin_step - ECCENTRICITY_SQUARED * cos * (n_c * sine_gain + sin * n_gain)
        + sin * 2.0 * axis_distance * half_sin_longitude * half_sin_longitude;
    // east = (N_c + h_c)cosφ_c sinΔλ
    let east = axis_distance * 2.0 * half_sin_longitude * half_cos_longitude;
    let down = -difference(c.altitude, t.altitude);

    let mut velocity = computed.velocity_ned;
    let mut attitude = computed.attitude.map(whole);
    if sin.abs() > POLAR_SINE {
        let (s, c) = Real::sin_cos(0.5 * convergence(computed, truth));
        let turn = Quaternion::new(c, Vector::new(0.0, 0.0, s));
        let (sine, cosine) = (2.0 * s * c, 1.0 - 2.0 * s * s);
        let (x, y) = (whole(velocity.x), whole(velocity.y));
        velocity.x = Pair::new(cosine * x - sine * y);
        velocity.y = Pair::new(cosine * y + sine * x);
        attitude = turn * attitude;
    }
    Drift {
        position_ned: Vector::new(north, east, down),
        velocity_ned: velocity.zip(truth.velocity_ned, difference),
        attitude_ned: (attitude * truth.attitude.map(whole).conjugate()).rotation_vector(),
    }
}

/// The rotation about down, rad, from the computed north to the true one, which is carried along the shortest
/// path from the true to the computed position.
pub(super) fn convergence(computed: &Solution<f64>, truth: &Solution<f64>) -> f64 {
    let (c, t) = (computed.position, truth.position);
    // q_y(φ + 90°) ⊗ q_z(Δλ) ⊗ q_y(−φ_c − 90°) is a rotation about down by α, followed by a tilt:
    // tan ½α = −sin ½Δλ sin ½(φ + φ_c)/(cos ½Δλ cos ½(φ_c − φ))
    let (sine, cosine) = Real::sin_cos(0.5 * difference(c.longitude, t.longitude));
    let (sin_mean, _) = Real::sin_cos(0.5 * (c.latitude.hi + t.latitude.hi));
    let (_, cos_half) = Real::sin_cos(0.5 * difference(c.latitude, t.latitude));
    2.0 * Real::atan2(-(sine * sin_mean), cosine * cos_half)
}

/// a − b: leading parts first, so that they cancel exactly.
#[inline(always)]
fn difference(a: Pair<f64>, b: Pair<f64>) -> f64 {
    (a.hi - b.hi) + (a.lo - b.lo)
}

/// The two parts in one.
#[inline(always)]
fn whole(x: Pair<f64>) -> f64 {
    x.hi + x.lo
}
