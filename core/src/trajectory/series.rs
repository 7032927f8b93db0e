//! Truncated power series: a function of time about an instant by its first `N` Taylor coefficients.
//!
//! Coefficient k is the k-th derivative over k!. Sums, products, quotients and powers of series are
//! algebra on the coefficients; sine and cosine take one call of the function at the instant itself.
//! Source: Moore, Kearfott & Cloud, Introduction to Interval Analysis, §9.2 (recursive Taylor coefficients).
//!
//! ```
//! use schuler::trajectory::series::Series;
//!
//! // t about t = 2, and 1/√t there: 2^(−½) − ½·2^(−3/2)·u + …
//! let t = Series::<3>([2.0, 1.0, 0.0]);
//! let root = t.reciprocal_root();
//! assert!((root.0[1] + 0.5 * 2.0_f64.powf(-1.5)).abs() < 1e-16);
//! assert!((root * root * t - Series::constant(1.0)).0.iter().all(|c| c.abs() < 1e-15));
//! ```

use crate::math::real::Real;
use core::ops::{Add, Mul, Neg, Sub};

/// The first `N` Taylor coefficients of a function, in the unit of its value per secondᵏ.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Series<const N: usize>(pub [f64; N]);

impl<const N: usize> Default for Series<N> {
    fn default() -> Self {
        Self::ZERO
    }
}

impl<const N: usize> Series<N> {
    /// 0.
    pub const ZERO: Self = Self([0.0; N]);

    /// A function that does not change.
    #[inline]
    pub fn constant(value: f64) -> Self {
        let mut this = Self::ZERO;
        if let Some(first) = this.0.first_mut() {
            *first = value;
        }
        this
    }

    /// The coefficient of a power, 0 beyond the last one.
    #[inline(always)]
    pub fn coefficient(&self, power: usize) -> f64 {
        self.0.get(power).copied().unwrap_or(0.0)
    }

    /// The value at the instant.
    #[inline(always)]
    pub fn value(&self) -> f64 {
        self.coefficient(0)
    }

    /// Its first coefficients.
    #[inline(always)]
    pub fn first<const M: usize>(&self) -> Series<M> {
        let mut start = Series::ZERO;
        for (to, from) in start.0.iter_mut().zip(self.0) {
            *to = from;
        }
        start
    }

    /// With a number added.
    #[inline(always)]
    pub fn plus(mut self, constant: f64) -> Self {
        if let Some(first) = self.0.first_mut() {
            *first += constant;
        }
        self
    }

    /// Times a number.
    #[inline(always)]
    pub fn scaled(self, factor: f64) -> Self {
        Self(self.0.map(|c| c * factor))
    }

    /// x^(−½); the value must be positive.
    #[inline(always)]
    pub fn reciprocal_root(self) -> Self {
        let mut root = Self::ZERO;
        for n in 0..N {
            root.set(n, self.root_term(&root, n));
        }
        root
    }

    /// Coefficient `n` of x^(−½) from those before it.
    #[inline(always)]
    pub(crate) fn root_term(&self, root: &Self, n: usize) -> f64 {
        // k = g^p:  g k' = p g' k,  k_n = Σ_{j=1..n} (p j − (n − j)) g_j k_{n−j}/(n g₀),  p = −½
        let value = self.value();
        if n == 0 {
            return 1.0 / Real::sqrt(value);
        }
        let mut sum = 0.0;
        for j in 1..=n {
            let weight = -0.5 * j as f64 - (n - j) as f64;
            sum += weight * self.coefficient(j) * root.coefficient(n - j);
        }
        // 1/g₀ = k₀²
        let first = root.value();
        sum * (first * first) * (1.0 / n as f64)
    }

    /// Coefficient `n` of a product.
    #[inline(always)]
    pub(crate) fn product_term(&self, b: &Self, n: usize) -> f64 {
        // (a b)_n = Σ_{i=0..n} a_i b_{n−i}
        (0..=n).fold(0.0, |sum, i| sum + self.coefficient(i) * b.coefficient(n - i))
    }

    /// 1/x; the value must not be 0.
    #[inline]
    pub fn reciprocal(self) -> Self {
        let mut inverse = Self::ZERO;
        for n in 0..N {
            inverse.set(n, self.inverse_term(&inverse, n));
        }
        inverse
    }

    /// Coefficient `n` of 1/x from those before it.
    #[inline]
    pub(crate) fn inverse_term(&self, inverse: &Self, n: usize) -> f64 {
        // x r = 1:  r_n = −r₀ Σ_{j=1..n} x_j r_{n−j}
        if n == 0 {
            return 1.0 / self.value();
        }
        let sum =
            (1..=n).fold(0.0, |sum, j| sum + self.coefficient(j) * inverse.coefficient(n - j));
        -sum * inverse.value()
    }

    /// Sine and cosine.
    pub fn sin_cos(self) -> (Self, Self) {
        // s' = x'c, c' = −x's:  s_n = Σ j x_j c_{n−j}/n,  c_n = −Σ j x_j s_{n−j}/n
        let (s, c) = Real::sin_cos(self.value());
        let (mut sine, mut cosine) = (Self::constant(s), Self::constant(c));
        for n in 1..N {
            let (mut up, mut down) = (0.0, 0.0);
            for j in 1..=n {
                let slope = j as f64 * self.coefficient(j);
                up += slope * cosine.coefficient(n - j);
                down += slope * sine.coefficient(n - j);
            }
            sine.set(n, up / n as f64);
            cosine.set(n, -down / n as f64);
        }
        (sine, cosine)
    }

    /// The derivative; its last coefficient is not known and 0.
    #[inline(always)]
    pub fn derivative(self) -> Self {
        Self(core::array::from_fn(|n| (n + 1) as f64 * self.coefficient(n + 1)))
    }

    /// The value after a time, s, by Horner's rule.
    #[inline]
    pub fn after(&self, time_s: f64) -> f64 {
        self.0.iter().rev().fold(0.0, |sum, c| sum * time_s + c)
    }

    /// What a time, s, adds to the value.
    #[inline]
    pub fn growth(&self, time_s: f64) -> f64 {
        self.0.iter().skip(1).rev().fold(0.0, |sum, c| sum * time_s + c) * time_s
    }

    /// The integral from the instant on; the last coefficient of the function has no place in it.
    pub fn integral(&self) -> Self {
        let mut integral = Self::ZERO;
        for n in 1..N {
            integral.set(n, self.coefficient(n - 1) / n as f64);
        }
        integral
    }

    /// Sets the coefficient of a power below `N`.
    #[inline(always)]
    pub fn set(&mut self, power: usize, coefficient: f64) {
        if let Some(place) = self.0.get_mut(power) {
            *place = coefficient;
        }
    }
}

impl<const N: usize> Add for Series<N> {
    type Output = Self;
    #[inline(always)]
    fn add(mut self, b: Self) -> Self {
        for (a, b) in self.0.iter_mut().zip(b.0) {
            *a += b;
        }
        self
    }
}

impl<const N: usize> Sub for Series<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(mut self, b: Self) -> Self {
        for (a, b) in self.0.iter_mut().zip(b.0) {
            *a -= b;
        }
        self
    }
}

impl<const N: usize> Neg for Series<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0.map(|c| -c))
    }
}

impl<const N: usize> Mul for Series<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        // (a b)_n = Σ_{i=0..n} a_i b_{n−i}
        let mut product = Self::ZERO;
        for (i, a) in self.0.iter().enumerate() {
            for (place, b) in product.0.iter_mut().skip(i).zip(b.0) {
                *place += a * b;
            }
        }
        product
    }
}
