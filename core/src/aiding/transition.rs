//! How navigation errors grow over a step, from the integrals that the body step has made.
//!
//! Errors are computed less true, in body axes (left-invariant): Ĉ = C·exp([ψ×]), δv = Cᵀ(v̂ − v), δr = Cᵀ(r̂ − r),
//! with v the velocity relative to inertial space; a bias is the true one less its estimate. In these
//! coordinates only the gravity gradient depends on the estimate, so that the equations hold at any heading error.
//! Source: Barrau and Bonnabel, IEEE Trans. Automatic Control 62 (2017), 1797 (the invariant error).
//!
//! ```
//! use schuler::aiding::transition::{Stretch, Transition};
//! use schuler::math::vector::Vector;
//!
//! // One second at rest, level: the specific force is 9.8 m/s² upwards.
//! let stretch = Stretch {
//!     time_s: 1.0,
//!     velocity: Vector::new(0.0, 0.0, -9.8),
//!     position: Vector::new(0.0, 0.0, -4.9),
//!     ..Stretch::default()
//! };
//! // A tilt of 1 mrad about the second axis: δv = ψ × u, along the first one.
//! let errors = [0.0_f64, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1e-3, 0.0];
//! let after = Transition::new(&stretch).of_errors(&errors);
//! assert!((after[3] + 9.8e-3).abs() < 1e-15 && (after[0] + 4.9e-3).abs() < 1e-15);
//! ```

use crate::math::quaternion::{Matrix, Quaternion};
use crate::math::real::{Number, Real};
use crate::math::vector::Vector;
use crate::record::{Record, record};
use crate::strapdown::block::body::BodyMotion;

/// Navigation errors: δr, δv, ψ.
pub const NAVIGATION: usize = 9;
/// Biases: of the gyros, of the accelerometers.
pub const BIASES: usize = 6;

/// The body's motion over one block or several, in the axes at its start.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stretch<R> {
    /// Duration, s.
    pub time_s: R,
    /// Rotation end → start, less one.
    pub rotation: Quaternion<R>,
    /// u = ∫Cf dt, m/s.
    pub velocity: Vector<R>,
    /// s = ∬Cf dt², m.
    pub position: Vector<R>,
}

impl<R: Real> Stretch<R> {
    /// No time.
    pub const NONE: Self = Self {
        time_s: R::ZERO,
        rotation: Quaternion::ZERO,
        velocity: Vector::ZERO,
        position: Vector::ZERO,
    };

    /// Goes on by a block.
    pub fn add(&mut self, body: &BodyMotion<R>, time_s: R) {
        // R = R₁R₂,  u = u₁ + R₁u₂,  s = s₁ + T₂u₁ + R₁s₂
        let turned = |x: Vector<R>| x + self.rotation.turn_less_one(x);
        let (gained, moved) = (turned(body.velocity), turned(body.position));
        self.position = self.position + self.velocity * time_s + moved;
        self.velocity = self.velocity + gained;
        let (a, b) = (self.rotation, body.rotation);
        self.rotation = (a + b + a * b).normalised_less_one();
        self.time_s = self.time_s + time_s;
    }
}

impl<R: Record> Record for Stretch<R> {
    record!(time_s, rotation, velocity, position);
}

/// Densities of the white noise of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StepNoise<R> {
    /// Angle random walk of each gyro, rad/√s.
    pub gyro: R,
    /// Velocity random walk of each accelerometer, m/s/√s.
    pub accelerometer: R,
}

/// The transition over a stretch, from its start to its end.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Transition<R> {
    time_s: R,
    /// Rᵀ: axes at the start → axes at the end.
    back: Matrix<R>,
    /// The rotation vector θ of R, to its third order.
    turn: Vector<R>,
    velocity: Vector<R>,
    position: Vector<R>,
    /// T·Γ in the axes at the end, 1/s.
    gradient: Matrix<R>,
}

/// Three vectors in one array.
fn joined<T: Copy>(a: Vector<T>, b: Vector<T>, c: Vector<T>) -> [T; NAVIGATION] {
    [a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z]
}

/// The matrix of a linear map.
pub(crate) fn matrix_of<R: Real>(map: impl Fn(Vector<R>) -> Vector<R>) -> Matrix<R> {
    let (zero, one) = (R::ZERO, R::ONE);
    let axes =
        [Vector::new(one, zero, zero), Vector::new(zero, one, zero), Vector::new(zero, zero, one)];
    Matrix { rows: axes.map(map) }.transpose()
}

/// [a×].
pub(crate) fn cross_matrix<R: Real>(a: Vector<R>) -> Matrix<R> {
    matrix_of(|x| a.cross(x))
}

/// k·A.
fn scaled<T: Number>(matrix: Matrix<T>, k: T) -> Matrix<T> {
    Matrix { rows: matrix.rows.map(|row| row * k) }
}

