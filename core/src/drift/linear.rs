//! The differential equation of small errors along a motion.
//!
//! An [`ErrorState`] compares Earth-fixed vectors, resolved along the true north, east and down: position
//! δr, velocity δv, and ψ, the small rotation from the true to the computed C_bᵉ. So its equation
//! holds at the poles too. [`MeridianShift`](super::meridian::MeridianShift) converts it to the drift that
//! is printed, in which truth and computed solution each have their own north, east and down.
//! Source: Groves, 2nd ed., §14.2.3 (Earth frame), here resolved along the true north, east and down
//! with the gradient of normal gravity; Titterton & Weston, 2nd ed., ch. 12.
//!
//! ```
//! use schuler::drift::linear::{ErrorDynamics, ErrorState};
//! use schuler::imu::rates;
//! use schuler::math::vector::Vector;
//! use schuler::trajectory::{Jet, Motion};
//!
//! let still = Motion {
//!     latitude: Jet { value: 0.8_f64, ..Jet::default() },
//!     altitude: Jet { value: 100.0, ..Jet::default() },
//!     ..Motion::default()
//! };
//! let dynamics = ErrorDynamics::new(&still, &rates(&still), false);
//! // A tilt of 1 mrad about east accelerates to the north, by about 10 mm/s².
//! let tilted = ErrorState { attitude: Vector::new(0.0, 1e-3, 0.0), ..ErrorState::default() };
//! assert!((dynamics.growth(&tilted).velocity.x.abs() - 9.8e-3).abs() < 1e-4);
//! ```

use crate::earth::{self, Radii};
use crate::math::quaternion::Matrix;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::sample::Rates;
use crate::trajectory::Motion;
use core::ops::{Add, Mul};

/// Differences of Earth-fixed vectors, computed less true, along the true north, east and down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ErrorState<R> {
    /// δr, m.
    pub position: Vector<R>,
    /// δv: of the velocity relative to the Earth, m/s.
    pub velocity: Vector<R>,
    /// ψ: C_bᵉ(computed) = (I + [ψ×])C_bᵉ(true), rad.
    pub attitude: Vector<R>,
}

/// The equation's coefficients at one instant of a motion.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ErrorDynamics<R> {
    /// C_bⁿ.
    body_to_ned: Matrix<R>,
    /// ω_ibᵇ, rad/s.
    rate_ib_b: Vector<R>,
    /// fⁿ, m/s².
    specific_force: Vector<R>,
    /// ω_ieⁿ, rad/s.
    earth_rate: Vector<R>,
    /// ω_enⁿ, rad/s.
    transport_rate: Vector<R>,
    /// Diagonal of ∂gⁿ/∂rⁿ, 1/s².
    gravity_gradient: Vector<R>,
    /// ∂g_D/∂r_N, 1/s².
    gravity_slope: R,
    /// Whether height and vertical velocity are those of the truth.
    vertical_held: bool,
}

impl<R: Real> ErrorDynamics<R> {
    /// At an instant of a motion at which perfect sensors read `rates`.
    pub fn new(motion: &Motion<R>, rates: &Rates<R>, vertical_held: bool) -> Self {
        let (s, c) = motion.latitude.value.sin_cos();
        let altitude = motion.altitude.value;
        let radii = Radii::at(s, c);
        let north_radius = radii.meridian + altitude;
        let body_to_ned = body_to_ned(motion);
        let gravity = earth::gravity(s, altitude);
        let (per_latitude, per_height) = earth::gradient::of_gravity(s, c, altitude);
        Self {
            body_to_ned,
            rate_ib_b: rates.rate_ib_b,
            specific_force: body_to_ned * rates.specific_force_b,
            earth_rate: earth::rotation_ned(s, c),
            transport_rate: motion.transport_rate(s, c),
            // Gravity γ(φ, h) turns with the vertical: −γ/(R_M + h), −γ/(R_N + h), −∂γ/∂h
            gravity_gradient: Vector::new(
                -(gravity / north_radius),
                -(gravity / (radii.prime_vertical + altitude)),
                -per_height,
            ),
            gravity_slope: per_latitude / north_radius,
            vertical_held,
        }
    }

