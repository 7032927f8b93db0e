//! What an inertial unit delivers: instantaneous rates, or increments over a sample.
//!
//! The two are different types, since taking one for the other is the field's commonest and
//! costliest mistake. A sample's time is the end of its interval.

use crate::math::vector::Vector;

/// Instantaneous rates of the body frame (forward, right, down).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rates<R> {
    /// Angular rate of the body against inertial space, ω_ibᵇ, rad/s.
    pub rate_ib_b: Vector<R>,
    /// Specific force, fᵇ, m/s²: what an accelerometer feels (−g upwards at rest).
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
