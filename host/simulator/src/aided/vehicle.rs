//! One run's navigator with its measurements.

use super::measurements::{self, Arrivals, Arriving};
use super::navigator::{self, Aids};
use super::report::Report;
use crate::input::InputError;
use crate::scene::Scene;
use crate::source::Source;
use schuler::aiding::aided::fault::AidedFault;
use schuler::sample::Increment;
use schuler::solution::Solution;

/// A run's navigator with its measurements.
pub struct AidedVehicle {
    navigator: Box<dyn Aids>,
    arriving: Arrivals,
    taken: u64,
}

impl AidedVehicle {
    /// At the start of a run; with `smoother`, its steps are kept.
    pub fn new(
        scene: &Scene,
        source: &Source,
        run: u64,
        initial: &Solution<f64>,
        smoother: bool,
    ) -> Result<Self, InputError> {
        let navigator = navigator::start(scene, initial, smoother)?;
        let arriving = measurements::of_run(scene, source, run);
        Ok(Self::with(navigator, arriving, scene.rate_hz))
    }

    /// A navigator with measurements in the order of their arrival.
    pub fn with(navigator: Box<dyn Aids>, arriving: Vec<Arriving>, rate_hz: f64) -> Self {
        Self { navigator, arriving: Arrivals::of(arriving, rate_hz), taken: 0 }
    }

    /// Takes the measurements that have arrived by the end of the next sample, and the sample.
    pub fn push(&mut self, sample: &Increment<f64>) -> Result<(), AidedFault> {
        self.taken += 1;
        while let Some(measured) = self.arriving.by(self.taken) {
            self.navigator.measure(&measured)?;
        }
        self.navigator.push(sample)
    }

    /// Takes what waits: the samples are at their end.
    pub fn finish(&mut self) -> Result<(), AidedFault> {
        self.navigator.finish()
    }

    /// The navigator.
    pub fn navigator(&self) -> &dyn Aids {
        self.navigator.as_ref()
    }

    /// What became of the measurements.
    pub fn report(&self) -> Report {
        self.navigator.report()
    }
}
