//! What an inertial unit delivers: instantaneous rates, or increments over a sample.
//!
//! The two are different types, because confusing them is a common and costly mistake. A sample's
//! time is the end of its interval.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//!
//! // A sample of 10 ms at rest, level: gravity upwards.
//! let sample = Increment { angle_b: Vector::ZERO, velocity_b: Vector::new(0.0, 0.0, -9.81 * 0.01) };
//! assert_eq!(sample.angle_b.norm(), 0.0);
//! ```

use crate::math::real::Real;
use crate::math::real::Twin as _;
use crate::math::vector::Vector;

/// Instantaneous rates of the body frame (forward, right, down).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rates<R> {
    /// Angular rate of the body against inertial space, ω_ibᵇ, rad/s.
    pub rate_ib_b: Vector<R>,
    /// Specific force, fᵇ, m/s²: what an accelerometer measures (at rest −g, that is, gravity's magnitude upwards).
    pub specific_force_b: Vector<R>,
}

/// Integrals of the rates over one sample.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Increment<R> {
    /// Δθ = ∫ω_ibᵇ dt, rad.
    pub angle_b: Vector<R>,
    /// Δv = ∫fᵇ dt, m/s.
    pub velocity_b: Vector<R>,
}

impl<R: Real> Increment<R> {
    /// No motion, no force.
    pub const ZERO: Self = Self { angle_b: Vector::ZERO, velocity_b: Vector::ZERO };

    /// The six numbers two by two: Δθ_x Δθ_y, Δθ_z Δv_x, Δv_y Δv_z.
    #[inline(always)]
    pub fn twins(&self) -> [R::Twin; 3] {
        let Self { angle_b: a, velocity_b: v } = self;
        [R::Twin::new(a.x, a.y), R::Twin::new(a.z, v.x), R::Twin::new(v.y, v.z)]
    }

    /// Back from [`Increment::twins`].
    #[inline(always)]
    pub fn from_twins([first, second, third]: [R::Twin; 3]) -> Self {
        let ((ax, ay), (az, vx), (vy, vz)) = (first.parts(), second.parts(), third.parts());
        Self { angle_b: Vector::new(ax, ay, az), velocity_b: Vector::new(vx, vy, vz) }
    }
}
