//! Many runs: their errors beside what their filters say.

use super::report::{Count, Report};
use super::smoother::Smoothed;
use super::vehicle::AidedVehicle;
use super::{measurements, navigator};
use crate::input::InputError;
use crate::quadratic::{by_chance, quadratic};
use crate::scene::Scene;
use crate::simulate::start;
use crate::source::Source;
use schuler::aiding::aided::fault::AidedFault;
use schuler::drift::compare::drift;
use schuler::math::vector::Vector;
use schuler::solution::Solution;

/// A run at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Read {
    /// Samples integrated until then.
    pub samples: u64,
    /// Its drift: position, velocity, attitude, each north, east, down; m, m/s, rad.
    pub error: [f64; 9],
    /// What its filter says of each.
    pub variance: [f64; 9],
    /// eᵀP⁻¹e of each of [`GROUPS`], by its degrees of freedom; not a number where P is not regular.
    pub nees: [f64; 4],
}

/// A run.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// In order of time.
    pub reads: Vec<Read>,
    /// What a smoother makes of each; none without one. Not numbers before the filter last started.
    pub smoothed: Vec<Read>,
    /// What became of its measurements.
    pub report: Report,
    /// Samples in which a sensor was at its limit.
    pub saturated: u64,
}

/// Why a run ended early.
#[derive(Clone, Debug)]
pub enum Ended {
    /// It does not start.
    Start(InputError),
    /// A sample that it did not take, from 1.
    Sample(u64, AidedFault),
}

/// What runs are of.
#[derive(Clone, Copy)]
pub struct Scenes<'a> {
    /// What is flown and measured.
    pub flown: &'a Scene,
    /// What the filter is told of it.
    pub believed: &'a Scene,
    /// Samples of what is flown.
    pub source: &'a Source,
}

impl<'a> Scenes<'a> {
    /// The filter is told what is flown.
    pub fn of(scene: &'a Scene, source: &'a Source) -> Self {
        Self { flown: scene, believed: scene, source }
    }
}

/// Flies a run, and reads it at the first block's end after so many samples each; the last is its end.
pub fn fly(scenes: Scenes, run: u64, stops: &[u64]) -> Result<Run, Ended> {
    let Scenes { flown: scene, believed, source } = scenes;
    let initial = start::of_run(&source.initial(0), scene, run);
    let smoother = believed.aiding.filter.smoother;
    let navigator = navigator::start(believed, &initial, smoother).map_err(Ended::Start)?;
    let arriving = measurements::of_run(scene, source, run);
    let mut vehicle = AidedVehicle::with(navigator, arriving, scene.rate_hz);
    let mut stream = source.start(run);
    let mut reads = Vec::with_capacity(stops.len());
    let mut stops = stops.iter().copied().peekable();
    for sample in 1..=scene.samples() {
        // No sample is lost: a scene that is aided refuses a link that loses any.
        let Some(increment) = stream.advance() else { continue };
        vehicle.push(&increment).map_err(|fault| Ended::Sample(sample, fault))?;
        let integrated = vehicle.navigator().integrated();
        if stops.next_if(|&stop| stop <= integrated).is_some() {
            reads.push(read(&vehicle, source));
        }
    }
    vehicle.finish().map_err(|fault| Ended::Sample(scene.samples(), fault))?;
    if stops.next().is_some() {
        reads.push(read(&vehicle, source));
    }
    let states = vehicle.navigator().smoothed();
    let smoothed = match smoother {
        true => reads.iter().map(|read| smoothed(&states, read.samples, source)).collect(),
        false => Vec::new(),
    };
    Ok(Run { reads, smoothed, report: vehicle.report(), saturated: stream.saturated() })
}

fn read(vehicle: &AidedVehicle, source: &Source) -> Read {
    let navigator = vehicle.navigator();
    let samples = navigator.integrated();
    Read::new(samples, &navigator.solution(), &source.truth(samples), &navigator.covariance())
}

/// The first smoothed state that is not before so many samples.
fn smoothed(states: &[Smoothed], samples: u64, source: &Source) -> Read {
    match states.get(states.partition_point(|state| state.samples < samples)) {
        Some(state) if states.first().is_some_and(|first| first.samples <= samples) => {
            let truth = source.truth(state.samples);
            Read { samples, ..Read::new(state.samples, &state.solution, &truth, &state.covariance) }
        }
        _ => Read { samples, error: [f64::NAN; 9], variance: [f64::NAN; 9], nees: [f64::NAN; 4] },
    }
}

