//! Where the vehicle was, and how it moved, at any time within a step.
//!
//! Between the ends of a step the position is the cubic through both positions and velocities, the attitude turns
//! evenly, and the rate changes evenly. Over a step of 0.1 s the cubic is off by T⁴/384 times the fourth derivative
//! of the position: 3 µm where the acceleration swings by 1 g at 1 Hz.

use super::locality::Locality;
use super::ring::Entry;
use crate::aiding::surroundings::Pose;
use crate::aiding::transition::Stretch;
use crate::earth::Geodetic;
use crate::math::compensated::Pair;
use crate::math::quaternion::{Matrix, Quaternion};
use crate::math::real::{Real, Scalar};
use crate::math::vector::Vector;
use crate::strapdown::correction::turn;

/// The vehicle at a time.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Moment<R> {
    /// A position near it.
    pub base: Geodetic<Pair<R>>,
    /// The way from there, north, east, down, m; down is the height lost.
    pub way_ned: Vector<R>,
    /// Attitude and velocity.
    pub pose: Pose<R>,
    /// v̇ⁿ, m/s².
    pub acceleration_ned: Vector<R>,
    /// ω_ibᵇ, rad/s.
    pub rate_ib_b: Vector<R>,
}

impl<R: Scalar> Moment<R> {
    /// At the end of a step.
    pub fn at_end<const N: usize, const E: usize>(entry: &Entry<R, N, E>) -> Self {
        let force = entry.stretch.velocity;
        let none = entry.stretch.time_s <= R::ZERO;
        let divisor = if none { R::ONE } else { entry.stretch.time_s };
        let body_to_ned = entry.attitude.matrix(R::ONE);
        let mut acceleration_ned = body_to_ned * (force * (R::ONE / divisor));
        if !none {
            // Of the specific force; gravity is of the same size everywhere.
            acceleration_ned.z = acceleration_ned.z + R::of(9.8);
        }
        Self {
            base: entry.position,
            way_ned: Vector::ZERO,
            pose: Pose { body_to_ned, velocity_ned: entry.velocity_ned },
            acceleration_ned,
            rate_ib_b: entry.rate_ib_b,
        }
    }

    /// A fraction of a step after its start, which is the end of the step before.
    pub fn within<const N: usize, const E: usize>(
        start: &Entry<R, N, E>,
        end: &Entry<R, N, E>,
        fraction: R,
        here: &Locality<R>,
    ) -> Self {
        let time_s = end.stretch.time_s;
        let uncorrected = Uncorrected::of(end, here);
        let way = here.way(&start.position, &end.position) + uncorrected.way_ned;
        let (f, square) = (fraction, fraction * fraction);
        let cube = square * f;
        let three = R::of(3.0);
        let [first, last] = [start.velocity_ned, uncorrected.velocity_ned];
        // p = D(3f² − 2f³) + T[v₀(f − 2f² + f³) + v₁(f³ − f²)] and its derivatives
        let way_ned = way * (three * square - R::TWO * cube)
            + (first * (f - R::TWO * square + cube) + last * (cube - square)) * time_s;
        let mean = way * (R::ONE / time_s);
        let velocity_ned = mean * (R::of(6.0) * (f - square))
            + first * (R::ONE - R::of(4.0) * f + three * square)
            + last * (three * square - R::TWO * f);
        let acceleration_ned = (mean * (R::of(6.0) - R::of(12.0) * f)
            + first * (R::of(6.0) * f - R::of(4.0))
            + last * (R::of(6.0) * f - R::TWO))
            * (R::ONE / time_s);
        let between = start.attitude.conjugate() * uncorrected.attitude;
        let turned = turn::rotation(between.rotation_vector() * f);
        let attitude = (start.attitude + start.attitude * turned).normalised();
        let rate = start.rate_ib_b + (end.rate_ib_b - start.rate_ib_b) * f;
        let pose = Pose { body_to_ned: attitude.matrix(R::ONE), velocity_ned };
        Self { base: start.position, way_ned, pose, acceleration_ned, rate_ib_b: rate }
    }
}

/// The end of a step before its correction.
struct Uncorrected<R> {
    /// From the corrected position, m.
    way_ned: Vector<R>,
    velocity_ned: Vector<R>,
    attitude: Quaternion<R>,
}

impl<R: Real> Uncorrected<R> {
    fn of<const N: usize, const E: usize>(entry: &Entry<R, N, E>, here: &Locality<R>) -> Self {
        // r̂ = r⁺ + C⁺δr,  v̂ = v⁺ + C⁺δv − ω_ie × C⁺δr,  Ĉ = C⁺ exp([ψ×])
        let [r, v, psi] = first_three(&entry.errors);
        let matrix: Matrix<R> = entry.attitude.matrix(R::ONE);
        let way_ned = matrix * r;
        let velocity = entry.velocity_ned + matrix * v - here.here.earth_rate_ned.cross(way_ned);
        let turned = turn::rotation(psi);
        Self { way_ned, velocity_ned: velocity, attitude: entry.attitude + entry.attitude * turned }
    }
}

/// δr, δv, ψ.
pub fn first_three<R: Real, const N: usize>(errors: &[R; N]) -> [Vector<R>; 3] {
    let mut parts = [Vector::ZERO; 3];
    for (part, cells) in parts.iter_mut().zip(errors.as_chunks().0) {
        *part = Vector::from(*cells);
    }
    parts
}

/// The rest of a step after a fraction of it, for the derivatives: rate and force are taken as steady.
pub fn rest<R: Real>(stretch: &Stretch<R>, fraction: R) -> Stretch<R> {
    let left = R::ONE - fraction;
    let whole = Quaternion::IDENTITY + stretch.rotation;
    let theta = whole.rotation_vector();
    let before = turn::rotation(-(theta * fraction));
    let velocity = stretch.velocity + before.turn_less_one(stretch.velocity);
    let time_s = stretch.time_s * left;
    Stretch {
        time_s,
        rotation: turn::rotation(theta * left),
        velocity: velocity * left,
        position: velocity * (left * time_s * R::HALF),
    }
}
