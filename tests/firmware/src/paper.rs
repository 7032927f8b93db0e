//! The paper's flight and sensors, bit for bit those of the host's built-in scene `paper`.

use core::f64::consts::{PI, TAU};
use schuler::noise::{Deviate, Stream, Streams};
use schuler::sensor::constant::Constant;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::gauss_markov::{GaussMarkov, GaussMarkovState};
use schuler::sensor::parameter::ParameterError;
use schuler::sensor::white::White;
use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing};
use schuler::trajectory::harmonic::{Channel, Channels, CourseError, Harmonic, HarmonicTrajectory};

/// Samples per second.
pub const RATE_HZ: f64 = 20.0;
/// The seed of the sensors' errors.
pub const SEED: u64 = 1;

const DEGREE: f64 = PI / 180.0;
const MICRO_G: f64 = 9.80665e-6;

/// The true motion: one harmonic in each channel.
pub type Course = HarmonicTrajectory<f64, 6>;

/// The true motion.
pub fn course() -> Result<Course, CourseError> {
    let swing = |amplitude| [Harmonic { amplitude, angular_rate: TAU / 7200.0, phase: 0.0 }];
    let (angle, height) = (swing(5.0 * DEGREE), swing(2000.0));
    let about = |offset| Channel { offset, rate: 0.0, harmonics: &angle };
    HarmonicTrajectory::new(Channels {
        roll: about(0.0),
        pitch: about(0.0),
        yaw: about(0.0),
        latitude: about(45.0 * DEGREE),
        longitude: about(100.0 * DEGREE),
        altitude: Channel { offset: 3500.0, rate: 0.0, harmonics: &height },
    })
}

/// The end of a sample, s.
pub fn time_s(sample: u32) -> f64 {
    f64::from(sample) / RATE_HZ
}

/// The sensors: no term but the paper's.
pub type Sensors<R> = Emulator<R, Gyro<R>, Accelerometer<R>>;

/// Constant drift, Gauss-Markov drift and white noise.
#[derive(Clone, Copy, Debug)]
pub struct Gyro<R> {
    constant: Constant<R>,
    gauss_markov: GaussMarkov<R>,
    white: White<R>,
}

/// A Gauss-Markov bias.
#[derive(Clone, Copy, Debug)]
pub struct Accelerometer<R> {
    gauss_markov: GaussMarkov<R>,
}

/// The branches of a sensor's streams that a triad of every term gives these.
const GAUSS_MARKOV: u64 = 2;
const WHITE: u64 = 3;

/// The sensors of a run of so many samples.
pub fn sensors<R: Deviate>(samples: u64) -> Result<Sensors<R>, ParameterError> {
    let timing = Timing::new(R::of(1.0 / RATE_HZ), samples)?;
    let each = |value: f64| [R::of(value); 3].into();
    let process = |rms| GaussMarkov::new(each(rms), each(720.0), timing);
    let drift = 0.1 * (DEGREE / 3600.0);
    let gyro = Gyro {
        constant: Constant::new(each(drift), timing)?,
        gauss_markov: process(drift)?,
        white: White::new(each(0.01 * (DEGREE / 60.0)), timing)?,
    };
    let accelerometer = Accelerometer { gauss_markov: process(100.0 * MICRO_G)? };
    Ok(Emulator::new(gyro, accelerometer, timing))
}

impl<R: Deviate> ErrorTerm<R> for Gyro<R> {
    type State = (GaussMarkovState<R>, [Stream; 3]);

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

impl<R: Deviate> ErrorTerm<R> for Accelerometer<R> {
    type State = GaussMarkovState<R>;

    fn start(&self, streams: Streams) -> Self::State {
        self.gauss_markov.start(streams.branch(GAUSS_MARKOV))
    }

    #[inline(always)]
    fn apply(&self, state: &mut Self::State, stimulus: &Stimulus<R>, reading: &mut Reading<R>) {
        self.gauss_markov.apply(state, stimulus, reading);
    }
}
