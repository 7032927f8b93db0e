//! What the two navigation frames have in common.

use super::block_time::BlockTime;
use super::body::BodyMotion;
use super::mechanization::Rejected;
use super::plausible::Plausible;
use crate::earth::{SEMI_MAJOR_AXIS, SEMI_MINOR_AXIS};
use crate::math::compensated::{Accumulate, Pair};
use crate::math::quaternion::Matrix;
use crate::math::real::{Real, Scalar};
use crate::math::vector::Vector;
use crate::solution::{EarthFixedSolution, Solution};

/// A navigation frame's state, with the step that carries it over a block.
pub trait Frame: Copy + Plausible {
    /// The scalar it computes in.
    type Real: Real;
    /// What it prints: its own coordinates, converted only when asked.
    type Output: Output<Self::Real>;
    /// What the inside of a block needs to know of the step across it.
    type Step: Copy;
    /// Whether it wants the body's motion with what rounding drops from it.
    const TWO_FLOAT: bool;

    /// From an initial solution.
    fn start(initial: &Solution<Self::Real>) -> Self;
    /// Sets up the gravity history: at the start, and whenever a block's duration changes.
    fn seed(&mut self, time: &BlockTime<Self::Real>, body: &BodyMotion<Self::Real>);
    /// Brings the gravity history to blocks that are longer by a factor.
    fn stretch(&mut self, factor: Self::Real);
    /// Steps over a block.
    fn step(&mut self, time: &BlockTime<Self::Real>, body: &BodyMotion<Self::Real>) -> Self::Step;
    /// The state at a fraction τ of the block that `step` crossed; `self` is the state before it and
    /// `body` the body's motion up to τ.
    fn within(
        &self,
        step: &Self::Step,
        time: &BlockTime<Self::Real>,
        body: &BodyMotion<Self::Real>,
        fraction: Self::Real,
    ) -> Self::Output;
    /// Sets height (m) and vertical velocity (down, m/s), as an altimeter would.
    fn hold_vertical(&mut self, altitude: Self::Real, down: Self::Real);
    /// Whether navigation can go on from where it stands.
    fn check_place(&self) -> Result<(), Rejected>;
    /// The state as it stands.
    fn output(&self) -> Self::Output;
}

/// The specific force that a block begins with, in the axes at its start.
pub(super) struct Beginning<R> {
    /// a, m/s².
    pub value: Vector<R>,
    /// ȧ, m/s³.
    pub rate: Vector<R>,
    /// ä, m/s⁴.
    pub rate_growth: Vector<R>,
}

impl<R: Real> Beginning<R> {
    /// The parabola whose first, second and third integrals over T are u, s and ∫s, turned by a matrix.
    pub fn of(matrix: &Matrix<R>, body: &BodyMotion<R>, time: R) -> Self {
        // With U = u/T, V = s/T² and Z = ∫s/T³: a = 3U − 24V + 60Z,
        // ȧT = −24U + 168V − 360Z,  äT² = 60U − 360V + 720Z
        let inverse = R::ONE / time;
        let inverse_square = inverse * inverse;
        let once = *matrix * body.velocity * inverse;
        let twice = *matrix * body.position * inverse_square;
        let thrice = *matrix * body.position_integral * (inverse_square * inverse);
        let sum = |u: f64, v: f64, z: f64| once * R::of(u) + twice * R::of(v) + thrice * R::of(z);
        Self {
            value: sum(3.0, -24.0, 60.0),
            rate: sum(-24.0, 168.0, -360.0) * inverse,
            rate_growth: sum(60.0, -360.0, 720.0) * inverse_square,
        }
    }
}

/// Height above and below the ellipsoid, m, up to which navigation starts and goes on.
pub(super) const FARTHEST: f64 = 1e6;

/// Whether a place in local-level axes is one to go on from.
#[inline(always)]
pub(super) fn check_local<R: Real>(cosine: R, altitude: R) -> Result<(), Rejected> {
    if !altitude.is_within(R::of(FARTHEST)) {
        Err(Rejected::Place)
    } else if R::any(cosine.less(R::of(POLAR_COSINE))) {
        Err(Rejected::Pole)
    } else {
        Ok(())
    }
}

/// Brings a longitude of at most ±3π back into ±180°, with all the digits of 2π; within ±180° it stays as it
/// is, to the last bit.
#[inline(always)]
pub(super) fn fold_longitude<S: Accumulate>(longitude: &mut S) {
    const TURN: f64 = core::f64::consts::TAU;
    let rest = S::Real::entry(-1.748_455_6e-7, 2.449_293_598_294_706_4e-16);
    let at = longitude.value();
    let outside = S::Real::of(0.5 * TURN).less(at.abs());
    if S::Real::any(outside) {
        let west = at.less(S::Real::ZERO);
        let back = |x: S::Real| S::Real::select(west, x, -x);
        let mut folded = *longitude;
        folded.add_pair(Pair { hi: back(S::Real::of(TURN)), lo: back(rest) });
        *longitude = S::select(outside, folded, *longitude);
    }
}

/// Whether a place in Earth-fixed axes is one to go on from: in the shell between the spheres
/// [`FARTHEST`] below the poles and above the equator.
#[inline(always)]
pub(super) fn check_earth_fixed<R: Real>(position_e: Vector<R>) -> Result<(), Rejected> {
    const LEAST: f64 = SEMI_MINOR_AXIS - FARTHEST;
    const MOST: f64 = SEMI_MAJOR_AXIS + FARTHEST;
    const MEAN: f64 = 0.5 * (MOST * MOST + LEAST * LEAST);
    const HALF_RANGE: f64 = 0.5 * (MOST * MOST - LEAST * LEAST);
    let from_mean = position_e.dot(position_e) - R::of(MEAN);
    if from_mean.is_within(R::of(HALF_RANGE)) { Ok(()) } else { Err(Rejected::Place) }
}

/// cosφ below which north and east are not told apart any more: 640 m from a pole.
const POLAR_COSINE: f64 = 1e-4;

/// A state that can be turned into a solution in local axes.
pub trait Output<R: Real>: Copy {
    /// To the digits of `R`.
    fn solution(&self) -> Solution<R>;
    /// In double precision, from all the digits carried.
    fn wide(&self) -> Solution<f64>
    where
        R: Scalar;
}

impl<R: Real> Output<R> for Solution<R> {
    #[inline(always)]
    fn solution(&self) -> Solution<R> {
        *self
    }
    fn wide(&self) -> Solution<f64>
    where
        R: Scalar,
    {
        self.widen()
    }
}

impl<R: Real> Output<R> for EarthFixedSolution<R> {
    fn solution(&self) -> Solution<R> {
        self.to_local()
    }
    fn wide(&self) -> Solution<f64>
    where
        R: Scalar,
    {
        self.widen().to_local()
    }
}
