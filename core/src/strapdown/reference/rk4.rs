//! Classical Runge-Kutta on instantaneous rates: a standard of comparison for sensors without increments.
//!
//! A step spans two samples and takes the rates at its start, middle and end. The continuous equations
//! in Earth-fixed axes (Groves, 2nd ed., §5.3) are integrated as they stand; the local error is of the
//! fifth order in the step, the global one of the fourth.
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::math::vector::Vector;
//! use schuler::sample::Rates;
//! use schuler::solution::{Euler, Solution};
//! use schuler::strapdown::reference::rk4::RungeKutta;
//!
//! let at = Geodetic { latitude: 0.8_f64, longitude: 0.1, altitude: 100.0 };
//! let initial = Solution::new(at, Vector::ZERO, Euler::default());
//! let navigator = RungeKutta::new(0.01)?;
//! let mut state = navigator.start(&initial)?;
//! let rates = Rates { rate_ib_b: Vector::ZERO, specific_force_b: Vector::new(0.0, 0.0, -9.81) };
//! navigator.step(&mut state, &[rates; 3])?;
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

use crate::earth::ROTATION_RATE;
use crate::math::compensated::Pair;
use crate::math::quaternion::Quaternion;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::record::{Record, record};
use crate::sample::Rates;
use crate::solution::{EarthFixedSolution, Solution};
use crate::strapdown::frame::gravitation::Latitude;
use crate::strapdown::gate::{Gate, admit_start};
use crate::strapdown::limits::Limits;
use crate::strapdown::limits::{Rejected, StartError};
use crate::strapdown::place::check_earth_fixed;

/// Samples that a step spans.
pub const STEP_SAMPLES: u32 = 2;

/// Configuration of the Runge-Kutta navigator.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RungeKutta<R> {
    /// Half a step: the sampling interval, s.
    half: R,
    limits: Limits<R>,
}

/// State of the Runge-Kutta navigator, in Earth-fixed axes.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RungeKuttaState<R> {
    moving: Moving<R>,
    latitude: Latitude<R>,
    /// Change of latitude over the last half step, rad: the next one is predicted by it.
    half_change: R,
}

/// What the equations integrate, and their derivatives per second.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Moving<R> {
    position: Vector<R>,
    /// Relative to the Earth, m/s.
    velocity: Vector<R>,
    /// Body → Earth-fixed.
    attitude: Quaternion<R>,
}

impl<R: Real> Moving<R> {
    /// self + slope·t.
    #[inline(always)]
    fn moved(self, slope: &Self, t: R) -> Self {
        Self {
            position: self.position + slope.position * t,
            velocity: self.velocity + slope.velocity * t,
            attitude: self.attitude + slope.attitude * t,
        }
    }

    /// The equations of motion, with the gravitation at the position.
    #[inline(always)]
    fn slope(&self, gravitation: Vector<R>, rates: &Rates<R>) -> Self {
        let omega = R::of(ROTATION_RATE);
        let (r, v, q) = (self.position, self.velocity, self.attitude);
        // v̇ = C f + G − 2ω × v − ω × (ω × r)
        let mut acceleration = q.matrix(R::ONE) * rates.specific_force_b + gravitation;
        acceleration.x = acceleration.x + omega * (R::TWO * v.y + omega * r.x);
        acceleration.y = acceleration.y - omega * (R::TWO * v.x - omega * r.y);
        // q̇ = ½ q ⊗ ω_ibᵇ − ½ ω_ieᵉ ⊗ q
        let body = Quaternion::new(R::ZERO, rates.rate_ib_b * R::HALF);
        let earth = Quaternion::new(R::ZERO, Vector::new(R::ZERO, R::ZERO, omega * R::HALF));
        Self { position: v, velocity: acceleration, attitude: q * body - earth * q }
    }
}

