//! Three components along one frame's axes.
//!
//! ```
//! use schuler::math::vector::Vector;
//!
//! let north = Vector::new(1.0_f64, 0.0, 0.0);
//! let east = Vector::new(0.0, 1.0, 0.0);
//! assert_eq!(north.cross(east), Vector::new(0.0, 0.0, 1.0));
//! assert_eq!((north * 3.0 + east * 4.0).norm(), 5.0);
//! ```

use super::real::{Number, Real};
use core::ops::{Add, Mul, Neg, Sub};

/// A vector; its frame is in the name of the variable that holds it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Vector<T> {
    /// First axis: north, forward, or Earth-fixed x.
    pub x: T,
    /// Second axis: east, right, or Earth-fixed y.
    pub y: T,
    /// Third axis: down, or Earth-fixed z.
    pub z: T,
}

impl<T: Number> Vector<T> {
    /// a × b.
    #[inline(always)]
    pub fn cross(self, b: Self) -> Self {
        Self {
            x: self.y * b.z - self.z * b.y,
            y: self.z * b.x - self.x * b.z,
            z: self.x * b.y - self.y * b.x,
        }
    }

    /// The products of each pair of components.
    #[inline(always)]
    pub fn times(self, b: Self) -> Self {
        Self { x: self.x * b.x, y: self.y * b.y, z: self.z * b.z }
    }

    /// a · b.
    #[inline(always)]
    pub fn dot(self, b: Self) -> T {
        self.x * b.x + self.y * b.y + self.z * b.z
    }
}

impl<T> Vector<T> {
    /// From its components.
    #[inline(always)]
    pub const fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }

    /// The same function of each component.
    #[inline(always)]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Vector<U> {
        Vector { x: f(self.x), y: f(self.y), z: f(self.z) }
    }

    /// The same function of each pair of components.
    #[inline(always)]
    pub fn zip<U, V>(self, b: Vector<U>, mut f: impl FnMut(T, U) -> V) -> Vector<V> {
        Vector { x: f(self.x, b.x), y: f(self.y, b.y), z: f(self.z, b.z) }
    }

    /// The components in order.
    #[inline(always)]
    pub fn into_array(self) -> [T; 3] {
        [self.x, self.y, self.z]
    }

    /// The components in order, to write.
    #[inline(always)]
    pub fn each_mut(&mut self) -> [&mut T; 3] {
        [&mut self.x, &mut self.y, &mut self.z]
    }
}

impl<T> From<[T; 3]> for Vector<T> {
    #[inline(always)]
    fn from([x, y, z]: [T; 3]) -> Self {
        Self { x, y, z }
    }
}

impl<R: Real> Vector<R> {
    /// The zero vector.
    pub const ZERO: Self = Self::new(R::ZERO, R::ZERO, R::ZERO);

    /// |a|.
    pub fn norm(self) -> R {
        self.dot(self).sqrt()
    }

    /// Every component finite and within ±bound.
    #[inline(always)]
    pub fn is_within(self, bound: R) -> bool {
        self.x.is_within(bound) & self.y.is_within(bound) & self.z.is_within(bound)
    }
}

impl<T: Number> Add for Vector<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        Self { x: self.x + b.x, y: self.y + b.y, z: self.z + b.z }
    }
}

impl<T: Number> Sub for Vector<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        Self { x: self.x - b.x, y: self.y - b.y, z: self.z - b.z }
    }
}

impl<T: Number> Neg for Vector<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y, z: -self.z }
    }
}

impl<T: Number> Mul<T> for Vector<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, k: T) -> Self {
        Self { x: self.x * k, y: self.y * k, z: self.z * k }
    }
}
