//! Bounds that follow from the arithmetic, the sampling and the Earth.
//!
//! Each except [`SCENE_M`] is a closed form with a stated number of roundings; none
//! is fitted to measurements.

use schuler::earth::{
    CENTRIFUGAL_RATIO, EQUATORIAL_GRAVITY, FLATTENING, Geodetic, ROTATION_RATE, SEMI_MAJOR_AXIS,
    gravity,
};
use schuler::math::vector::Vector;
use schuler::trajectory::Trajectory as _;
use schuler_simulator::simulate::largest;
use schuler_simulator::source::Source;
use schuler_simulator::units::ARCSECOND;

/// Half an ulp of 1 in double precision: the most that one rounding drops of 1.
pub const UNIT: f64 = f64::EPSILON / 2.0;
/// The same in single precision.
pub const SINGLE_UNIT: f64 = f32::EPSILON as f64 / 2.0;

/// What is demanded of the built-in scenes in double precision, m: a requirement, some ten roundings of
/// the position.
pub const SCENE_M: f64 = 1e-8;

/// Roundings that a constant input goes through, each with its own sign, on its way into the state:
/// the rates' rotation by three angles, their sum, the product with the interval; C from q, C u, γ.
pub const ROUNDINGS: f64 = 8.0;

/// ω_s = √(g/R), rad/s.
pub fn schuler_rate() -> f64 {
    (EQUATORIAL_GRAVITY / SEMI_MAJOR_AXIS).sqrt()
}

/// κ of the free vertical channel at a latitude's sine and the ellipsoid, 1/s.
pub fn vertical_rate(sine: f64) -> f64 {
    // κ² = −∂γ/∂h = (2γ/a)(1 + f + m − 2f sin²φ): √2·ω_s with the ellipsoid's own gradient
    let bracket = 1.0 + FLATTENING + CENTRIFUGAL_RATIO - 2.0 * FLATTENING * sine * sine;
    (2.0 * gravity(sine, 0.0) / SEMI_MAJOR_AXIS * bracket).sqrt()
}

/// Position after a time with the vertical free, m.
pub fn free_m(time_s: f64) -> f64 {
    // Rounding of a coordinate of the Earth's size, and of gravity through the vertical:
    // Ku(R + (γ/κ²)(cosh κt − 1))
    let kappa = vertical_rate(0.0);
    let fallen = EQUATORIAL_GRAVITY / (kappa * kappa) * ((kappa * time_s).cosh() - 1.0);
    ROUNDINGS * UNIT * (SEMI_MAJOR_AXIS + fallen)
}
/// Why.
pub const FREE_WHY: &str = "8 roundings of the position (uR) and of gravity, u(g/κ²)(cosh κt − 1)";

/// Horizontal position after a time with the vertical held, m, where each rounding has relative size
/// `unit`.
pub fn held_m(unit: f64, time_s: f64) -> f64 {
    // Rounding of gravity tilts the level by Ku: at most 2KuR of a Schuler swing. Rounding of the
    // Earth's rate turns it by Kuω_ie t.
    ROUNDINGS * unit * SEMI_MAJOR_AXIS * (2.0 + ROTATION_RATE * time_s)
}
/// Why.
pub const HELD_WHY: &str = "8 roundings of gravity (2uR, a Schuler swing) and of the Earth's rate";

/// Attitude in arcsec after the body turned by some angle, rad, where the position is good to some
/// metres: roundings of each increment, and the level that the position takes along.
pub fn attitude_arcsec(position_m: f64, turned: f64) -> f64 {
    (ROUNDINGS * UNIT * (1.0 + turned) + position_m / SEMI_MAJOR_AXIS) / ARCSECOND
}
/// Why.
pub const ATTITUDE_WHY: &str = "8 roundings per radian turned, and the position's own share";

/// What gravity's parabola over a block leaves, along a true motion.
#[derive(Clone, Copy, Debug)]
pub struct Parabola {
    /// Position at the end with the vertical free, m: every block's rest of one sign, and grown.
    pub position_m: f64,
    /// The largest rest of a block over its time, m/s.
    pub rate: f64,
}

impl Parabola {
    /// Over blocks of `block_s`.
    pub fn along(source: &Source, block_s: f64, duration_s: f64) -> Self {
        let kappa = vertical_rate(0.0);
        let mut parabola = Self { position_m: 0.0, rate: 0.0 };
        let mut last = [Vector::ZERO; 4];
        let blocks = (duration_s / block_s) as u64;
        for block in 0..blocks {
            let time_s = block as f64 * block_s;
            let mut next = gravitation(source, time_s);
            // ∇ to ∇⁴ at this block
            let mut differences = [Vector::ZERO; 4];
            let mut older = last;
            for (difference, old) in differences.iter_mut().zip(&mut older) {
                *difference = next - *old;
                (*old, next) = (next, *difference);
            }
            last = older;
            if block < 4 {
                continue;
            }
            // T²(½G₀ + ⅙∇ + ⅛∇²) leaves T²(19/180)∇³, T(G₁ − ½δ − δ²/12 − δ³/24) leaves T(19/720)∇⁴
            let [_, _, third, fourth] = differences.map(Vector::norm);
            let place = 19.0 / 180.0 * block_s * block_s * third;
            let speed = 19.0 / 720.0 * block_s * fourth;
            let x = kappa * (duration_s - time_s);
            parabola.position_m += place * x.cosh() + speed * x.sinh() / kappa;
            parabola.rate = largest(parabola.rate, place / block_s);
        }
        parabola
    }
}

/// Gravitation at the true position, in axes that stand still among the stars.
fn gravitation(source: &Source, time_s: f64) -> Vector<f64> {
    let motion = source.course.at(time_s);
    let (latitude, altitude) = (motion.latitude.value, motion.altitude.value);
    // The Earth's turn makes longitude inertial.
    let longitude = motion.longitude.value + ROTATION_RATE * time_s;
    let Vector { x, y, .. } = Geodetic { latitude, longitude, altitude }.to_earth_fixed();
    let ((s, c), (sl, cl)) = (latitude.sin_cos(), longitude.sin_cos());
    // G = −γ n̂ + ω × (ω × r)
    let pull = -gravity(s, altitude);
    let inward = -(ROTATION_RATE * ROTATION_RATE);
    Vector::new(pull * c * cl + inward * x, pull * c * sl + inward * y, pull * s)
}
