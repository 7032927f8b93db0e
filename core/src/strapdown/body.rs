//! The body step: rotation, velocity and position increments of one block, in body axes.
//!
//! From the fitted rates w(σ), f(σ) a power series about the block's centre solves
//! q′ = ½ q ⊗ w, U′ = f − w × U, D′ = U − w × D; no trigonometry and no iteration. The sums of the
//! increments enter once, as they are, and the polynomials only add what rotation does to them: that
//! keeps single precision from losing what the sensor delivered.

use super::fit::Fit;
use crate::math::compensated::two_sum;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::twin::Twin as _;
use crate::math::vector::Vector;
use crate::sample::Increment;

/// What a block, or its first part, does to a body that starts at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BodyMotion<R> {
    /// Rotation end → start, less one: e = q_bb − 1.
    pub rotation: Quaternion<R>,
    /// What rounding drops from its vector part; 0 unless two-float numbers are asked for.
    pub rotation_low: Vector<R>,
    /// u = ∫ C f dt in the axes at the start, m/s.
    pub velocity: Vector<R>,
    /// What rounding drops from it.
    pub velocity_low: Vector<R>,
    /// s = ∬ C f dt² in the axes at the start, m.
    pub position: Vector<R>,
}

/// The sum of a block's increments.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sum<R> {
    increment: Increment<R>,
    /// What rounding dropped from it.
    low: Increment<R>,
    two_float: bool,
}

impl<R: Real> Sum<R> {
    /// A sum that was rounded.
    #[inline(always)]
    pub fn rounded(increment: Increment<R>) -> Self {
        Self { increment, low: Increment::ZERO, two_float: false }
    }

    /// The sum of increments with what rounding drops.
    #[inline(always)]
    pub fn exact(samples: &[Increment<R>]) -> Self {
        let (mut increment, mut low) = (Increment::ZERO, Increment::ZERO);
        for sample in samples {
            let (angle, angle_low) = two_sums(increment.angle_b, sample.angle_b);
            let (velocity, velocity_low) = two_sums(increment.velocity_b, sample.velocity_b);
            increment = Increment { angle_b: angle, velocity_b: velocity };
            low.angle_b = low.angle_b + angle_low;
            low.velocity_b = low.velocity_b + velocity_low;
        }
        Self { increment, low, two_float: true }
    }
}

/// a + b = s + e, component by component, exactly.
#[inline(always)]
fn two_sums<R: Real>(a: Vector<R>, b: Vector<R>) -> (Vector<R>, Vector<R>) {
    let pairs = a.zip(b, two_sum);
    (pairs.map(|(s, _)| s), pairs.map(|(_, e)| e))
}

/// One coefficient, or the series at one σ: q (less one, at a point), U and D.
#[derive(Clone, Copy, Debug)]
pub(super) struct Term<R: Real> {
    /// q's scalar and x, and its y and z.
    wx: R::Twin,
    yz: R::Twin,
    /// U and D side by side.
    pub motion: Vector<R::Twin>,
}

impl<R: Real> Term<R> {
    #[inline(always)]
    pub fn zero() -> Self {
        let zero = R::Twin::both(R::ZERO);
        Self { wx: zero, yz: zero, motion: Vector::new(zero, zero, zero) }
    }

    #[inline(always)]
    pub fn zip(self, b: Self, f: impl Fn(R::Twin, R::Twin) -> R::Twin) -> Self {
        Self { wx: f(self.wx, b.wx), yz: f(self.yz, b.yz), motion: self.motion.zip(b.motion, &f) }
    }

    /// q times one factor, U and D times another.
    #[inline(always)]
    pub fn scaled(self, rotation: R::Twin, motion: R::Twin) -> Self {
        Self {
            wx: self.wx * rotation,
            yz: self.yz * rotation,
            motion: self.motion.map(|c| c * motion),
        }
    }

    #[inline(always)]
    pub fn rotation(&self) -> Quaternion<R> {
        let ((w, x), (y, z)) = (self.wx.parts(), self.yz.parts());
        Quaternion::new(w, Vector::new(x, y, z))
    }

    #[inline(always)]
    pub fn velocity(&self) -> Vector<R> {
        self.motion.map(|c| c.parts().0)
    }

    #[inline(always)]
    pub fn position(&self) -> Vector<R> {
        self.motion.map(|c| c.parts().1)
    }