impl<R: Real> Transition<R> {
    /// In a uniform field of gravitation.
    pub fn new(stretch: &Stretch<R>) -> Self {
        let Stretch { time_s, rotation, velocity, position } = *stretch;
        let back = (Quaternion::IDENTITY + rotation).matrix(R::ONE).transpose();
        // sin ½θ·n = v:  θ = 2v(1 + |v|²/6 + …)
        let v = rotation.v;
        let turn = v * (R::TWO + v.dot(v) * R::ratio(1, 3));
        Self { time_s, back, turn, velocity, position, gradient: Matrix::default() }
    }

    /// With the gradient of gravitation Γ in the axes at the end, 1/s².
    pub fn with_gradient(self, gradient_b: &Matrix<R>) -> Self {
        Self { gradient: scaled(*gradient_b, self.time_s), ..self }
    }

    /// Its duration, s.
    pub fn time_s(&self) -> R {
        self.time_s
    }

    /// u = ∫Cf dt in the axes at the start, m/s.
    pub fn velocity(&self) -> Vector<R> {
        self.velocity
    }

    /// s = ∬Cf dt² in the axes at the start, m.
    pub fn position(&self) -> Vector<R> {
        self.position
    }

    /// TΓx.
    pub(super) fn fallen(&self, x: Vector<R>) -> Vector<R> {
        self.gradient * x
    }

    /// Jᵀx, J = ∫R dt.
    pub(super) fn integral_transposed(&self, x: Vector<R>) -> Vector<R> {
        // J = T(I + ½[θ×] + ⅙[θ×]² + …)
        let once = self.turn.cross(x);
        (x - once * R::HALF + self.turn.cross(once) * R::ratio(1, 6)) * self.time_s
    }

    /// Rᵀ: the rotation of a vector's components from the axes at the start to those at the end.
    pub fn back(&self) -> &Matrix<R> {
        &self.back
    }

    /// A·x: the errors at the end, without biases.
    #[inline(always)]
    pub fn of_errors(&self, x: &[R; NAVIGATION]) -> [R; NAVIGATION] {
        // ψ₁ = Rᵀψ,  δv₁ = Rᵀ(δv + ψ×u) + TΓRᵀδr,  δr₁ = Rᵀ(δr + Tδv + ψ×s)
        let [a, b, c, d, e, f, g, h, i] = *x;
        let (r, v, psi) = (Vector::new(a, b, c), Vector::new(d, e, f), Vector::new(g, h, i));
        let fallen = self.gradient * (self.back * r);
        let gained = self.back * (v + psi.cross(self.velocity));
        let moved = self.back * (r + v * self.time_s + psi.cross(self.position));
        joined(moved, gained + fallen, self.back * psi)
    }

    /// A·x + B·b: the errors at the end; b has the biases of the gyros, then of the accelerometers.
    #[inline(always)]
    pub fn of(&self, x: &[R; NAVIGATION], biases: &[R; BIASES]) -> [R; NAVIGATION] {
        // ψ + Jb_g,  δv + b_g×(Tu − s) + Jb_a,  δr + b_g×(Ts/3) + ½T²b_a,  then as without biases;
        // J = ∫R dt = T(I + ½[θ×] + ⅙[θ×]² + …)
        let t = self.time_s;
        let [gx, gy, gz, ax, ay, az] = *biases;
        let (gyro, force) = (Vector::new(gx, gy, gz), Vector::new(ax, ay, az));
        let integral = |b: Vector<R>| {
            let once = self.turn.cross(b);
            (b + once * R::HALF + self.turn.cross(once) * R::ratio(1, 6)) * t
        };
        let [a, b, c, d, e, f, g, h, i] = *x;
        let (r, v, psi) = (Vector::new(a, b, c), Vector::new(d, e, f), Vector::new(g, h, i));
        let fallen = self.gradient * (self.back * r);
        let late = self.velocity * t - self.position;
        let gained = v + psi.cross(self.velocity) + gyro.cross(late) + integral(force);
        let moved = r
            + v * t
            + psi.cross(self.position)
            + gyro.cross(self.position * (t * R::ratio(1, 3)))
            + force * (t * t * R::HALF);
        joined(self.back * moved, self.back * gained + fallen, self.back * (psi + integral(gyro)))
    }

    /// What unit noises of gyros and accelerometers, in the axes at the end, do to the errors there.
    #[inline(always)]
    pub(crate) fn noise_columns(&self) -> [[R; NAVIGATION]; 6] {
        // On average noise acts over half the step: ψ-noise gives δv by ψ × ½u, δv-noise gives δr by ½T.
        let (half, late) = (self.back * self.velocity * R::HALF, self.time_s * R::HALF);
        let (zero, one) = (R::ZERO, R::ONE);
        let axes = [
            Vector::new(one, zero, zero),
            Vector::new(zero, one, zero),
            Vector::new(zero, zero, one),
        ];
        let [gx, gy, gz] = axes.map(|axis| joined(Vector::ZERO, axis.cross(half), axis));
        let [ax, ay, az] = axes.map(|axis| joined(axis * late, axis, Vector::ZERO));
        [gx, gy, gz, ax, ay, az]
    }
}