impl<R: Real> RungeKutta<R> {
    /// With a sampling interval in seconds, half a step, and the default limits.
    ///
    /// # Errors
    ///
    /// [`StartError`] if the interval or a limit is out of range.
    pub fn new(interval_s: R) -> Result<Self, StartError> {
        let limits = Limits::default();
        Gate::new(interval_s, limits, 2)?;
        Ok(Self { half: interval_s, limits })
    }

    /// Starts from an initial solution, whose attitude is brought to unit length.
    ///
    /// # Errors
    ///
    /// [`StartError`] if the initial solution is out of range, or navigation cannot start at its place.
    pub fn start(&self, initial: &Solution<R>) -> Result<RungeKuttaState<R>, StartError> {
        let initial = admit_start(initial)?;
        let at = initial.to_earth_fixed();
        let (sine, cosine) = initial.position.latitude.hi.sin_cos();
        Ok(RungeKuttaState {
            moving: Moving {
                position: at.position_e.map(|c| c.hi),
                velocity: at.velocity_e.map(|c| c.hi),
                attitude: at.attitude.map(|c| c.hi),
            },
            latitude: Latitude { sine, cosine, change: R::ZERO },
            half_change: R::ZERO,
        })
    }

    /// Steps over two samples, given the rates at the start, in the middle and at the end. What is
    /// refused leaves the state as it was.
    ///
    /// # Errors
    ///
    /// [`Rejected`] if the rates are refused. The state is then unchanged.
    #[inline]
    pub fn step(
        &self,
        state: &mut RungeKuttaState<R>,
        rates: &[Rates<R>; 3],
    ) -> Result<(), Rejected> {
        for rates in rates {
            if !rates.rate_ib_b.is_within(self.limits.angular_rate) {
                return Err(Rejected::Angle);
            }
            if !rates.specific_force_b.is_within(self.limits.specific_force) {
                return Err(Rejected::Velocity);
            }
        }
        check_earth_fixed(state.moving.position)?;
        let [start, middle, end] = rates;
        let (half, y) = (self.half, state.moving);
        // k₁ = f(t, y), k₂ = f(t + ½h, y + ½h k₁), k₃ = f(t + ½h, y + ½h k₂), k₄ = f(t + h, y + h k₃)
        let k1 = y.slope(state.gravitation(y.position, false), start);
        let first = y.moved(&k1, half);
        let k2 = first.slope(state.gravitation(first.position, true), middle);
        let second = y.moved(&k2, half);
        let k3 = second.slope(state.gravitation(second.position, false), middle);
        let third = y.moved(&k3, half + half);
        let k4 = third.slope(state.gravitation(third.position, true), end);
        // y ← y + h/6 (k₁ + 2k₂ + 2k₃ + k₄)
        let sum = k1.moved(&k2, R::TWO).moved(&k3, R::TWO).moved(&k4, R::ONE);
        let moved = y.moved(&sum, half * R::of(1.0 / 3.0));
        state.moving = Moving { attitude: moved.attitude.normalised(), ..moved };
        Ok(())
    }
}

impl<R: Real> RungeKuttaState<R> {
    /// The gravitation at a position: half a step `ahead` of the last one, or next to it.
    #[inline(always)]
    fn gravitation(&mut self, position: Vector<R>, ahead: bool) -> Vector<R> {
        let before = self.latitude;
        self.latitude.change = if ahead { self.half_change } else { R::ZERO };
        let gravitation = self.latitude.gravitation(position);
        if ahead {
            // sin(φ₁ − φ₀), the change being small
            let after = self.latitude;
            self.half_change = after.sine * before.cosine - after.cosine * before.sine;
        }
        gravitation
    }

    /// Navigation at the end of the last step.
    pub fn output(&self) -> EarthFixedSolution<R> {
        EarthFixedSolution {
            position_e: self.moving.position.map(Pair::new),
            velocity_e: self.moving.velocity.map(Pair::new),
            attitude: self.moving.attitude.map(Pair::new),
        }
    }
}

impl<R: Record> Record for Moving<R> {
    record!(position, velocity, attitude);
}

impl<R: Record> Record for RungeKuttaState<R> {
    record!(moving, latitude, half_change);
}