impl Read {
    fn new(
        samples: u64,
        computed: &Solution<f64>,
        truth: &Solution<f64>,
        covariance: &[[f64; 9]; 9],
    ) -> Self {
        let drift = drift(computed, truth);
        let parts = [drift.position_ned, drift.velocity_ned, drift.attitude_ned];
        let parts = parts.map(Vector::into_array);
        let mut error = [0.0; 9];
        for (to, from) in error.iter_mut().zip(parts.as_flattened()) {
            *to = *from;
        }
        let nees = std::array::from_fn(|group| match group {
            0 => quadratic(covariance, &error) / 9.0,
            _ => three(covariance, &error, 3 * (group - 1)) / 3.0,
        });
        Self { samples, error, variance: std::array::from_fn(|i| covariance[i][i]), nees }
    }
}

/// The form of three of the nine.
fn three(covariance: &[[f64; 9]; 9], error: &[f64; 9], first: usize) -> f64 {
    let block = std::array::from_fn(|i| std::array::from_fn(|j| covariance[first + i][first + j]));
    quadratic::<3>(&block, &std::array::from_fn(|i| error[first + i]))
}

/// Groups of the nine: all of them, position, velocity, attitude.
pub const GROUPS: [&str; 4] = ["all", "position", "velocity", "attitude"];

/// How many of the nine each of [`GROUPS`] has.
pub const FREEDOM: [f64; 4] = [9.0, 3.0, 3.0, 3.0];

/// All runs at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Together {
    /// When, s.
    pub time_s: f64,
    /// Root of the mean square of each of the nine errors.
    pub rms: [f64; 9],
    /// Root of the mean variance that the filters say.
    pub sigma: [f64; 9],
    /// The mean of eᵀP⁻¹e of each of [`GROUPS`], by its degrees of freedom: 1 is expected.
    pub nees: [f64; 4],
    /// Where 95 % of such means lie.
    pub expected: [[f64; 2]; 4],
}

/// What runs come to together at each instant, where samples come at a rate.
pub fn together(runs: &[Run], rate_hz: f64) -> Vec<Together> {
    instants(runs, rate_hz, |run| &run.reads)
}

/// The same of what a smoother makes of them, at the instants that it reaches; none without one.
pub fn smoothed_together(runs: &[Run], rate_hz: f64) -> Vec<Together> {
    let all = instants(runs, rate_hz, |run| &run.smoothed);
    all.into_iter().filter(|one| one.sigma[0].is_finite()).collect()
}

fn instants(runs: &[Run], rate_hz: f64, reads: fn(&Run) -> &Vec<Read>) -> Vec<Together> {
    let instants = runs.iter().map(|run| reads(run).len()).min().unwrap_or(0);
    let at = |at: usize| {
        let known = runs.iter().filter_map(|run| reads(run).get(at));
        let time_s = known.clone().next().map_or(0.0, |read| read.samples as f64 / rate_hz);
        at_instant(time_s, &known.filter(|read| read.error[0].is_finite()).collect::<Vec<_>>())
    };
    (0..instants).map(at).collect()
}

fn at_instant(time_s: f64, reads: &[&Read]) -> Together {
    let n = reads.len() as f64;
    let mean = |value: &dyn Fn(&Read) -> f64| reads.iter().map(|read| value(read)).sum::<f64>() / n;
    Together {
        time_s,
        rms: std::array::from_fn(|i| mean(&|read| read.error[i].powi(2)).sqrt()),
        sigma: std::array::from_fn(|i| mean(&|read| read.variance[i]).sqrt()),
        nees: std::array::from_fn(|group| mean(&|read| read.nees[group])),
        expected: FREEDOM.map(|freedom| by_chance(n * freedom)),
    }
}

/// The measurements of all runs, by sensor.
pub fn counts(runs: &[Run]) -> Vec<Count> {
    let mut all: Vec<Count> = Vec::new();
    for count in runs.iter().flat_map(|run| &run.report.sensors) {
        if !all.iter().any(|one| one.sensor == count.sensor) {
            all.push(Count { sensor: count.sensor, ..Count::default() });
        }
        for one in all.iter_mut().filter(|one| one.sensor == count.sensor) {
            one.accepted += count.accepted;
            one.refused += count.refused;
            one.lockouts += count.lockouts;
            one.degrees += count.degrees;
            one.nis += count.nis;
        }
    }
    all
}