    /// Adds q ⊗ w, U × w and D × w of a coefficient; w has each component twice.
    #[inline(always)]
    fn add_product(&mut self, term: &Self, w: &Vector<R::Twin>) {
        let (p, q) = (term.wx, term.yz);
        let (p_turned, q_turned) = (p.quarter_turn(), q.quarter_turn());
        // (q ⊗ w): −(x w_x + y w_y + z w_z), q_w w_x + (y w_z − z w_y)
        self.wx = self.wx + p_turned * w.x - q * w.y + q_turned * w.z;
        // q_w w_y + (z w_x − x w_z), q_w w_z + (x w_y − y w_x)
        self.yz = self.yz + p * w.y + p_turned * w.z - q_turned * w.x;
        self.motion = self.motion + term.motion.cross(*w);
    }
}

/// The series of a block to the power N − 1, with the sums of its even and odd terms.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Series<R: Real, const N: usize> {
    pub(super) terms: [Term<R>; N],
    pub(super) last: usize,
    pub(super) even: Term<R>,
    pub(super) odd: Term<R>,
    /// What the odd coefficients hold beyond their own wₙ/2(n + 1) and fₙ/(n + 1).
    curved: Term<R>,
}

/// Products of orders up to this one are written out wherever they are; more take a loop.
const FEW: usize = 3;
/// Coefficients of the fit whose series large processors have written out whole: that of fast motion.
const EIGHT: usize = 8;

/// A loop over these numbers, written out: what it indexes need not be in memory.
macro_rules! written_out {
    ($n:ident in [$($number:literal)+] if $wanted:expr => $body:expr) => {
        $({
            let $n = $number;
            if $wanted {
                $body;
            }
        })+
    };
}

impl<R: Real, const N: usize> Series<R, N> {
    /// Solved to σ^`order`, at most N − 1: the fit enters whole, products with it as far as that.
    #[inline(always)]
    fn solve<const K: usize>(fit: &Fit<R, K>, order: usize) -> Self {
        const { assert!(N % 2 == 1 && N > K + 1 && K + 1 >= FEW) };
        // Apart, so that the few are never in memory.
        if order <= FEW {
            Self::few(fit)
        } else if R::Twin::IN_REGISTER && K == EIGHT && order + 1 >= N {
            Self::written_out::<K, true>(fit)
        } else if R::Twin::IN_REGISTER && K == EIGHT && order == K + 1 {
            Self::written_out::<K, false>(fit)
        } else {
            Self::many(fit, order)
        }
    }

    #[inline(always)]
    fn few<const K: usize>(fit: &Fit<R, K>) -> Self {
        let rate = fit.rate.map(|w| w.map(R::Twin::both));
        let mut series = Self::begun();
        series.advance(0, 0, fit, &rate);
        series.advance(1, 1, fit, &rate);
        series.advance(2, 2, fit, &rate);
        const { assert!(FEW == 3 && K <= 14) };
        written_out!(n in [3 4 5 6 7 8 9 10 11 12 13 14] if n <= K => series.advance(n, 0, fit, &rate));
        written_out!(n in [7 6 5 4 3 2 1 0] if 2 * n <= K => series.sum_two(n));
        series.last = K + 1;
        series
    }

    /// To the order that the window has terms for at most, or to that of its fit.
    #[inline(always)]
    fn written_out<const K: usize, const LONGEST: bool>(fit: &Fit<R, K>) -> Self {
        let rate = fit.rate.map(|w| w.map(R::Twin::both));
        let order = if LONGEST { N - 1 } else { K + 1 };
        let mut series = Self::begun();
        written_out!(n in [0 1 2 3 4 5 6 7 8 9] if n < order => series.advance(n, n, fit, &rate));
        written_out!(n in [4 3 2 1 0] if n < order.div_ceil(2) => series.sum_two(n));
        series.last = order;
        series
    }

    #[inline(always)]
    fn many<const K: usize>(fit: &Fit<R, K>, order: usize) -> Self {
        let rate = fit.rate.map(|w| w.map(R::Twin::both));
        let mut series = Self::begun();
        let order = order.min(N - 1);
        for n in 0..order {
            series.advance(n, n, fit, &rate);
        }
        for n in order..K + 1 {
            series.advance(n, 0, fit, &rate);
        }
        series.sum(order.max(K + 1));
        series
    }

    /// q₀ = 1, U₀ = D₀ = 0: the products with them are wₙ itself and 0.
    #[inline(always)]
    fn begun() -> Self {
        let zero = Term::zero();
        let mut series = Self { terms: [zero; N], last: 0, even: zero, odd: zero, curved: zero };
        series.terms[0].wx = R::Twin::new(R::ONE, R::ZERO);
        series
    }

