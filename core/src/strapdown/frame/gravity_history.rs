//! Gravity's backward differences at the ends of blocks, and its integrals over the next block from them
//! (Adams).
//!
//! With ∇ = G₀ − G₋₁, ∇² = ∇ − ∇₋₁, … and τ ∈ [0, 1] over the block, G(τ) = Σ ∇ᵏ τ(τ + 1)…(τ + k − 1)/k!
//! up to k = 4, whose twofold integral is ½G₀ + ⅙∇ + ⅛∇² + ¹⁹⁄₁₈₀∇³ + ³⁄₃₂∇⁴. Once G₁ is known, with
//! δ = G₁ − G₀, δ² = δ − ∇, … up to δ⁵, the integral of the polynomial that includes G₁ is
//! G₀ + ½δ − δ²/12 − δ³/24 − ¹⁹⁄₇₂₀δ⁴ − ³⁄₁₆₀δ⁵.

use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::record::{Record, record};

/// ∇ to ∇⁴ of gravity, m/s².
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct GravityHistory<R> {
    /// ∇.
    pub difference: Vector<R>,
    /// ∇².
    pub second_difference: Vector<R>,
    /// ∇³.
    pub third_difference: Vector<R>,
    /// ∇⁴, in the axes in which it was found: it is too small to need rotation.
    pub fourth_difference: Vector<R>,
}

impl<R: Real> GravityHistory<R> {
    /// Of constant gravity.
    pub const NONE: Self = Self {
        difference: Vector::ZERO,
        second_difference: Vector::ZERO,
        third_difference: Vector::ZERO,
        fourth_difference: Vector::ZERO,
    };

    /// From gravity less G₀ at the ends of the four blocks before, the latest first.
    pub fn of([g1, g2, g3, g4]: [Vector<R>; 4]) -> Self {
        let (first, second, third, last) = (-g1, g1 - g2, g2 - g3, g3 - g4);
        let second_difference = first - second;
        let third_difference = second_difference - (second - third);
        Self {
            difference: first,
            second_difference,
            third_difference,
            fourth_difference: third_difference - ((second - third) - (third - last)),
        }
    }

    /// The twofold integral beyond ½G₀.
    #[inline(always)]
    pub fn twofold(&self) -> Vector<R> {
        let small = self.third_difference * R::of(19.0 / 180.0)
            + self.fourth_difference * R::of(3.0 / 32.0);
        self.difference * R::of(1.0 / 6.0) + (self.second_difference * R::of(0.125) + small)
    }

    /// Takes δ, and returns the mean over the block less G₀. δ to δ⁴ become the next block's ∇ to
    /// ∇⁴, in the axes of this one.
    #[inline(always)]
    pub fn advance(&mut self, delta: Vector<R>) -> Vector<R> {
        let delta2 = delta - self.difference;
        let delta3 = delta2 - self.second_difference;
        let delta4 = delta3 - self.third_difference;
        let delta5 = delta4 - self.fourth_difference;
        *self = Self {
            difference: delta,
            second_difference: delta2,
            third_difference: delta3,
            fourth_difference: delta4,
        };
        let small = delta3 * R::of(1.0 / 24.0)
            + (delta4 * R::of(19.0 / 720.0) + delta5 * R::of(3.0 / 160.0));
        delta * R::HALF - (delta2 * R::of(1.0 / 12.0) + small)
    }

    /// Half of G₁ − G₋₁ and of G₁ − 2G₀ + G₋₁: gravity over the block as a parabola.
    #[inline(always)]
    pub fn parabola(&self, delta: Vector<R>) -> (Vector<R>, Vector<R>) {
        ((delta + self.difference) * R::HALF, (delta - self.difference) * R::HALF)
    }

    /// Converts to blocks that are ρ times as long.
    #[inline(never)]
    pub fn stretch(&mut self, rho: R) {
        // Going back by a block is 1 − ∇, by a longer one (1 − ∇)^ρ, and ∇ ← 1 − (1 − ∇)^ρ:
        // ∇ ← ρ(∇ + (1 − ρ)/2 (∇² + (2 − ρ)/3 (∇³ + (3 − ρ)/4 ∇⁴)))
        // ∇² ← ρ²(∇² + (1 − ρ)(∇³ + (11 − 7ρ)/12 ∇⁴)),  ∇³ ← ρ³(∇³ + 3(1 − ρ)/2 ∇⁴),  ∇⁴ ← ρ⁴∇⁴
        let Self {
            difference: nabla,
            second_difference: nabla2,
            third_difference: nabla3,
            fourth_difference: nabla4,
        } = *self;
        let less = R::ONE - rho;
        let fourth = nabla3 + nabla4 * ((R::of(3.0) - rho) * R::of(0.25));
        let third = nabla2 + fourth * ((R::TWO - rho) * R::of(1.0 / 3.0));
        let bent = nabla3 + nabla4 * ((R::of(11.0) - R::of(7.0) * rho) * R::of(1.0 / 12.0));
        let square = rho * rho;
        *self = Self {
            difference: (nabla + third * (less * R::HALF)) * rho,
            second_difference: (nabla2 + bent * less) * square,
            third_difference: (nabla3 + nabla4 * (less * R::of(1.5))) * (square * rho),
            fourth_difference: nabla4 * (square * square),
        };
    }

    /// Whether all are within a bound.
    pub fn is_within(&self, bound: R) -> bool {
        self.difference.is_within(bound)
            & self.second_difference.is_within(bound)
            & self.third_difference.is_within(bound)
            & self.fourth_difference.is_within(bound)
    }
}

impl<R: Record> Record for GravityHistory<R> {
    record!(difference, second_difference, third_difference, fourth_difference);
}
