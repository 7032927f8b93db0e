//! Runge-Kutta on rates, flown like the navigators on increments.

use super::compared::Arithmetic;
use super::{Reader, Unavailable};
use crate::scene::Precision;
use schuler::math::coarse::Coarse;
use schuler::math::real::Scalar;
use schuler::output::Output as _;
use schuler::sample::Rates;
use schuler::solution::Solution;
use schuler::strapdown::limits::{Rejected, StartError};
use schuler::strapdown::reference::rk4::{RungeKutta, RungeKuttaState, STEP_SAMPLES};

/// A navigator on instantaneous rates in flight. The first rates are those of the start.
pub trait NavigateRates {
    /// Takes the rates at the end of a sample, and reads the row of a step that they complete.
    fn push(&mut self, rates: &Rates<f64>, read: &mut Reader) -> Result<(), Rejected>;
    /// Flies rates from the start again without reading a row: what a step costs.
    fn fly_unread(&self, rates: &[Rates<f64>]) -> Box<dyn FnMut() + '_>;
}

/// Starts it in some arithmetic, of which it compensates nothing, with a sampling interval in seconds.
pub fn start(
    arithmetic: Arithmetic,
    interval_s: f64,
    initial: &Solution<f64>,
) -> Result<Box<dyn NavigateRates>, Unavailable> {
    Ok(match (arithmetic, arithmetic.precision()) {
        (Arithmetic::Coarse, _) => Box::new(OnRates::<Coarse>::new(interval_s, initial)?),
        (_, Precision::F64) => Box::new(OnRates::<f64>::new(interval_s, initial)?),
        (_, Precision::F32 | Precision::F32x2) => {
            Box::new(OnRates::<f32>::new(interval_s, initial)?)
        }
    })
}

/// The core's Runge-Kutta navigator with its state.
struct OnRates<R: Scalar> {
    navigator: RungeKutta<R>,
    initial: Solution<R>,
    state: RungeKuttaState<R>,
    /// The rates of the step that is being filled, of which the first `filled` are known.
    step: [Rates<R>; 3],
    filled: usize,
    samples: u64,
}

impl<R: Scalar> OnRates<R> {
    fn new(interval_s: f64, initial: &Solution<f64>) -> Result<Self, StartError> {
        let navigator = RungeKutta::new(R::narrow(interval_s))?;
        let initial = Solution::narrow(initial);
        let state = navigator.start(&initial)?;
        let step = Default::default();
        Ok(Self { navigator, initial, state, step, filled: 0, samples: 0 })
    }
}

impl<R: Scalar> NavigateRates for OnRates<R> {
    fn push(&mut self, rates: &Rates<f64>, read: &mut Reader) -> Result<(), Rejected> {
        self.step[self.filled] = narrow(rates);
        self.filled += 1;
        if self.filled == self.step.len() {
            self.navigator.step(&mut self.state, &self.step)?;
            self.samples += u64::from(STEP_SAMPLES);
            self.step[0] = self.step[2];
            self.filled = 1;
            read(self.samples, &self.state.output().wide());
        }
        Ok(())
    }

    fn fly_unread(&self, rates: &[Rates<f64>]) -> Box<dyn FnMut() + '_> {
        let rates: Vec<Rates<R>> = rates.iter().map(narrow).collect();
        Box::new(move || {
            if let Ok(mut state) = self.navigator.start(&self.initial) {
                for step in rates.windows(3).step_by(STEP_SAMPLES as usize) {
                    if let Some(step) = step.first_chunk() {
                        // What cannot be right was refused in the flight itself.
                        let _ = self.navigator.step(&mut state, step);
                    }
                }
                std::hint::black_box(&state);
            }
        })
    }
}

fn narrow<R: Scalar>(rates: &Rates<f64>) -> Rates<R> {
    Rates {
        rate_ib_b: rates.rate_ib_b.map(R::narrow),
        specific_force_b: rates.specific_force_b.map(R::narrow),
    }
}
