//! The factors U and D in one array, column by column.
//!
//! ```
//! use schuler::aiding::covariance::ud::Ud;
//!
//! let ud = Ud::<f32, 3, 6>::diagonal([1.0, 2.0, 0.0]);
//! assert_eq!(ud.variance(1), 4.0);
//! // Nothing is uncertain about the third.
//! assert_eq!((ud.variance(2), ud.covariance(1, 2)), (0.0, 0.0));
//! ```

use crate::math::real::Real;
use crate::record::{Record, record};

/// P = U·D·Uᵀ of `N` states in `P` = N(N + 1)/2 numbers.
///
/// Column j takes j + 1 numbers: the part of U above the diagonal, then D_j. A D of 0 is legal: such a state is
/// known exactly, given the states after it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ud<R, const N: usize, const P: usize> {
    packed: [R; P],
}

/// Column after column: U above the diagonal, and D.
pub(super) struct ColumnsMut<'a, R> {
    rest: &'a mut [R],
    above: usize,
}

impl<'a, R> Iterator for ColumnsMut<'a, R> {
    type Item = (&'a mut [R], &'a mut R);

    #[inline(always)]
    fn next(&mut self) -> Option<Self::Item> {
        let rest = core::mem::take(&mut self.rest);
        let (column, rest) = rest.split_at_mut_checked(self.above + 1)?;
        self.rest = rest;
        self.above += 1;
        let (d, above) = column.split_last_mut()?;
        Some((above, d))
    }
}

impl<R: Real, const N: usize, const P: usize> Ud<R, N, P> {
    /// The compiler stops at a wrong size.
    const FITS: () =
        assert!(P == N * (N + 1) / 2, "the factors of N states take N(N + 1)/2 numbers");

    /// Every state known exactly.
    pub const fn exact() -> Self {
        let () = Self::FITS;
        Self { packed: [R::ZERO; P] }
    }

    /// Independent states with these standard deviations.
    pub fn diagonal(sigmas: [R; N]) -> Self {
        let mut ud = Self::exact();
        for ((_, d), sigma) in ud.columns_mut().zip(sigmas) {
            *d = sigma * sigma;
        }
        ud
    }

    /// Where column j begins.
    #[inline(always)]
    const fn offset(j: usize) -> usize {
        j * (j + 1) / 2
    }

    /// U above the diagonal in column j, and D_j; nothing and 0 beyond the last.
    #[inline(always)]
    pub fn column(&self, j: usize) -> (&[R], R) {
        let begin = Self::offset(j);
        match self.packed.get(begin..=begin + j).and_then(<[R]>::split_last) {
            Some((d, above)) => (above, *d),
            None => (&[], R::ZERO),
        }
    }

    /// The same, to write.
    #[inline(always)]
    pub(super) fn column_mut(&mut self, j: usize) -> Option<(&mut [R], &mut R)> {
        let begin = Self::offset(j);
        let column = self.packed.get_mut(begin..=begin + j)?;
        column.split_last_mut().map(|(d, above)| (above, d))
    }

    /// Every column, to write.
    #[inline(always)]
    pub(super) fn columns_mut(&mut self) -> ColumnsMut<'_, R> {
        ColumnsMut { rest: &mut self.packed, above: 0 }
    }

    /// U_ij.
    #[inline(always)]
    fn entry(&self, i: usize, j: usize) -> R {
        if i == j { R::ONE } else { self.column(j).0.get(i).copied().unwrap_or(R::ZERO) }
    }

    /// P_ij.
    pub fn covariance(&self, i: usize, j: usize) -> R {
        // P_ij = Σ_k U_ik D_k U_jk
        let mut sum = R::ZERO;
        for k in i.max(j)..N {
            sum = sum + self.entry(i, k) * self.column(k).1 * self.entry(j, k);
        }
        sum
    }

    /// P_ii.
    pub fn variance(&self, i: usize) -> R {
        self.covariance(i, i)
    }

    /// √P_ii.
    pub fn sigma(&self, i: usize) -> R {
        self.variance(i).sqrt()
    }

    /// hᵀPk: the covariance of two combinations of states.
    pub fn covariance_of(&self, h: &[R; N], k: &[R; N]) -> R {
        let mut sum = R::ZERO;
        for j in 0..N {
            let (above, d) = self.column(j);
            let along = |h: &[R; N]| {
                above.iter().zip(h).fold(R::ZERO, |f, (u, h)| f + *u * *h)
                    + h.get(j).copied().unwrap_or(R::ZERO)
            };
            sum = sum + along(h) * along(k) * d;
        }
        sum
    }

    /// hᵀPh: the variance of a combination of states.
    pub fn variance_of(&self, h: &[R; N]) -> R {
        let mut sum = R::ZERO;
        for j in 0..N {
            let (above, d) = self.column(j);
            let along = above.iter().zip(h).fold(R::ZERO, |f, (u, h)| f + *u * *h)
                + h.get(j).copied().unwrap_or(R::ZERO);
            sum = sum + along * along * d;
        }
        sum
    }

    /// The earlier factors but where the mask holds, lane by lane.
    #[inline]
    pub fn revert_unless(&mut self, mask: R::Mask, earlier: &Self) {
        if !R::any(R::ZERO.less(R::select(mask, R::ZERO, R::ONE))) {
            return;
        }
        for (mine, old) in self.packed.iter_mut().zip(&earlier.packed) {
            *mine = R::select(mask, *mine, *old);
        }
    }

    /// Whether every number is finite, and no D negative.
    pub fn is_plausible(&self) -> bool {
        let most = R::of(1e30);
        (0..N).all(|j| {
            let (above, d) = self.column(j);
            above.iter().all(|u| u.is_within(most)) && d.is_within(most) && !R::any(d.less(R::ZERO))
        })
    }
}

impl<R: Record, const N: usize, const P: usize> Record for Ud<R, N, P> {
    record!(packed;);
}
