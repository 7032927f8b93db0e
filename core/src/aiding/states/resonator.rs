//! The displacement of a vehicle that sways and goes nowhere: a Gauss-Markov process of second order for each axis.
//!
//! Its error is in body axes as the other errors, so that it means the same at any heading. That takes the same
//! process for every axis.

use crate::aiding::covariance::ud::Ud;
use crate::aiding::surroundings::Pose;
use crate::aiding::transition::Transition;
use crate::math::quaternion::Matrix;
use crate::math::real::Real;
use crate::math::vector::Vector;

/// A displacement x with ẍ = −w²x − 2ζwẋ + noise in each of three axes; its states are x, then ẋ.
///
/// ```
/// use schuler::aiding::states::resonator::Resonator;
///
/// let sway = Resonator { rms_m: 0.3_f64, rate: 0.9, damping: 0.05 };
/// // Without noise a period of 7 s takes less than a third of it away.
/// let [[a, _], _] = sway.decay(core::f64::consts::TAU / 0.9);
/// assert!(a > 0.7 && a < 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Resonator<R> {
    /// Its rms s per axis, m.
    pub rms_m: R,
    /// Its natural angular rate w, rad/s.
    pub rate: R,
    /// Its damping ζ, as a fraction of the critical one.
    pub damping: R,
}

impl<R: Real> Resonator<R> {
    /// Displacement and its rate, in three axes.
    pub const STATES: usize = 6;

    /// The standard deviation of one state.
    pub fn sigma(&self, state: usize) -> R {
        if state < 3 { self.rms_m } else { self.rms_m * self.rate }
    }

    /// exp(FT) for x and ẋ, F = [0 1; −w² −2ζw].
    pub fn decay(&self, time_s: R) -> [[R; 2]; 2] {
        // The series of exp(FT/2ᵏ), squared k times.
        let mut halves = 0;
        let mut t = time_s;
        while R::any(R::HALF.less((self.rate * t).abs())) && halves < 16 {
            t = t * R::HALF;
            halves += 1;
        }
        let (low, high) = (-(self.rate * self.rate * t), -(R::TWO * self.damping * self.rate * t));
        let product = |a: [[R; 2]; 2], b: [[R; 2]; 2]| {
            let [[a, b_], [c, d]] = a;
            let [[e, f], [g, h]] = b;
            [[a * e + b_ * g, a * f + b_ * h], [c * e + d * g, c * f + d * h]]
        };
        let one = [[R::ONE, R::ZERO], [R::ZERO, R::ONE]];
        let (mut sum, mut term) = (one, one);
        for n in 1..12 {
            let inverse = R::ratio(1, n);
            term = product(term, [[R::ZERO, t], [low, high]]).map(|row| row.map(|x| x * inverse));
            let ([[a, b], [c, d]], [[e, f], [g, h]]) = (sum, term);
            sum = [[a + e, b + f], [c + g, d + h]];
        }
        for _ in 0..halves {
            sum = product(sum, sum);
        }
        sum
    }

    /// Carries covariance and estimate on. The estimate is in north, east and down.
    pub fn advance<const N: usize, const P: usize>(
        &self,
        ud: &mut Ud<R, N, P>,
        first: usize,
        estimate: &mut [R],
        transition: &Transition<R>,
    ) {
        let time_s = transition.time_s();
        let decay = self.decay(time_s);
        let [[a, b], [c, d]] = decay;
        // In body axes the process is the same, and turns: A ⊗ Rᵀ. The Earth's rate against the sway is left out.
        ud.map_states(first, &turned(decay, transition.back()));
        // Q = P∞ − A P∞ Aᵀ, P∞ = diag(s², s²w²), by its factors; what ẋ does not explain of x is q T³/12,
        // q = 4ζw³s²
        let position = self.rms_m * self.rms_m;
        let speed = position * self.rate * self.rate;
        let cross = -(a * c * position + b * d * speed);
        let rest = (speed - d * d * speed) - c * c * position;
        let slope = cross / rest;
        let density = R::of(4.0) * self.damping * self.rate * speed;
        let own = density * time_s * time_s * time_s * R::ratio(1, 12);
        for axis in 0..3 {
            let mut along = [R::ZERO; N];
            let (x, v) = (first + axis, first + axis + 3);
            if let Some(cell) = along.get_mut(x) {
                *cell = slope;
            }
            if let Some(cell) = along.get_mut(v) {
                *cell = R::ONE;
            }
            ud.add_rank_one_to(v + 1, rest, along);
            ud.add_variance(x, own);
        }
        if let [x0, x1, x2, v0, v1, v2] = estimate {
            for (x, v) in [(x0, v0), (x1, v1), (x2, v2)] {
                (*x, *v) = (a * *x + b * *v, c * *x + d * *v);
            }
        }
    }

    /// Takes the estimated errors, in body axes, off the estimates.
    pub(super) fn feed(estimate: &mut [R], errors: &[R], pose: &Pose<R>) {
        if let ([x0, x1, x2, v0, v1, v2], &[a, b, c, d, e, f]) = (estimate, errors) {
            let x = pose.body_to_ned * Vector::new(a, b, c);
            let v = pose.body_to_ned * Vector::new(d, e, f);
            (*x0, *x1, *x2) = (*x0 - x.x, *x1 - x.y, *x2 - x.z);
            (*v0, *v1, *v2) = (*v0 - v.x, *v1 - v.y, *v2 - v.z);
        }
    }
}

/// A ⊗ Rᵀ by rows.
fn turned<R: Real>(decay: [[R; 2]; 2], back: &Matrix<R>) -> [[R; 6]; 6] {
    let [[a, b], [c, d]] = decay;
    let rows =
        |a: R, b: R| back.rows.map(|Vector { x, y, z }| [x * a, y * a, z * a, x * b, y * b, z * b]);
    let ([x0, x1, x2], [v0, v1, v2]) = (rows(a, b), rows(c, d));
    [x0, x1, x2, v0, v1, v2]
}
