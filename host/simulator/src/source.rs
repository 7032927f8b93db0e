//! The stream of samples of a scene: true motion, perfect increments, sensor errors, link.

pub use crate::course::Course;
use crate::emulator;
use crate::lanes::one::One;
use crate::lanes::pack::Lanes;
use crate::lanes::sensors::{Sensors, Terms, same};
use crate::lively;
use crate::scene::Scene;
use schuler::imu::{self, Quadrature};
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::noise::{Stream, Streams};
use schuler::sample::{Increment, Rates};
use schuler::sensor::parameter::ParameterError;
use schuler::sensor::triad::Triad;
use schuler::solution::Solution;
use schuler::trajectory::harmonic::CourseError;
use schuler::trajectory::{Motion, Trajectory};
use std::fmt;
use std::ops::Range;

/// Samples that are worked out at once where one run asks for one after the other.
const AT_ONCE: u64 = 64;

type EmulatorState = schuler::sensor::emulator::State<One, Triad<One>, Triad<One>>;

/// A scene that the core cannot build.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SourceError {
    /// Its motion.
    Trajectory(CourseError),
    /// A sensor parameter.
    Sensor(ParameterError),
}

impl fmt::Display for SourceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Trajectory(error) => error.fmt(f),
            Self::Sensor(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for SourceError {}

/// Truth and sensors of a scene.
pub struct Source {
    /// The motion.
    pub course: Course,
    /// The quadrature of its rates.
    pub quadrature: Quadrature,
    /// The sensors; `None` where they are perfect.
    pub emulator: Option<Terms<One>>,
    rate_hz: f64,
    seed: u64,
    loss: f64,
    jitter_s: f64,
    /// The increment of every sample, where nothing changes.
    constant: Option<Increment<f64>>,
}

impl Source {
    /// Of a scene. `force_all` skips nothing: every evaluation is made, every term is asked.
    pub fn new(scene: &Scene, force_all: bool) -> Result<Self, SourceError> {
        let course = scene.trajectory.build().map_err(SourceError::Trajectory)?;
        let interval_s = 1.0 / scene.rate_hz;
        let bandwidth = course.bound().bandwidth;
        let by_trial = course
            .path()
            .filter(|_| bandwidth > 0.0)
            .and_then(|path| lively::quadrature(&course, path, scene.rate_hz, scene.samples()));
        let planned = by_trial.unwrap_or_else(|| Quadrature::plan(bandwidth, interval_s));
        let quadrature = if force_all { planned.finest() } else { planned };
        let perfect = scene.gyro == Default::default() && scene.accelerometer == Default::default();
        let emulator = if perfect && !force_all {
            None
        } else {
            Some(emulator::build(scene).map_err(SourceError::Sensor)?.map(One))
        };
        let still = bandwidth == 0.0 && scene.link.jitter_s == 0.0 && !force_all;
        let constant = still.then(|| course.sample(quadrature, 1, scene.rate_hz));
        Ok(Self {
            course,
            quadrature,
            emulator,
            rate_hz: scene.rate_hz,
            seed: scene.seed,
            loss: scene.link.loss,
            jitter_s: scene.link.jitter_s,
            constant,
        })
    }

    /// Whether one increment serves for every sample.
    pub fn is_constant(&self) -> bool {
        self.constant.is_some()
    }

    /// Samples per second.
    pub fn rate_hz(&self) -> f64 {
        self.rate_hz
    }

    /// Nominal end of a sample, s; the start of the run is that of sample 0.
    pub fn time_s(&self, sample: u64) -> f64 {
        sample as f64 / self.rate_hz
    }

    /// The true state at the end of a sample.
    pub fn truth(&self, sample: u64) -> Solution<f64> {
        self.course.solution_at(self.instant(sample))
    }

    /// The true state at the end of a sample, to about twice the digits where they count: a start.
    pub fn initial(&self, sample: u64) -> Solution<f64> {
        self.course.initial_at(self.instant(sample))
    }

    /// What perfect sensors read at the end of a sample.
    pub fn rates(&self, sample: u64) -> Rates<f64> {
        self.course.rates_at(self.instant(sample))
    }

    fn instant(&self, sample: u64) -> Pair<f64> {
        imu::instant(sample as f64, self.rate_hz)
    }

    /// The true motion at the end of a sample.
    pub fn motion(&self, sample: u64) -> Motion<f64> {
        self.course.at_instant(self.instant(sample))
    }

    /// The perfect increment of the sample of a number, from 1.
    pub fn perfect_sample(&self, sample: u64) -> Increment<f64> {
        let sampled = || self.course.sample(self.quadrature, sample, self.rate_hz);
        self.constant.unwrap_or_else(sampled)
    }

    /// The perfect increments of samples of these numbers, from 1.
    pub fn perfect_samples(&self, numbers: Range<u64>) -> Vec<Increment<f64>> {
        let still = Increment { angle_b: Vector::ZERO, velocity_b: Vector::ZERO };
        let mut increments = vec![self.constant.unwrap_or(still); numbers.clone().count()];
        if self.constant.is_none() {
            self.course.samples(self.quadrature, numbers.start, self.rate_hz, &mut increments);
        }
        increments
    }

    /// The perfect increment between two times, s.
    pub fn perfect(&self, from_s: f64, to_s: f64) -> Increment<f64> {
        self.constant.unwrap_or_else(|| self.course.increment(self.quadrature, from_s, to_s))
    }

    /// Starts the sensors of run `first` and of those after it, one in each lane; `None` where they are
    /// perfect.
    pub fn start_lanes<P: Lanes<N>, const N: usize>(&self, first: u64) -> Option<Sensors<P, N>> {
        self.emulator.as_ref().map(|terms| Sensors::start(terms, self.seed, first))
    }

    /// Starts the stream of one run.
    pub fn start(&self, run: u64) -> Samples<'_> {
        let link = Streams::new(self.seed, run).branch(Streams::LINK);
        Samples {
            source: self,
            state: self.emulator.as_ref().map(|emulator| emulator.start(self.seed, run)),
            loss: link.branch(0).open(),
            jitter: link.branch(1).open(),
            ahead: Vec::new(),
            from: 0,
            sample: 0,
            end_s: 0.0,
        }
    }
}

