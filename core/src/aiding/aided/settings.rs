//! What an aided navigator rests on: sensors, first uncertainties, gates.
//!
//! ```
//! use schuler::aiding::aided::settings::{Settings, Start, States};
//! use schuler::aiding::states::Process;
//!
//! let bias = [5e-5_f64, 1e-3].map(Process::constant);
//! let states = States::new(3e-5, 8e-4, bias[0], bias[1]);
//! let start = Start { position_m: 1.0, velocity_m_s: 0.1, level_rad: 3e-3, heading_rad: 0.03 };
//! let settings = Settings::new(states, start);
//! assert_eq!((settings.states.count(), settings.patience), (15, 5));
//! ```

use super::fault::AidedFault;
use super::measured::Kind;
use crate::aiding::chi_square;
use crate::aiding::model::Model;
use crate::aiding::states::latency::Latency;
use crate::aiding::states::lever_arm::LeverArm;
use crate::aiding::states::scale::Scale;
use crate::aiding::states::{Extra, Process};
use crate::math::real::{Real, Scalar};
use crate::math::vector::Vector;

/// The longest lever arm, m.
pub const LONGEST_LEVER: f64 = 100.0;

/// What a filter estimates beside position, velocity and attitude, and its noise.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct States<R> {
    /// Angle random walk, rad/√s.
    pub gyro_noise: R,
    /// Velocity random walk, m/s/√s.
    pub accelerometer_noise: R,
    /// Each gyro's bias, rad/s.
    pub gyro_bias: Process<R>,
    /// Each accelerometer's bias, m/s².
    pub accelerometer_bias: Process<R>,
    /// The error of the antenna's lever arm, if it is estimated: three states.
    pub lever_arm: Option<LeverArm<R>>,
    /// How much earlier than told positions and velocities were true, if it is estimated.
    pub latency: Option<Latency<R>>,
    /// A barometer's bias, m.
    pub barometer_bias: Option<Process<R>>,
    /// An odometer's scale factor.
    pub odometer_scale: Option<Scale<R>>,
}

/// Where each further state is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Places {
    pub lever_arm: Option<usize>,
    pub latency: Option<usize>,
    pub barometer_bias: Option<usize>,
    pub odometer_scale: Option<usize>,
}

impl<R: Real> States<R> {
    /// Nine navigation errors and six biases.
    pub const fn new(
        gyro_noise: R,
        accelerometer_noise: R,
        gyro_bias: Process<R>,
        accelerometer_bias: Process<R>,
    ) -> Self {
        Self {
            gyro_noise,
            accelerometer_noise,
            gyro_bias,
            accelerometer_bias,
            lever_arm: None,
            latency: None,
            barometer_bias: None,
            odometer_scale: None,
        }
    }

    /// Their number.
    pub fn count(&self) -> usize {
        self.model().states()
    }

    /// The filter's model.
    pub fn model(&self) -> Model<R> {
        self.placed().0
    }

    /// The model, and where its further states are.
    pub(super) fn placed(&self) -> (Model<R>, Places) {
        let mut model = Model::new(
            self.gyro_noise,
            self.accelerometer_noise,
            self.gyro_bias,
            self.accelerometer_bias,
        );
        // There is room for as many groups as there can be.
        let mut add = |extra: Option<Extra<R>>| {
            let first = model.states();
            model = model.with(extra?)?;
            Some(first)
        };
        let places = Places {
            lever_arm: add(self.lever_arm.map(Extra::LeverArm)),
            latency: add(self.latency.map(Extra::Latency)),
            barometer_bias: add(self.barometer_bias.map(Extra::Number)),
            odometer_scale: add(self.odometer_scale.map(Extra::Scale)),
        };
        (model, places)
    }
}

