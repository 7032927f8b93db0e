//! The emulator: perfect increments in, the increments of real sensors out.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//! use schuler::sensor::{Timing, constant::Constant, emulator::Emulator, white::White};
//!
//! let timing = Timing::new(0.01_f64, 1000)?;
//! let axes = |x| Vector::new(x, x, x);
//! let gyro = (Constant::new(axes(5e-7), timing)?, White::new(axes(3e-6), timing)?);
//! // `()`: perfect accelerometers.
//! let emulator = Emulator::new(gyro, (), timing);
//! let mut state = emulator.start(1, 0);
//! let perfect = Increment { angle_b: Vector::ZERO, velocity_b: Vector::new(0.0, 0.0, -0.098) };
//! let read = emulator.emulate(&mut state, &perfect);
//! assert!(read.velocity_b == perfect.velocity_b && read.angle_b != perfect.angle_b);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::triad::Triad;
use super::{ErrorTerm, Reading, Stimulus, Timing};
use crate::math::vector::Vector;
use crate::noise::Streams;
use crate::noise::random::Random;
use crate::record::{Record, record};
use crate::sample::{Increment, Rates};

/// A triad of gyros and a triad of accelerometers.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Emulator<R, G, A> {
    gyro: G,
    accelerometer: A,
    timing: Timing<R>,
}

/// The state of the sensors of one run.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EmulatorState<G, A> {
    /// Of the gyros' terms.
    pub gyro: G,
    /// Of the accelerometers' terms.
    pub accelerometer: A,
    /// Samples in which some axis exceeded its limit, in any run.
    pub saturated: u64,
}

/// The state of an emulator made of these terms.
pub type State<R, G, A> = EmulatorState<<G as ErrorTerm<R>>::State, <A as ErrorTerm<R>>::State>;

impl<R: Random, G: ErrorTerm<R>, A: ErrorTerm<R>> Emulator<R, G, A> {
    /// From the error terms of the gyros and of the accelerometers, made for the same timing.
    pub fn new(gyro: G, accelerometer: A, timing: Timing<R>) -> Self {
        Self { gyro, accelerometer, timing }
    }

    /// The state before the first sample: a pure function of a seed and the number of a run.
    pub fn start(&self, seed: u64, run: u64) -> State<R, G, A> {
        let streams = Streams::new(seed, run);
        EmulatorState {
            gyro: self.gyro.start(streams.branch(Streams::GYRO)),
            accelerometer: self.accelerometer.start(streams.branch(Streams::ACCELEROMETER)),
            saturated: 0,
        }
    }

    /// What the sensors read in the next sample, given the truth.
    #[inline]
    pub fn emulate(&self, state: &mut State<R, G, A>, perfect: &Increment<R>) -> Increment<R> {
        let (increment, saturated) = self.emulate_marked(state, perfect);
        state.saturated += u64::from(R::any(saturated));
        increment
    }

    /// The same, with a mark in each run of a pack whose sensors were at a limit; the state does not count
    /// them.
    #[inline(always)]
    pub fn emulate_marked(
        &self,
        state: &mut State<R, G, A>,
        perfect: &Increment<R>,
    ) -> (Increment<R>, R::Mask) {
        let velocity_b = perfect.velocity_b;
        let gyro = read(&self.gyro, &mut state.gyro, perfect.angle_b, velocity_b);
        let accelerometer =
            read(&self.accelerometer, &mut state.accelerometer, velocity_b, velocity_b);
        let increment = Increment { angle_b: gyro.increment, velocity_b: accelerometer.increment };
        (increment, gyro.saturated | accelerometer.saturated)
    }

    /// The same for sensors that deliver rates: the errors of a sample, averaged over it, are added to the
    /// instantaneous rates. So white noise has a bandwidth of half the sample rate, a bias is its
    /// mean over the sample, and a quantized output moves in steps of the least significant bit divided by
    /// the interval. A component without error passes unchanged.
    #[inline]
    pub fn emulate_rates(&self, state: &mut State<R, G, A>, perfect: &Rates<R>) -> Rates<R> {
        let interval_s = self.timing.interval_s();
        let increment = Increment {
            angle_b: perfect.rate_ib_b * interval_s,
            velocity_b: perfect.specific_force_b * interval_s,
        };
        let read = self.emulate(state, &increment);
        Rates {
            rate_ib_b: self.rate(perfect.rate_ib_b, increment.angle_b, read.angle_b),
            specific_force_b: self.rate(
                perfect.specific_force_b,
                increment.velocity_b,
                read.velocity_b,
            ),
        }
    }

    /// The rate that is read, given the perfect rate and the increments without and with errors.
    #[inline]
    fn rate(&self, perfect: Vector<R>, before: Vector<R>, after: Vector<R>) -> Vector<R> {
        // a·Δt/Δt may differ from a by a unit in the last place.
        let read = before.zip(after, |b, a| (a.less(b) | b.less(a), a / self.timing.interval_s()));
        perfect.zip(read, |rate, (differs, read)| R::select(differs, read, rate))
    }
}

impl<R: Copy> Emulator<R, Triad<R>, Triad<R>> {
    /// The same sensors in numbers of another type, as `number` makes them from these: in lanes.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> Emulator<T, Triad<T>, Triad<T>> {
        Emulator {
            gyro: self.gyro.map(&number),
            accelerometer: self.accelerometer.map(&number),
            timing: self.timing.map(number),
        }
    }
}

#[inline(always)]
fn read<R: Random, T: ErrorTerm<R>>(
    term: &T,
    state: &mut T::State,
    sensed: Vector<R>,
    velocity_b: Vector<R>,
) -> Reading<R> {
    let mut reading = Reading::new(sensed);
    term.apply(state, &Stimulus { sensed, velocity_b }, &mut reading);
    reading
}

impl<G: Record, A: Record> Record for EmulatorState<G, A> {
    record!(gyro, accelerometer, saturated);
}
