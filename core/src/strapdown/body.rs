//! The body step: rotation, velocity and position increments of one block, in body axes.
//!
//! From the fitted rates w(σ), f(σ) a power series about the block's centre solves
//! q′ = ½ q ⊗ w, U′ = f − w × U, D′ = U − w × D; no trigonometry and no iteration. The sums of the
//! increments enter once, as they are, and the polynomials only add what rotation does to them: that
//! keeps single precision from losing what the sensor delivered.

use super::fit::Fit;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::twin::Twin;
use crate::math::vector::Vector;
use crate::sample::Increment;

/// What a block, or its first part, does to a body that starts at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyMotion<R> {
    /// Rotation end → start, less one: e = q_bb − 1.
    pub rotation: Quaternion<R>,
    /// u = ∫ C f dt in the axes at the start, m/s.
    pub velocity: Vector<R>,
    /// s = ∬ C f dt² in the axes at the start, m.
    pub position: Vector<R>,
}

/// One coefficient, or the series at one σ: q (less one, at a point), U and D.
#[derive(Clone, Copy, Debug)]
struct Term<R> {
    /// q's scalar and x, and its y and z.
    wx: Twin<R>,
    yz: Twin<R>,
    /// U and D side by side.
    motion: Vector<Twin<R>>,
}

impl<R: Real> Term<R> {
    const ZERO: Self = Self {
        wx: Twin::ZERO,
        yz: Twin::ZERO,
        motion: Vector::new(Twin::ZERO, Twin::ZERO, Twin::ZERO),
    };

    #[inline(always)]
    fn zip(self, b: Self, f: impl Fn(Twin<R>, Twin<R>) -> Twin<R>) -> Self {
        Self { wx: f(self.wx, b.wx), yz: f(self.yz, b.yz), motion: self.motion.zip(b.motion, &f) }
    }

    #[inline(always)]
    fn rotation(&self) -> Quaternion<R> {
        Quaternion::new(self.wx.0, Vector::new(self.wx.1, self.yz.0, self.yz.1))
    }

    #[inline(always)]
    fn velocity(&self) -> Vector<R> {
        self.motion.map(|c| c.0)
    }

    #[inline(always)]
    fn position(&self) -> Vector<R> {
        self.motion.map(|c| c.1)
    }
}

/// The series of a block to the power N − 1, with its values at the start.
#[derive(Clone, Copy, Debug)]
pub struct Series<R, const N: usize> {
    terms: [Term<R>; N],
    start: Term<R>,
}

/// Repeats a body for n = 0, 1, … up to a constant below 16: in a row where there is room for the code
/// and a vector unit to feed, in a loop on a microcontroller. The operations are the same.
macro_rules! each_order {
    ($end:expr, $n:ident => $body:block) => {
        if cfg!(target_pointer_width = "64") {
            each_order!(@row $end, $n, $body, 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15);
        } else {
            for $n in 0..$end $body
        }
    };
    (@row $end:expr, $n:ident, $body:block, $($order:literal)+) => {
        $(if $order < $end {
            let $n: usize = $order;
            $body
        })+
    };
}