/// Standard deviations of the errors at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Start<R> {
    /// Position, m per axis.
    pub position_m: R,
    /// Velocity, m/s per axis.
    pub velocity_m_s: R,
    /// Roll and pitch, rad.
    pub level_rad: R,
    /// Heading, rad. Above 0.1 it is looked for: until it is found, positions and velocities are not refused.
    pub heading_rad: R,
}

/// What a filter does when a sensor has been refused many times in a row.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Lockout {
    /// It counts it, and doubts itself: the last innovation becomes an uncertainty of its own.
    #[default]
    Inflate,
    /// It counts it, and goes on refusing.
    Keep,
}

/// An aided navigator's settings.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Settings<R> {
    /// States and noise.
    pub states: States<R>,
    /// First uncertainties.
    pub start: Start<R>,
    /// From the inertial unit to the antenna, in body axes, m.
    pub lever_b: Vector<R>,
    /// From the inertial unit to the barometer's port, m.
    pub barometer_lever_b: Vector<R>,
    /// From the inertial unit to the odometer: where wheels do not slip sideways, m.
    pub odometer_lever_b: Vector<R>,
    /// How often a vector that fits is refused.
    pub false_refusal: R,
    /// Refusals in a row that are a lockout.
    pub patience: u32,
    /// What a lockout leads to.
    pub lockout: Lockout,
    /// How long measurements wait for those that are still on their way, in samples. Then bits do not depend on
    /// transport. `None`: each is taken as soon as the navigator has passed its time.
    pub horizon_samples: Option<u32>,
    /// How much time a step of the filter covers, s, about.
    pub step_s: R,
}

impl<R: Real> Settings<R> {
    /// One in 10⁴ vectors that fit is refused, five refusals in a row are a lockout, steps of 0.1 s.
    pub fn new(states: States<R>, start: Start<R>) -> Self {
        Self {
            states,
            start,
            lever_b: Vector::ZERO,
            barometer_lever_b: Vector::ZERO,
            odometer_lever_b: Vector::ZERO,
            false_refusal: R::of(1e-4),
            patience: 5,
            lockout: Lockout::Inflate,
            horizon_samples: None,
            step_s: R::of(0.1),
        }
    }
}

/// The largest NIS by kind.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Limits<R> {
    one: R,
    two: R,
    three: R,
    six: R,
}

impl<R: Scalar> Limits<R> {
    fn new(probability: R) -> Self {
        let of = |degrees| chi_square::quantile(probability, degrees);
        Self { one: of(1), two: of(2), three: of(3), six: of(6) }
    }

    /// Of a kind.
    pub fn of(&self, kind: Kind) -> R {
        match kind.degrees() {
            1 => self.one,
            2 => self.two,
            3 => self.three,
            _ => self.six,
        }
    }
}

impl<R: Scalar> Settings<R> {
    /// Whether a filter of so many states can fly them; the limits of its gates.
    pub(super) fn admit(&self, states: usize) -> Result<Limits<R>, AidedFault> {
        let positive = |x: R| x > R::ZERO && x.is_within(R::of(1e6));
        let start = &self.start;
        let sound = self.states.count() <= states
            && positive(self.states.gyro_noise)
            && positive(self.states.accelerometer_noise)
            && self.states.gyro_bias.sigma().is_within(R::of(1e6))
            && self.states.accelerometer_bias.sigma().is_within(R::of(1e6))
            && positive(start.position_m)
            && positive(start.velocity_m_s)
            && positive(start.level_rad)
            && positive(start.heading_rad)
            && positive(self.step_s)
            && self.patience > 0
            && self.false_refusal > R::ZERO
            && self.false_refusal < R::HALF;
        if !sound {
            return Err(AidedFault::Settings);
        }
        let most = R::of(LONGEST_LEVER);
        let levers = [self.lever_b, self.odometer_lever_b, self.barometer_lever_b];
        if !levers.into_iter().all(|lever| lever.norm().is_within(most)) {
            return Err(AidedFault::Lever);
        }
        Ok(Limits::new(self.false_refusal))
    }
}
