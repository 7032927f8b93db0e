//! The states of a filter, and its noise: configuration, apart from the filter's state.
//!
//! ```
//! use schuler::aiding::model::Model;
//! use schuler::aiding::states::{Extra, Process, resonator::Resonator};
//!
//! let bias = Process::constant(1e-7);
//! let model = Model::new(1e-6_f64, 1e-4, bias, bias);
//! let sway = Resonator { rms_m: 0.3, rate: 0.9, damping: 0.05 };
//! let model = model.with(Extra::Resonator(sway)).unwrap();
//! assert_eq!((model.states(), model.first(0)), (21, Some(15)));
//! ```

use super::states::{Extra, Process};
use super::transition::{BIASES, NAVIGATION, StepNoise};
use crate::math::real::Real;

/// The first gyro bias.
pub const GYRO_BIAS: usize = NAVIGATION;
/// The first accelerometer bias.
pub const ACCELEROMETER_BIAS: usize = NAVIGATION + BIASES / 2;
/// The first further state.
pub const FIRST_EXTRA: usize = NAVIGATION + BIASES;
/// Groups of further states at most.
pub const MOST_EXTRAS: usize = 4;
/// Seconds from one noise of the biases to the next.
pub(super) const BIAS_EVERY_S: f64 = 1.0;

/// What a filter estimates, and the noise of what it rests on.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Model<R> {
    /// White noise of the sensors.
    pub noise: StepNoise<R>,
    /// Each gyro's bias, rad/s.
    pub gyro_bias: Process<R>,
    /// Each accelerometer's bias, m/s².
    pub accelerometer_bias: Process<R>,
    extras: [Option<Extra<R>>; MOST_EXTRAS],
}

impl<R: Real> Model<R> {
    /// Nine navigation errors and six biases, from the angle random walk (rad/√s) and the velocity random walk
    /// (m/s/√s).
    pub const fn new(
        gyro_noise: R,
        accelerometer_noise: R,
        gyro_bias: Process<R>,
        accelerometer_bias: Process<R>,
    ) -> Self {
        let noise = StepNoise { gyro: gyro_noise, accelerometer: accelerometer_noise };
        Self { noise, gyro_bias, accelerometer_bias, extras: [None; MOST_EXTRAS] }
    }

    /// With a further group of states; `None` if there are [`MOST_EXTRAS`] already.
    pub fn with(mut self, extra: Extra<R>) -> Option<Self> {
        *self.extras.iter_mut().find(|slot| slot.is_none())? = Some(extra);
        Some(self)
    }

    /// The groups of further states, with the number of the first state of each.
    pub fn extras(&self) -> impl Iterator<Item = (usize, &Extra<R>)> {
        let mut next = FIRST_EXTRA;
        self.extras.iter().flatten().map(move |extra| {
            let first = next;
            next += extra.states();
            (first, extra)
        })
    }

    /// The first state of a group.
    pub fn first(&self, group: usize) -> Option<usize> {
        self.extras().nth(group).map(|(first, _)| first)
    }

    /// The number of states.
    pub fn states(&self) -> usize {
        FIRST_EXTRA + self.extras().map(|(_, extra)| extra.states()).sum::<usize>()
    }
}
