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

use crate::math::compensated::Pair;
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

impl<R: Real> Increment<R> {
    /// The integrals of rates that a unit has averaged over the sample, as most chips with a decimation
    /// filter do: mean times interval, without any error of integration.
    pub fn from_mean_rates(mean: &Rates<R>, interval_s: Pair<R>) -> Self {
        Self {
            angle_b: scaled(mean.rate_ib_b, interval_s),
            velocity_b: scaled(mean.specific_force_b, interval_s),
        }
    }

    /// The integrals of instantaneous rates over a sample, from those at its start and at its end: the
    /// trapezoid.
    ///
    /// Per sample of h seconds it is off by h³/12 times the second derivative of the rate. Of an
    /// oscillation of ω rad/s it so reads (ωh)²/12 too little: 0.08 % at 63 samples per cycle, 3 % at ten.
    /// Coning and sculling of the rates are lost in the same measure, and no navigator brings them back:
    /// where a unit can deliver increments, take those.
    pub fn from_rates(start: &Rates<R>, end: &Rates<R>, interval_s: Pair<R>) -> Self {
        // Δθ = ½h(ω₀ + ω₁) − h³ω″/12
        let mean = |a: Vector<R>, b: Vector<R>| (a + b) * R::HALF;
        let mean = Rates {
            rate_ib_b: mean(start.rate_ib_b, end.rate_ib_b),
            specific_force_b: mean(start.specific_force_b, end.specific_force_b),
        };
        Self::from_mean_rates(&mean, interval_s)
    }
}

/// A rate times an interval, of which both parts count: a rounded one would be an error of scale.
fn scaled<R: Real>(rate: Vector<R>, interval_s: Pair<R>) -> Vector<R> {
    rate * interval_s.hi + rate * interval_s.lo
}

/// Turns the rates of a unit into increments, sample by sample: [`Increment::from_rates`] with a memory of
/// the last rates.
///
/// ```
/// use schuler::prelude::*;
///
/// let navigator = Navigator4::<f32>::from_rate_hz(100.0)?;
/// # let level = Euler { roll: 0.0, pitch: 0.0, yaw: 0.0 };
/// # let mut state = navigator.start(&Solution::new(Geodetic::default(), Vector::ZERO, level))?;
/// let read = || Rates { rate_ib_b: Vector::ZERO, specific_force_b: Vector::new(0.0, 0.0, -9.78_f32) };
/// let interval_s = Pair::new(100.0).reciprocal();
/// // The rates at the start; then a sample whenever there are new ones.
/// let mut rates = RateIntegrator::new(read());
/// navigator.push(&mut state, rates.increment(read(), interval_s))?;
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RateIntegrator<R> {
    last: Rates<R>,
}

impl<R: Real> RateIntegrator<R> {
    /// With the rates at the instant that navigation starts at.
    pub fn new(first: Rates<R>) -> Self {
        Self { last: first }
    }

    /// The increment up to new rates, so many seconds after the last ones. The interval may be another one
    /// each time; then hand it to the navigator, too, with
    /// [`push_over`](crate::strapdown::mechanization::UnequalIntervals::push_over).
    pub fn increment(&mut self, rates: Rates<R>, interval_s: Pair<R>) -> Increment<R> {
        let increment = Increment::from_rates(&self.last, &rates, interval_s);
        self.last = rates;
        increment
    }
}