/// A block's motion and its series. `sum` is the sum of the block's own increments, `half_time_s`
/// half the block's duration.
#[inline(always)]
pub fn integrate<R: Real, const K: usize, const N: usize>(
    fit: &Fit<R, K>,
    sum: Increment<R>,
    half_time_s: R,
) -> (BodyMotion<R>, Series<R, N>) {
    let mut terms = [Term::ZERO; N];
    terms[0].wx = Twin(R::ONE, R::ZERO);
    // What the odd coefficients hold beyond their own wₙ/2(n + 1) and fₙ/(n + 1).
    let mut odd_rotation = Vector::ZERO;
    let mut odd_velocity = Vector::ZERO;
    each_order!(N - 1, n => {
        // q_{n+1} = 1/(2(n+1)) Σ q_{n−k} ⊗ w_k
        // U_{n+1} = (f_n − Σ w_k × U_{n−k})/(n+1),  D_{n+1} = (U_n − Σ w_k × D_{n−k})/(n+1)
        let mut turned = Term::ZERO;
        for k in 0..K.min(n) {
            turned = turned.zip(product(&terms[n - k], fit.rate[k]), |a, b| a + b);
        }
        let inverse = R::INVERSE[n + 1];
        let half_inverse = Twin::both(inverse * R::HALF);
        let (w, f) = if n < K { (fit.rate[n], fit.force[n]) } else { (Vector::ZERO, Vector::ZERO) };
        let last = terms[n].motion;
        if n % 2 == 0 {
            odd_rotation = odd_rotation + turned.rotation().v * half_inverse.0;
            odd_velocity = odd_velocity + turned.velocity() * inverse;
        }
        terms[n + 1] = Term {
            wx: (turned.wx + Twin(R::ZERO, w.x)) * half_inverse,
            yz: (turned.yz + Twin(w.y, w.z)) * half_inverse,
            motion: f
                .zip(last, |f, last| Twin(f, last.0))
                .zip(turned.motion, |a, b| (a + b) * Twin::both(inverse)),
        };
    });
    let mut even = Term::ZERO;
    let mut odd = Term::ZERO;
    each_order!(N - 1, n => {
        let n = N - 1 - n;
        let half = if n % 2 == 0 { &mut even } else { &mut odd };
        *half = half.zip(terms[n], |a, b| a + b);
    });
    let (start, end) = (even.zip(odd, |a, b| a - b), even.zip(odd, |a, b| a + b));

    // vec(e₋* + e₊) = ½ΣΔθ + 2Σ_odd qₙ beyond wₙ₋₁/2n,  e = e₋* + e₊ + e₋* ⊗ e₊
    let (before, after) = (start.rotation(), end.rotation());
    let both = before.conjugate() * after;
    let e = Quaternion::new(
        before.w + after.w + both.w,
        sum.angle_b * R::HALF + (odd_rotation + odd_rotation + both.v),
    )
    .normalised_less_one();
    // u = ΣΔv + 2Σ_odd Uₙ beyond fₙ₋₁/n + (R − I)U₊
    let u = sum.velocity_b + (odd_velocity + odd_velocity + e.turn_less_one(end.velocity()));
    // s = (T/2)(R D₊ − D₋ − 2U₋)
    let s = (end.position() - start.position() - start.velocity() - start.velocity()
        + e.turn_less_one(end.position()))
        * half_time_s;
    (BodyMotion { rotation: e, velocity: u, position: s }, Series { terms, start })
}

/// q ⊗ w, U × w and D × w of a coefficient.
#[inline(always)]
fn product<R: Real>(term: &Term<R>, w: Vector<R>) -> Term<R> {
    let w = w.map(Twin::both);
    let (p, q) = (term.wx, term.yz);
    let (p_turned, q_turned) = (p.quarter_turn(), q.quarter_turn());
    let x = term.motion;
    Term {
        // (q ⊗ w): −(x w_x + y w_y + z w_z), q_w w_x + (y w_z − z w_y)
        wx: p_turned * w.x - q * w.y + q_turned * w.z,
        // q_w w_y + (z w_x − x w_z), q_w w_z + (x w_y − y w_x)
        yz: p * w.y + p_turned * w.z - q_turned * w.x,
        motion: x.cross(w),
    }
}

impl<R: Real, const N: usize> Series<R, N> {
    /// The motion from the block's start to σ in (−1, 1).
    #[inline]
    pub fn until(&self, sigma: R, half_time_s: R) -> BodyMotion<R> {
        let both = Twin::both(sigma);
        let mut at = Term::ZERO;
        for n in (1..N).rev() {
            at = at.zip(self.terms[n], |a, b| (a + b) * both);
        }
        let start = &self.start;
        // q_rel = q(−1)* q(σ),  u = R_rel U(σ) − U₋,  s = (T/2)(R_rel D(σ) − D₋ − (1 + σ)U₋)
        let back = start.rotation().conjugate();
        let e = (back + at.rotation() + back * at.rotation()).normalised_less_one();
        let (velocity, position) = (at.velocity(), at.position());
        BodyMotion {
            rotation: e,
            velocity: velocity - start.velocity() + e.turn_less_one(velocity),
            position: (position - start.position() - start.velocity() * (R::ONE + sigma)
                + e.turn_less_one(position))
                * half_time_s,
        }
    }
}
