//! Many runs: their errors beside what their filters say.

use super::kept::{AidedRuns, Failure};
use super::report::{Count, Report};
use super::vehicle::AidedVehicle;
use super::{measurements, navigator};
use crate::input::InputError;
use crate::parallel;
use crate::quadratic::{by_chance, quadratic};
use crate::scene::Scene;
use crate::simulate::start;
use crate::source::Source;
use schuler::aiding::aided::fault::AidedFault;
use schuler::drift::compare::drift;
use schuler::math::vector::Vector;
use std::ops::Range;

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
    // What a smoother would need is not kept: errors are compared with the filter's claims.
    let navigator = navigator::start(believed, &initial, false).map_err(Ended::Start)?;
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
    Ok(Run { reads, report: vehicle.report(), saturated: stream.saturated() })
}

/// How runs are flown.
#[derive(Clone, Copy, Debug)]
pub struct Means<'a> {
    /// On so many threads.
    pub threads: usize,
    /// Read when so many samples have been integrated.
    pub stops: &'a [u64],
    /// Runs of a batch; some seconds' worth of them unless told.
    pub batch: Option<u64>,
}

/// Samples of a batch, over its runs: some seconds.
const SAMPLES: u64 = 4_000_000;
/// Runs of a batch, at least.
const FEWEST: u64 = 16;

/// Flies the runs of a range of numbers; `done` gets each batch, in order, and `progress` how many have ended.
pub fn fly_range<E: From<InputError>>(
    scenes: Scenes,
    runs: Range<u64>,
    means: Means,
    progress: &(dyn Fn(u64) + Sync),
    done: &mut dyn FnMut(AidedRuns) -> Result<(), E>,
) -> Result<(), E> {
    let Means { threads, stops, batch } = means;
    let size = batch.unwrap_or_else(|| (SAMPLES / scenes.flown.samples().max(1)).max(FEWEST));
    let one = |run| match fly(scenes, run, stops) {
        Ok(run) => Ok(Ok(run)),
        Err(Ended::Sample(sample, why)) => Ok(Err(Failure { run, sample, why })),
        Err(Ended::Start(error)) => Err(error),
    };
    let mut first = runs.start;
    while first < runs.end {
        let numbers = first..runs.end.min(first.saturating_add(size.max(1)));
        let so_far = first - runs.start;
        let reach = |flown: u64| progress(so_far + flown);
        let flown = parallel::all(numbers.clone(), threads, &one, &reach);
        let mut batch = AidedRuns { numbers, ended: Vec::new(), failed: Vec::new() };
        for run in flown.map_err(|(_, error)| error)? {
            match run {
                Ok(run) => batch.ended.push(run),
                Err(failure) => batch.failed.push(failure),
            }
        }
        first = batch.numbers.end;
        done(batch)?;
    }
    Ok(())
}

fn read(vehicle: &AidedVehicle, source: &Source) -> Read {
    let navigator = vehicle.navigator();
    let samples = navigator.integrated();
    let drift = drift(&navigator.solution(), &source.truth(samples));
    let parts = [drift.position_ned, drift.velocity_ned, drift.attitude_ned];
    let [position, velocity, attitude] = parts.map(Vector::into_array);
    let mut error = [0.0; 9];
    for (to, from) in error.iter_mut().zip([position, velocity, attitude].as_flattened()) {
        *to = *from;
    }
    let covariance = navigator.covariance();
    let nees = std::array::from_fn(|group| match group {
        0 => quadratic(&covariance, &error) / 9.0,
        _ => three(&covariance, &error, 3 * (group - 1)) / 3.0,
    });
    Read { samples, error, variance: std::array::from_fn(|i| covariance[i][i]), nees }
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
    let instants = runs.iter().map(|run| run.reads.len()).min().unwrap_or(0);
    (0..instants).map(|at| at_instant(runs, at, rate_hz)).collect()
}

fn at_instant(runs: &[Run], at: usize, rate_hz: f64) -> Together {
    let reads: Vec<&Read> = runs.iter().filter_map(|run| run.reads.get(at)).collect();
    let n = reads.len().max(1) as f64;
    let mean = |value: &dyn Fn(&Read) -> f64| reads.iter().map(|read| value(read)).sum::<f64>() / n;
    Together {
        time_s: reads.first().map_or(0.0, |read| read.samples as f64 / rate_hz),
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
