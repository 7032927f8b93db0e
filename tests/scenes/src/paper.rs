//! The paper's flight and sensors: `host/simulator/scenes/paper.toml`.

use crate::channel::{channel, harmonic};
use crate::units::{DEGREE, DEGREE_PER_HOUR, DEGREE_PER_ROOT_HOUR, METRE, MICRO_G};
use schuler::math::vector::Vector;
use schuler::noise::random::{Axes, Random};
use schuler::noise::{Deviate, Streams};
use schuler::sensor::constant::Constant;
use schuler::sensor::gauss_markov::{GaussMarkov, GaussMarkovState};
use schuler::sensor::parameter::ParameterError;
use schuler::sensor::triad::Triad;
use schuler::sensor::white::White;
use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing};
use schuler::trajectory::harmonic::{Channels, Harmonic};

/// Samples per second.
pub const RATE_HZ: f64 = 20.0;
/// Samples of the whole flight, half an hour.
pub const SAMPLES: u64 = 36_000;
/// The seed of the sensors' errors.
pub const SEED: u64 = 1;

const SWING: &[Harmonic<f64>] = &[harmonic(5.0, 7200.0, 0.0, DEGREE)];
const CLIMB: &[Harmonic<f64>] = &[harmonic(2000.0, 7200.0, 0.0, METRE)];

/// The true motion: one harmonic in each channel.
pub const CHANNELS: Channels<'static, f64> = Channels {
    roll: channel(0.0, 0.0, SWING, DEGREE),
    pitch: channel(0.0, 0.0, SWING, DEGREE),
    yaw: channel(0.0, 0.0, SWING, DEGREE),
    latitude: channel(45.0, 0.0, SWING, DEGREE),
    longitude: channel(100.0, 0.0, SWING, DEGREE),
    altitude: channel(3500.0, 0.0, CLIMB, METRE),
};

/// Constant drift, Gauss-Markov drift and white noise: no term but the paper's.
#[derive(Clone, Copy, Debug)]
pub struct Gyro<R> {
    constant: Constant<R>,
    gauss_markov: GaussMarkov<R>,
    white: White<R>,
}

/// A Gauss-Markov bias: no term but the paper's.
#[derive(Clone, Copy, Debug)]
pub struct Accelerometer<R> {
    gauss_markov: GaussMarkov<R>,
}

/// The branches of a sensor's streams that a triad of every term gives these.
const GAUSS_MARKOV: u64 = 2;
const WHITE: u64 = 3;

/// 0.1 °/h of constant drift, 0.1 °/h of Gauss-Markov drift over 720 s, 0.01 °/√h of white noise.
pub fn gyro<R: Deviate>(timing: Timing<R>) -> Result<Gyro<R>, ParameterError> {
    Ok(Gyro {
        constant: Constant::new(each(0.1, DEGREE_PER_HOUR), timing)?,
        gauss_markov: process(0.1, DEGREE_PER_HOUR, timing)?,
        white: White::new(each(0.01, DEGREE_PER_ROOT_HOUR), timing)?,
    })
}

/// 100 µg of Gauss-Markov bias over 720 s.
pub fn accelerometer<R: Deviate>(timing: Timing<R>) -> Result<Accelerometer<R>, ParameterError> {
    Ok(Accelerometer { gauss_markov: process(100.0, MICRO_G, timing)? })
}

fn each<R: Deviate>(value: f64, unit: f64) -> Vector<R> {
    [R::of(value * unit); 3].into()
}

fn process<R: Deviate>(
    rms: f64,
    unit: f64,
    timing: Timing<R>,
) -> Result<GaussMarkov<R>, ParameterError> {
    GaussMarkov::new(each(rms, unit), each(720.0, 1.0), timing)
}

/// With every term there or not, as the program's scenes have it.
impl<R: Deviate> From<Gyro<R>> for Triad<R> {
    fn from(Gyro { constant, gauss_markov, white }: Gyro<R>) -> Self {
        Self {
            constant: Some(constant),
            gauss_markov: Some(gauss_markov),
            white: Some(white),
            ..Self::PERFECT
        }
    }
}

impl<R: Deviate> From<Accelerometer<R>> for Triad<R> {
    fn from(Accelerometer { gauss_markov }: Accelerometer<R>) -> Self {
        Self { gauss_markov: Some(gauss_markov), ..Self::PERFECT }
    }
}

impl<R: Random> ErrorTerm<R> for Gyro<R> {
    type State = (GaussMarkovState<R>, Axes<R>);

    fn start(&self, streams: Streams) -> Self::State {
        let gauss_markov = self.gauss_markov.start(streams.branch(GAUSS_MARKOV));
        (gauss_markov, self.white.start(streams.branch(WHITE)))
    }

    #[inline(always)]
    fn apply(&self, state: &mut Self::State, stimulus: &Stimulus<R>, reading: &mut Reading<R>) {
        self.constant.apply(&mut (), stimulus, reading);
        self.gauss_markov.apply(&mut state.0, stimulus, reading);
        self.white.apply(&mut state.1, stimulus, reading);
    }
}

impl<R: Random> ErrorTerm<R> for Accelerometer<R> {
    type State = GaussMarkovState<R>;

    fn start(&self, streams: Streams) -> Self::State {
        self.gauss_markov.start(streams.branch(GAUSS_MARKOV))
    }

    #[inline(always)]
    fn apply(&self, state: &mut Self::State, stimulus: &Stimulus<R>, reading: &mut Reading<R>) {
        self.gauss_markov.apply(state, stimulus, reading);
    }
}