    /// The coefficient after the n-th, from products with as many before it.
    #[inline(always)]
    fn advance<const K: usize>(
        &mut self,
        n: usize,
        products: usize,
        fit: &Fit<R, K>,
        rate: &[Vector<R::Twin>; K],
    ) {
        // q_{n+1} = 1/(2(n+1)) Σ q_{n−k} ⊗ w_k
        // U_{n+1} = (f_n − Σ w_k × U_{n−k})/(n+1),  D_{n+1} = (U_n − Σ w_k × D_{n−k})/(n+1)
        let mut turned = Term::zero();
        let past = self.terms.get(1..=products).unwrap_or(&[]);
        for (term, w) in past.iter().rev().zip(rate) {
            turned.add_product(term, w);
        }
        let inverse = R::INVERSE.get(n + 1).copied().unwrap_or(R::ZERO);
        let (half, whole) = (R::Twin::both(inverse * R::HALF), R::Twin::both(inverse));
        let turned = turned.scaled(half, whole);
        if n.is_multiple_of(2) && products > 0 {
            self.curved = self.curved.zip(turned, |a, b| a + b);
        }
        let w = fit.rate.get(n).copied().unwrap_or(Vector::ZERO);
        let f = fit.force.get(n).copied().unwrap_or(Vector::ZERO);
        let [.., before, next] = self.terms.get_mut(..n + 2).unwrap_or(&mut []) else { return };
        let driven = Term {
            wx: R::Twin::new(R::ZERO, w.x),
            yz: R::Twin::new(w.y, w.z),
            motion: f.zip(before.velocity(), R::Twin::new),
        };
        *next = turned.zip(driven.scaled(half, whole), |a, b| a + b);
    }

    /// Sums up to the `last` term, the smallest first, even and odd powers apart: their sum is σ = 1,
    /// their difference σ = −1.
    #[inline(always)]
    fn sum(&mut self, last: usize) {
        for n in (0..last.div_ceil(2)).rev() {
            self.sum_two(n);
        }
        self.last = last;
    }

    /// Adds the n-th odd and even terms to their sums.
    #[inline(always)]
    fn sum_two(&mut self, n: usize) {
        if let Some([odd, even]) = self.terms.get(2 * n + 1..2 * n + 3) {
            self.odd = self.odd.zip(*odd, |a, b| a + b);
            self.even = self.even.zip(*even, |a, b| a + b);
        }
    }
}

/// A block's motion and its series up to σ^`order`, at most N − 1. `sum` is the sum of the block's own
/// increments, `half_time_s` half the block's duration.
#[inline(always)]
pub fn integrate<R: Real, const K: usize, const N: usize>(
    fit: &Fit<R, K>,
    sum: &Sum<R>,
    half_time_s: R,
    order: usize,
) -> (BodyMotion<R>, Series<R, N>) {
    let series = Series::solve(fit, order);
    let Series { even, odd, curved, .. } = series;
    // With q(±1) − 1 = (a, A) ± (b, B), even ± odd, e = e₋* + e₊ + e₋* ⊗ e₊ is
    // eₛ = 2a + a² + |A|² − b² − |B|²,  eᵥ = ½ΣΔθ + 2(Σ_odd qₙ beyond wₙ₋₁/2n + aB − bA + B × A)
    let (a, b) = (even.rotation(), odd.rotation());
    let bent = b.v * a.w - a.v * b.w + b.v.cross(a.v) + curved.rotation().v;
    let half_sum = sum.increment.angle_b * R::HALF;
    let scalar = a.w + a.w + (a.dot(a) - b.dot(b));
    let (e, rotation_low) = if sum.two_float {
        // Normalising shrinks the remainder, not the rotation itself.
        let (v, low) = two_sums(half_sum, bent + bent);
        let k = Quaternion::new(scalar, v).excess();
        let low = low + sum.low.angle_b * R::HALF - v * k;
        (Quaternion::new(scalar - k * (R::ONE + scalar), v), low)
    } else {
        let v = half_sum + (bent + bent);
        (Quaternion::new(scalar, v).normalised_less_one(), Vector::ZERO)
    };
    let turned = e.map(R::Twin::both).turn_less_one(even.motion + odd.motion);
    // u = ΣΔv + 2Σ_odd Uₙ beyond fₙ₋₁/n + (R − I)U₊
    let bent = curved.velocity();
    let added = bent + bent + turned.map(|c| c.parts().0);
    let (velocity, velocity_low) = if sum.two_float {
        let (velocity, low) = two_sums(sum.increment.velocity_b, added);
        (velocity, low + sum.low.velocity_b)
    } else {
        (sum.increment.velocity_b + added, Vector::ZERO)
    };
    // s = (T/2)(R D₊ − D₋ − 2U₋) = (T/2)(2D_odd + 2U_odd − 2U_even + (R − I)D₊)
    let straight = odd.position() + odd.velocity() - even.velocity();
    let position = (straight + straight + turned.map(|c| c.parts().1)) * half_time_s;
    let motion = BodyMotion { rotation: e, rotation_low, velocity, velocity_low, position };
    (motion, series)
}