/// What sensors make of a perfect increment.
#[inline]
pub fn emulate(
    emulator: &Terms<One>,
    state: &mut EmulatorState,
    perfect: &Increment<f64>,
) -> Increment<f64> {
    let read = emulator.emulate(state, &same(perfect));
    let plain = |v: Vector<One>| v.map(|One(x)| x);
    Increment { angle_b: plain(read.angle_b), velocity_b: plain(read.velocity_b) }
}

/// The samples of one run, in order and without end.
pub struct Samples<'a> {
    source: &'a Source,
    state: Option<EmulatorState>,
    loss: Stream,
    jitter: Stream,
    /// Perfect increments that were worked out at once, and the number of the first.
    ahead: Vec<Increment<f64>>,
    from: u64,
    sample: u64,
    /// When the last sample's interval really ended, s.
    end_s: f64,
}

impl Samples<'_> {
    /// The next sample; `None` if the link lost it.
    pub fn advance(&mut self) -> Option<Increment<f64>> {
        self.advance_seen().1
    }

    /// The next sample as it would be without error, and as it arrives.
    pub fn advance_seen(&mut self) -> (Increment<f64>, Option<Increment<f64>>) {
        let from_s = self.end_s;
        self.step();
        let perfect = if self.source.jitter_s > 0.0 {
            self.source.perfect(from_s, self.end_s)
        } else {
            self.perfect()
        };
        let increment = self.sense(&perfect);
        (perfect, self.arrives().then_some(increment))
    }

    /// The perfect increment of this sample.
    fn perfect(&mut self) -> Increment<f64> {
        if self.source.is_constant() || !self.source.course.is_for_lanes() {
            return self.source.perfect_sample(self.sample);
        }
        let ahead = usize::try_from(self.sample - self.from).ok();
        if let Some(increment) = ahead.and_then(|place| self.ahead.get(place)) {
            return *increment;
        }
        self.from = self.sample;
        self.ahead = self.source.perfect_samples(self.sample..self.sample + AT_ONCE);
        self.ahead[0]
    }

    /// What the sensors make of the next sample's perfect increment, which runs may share: a link
    /// that loses or delays samples is not asked.
    pub fn sense(&mut self, perfect: &Increment<f64>) -> Increment<f64> {
        match (&self.source.emulator, &mut self.state) {
            (Some(emulator), Some(state)) => emulate(emulator, state, perfect),
            _ => *perfect,
        }
    }

    /// The next sample as instantaneous rates at its end; `None` if the link lost it.
    pub fn advance_rates(&mut self) -> Option<Rates<f64>> {
        self.step();
        let mut rates = if self.source.jitter_s > 0.0 {
            self.source.course.rates_at(Pair::new(self.end_s))
        } else {
            self.source.rates(self.sample)
        };
        if let (Some(emulator), Some(state)) = (&self.source.emulator, &mut self.state) {
            let Rates { rate_ib_b, specific_force_b } = emulator.emulate_rates(
                state,
                &Rates {
                    rate_ib_b: rates.rate_ib_b.map(One),
                    specific_force_b: rates.specific_force_b.map(One),
                },
            );
            let plain = |v: Vector<One>| v.map(|One(x)| x);
            rates =
                Rates { rate_ib_b: plain(rate_ib_b), specific_force_b: plain(specific_force_b) };
        }
        self.arrives().then_some(rates)
    }

    /// On to the end of the next sample, late or early by the link's jitter.
    fn step(&mut self) {
        self.sample += 1;
        self.end_s = self.source.time_s(self.sample);
        if self.source.jitter_s > 0.0 {
            self.end_s += self.source.jitter_s * self.jitter.normal::<f64>();
        }
    }

    /// Whether the link lets the sample through.
    fn arrives(&mut self) -> bool {
        self.source.loss == 0.0 || self.loss.uniform::<f64>() >= self.source.loss
    }

    /// Samples so far in which a sensor was at its limit.
    pub fn saturated(&self) -> u64 {
        self.state.as_ref().map_or(0, |state| state.saturated)
    }
}
