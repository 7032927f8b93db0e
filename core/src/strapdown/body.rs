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
pub struct Sum<R> {
    increment: Increment<R>,
    /// What rounding dropped from it.
    low: Increment<R>,
    two_float: bool,
}

impl<R: Real> Sum<R> {
    /// Of increments; with what rounding drops if two-float numbers are asked for.
    #[inline(always)]
    pub fn of(samples: &[Increment<R>], two_float: bool) -> Self {
        let zero = Increment { angle_b: Vector::ZERO, velocity_b: Vector::ZERO };
        let (mut increment, mut low) = (zero, zero);
        for sample in samples {
            if two_float {
                let (angle, angle_low) = two_sums(increment.angle_b, sample.angle_b);
                let (velocity, velocity_low) = two_sums(increment.velocity_b, sample.velocity_b);
                increment = Increment { angle_b: angle, velocity_b: velocity };
                low.angle_b = low.angle_b + angle_low;
                low.velocity_b = low.velocity_b + velocity_low;
            } else {
                increment.angle_b = increment.angle_b + sample.angle_b;
                increment.velocity_b = increment.velocity_b + sample.velocity_b;
            }
        }
        Self { increment, low, two_float }
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
struct Term<R: Real> {
    /// q's scalar and x, and its y and z.
    wx: R::Twin,
    yz: R::Twin,
    /// U and D side by side.
    motion: Vector<R::Twin>,
}

impl<R: Real> Term<R> {
    #[inline(always)]
    fn zero() -> Self {
        let zero = R::Twin::both(R::ZERO);
        Self { wx: zero, yz: zero, motion: Vector::new(zero, zero, zero) }
    }

    #[inline(always)]
    fn zip(self, b: Self, f: impl Fn(R::Twin, R::Twin) -> R::Twin) -> Self {
        Self { wx: f(self.wx, b.wx), yz: f(self.yz, b.yz), motion: self.motion.zip(b.motion, &f) }
    }

    #[inline(always)]
    fn rotation(&self) -> Quaternion<R> {
        let ((w, x), (y, z)) = (self.wx.parts(), self.yz.parts());
        Quaternion::new(w, Vector::new(x, y, z))
    }

    #[inline(always)]
    fn velocity(&self) -> Vector<R> {
        self.motion.map(|c| c.parts().0)
    }

    #[inline(always)]
    fn position(&self) -> Vector<R> {
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
        let (x, sum) = (term.motion, self.motion);
        self.motion = Vector {
            x: sum.x + x.y * w.z - x.z * w.y,
            y: sum.y + x.z * w.x - x.x * w.z,
            z: sum.z + x.x * w.y - x.y * w.x,
        };
    }
}

/// The series of a block to the power N − 1, with the sums of its even and odd terms.
#[derive(Clone, Copy, Debug)]
pub struct Series<R: Real, const N: usize> {
    terms: [Term<R>; N],
    last: usize,
    even: Term<R>,
    odd: Term<R>,
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
    let order = order.min(N - 1);
    let rate = fit.rate.map(|w| w.map(R::Twin::both));
    let mut terms = [Term::zero(); N];
    // q₀ = 1, U₀ = D₀ = 0: the products with them are wₙ itself and 0.
    terms[0].wx = R::Twin::new(R::ONE, R::ZERO);
    // What the odd coefficients hold beyond their own wₙ/2(n + 1) and fₙ/(n + 1).
    let mut odd_rotation = Vector::ZERO;
    let mut odd_velocity = Vector::ZERO;
    for n in 0..order {
        // q_{n+1} = 1/(2(n+1)) Σ q_{n−k} ⊗ w_k
        // U_{n+1} = (f_n − Σ w_k × U_{n−k})/(n+1),  D_{n+1} = (U_n − Σ w_k × D_{n−k})/(n+1)
        let mut turned = Term::zero();
        let past = terms.get(1..=n).unwrap_or(&[]);
        for (term, w) in past.iter().rev().zip(&rate) {
            turned.add_product(term, w);
        }
        let inverse = R::INVERSE.get(n + 1).copied().unwrap_or(R::ZERO);
        let half_inverse = R::Twin::both(inverse * R::HALF);
        if n % 2 == 0 {
            odd_rotation = odd_rotation + turned.rotation().v * (inverse * R::HALF);
            odd_velocity = odd_velocity + turned.velocity() * inverse;
        }
        let w = fit.rate.get(n).copied().unwrap_or(Vector::ZERO);
        let f = fit.force.get(n).copied().unwrap_or(Vector::ZERO);
        let [.., before, next] = terms.get_mut(..n + 2).unwrap_or(&mut []) else { break };
        let driven = f.zip(before.motion, |f, before| R::Twin::new(f, before.parts().0));
        *next = Term {
            wx: (turned.wx + R::Twin::new(R::ZERO, w.x)) * half_inverse,
            yz: (turned.yz + R::Twin::new(w.y, w.z)) * half_inverse,
            motion: driven.zip(turned.motion, |a, b| (a + b) * R::Twin::both(inverse)),
        };
    }
    // The smallest first, even and odd powers apart: their sum is σ = 1, their difference σ = −1.
    let mut even = Term::zero();
    let mut odd = Term::zero();
    for (n, term) in terms.iter().enumerate().take(order + 1).skip(1).rev() {
        let half = if n % 2 == 0 { &mut even } else { &mut odd };
        *half = half.zip(*term, |a, b| a + b);
    }
    // With q(±1) − 1 = (a, A) ± (b, B), even ± odd, e = e₋* + e₊ + e₋* ⊗ e₊ is
    // eₛ = 2a + a² + |A|² − b² − |B|²,  eᵥ = ½ΣΔθ + 2(Σ_odd qₙ beyond wₙ₋₁/2n + aB − bA + B × A)
    let (a, b) = (even.rotation(), odd.rotation());
    let curved = b.v * a.w - a.v * b.w + b.v.cross(a.v) + odd_rotation;
    let half_sum = sum.increment.angle_b * R::HALF;
    let scalar = a.w + a.w + (a.dot(a) - b.dot(b));
    let (e, rotation_low) = if sum.two_float {
        // Normalising shrinks the remainder, not the rotation itself.
        let (v, low) = two_sums(half_sum, curved + curved);
        let k = Quaternion::new(scalar, v).excess();
        let low = low + sum.low.angle_b * R::HALF - v * k;
        (Quaternion::new(scalar - k * (R::ONE + scalar), v), low)
    } else {
        let v = half_sum + (curved + curved);
        (Quaternion::new(scalar, v).normalised_less_one(), Vector::ZERO)
    };
    let end = even.motion.zip(odd.motion, |a, b| (a + b).parts());
    // u = ΣΔv + 2Σ_odd Uₙ beyond fₙ₋₁/n + (R − I)U₊
    let turned = e.turn_less_one(end.map(|(velocity, _)| velocity));
    let added = odd_velocity + odd_velocity + turned;
    let (velocity, velocity_low) = if sum.two_float {
        let (velocity, low) = two_sums(sum.increment.velocity_b, added);
        (velocity, low + sum.low.velocity_b)
    } else {
        (sum.increment.velocity_b + added, Vector::ZERO)
    };
    // s = (T/2)(R D₊ − D₋ − 2U₋) = (T/2)(2D_odd + 2U_odd − 2U_even + (R − I)D₊)
    let straight = odd.position() + odd.velocity() - even.velocity();
    let turned = e.turn_less_one(end.map(|(_, position)| position));
    let position = (straight + straight + turned) * half_time_s;
    let motion = BodyMotion { rotation: e, rotation_low, velocity, velocity_low, position };
    (motion, Series { terms, last: order, even, odd })
}

impl<R: Real, const N: usize> Series<R, N> {
    /// The motion from the block's start to σ in (−1, 1).
    #[inline]
    pub fn until(&self, sigma: R, half_time_s: R) -> BodyMotion<R> {
        let both = R::Twin::both(sigma);
        let mut at = Term::zero();
        for term in self.terms.iter().take(self.last + 1).skip(1).rev() {
            at = at.zip(*term, |a, b| (a + b) * both);
        }
        let start = self.even.zip(self.odd, |a, b| a - b);
        // q_rel = q(−1)* q(σ),  u = R_rel U(σ) − U₋,  s = (T/2)(R_rel D(σ) − D₋ − (1 + σ)U₋)
        let back = start.rotation().conjugate();
        let e = (back + at.rotation() + back * at.rotation()).normalised_less_one();
        let (velocity, position) = (at.velocity(), at.position());
        BodyMotion {
            rotation: e,
            rotation_low: Vector::ZERO,
            velocity_low: Vector::ZERO,
            velocity: velocity - start.velocity() + e.turn_less_one(velocity),
            position: (position - start.position() - start.velocity() * (R::ONE + sigma)
                + e.turn_less_one(position))
                * half_time_s,
        }
    }
}
