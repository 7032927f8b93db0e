//! The core's aided navigators behind one interface: frame and precision are chosen at run time.

use super::estimates;
use super::report::{Judgement, Report};
use super::seen::Seen;
use super::settings;
use super::smoother::{Smoothed, Steps};
use crate::input::{Complaint, InputError};
use crate::plan::AIDED;
use crate::scene::{Algorithm, Axes, Navigator as Configuration, Precision, Scene};
use schuler::aiding::aided::fault::AidedFault;
use schuler::aiding::aided::measured::Measured;
use schuler::aiding::aided::navigator::Aided;
use schuler::aiding::aided::settings::Settings;
use schuler::aiding::aided::state::AidedState;
use schuler::digest::Digest;
use schuler::flight::carried::Carried;
use schuler::math::compensated::Pair;
use schuler::math::real::{Real, Scalar};
use schuler::navigators::{EarthFixedNavigator4, Navigator4};
use schuler::output::Output;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::block::body::BodyMotion;
use schuler::strapdown::limits::StartError;
use schuler::strapdown::mechanization::Mechanization;

/// States of the filter, the numbers of its covariance, those beside the fifteen, remembered steps, and measurements
/// that may wait.
const STATES: usize = 21;
const NUMBERS: usize = STATES * (STATES + 1) / 2;
const FURTHER: usize = STATES - 15;
const STEPS: usize = 256;
const WAITING: usize = 256;

/// An aided navigator in flight.
pub trait Aids: Send {
    /// Takes a measurement that has arrived. What is late, comes again or finds no room is counted.
    fn measure(&mut self, measured: &Measured<f64>) -> Result<(), AidedFault>;
    /// Takes a sample.
    fn push(&mut self, sample: &Increment<f64>) -> Result<(), AidedFault>;
    /// Takes what waits: the samples are at their end.
    fn finish(&mut self) -> Result<(), AidedFault>;
    /// Samples integrated.
    fn integrated(&self) -> u64;
    /// Navigation at the end of the last block.
    fn solution(&self) -> Solution<f64>;
    /// The covariance of its drift: position, velocity, attitude, north, east, down, m, m/s, rad.
    fn covariance(&self) -> [[f64; 9]; 9];
    /// Digest of every state so far.
    fn digest(&self) -> u64;
    /// What became of the measurements.
    fn report(&self) -> Report;
    /// Its states as all measurements together say they were, where it is smoothed: after each step since the
    /// filter last started. To be called after the end.
    fn smoothed(&self) -> Vec<Smoothed>;
    /// What the filter has found beside the motion.
    fn found(&self) -> Vec<Found>;
    /// Every measurement, in the order in which it was judged.
    fn judged(&self) -> &[Judgement];
    /// The columns of its [`estimates`](Self::estimates).
    fn estimated(&self) -> Vec<String>;
    /// Biases and further states at the end of the last block, in place of what the row had.
    fn estimates(&self, row: &mut Vec<f64>);
}

/// Something that a filter has found beside the motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// What, with its unit.
    pub name: &'static str,
    /// Of each component: the number, and its standard deviation.
    pub numbers: Vec<[f64; 2]>,
}

/// What an aided navigator is made of.
#[derive(Clone, Copy, Debug)]
pub struct Made<'a> {
    /// Frame, precision, algorithm, window.
    pub navigator: &'a Configuration,
    /// The samples' interval, s.
    pub interval: Pair<f64>,
    /// Samples per second.
    pub rate_hz: f64,
    /// The filter.
    pub settings: &'a Settings<f64>,
    /// Whether it is smoothed afterwards: then its steps are kept.
    pub smoother: bool,
}

/// Starts the aided navigator of a scene; with `smoother`, its steps are kept.
pub fn start(
    scene: &Scene,
    initial: &Solution<f64>,
    smoother: bool,
) -> Result<Box<dyn Aids>, InputError> {
    let interval = Pair::new(scene.rate_hz).reciprocal();
    let (navigator, rate_hz) = (&scene.navigator, scene.rate_hz);
    let made = Made { navigator, interval, rate_hz, settings: &settings::of(scene), smoother };
    begin(&made, initial)
}

/// Starts one from a solution.
pub fn begin(made: &Made<'_>, initial: &Solution<f64>) -> Result<Box<dyn Aids>, InputError> {
    let navigator = made.navigator;
    let refuse = |key: &str, what: &str, accepted: &str| {
        Err(InputError::option(key, Complaint::new(what.to_owned(), accepted.to_owned())))
    };
    if navigator.algorithm != Algorithm::Taylor {
        return refuse("navigator.algorithm", "an aided navigator is taylor", "\"taylor\"");
    }
    if navigator.window.is_some_and(|window| window != AIDED) {
        let what = "an aided navigator has a window without look-ahead: 0,4,0";
        return refuse("navigator.window", what, "\"auto\", \"0,4,0\"");
    }
    match (navigator.frame, navigator.precision) {
        (Axes::LocalLevel, Precision::F64) => boxed(made, initial, Navigator4::<f64>::new),
        (Axes::EarthFixed, Precision::F64) => {
            boxed(made, initial, EarthFixedNavigator4::<f64>::new)
        }
        (Axes::LocalLevel, Precision::F32) => boxed(made, initial, Navigator4::<f32>::new),
        (Axes::EarthFixed, Precision::F32) => {
            boxed(made, initial, EarthFixedNavigator4::<f32>::new)
        }
        (_, Precision::F32x2) => {
            let what = "an aided navigator has no two-float products";
            refuse("navigator.precision", what, "\"f64\", \"f32\"")
        }
    }
}