    /// F·x: the rate of change of an error without sensor errors.
    #[inline]
    pub fn growth(&self, x: &ErrorState<R>) -> ErrorState<R> {
        let mut position = x.position;
        let mut velocity = x.velocity;
        if self.vertical_held {
            // With r_D held, δv_D = (ω_en × δr)_D follows from the horizontal errors.
            position.z = R::ZERO;
            velocity.z = self.transport_rate.cross(position).z;
        }
        let inertial_rate = self.earth_rate + self.transport_rate;
        // δṙ = δv − ω_en × δr
        let mut position_rate = velocity - self.transport_rate.cross(position);
        // δv̇ = ψ × f − (2ω_ie + ω_en) × δv + (∂g/∂r)δr    (Groves 14.48 and 14.49)
        let mut velocity_rate = x.attitude.cross(self.specific_force)
            - (self.earth_rate + inertial_rate).cross(velocity)
            + self.gravity_gradient.zip(position, |a, b| a * b);
        velocity_rate.z = velocity_rate.z + self.gravity_slope * position.x;
        // ψ̇ = −(ω_ie + ω_en) × ψ                             (Groves 14.48)
        let attitude_rate = x.attitude.cross(inertial_rate);
        if self.vertical_held {
            position_rate.z = R::ZERO;
            velocity_rate.z = R::ZERO;
        }
        ErrorState { position: position_rate, velocity: velocity_rate, attitude: attitude_rate }
    }

    /// G·u: what sensor errors add to the rate of change; `error` is the reading less the truth.
    #[inline]
    pub fn drive(&self, error: &Rates<R>) -> ErrorState<R> {
        // δv̇ = … + C_bⁿ δf,  ψ̇ = … + C_bⁿ δω
        let mut velocity = self.body_to_ned * error.specific_force_b;
        if self.vertical_held {
            velocity.z = R::ZERO;
        }
        ErrorState {
            position: Vector::ZERO,
            velocity,
            attitude: self.body_to_ned * error.rate_ib_b,
        }
    }

    /// The largest term that the linear equation leaves out, as a mean over attitude errors whose
    /// second moments E(ψψᵀ) are given: ½E(ψ × (ψ × f)) in the rate of velocity.
    pub fn second_order(&self, attitude: &Matrix<R>) -> ErrorState<R> {
        // ψ × (ψ × f) = ψ(ψ·f) − f|ψ|²
        let [first, second, third] = attitude.rows;
        let f = self.specific_force;
        let mut velocity = (*attitude * f - f * (first.x + second.y + third.z)) * R::HALF;
        if self.vertical_held {
            velocity.z = R::ZERO;
        }
        ErrorState { velocity, position: Vector::ZERO, attitude: Vector::ZERO }
    }

    /// F·G·e − Ġ·e: the input to x − G·e, for sensors whose integrals have the error e.
    ///
    /// x̂ = x − G·e obeys dx̂/dt = F·x̂ + (F·G − Ġ)e where dx/dt = F·x + G·ė.
    pub fn drive_of_integral(&self, error: &Rates<R>) -> ErrorState<R> {
        let direct = self.drive(error);
        // Ċ_bⁿ e = C_bⁿ(ω_ib × e) − (ω_ie + ω_en) × C_bⁿ e
        let inertial_rate = self.earth_rate + self.transport_rate;
        let turned = |e: Vector<R>| {
            self.body_to_ned * self.rate_ib_b.cross(e) - inertial_rate.cross(self.body_to_ned * e)
        };
        let mut velocity = turned(error.specific_force_b);
        if self.vertical_held {
            velocity.z = R::ZERO;
        }
        let turning =
            ErrorState { position: Vector::ZERO, velocity, attitude: turned(error.rate_ib_b) };
        self.growth(&direct) + turning * -R::ONE
    }
}

/// C_bⁿ = (Rx(γ)·Ry(θ)·Rz(ψ))ᵀ.
fn body_to_ned<R: Real>(motion: &Motion<R>) -> Matrix<R> {
    let (sr, cr) = motion.roll.value.sin_cos();
    let (sp, cp) = motion.pitch.value.sin_cos();
    let (sy, cy) = motion.yaw.value.sin_cos();
    Matrix {
        rows: [
            Vector::new(cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
            Vector::new(sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
            Vector::new(-sp, cp * sr, cp * cr),
        ],
    }
}

impl<R: Real> ErrorState<R> {
    /// Position, velocity, attitude; north, east, down of each.
    pub fn into_array(self) -> [R; 9] {
        let (Vector { x: a, y: b, z: c }, v, p) = (self.position, self.velocity, self.attitude);
        [a, b, c, v.x, v.y, v.z, p.x, p.y, p.z]
    }
}

impl<R> From<[R; 9]> for ErrorState<R> {
    fn from([a, b, c, d, e, f, g, h, i]: [R; 9]) -> Self {
        Self {
            position: Vector { x: a, y: b, z: c },
            velocity: Vector { x: d, y: e, z: f },
            attitude: Vector { x: g, y: h, z: i },
        }
    }
}

impl<R: Real> Add for ErrorState<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        Self {
            position: self.position + b.position,
            velocity: self.velocity + b.velocity,
            attitude: self.attitude + b.attitude,
        }
    }
}

impl<R: Real> Mul<R> for ErrorState<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, k: R) -> Self {
        Self {
            position: self.position * k,
            velocity: self.velocity * k,
            attitude: self.attitude * k,
        }
    }
}
