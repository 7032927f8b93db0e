//! The power series of a block: rotation, velocity and position about its centre.
//!
//! Each coefficient follows from products of the coefficients before it with the fitted rates. Up to order 3
//! the products are written out, so that no coefficient is in memory. Higher orders use a loop, except for the
//! windows of fast motion where long code is no disadvantage.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//! use schuler::strapdown::block::body::{Sum, integrate};
//! use schuler::strapdown::block::fit::Fit;
//! use schuler::strapdown::block::series::Series;
//!
//! // A steady rate of 0.2 rad per block: higher orders of the series add less and less.
//! let sample = Increment { angle_b: Vector::new(0.05, 0.0, 0.0), velocity_b: Vector::ZERO };
//! let samples = [sample; 4];
//! let (fit, _) = Fit::<f64, 4>::from_any(&samples, 0, 4);
//! let sine = |order| {
//!     let (body, _): (_, Series<f64, 11>) = integrate(&fit, &Sum::plain(&samples), 0.02, order);
//!     body.rotation.v.x
//! };
//! assert!((sine(3) - 0.1_f64.sin()).abs() < 1e-7);
//! assert!((sine(10) - 0.1_f64.sin()).abs() < 1e-16);
//! ```

use super::fit::Fit;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::real::Twin as _;
use crate::math::vector::Vector;

/// One coefficient, or the series at one σ: q (less one, at a point), U and D.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Term<R: Real> {
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
    pub(crate) terms: [Term<R>; N],
    pub(crate) last: usize,
    pub(crate) even: Term<R>,
    pub(crate) odd: Term<R>,
    /// The sum of the odd coefficients without their own wₙ/2(n + 1) and fₙ/(n + 1).
    pub(crate) curved: Term<R>,
}

/// Products of orders up to this one are written out for every window.
const LOW_ORDER: usize = 3;
/// Coefficients of the fit and terms of the series in the windows of fast motion. Their series is written
/// out to the order of the fit, where code size does not matter.
const FAST_MOTION: (usize, usize) = (8, 23);

/// A loop over these numbers, written out: the indexed values need not be in memory.
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
    /// The series to σ^`order`, at most N − 1. The fit enters whole; products with it are truncated there.
    #[inline(always)]
    pub(crate) fn solve<const K: usize>(fit: &Fit<R, K>, order: usize) -> Self {
        const { assert!(N % 2 == 1 && N > K + 1 && K + 1 >= LOW_ORDER) };
        let written_out = R::Twin::IN_REGISTER && (K, N) == FAST_MOTION;
        // Separate functions, so that one order does not force the coefficients of another into memory.
        if order <= LOW_ORDER {
            Self::of_low_order(fit)
        } else if written_out && order == K + 1 {
            Self::of_fast_motion(fit)
        } else {
            Self::of_order(fit, order)
        }
    }

    /// To σ³.
    #[inline(always)]
    fn of_low_order<const K: usize>(fit: &Fit<R, K>) -> Self {
        let rate = fit.rate.map(|w| w.map(R::Twin::both));
        let mut series = Self::begun();
        series.advance(0, 0, fit, &rate);
        series.advance(1, 1, fit, &rate);
        series.advance(2, 2, fit, &rate);
        const { assert!(LOW_ORDER == 3 && K <= 14) };
        written_out!(n in [3 4 5 6 7 8 9 10 11 12 13 14] if n <= K => series.advance(n, 0, fit, &rate));
        written_out!(n in [7 6 5 4 3 2 1 0] if 2 * n <= K => series.sum_two(n));
        series.last = K + 1;
        series
    }

    /// To the order of the fit.
    #[inline(always)]
    fn of_fast_motion<const K: usize>(fit: &Fit<R, K>) -> Self {
        let rate = fit.rate.map(|w| w.map(R::Twin::both));
        let order = K + 1;
        let mut series = Self::begun();
        written_out!(n in [0 1 2 3 4 5 6 7 8] if n < order => series.advance(n, n, fit, &rate));
        written_out!(n in [4 3 2 1 0] if n < order.div_ceil(2) => series.sum_two(n));
        series.last = order;
        series
    }

    /// To any order.
    #[inline(always)]
    fn of_order<const K: usize>(fit: &Fit<R, K>, order: usize) -> Self {
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
