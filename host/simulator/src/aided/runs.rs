//! Many runs: their errors beside what their filters say.

use super::report::{Count, Report};
use super::vehicle::AidedVehicle;
use crate::input::InputError;
use crate::quadratic::{by_chance, quadratic};
use crate::scene::Scene;
use crate::simulate::start;
use crate::source::Source;
use schuler::aiding::aided::fault::AidedFault;
use schuler::drift::compare::drift;
use schuler::math::vector::Vector;

/// A run at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Read {
    /// When, s.
    pub time_s: f64,
    /// Its drift: position, velocity, attitude, each north, east, down; m, m/s, rad.
    pub error: [f64; 9],
    /// What its filter says of it.
    pub covariance: [[f64; 9]; 9],
}

/// A run.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// In order of time.
    pub reads: Vec<Read>,
    /// What became of its measurements.
    pub report: Report,
}

/// Why a run ended early.
#[derive(Clone, Debug)]
pub enum Ended {
    /// It does not start.
    Start(InputError),
    /// A sample that it did not take, from 1.
    Sample(u64, AidedFault),
}

/// Flies a run, and reads it at the first block's end after so many samples each; the last is its end.
pub fn fly(scene: &Scene, source: &Source, run: u64, stops: &[u64]) -> Result<Run, Ended> {
    let initial = start::of_run(&source.initial(0), scene, run);
    // What a smoother would need is not kept: errors are compared with the filter's claims.
    let vehicle = AidedVehicle::new(scene, source, run, &initial, false);
    let mut vehicle = vehicle.map_err(Ended::Start)?;
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
    Ok(Run { reads, report: vehicle.report() })
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
    Read { time_s: source.time_s(samples), error, covariance: navigator.covariance() }
}

/// Groups of the nine: all of them, position, velocity, attitude.
pub const GROUPS: [&str; 4] = ["all", "position", "velocity", "attitude"];

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

/// What runs come to together at each instant.
pub fn together(runs: &[Run]) -> Vec<Together> {
    let instants = runs.iter().map(|run| run.reads.len()).min().unwrap_or(0);
    (0..instants).map(|at| at_instant(runs, at)).collect()
}

fn at_instant(runs: &[Run], at: usize) -> Together {
    let reads: Vec<&Read> = runs.iter().filter_map(|run| run.reads.get(at)).collect();
    let n = reads.len().max(1) as f64;
    let mean = |value: &dyn Fn(&Read) -> f64| reads.iter().map(|read| value(read)).sum::<f64>() / n;
    let three = |read: &Read, first: usize| {
        let covariance =
            std::array::from_fn(|i| std::array::from_fn(|j| read.covariance[first + i][first + j]));
        quadratic::<3>(&covariance, &std::array::from_fn(|i| read.error[first + i]))
    };
    let freedom = |group: usize| if group == 0 { 9.0 } else { 3.0 };
    Together {
        time_s: reads.first().map_or(0.0, |read| read.time_s),
        rms: std::array::from_fn(|i| mean(&|read| read.error[i].powi(2)).sqrt()),
        sigma: std::array::from_fn(|i| mean(&|read| read.covariance[i][i]).sqrt()),
        nees: std::array::from_fn(|group| match group {
            0 => mean(&|read| quadratic(&read.covariance, &read.error)) / 9.0,
            _ => mean(&|read| three(read, 3 * (group - 1))) / 3.0,
        }),
        expected: std::array::from_fn(|group| by_chance(n * freedom(group))),
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
