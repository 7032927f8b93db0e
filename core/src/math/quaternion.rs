//! Rotations: unit quaternions, and small rotations that are stored as q − 1.
//!
//! `q` with subscript b→n takes body components to navigation components:
//! xⁿ = q ⊗ xᵇ ⊗ q*. A rotation by a small angle is kept as e = q − 1, which does not lose bits beside 1.
//!
//! ```
//! use schuler::math::{quaternion::Quaternion, vector::Vector};
//!
//! // A quarter turn about the third axis takes forward to right.
//! let half = core::f64::consts::FRAC_PI_4;
//! let quarter = Quaternion::new(half.cos(), Vector::new(0.0, 0.0, half.sin()));
//! let turned = quarter.matrix(1.0) * Vector::new(1.0, 0.0, 0.0);
//! assert!((turned - Vector::new(0.0, 1.0, 0.0)).norm() < 1e-15);
//! ```

use super::real::{Number, Real};
use super::vector::Vector;
use core::ops::{Add, Mul, Sub};

/// A quaternion: scalar part, then vector part (Hamilton's product).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Quaternion<T> {
    /// Scalar part.
    pub w: T,
    /// Vector part.
    pub v: Vector<T>,
}

impl<T: Number> Quaternion<T> {
    /// q*, the opposite rotation.
    #[inline(always)]
    pub fn conjugate(self) -> Self {
        Self { w: self.w, v: -self.v }
    }

    /// (R − I)x for the rotation 1 + self: what the rotation adds to a vector.
    #[inline(always)]
    pub fn turn_less_one(self, x: Vector<T>) -> Vector<T> {
        // t = 2 eᵥ × x,  (R − I)x = (1 + eₛ)t + eᵥ × t
        let t = self.v.cross(x);
        let t = t + t;
        t + t * self.w + self.v.cross(t)
    }

    /// The rotation matrix of a unit quaternion.
    #[inline(always)]
    pub fn matrix(self, one: T) -> Matrix<T> {
        let Self { w, v: Vector { x, y, z } } = self;
        let (x2, y2, z2) = (x + x, y + y, z + z);
        let (xx, yy, zz) = (x * x2, y * y2, z * z2);
        let (xy, xz, yz) = (x * y2, x * z2, y * z2);
        let (wx, wy, wz) = (w * x2, w * y2, w * z2);
        Matrix {
            rows: [
                Vector::new(one - (yy + zz), xy - wz, xz + wy),
                Vector::new(xy + wz, one - (xx + zz), yz - wx),
                Vector::new(xz - wy, yz + wx, one - (xx + yy)),
            ],
        }
    }
}

impl<T> Quaternion<T> {
    /// From scalar and vector part.
    #[inline(always)]
    pub const fn new(w: T, v: Vector<T>) -> Self {
        Self { w, v }
    }

    /// The same function of each component.
    #[inline(always)]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Quaternion<U> {
        Quaternion { w: f(self.w), v: self.v.map(f) }
    }

    /// Scalar part first, to write.
    #[inline(always)]
    pub fn each_mut(&mut self) -> [&mut T; 4] {
        [&mut self.w, &mut self.v.x, &mut self.v.y, &mut self.v.z]
    }
}

impl<R: Real> Quaternion<R> {
    /// The zero quaternion: no rotation, in the form less one.
    pub const ZERO: Self = Self::new(R::ZERO, Vector::ZERO);
    /// No rotation.
    pub const IDENTITY: Self = Self::new(R::ONE, Vector::ZERO);

    /// The rotation 1 + self brought back to unit length, still less one (one Newton step).
    #[inline(always)]
    pub fn normalised_less_one(self) -> Self {
        // e ← e − ½(2eₛ + |e|²)(1 + e)
        let k = self.excess();
        Self { w: self.w - k * (R::ONE + self.w), v: self.v - self.v * k }
    }

    /// |1 + self| − 1 to first order: ½(2eₛ + |e|²).
    #[inline(always)]
    pub fn excess(self) -> R {
        (self.w + self.w + self.dot(self)) * R::HALF
    }

    /// Brought back to unit length by one Newton step.
    #[inline(always)]
    pub fn normalised(self) -> Self {
        // q ← q(3 − |q|²)/2
        self * (R::of(1.5) - R::HALF * self.dot(self))
    }

    /// The four-dimensional scalar product.
    #[inline(always)]
    pub fn dot(self, b: Self) -> R {
        self.w * b.w + self.v.dot(b.v)
    }

    /// The rotation vector of a unit quaternion, radians, of length at most π.
    pub fn rotation_vector(self) -> Vector<R> {
        let back = self.w.less(R::ZERO);
        let q = self.map(|c| R::select(back, -c, c));
        // φ = 2 atan2(|v|, w) v/|v|, and 2v/w where |v| vanishes
        let length = q.v.norm();
        let none = length.less(R::of(1e-18));
        let divisor = R::select(none, R::ONE, length);
        let factor = R::select(none, R::TWO, R::TWO * length.atan2(q.w) / divisor);
        q.v * factor
    }
}

impl<T: Number> Mul for Quaternion<T> {
    type Output = Self;
    /// a ⊗ b: first b, then a.
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        let (p, q) = (self.v, b.v);
        Self {
            w: self.w * b.w - p.dot(q),
            v: Vector {
                x: self.w * q.x + p.x * b.w + p.y * q.z - p.z * q.y,
                y: self.w * q.y + p.y * b.w + p.z * q.x - p.x * q.z,
                z: self.w * q.z + p.z * b.w + p.x * q.y - p.y * q.x,
            },
        }
    }
}

impl<T: Number> Add for Quaternion<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        Self { w: self.w + b.w, v: self.v + b.v }
    }
}

impl<T: Number> Sub for Quaternion<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        Self { w: self.w - b.w, v: self.v - b.v }
    }
}

impl<T: Number> Mul<T> for Quaternion<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, k: T) -> Self {
        Self { w: self.w * k, v: self.v * k }
    }
}

/// A 3 × 3 matrix by rows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Matrix<T> {
    /// The rows, first to third.
    pub rows: [Vector<T>; 3],
}

impl<T: Number> Matrix<T> {
    /// The transpose: the inverse of a rotation.
    #[inline(always)]
    pub fn transpose(self) -> Self {
        let [a, b, c] = self.rows;
        Self {
            rows: [
                Vector::new(a.x, b.x, c.x),
                Vector::new(a.y, b.y, c.y),
                Vector::new(a.z, b.z, c.z),
            ],
        }
    }
}

impl<T> Matrix<T> {
    /// The same function of each element.
    #[inline(always)]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Matrix<U> {
        Matrix { rows: self.rows.map(|row| row.map(&mut f)) }
    }
}

impl<T> From<[[T; 3]; 3]> for Matrix<T> {
    #[inline(always)]
    fn from(rows: [[T; 3]; 3]) -> Self {
        Self { rows: rows.map(Vector::from) }
    }
}

impl<T: Number> Mul<Vector<T>> for Matrix<T> {
    type Output = Vector<T>;
    #[inline(always)]
    fn mul(self, x: Vector<T>) -> Vector<T> {
        let [a, b, c] = self.rows;
        Vector::new(a.dot(x), b.dot(x), c.dot(x))
    }
}