/// By a mechanization of an interval.
fn boxed<R, M>(
    made: &Made<'_>,
    initial: &Solution<f64>,
    mechanization: impl FnOnce(Pair<R>) -> Result<M, StartError>,
) -> Result<Box<dyn Aids>, InputError>
where
    R: Scalar + Real<Mask = bool> + Record + Send,
    M: Mechanization<Real = R, Body = BodyMotion<R>, Frame: Record, State: Send> + Send + 'static,
{
    let interval_s = Pair::narrow(made.interval);
    let stopped =
        |fault: AidedFault| InputError::option("filter", Complaint::new(fault.to_string(), ""));
    let mechanization = mechanization(interval_s).map_err(|_| stopped(AidedFault::Start))?;
    let settings = settings::narrow(made.settings);
    let aided = Aided::new(mechanization, interval_s, settings).map_err(stopped)?;
    let state = aided.start(&Solution::narrow(initial)).map_err(stopped)?;
    Ok(Box::new(Flying::<M> {
        aided,
        state,
        carried: Carried::default(),
        digest: Digest::default(),
        seen: Seen::new(made.rate_hz, made.smoother.then(Steps::default)),
    }))
}

type One<M> = Aided<M, STATES, NUMBERS, FURTHER, STEPS, WAITING>;
type StateOf<M> = AidedState<M, STATES, NUMBERS, FURTHER, STEPS, WAITING>;

struct Flying<M: Mechanization> {
    aided: One<M>,
    state: StateOf<M>,
    carried: Carried,
    digest: Digest,
    seen: Seen,
}

impl<R, M> Flying<M>
where
    R: Scalar + Real<Mask = bool>,
    M: Mechanization<Real = R, Body = BodyMotion<R>>,
{
    /// Shows the state at the end of a block to a smoother.
    fn reach(&mut self) {
        let Self { aided, state, seen, .. } = self;
        if let Some(steps) = &mut seen.steps {
            steps.reach(state.integrated(), || {
                let rows = aided.drift_rows(state);
                let rows = rows.map(|row| std::array::from_fn(|i| row[i].widen()));
                (aided.output(state).wide(), rows)
            });
        }
    }
}

impl<R, M> Aids for Flying<M>
where
    R: Scalar + Real<Mask = bool> + Record + Send,
    M: Mechanization<Real = R, Body = BodyMotion<R>, Frame: Record, State: Send> + Send + 'static,
{
    fn measure(&mut self, measured: &Measured<f64>) -> Result<(), AidedFault> {
        match self.aided.measure(&mut self.state, &Measured::narrow(measured)) {
            Err(AidedFault::Late | AidedFault::Again | AidedFault::Full) => Ok(()),
            done => done,
        }
    }

    fn push(&mut self, sample: &Increment<f64>) -> Result<(), AidedFault> {
        let before = self.state.integrated();
        let narrow = self.carried.narrow(sample);
        self.aided.push_seen(&mut self.state, narrow, &mut self.seen)?;
        if self.state.integrated() != before {
            self.digest.add(M::frame(self.state.navigator()));
            self.reach();
        }
        Ok(())
    }

    fn finish(&mut self) -> Result<(), AidedFault> {
        self.aided.finish(&mut self.state, &mut self.seen);
        self.reach();
        self.digest.add(M::frame(self.state.navigator()));
        self.digest.add(self.state.filter());
        Ok(())
    }

    fn integrated(&self) -> u64 {
        self.state.integrated()
    }

    fn solution(&self) -> Solution<f64> {
        self.aided.output(&self.state).wide()
    }

    fn covariance(&self) -> [[f64; 9]; 9] {
        self.aided.covariance_ned(&self.state).map(|row| row.map(Scalar::widen))
    }

    fn digest(&self) -> u64 {
        self.digest.value()
    }

    fn report(&self) -> Report {
        self.seen.report(&self.state)
    }

    fn smoothed(&self) -> Vec<Smoothed> {
        let Some(steps) = &self.seen.steps else { return Vec::new() };
        let ud = self.state.filter().covariance();
        let cells = (0..STATES).flat_map(|i| (0..=i).map(move |j| (i, j)));
        let end: Vec<f64> = cells.map(|(i, j)| ud.covariance(i, j).widen()).collect();
        steps.smoothed(&end)
    }

    fn found(&self) -> Vec<Found> {
        let (states, filter) = (&self.aided.settings().states, self.state.filter());
        let sizes = [
            ("lever arm forward, right, down, m", 3, states.lever_arm.is_some()),
            ("latency, s", 1, states.latency.is_some()),
            ("barometer bias, m", 1, states.barometer_bias.is_some()),
            ("odometer scale", 1, states.odometer_scale.is_some()),
        ];
        let mut at = 0;
        let there = sizes.into_iter().filter(|(_, _, is_there)| *is_there);
        let found = there.map(|(name, size, _)| {
            let places = at..at + size;
            at += size;
            let numbers = places.filter_map(|i| {
                let variance = filter.covariance().covariance(15 + i, 15 + i);
                Some([filter.extras().get(i)?.widen(), variance.widen().max(0.0).sqrt()])
            });
            Found { name, numbers: numbers.collect() }
        });
        found.collect()
    }

    fn judged(&self) -> &[Judgement] {
        self.seen.judged()
    }

    fn estimated(&self) -> Vec<String> {
        estimates::columns(&self.aided.settings().states)
    }

    fn estimates(&self, row: &mut Vec<f64>) {
        estimates::read(&self.aided.settings().states, self.state.filter(), row);
    }
}
