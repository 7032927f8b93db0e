//! The core's aided navigators behind one interface: frame and precision are chosen at run time.

use super::report::{Judgement, Report};
use super::settings;
use crate::input::{Complaint, InputError};
use crate::scene::{Algorithm, Axes, Precision, Scene};
use schuler::aiding::aided::fault::AidedFault;
use schuler::aiding::aided::measured::{Measured, Sensor};
use schuler::aiding::aided::navigator::Aided;
use schuler::aiding::aided::state::AidedState;
use schuler::aiding::aided::verdict::{Verdict, Witness};
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
use schuler::strapdown::block::window::{H0B4A0, Window as _};
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
}

/// Starts the aided navigator of a scene.
pub fn start(scene: &Scene, initial: &Solution<f64>) -> Result<Box<dyn Aids>, InputError> {
    let navigator = &scene.navigator;
    let refuse = |key: &str, what: &str, accepted: &str| {
        Err(InputError::option(key, Complaint::new(what.to_owned(), accepted.to_owned())))
    };
    if navigator.algorithm != Algorithm::Taylor {
        return refuse("navigator.algorithm", "an aided navigator is taylor", "\"taylor\"");
    }
    if navigator.window.is_some_and(|window| window != H0B4A0::SHAPE) {
        let what = "an aided navigator has a window without look-ahead: 0,4,0";
        return refuse("navigator.window", what, "\"auto\", \"0,4,0\"");
    }
    match (navigator.frame, navigator.precision) {
        (Axes::LocalLevel, Precision::F64) => boxed(scene, initial, Navigator4::<f64>::new),
        (Axes::EarthFixed, Precision::F64) => {
            boxed(scene, initial, EarthFixedNavigator4::<f64>::new)
        }
        (Axes::LocalLevel, Precision::F32) => boxed(scene, initial, Navigator4::<f32>::new),
        (Axes::EarthFixed, Precision::F32) => {
            boxed(scene, initial, EarthFixedNavigator4::<f32>::new)
        }
        (_, Precision::F32x2) => {
            let what = "an aided navigator has no two-float products";
            refuse("navigator.precision", what, "\"f64\", \"f32\"")
        }
    }
}

/// By a mechanization of an interval.
fn boxed<R, M>(
    scene: &Scene,
    initial: &Solution<f64>,
    mechanization: impl FnOnce(Pair<R>) -> Result<M, StartError>,
) -> Result<Box<dyn Aids>, InputError>
where
    R: Scalar + Real<Mask = bool> + Record + Send,
    M: Mechanization<Real = R, Body = BodyMotion<R>, Frame: Record, State: Send> + Send + 'static,
{
    let interval_s = Pair::narrow(Pair::new(scene.rate_hz).reciprocal());
    let stopped =
        |fault: AidedFault| InputError::option("filter", Complaint::new(fault.to_string(), ""));
    let mechanization = mechanization(interval_s).map_err(|_| stopped(AidedFault::Start))?;
    let aided = Aided::new(mechanization, interval_s, settings::of(scene)).map_err(stopped)?;
    let state = aided.start(&Solution::narrow(initial)).map_err(stopped)?;
    Ok(Box::new(Flying::<M> {
        aided,
        state,
        carried: Carried::default(),
        digest: Digest::default(),
        seen: Seen::new(scene.rate_hz),
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

/// What is seen of the filter.
pub(crate) struct Seen {
    rate_hz: f64,
    judged: Vec<Judgement>,
    /// When the filter started again, s.
    restarts: Vec<f64>,
}

impl Seen {
    /// Nothing yet.
    pub(crate) fn new(rate_hz: f64) -> Self {
        Self { rate_hz, judged: Vec::new(), restarts: Vec::new() }
    }

    /// What became of the measurements.
    pub(crate) fn report<
        M: Mechanization,
        const N: usize,
        const P: usize,
        const E: usize,
        const L: usize,
        const Q: usize,
    >(
        &self,
        state: &AidedState<M, N, P, E, L, Q>,
    ) -> Report {
        let lockouts = Sensor::ALL.map(|sensor| state.tally(sensor).lockouts());
        Report::new(&self.judged, &self.restarts, lockouts, *state.transport())
    }
}

impl<R: Scalar, const N: usize, const P: usize, const E: usize> Witness<R, N, P, E> for Seen {
    fn judged(&mut self, verdict: &Verdict<R>) {
        let &Verdict { at, kind, nis, accepted, locked_out, .. } = verdict;
        let time_s = (at.samples as f64 + at.part.widen()) / self.rate_hz;
        self.judged.push(Judgement { time_s, kind, nis: nis.widen(), accepted, locked_out });
    }

    fn restarted(&mut self, samples: u64) {
        self.restarts.push(samples as f64 / self.rate_hz);
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
        }
        Ok(())
    }

    fn finish(&mut self) -> Result<(), AidedFault> {
        self.aided.finish(&mut self.state, &mut self.seen);
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
}
