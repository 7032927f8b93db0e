//! `schuler replay`: navigates a recorded stream.

use crate::cli::ReplayArgs;
use crate::gap::{Bridge, Missing};
use crate::input::{Complaint, InputError};
use crate::navigator::{self, Unavailable};
use crate::recording::navigation::{NavigationRow, NavigationWriter};
use crate::recording::{Gap, Recording, Sample};
use crate::scene::Navigator;
use crate::units::{ARCSECOND, DEGREE, DEGREE_PER_HOUR};
use schuler::alignment::{Alignment, AlignmentError};
use schuler::drift::compare::drift;
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::solution::Solution;
use schuler::strapdown::mechanization::Rejected;
use schuler::strapdown::plan;

/// Navigates a recording and writes `nav.csv`, a row per sample. Prints what was aligned to, and where
/// the vehicle ends up.
pub fn replay(args: &ReplayArgs) -> Result<(), InputError> {
    args.check()?;
    let imu = args.imu.display().to_string();
    let recording = Recording::read(&imu)?;
    let mut options = Navigator::default();
    args.navigator.apply(&mut options);
    options.gap = args.gap.unwrap_or(options.gap);
    let given = args.initial.as_ref().map(|file| NavigationRow::read(&file.display().to_string()));
    let initial = given.transpose()?.or(recording.initial).ok_or_else(|| {
        let complaint = Complaint::new(
            "is missing, and the recording brings no initial state",
            "a TOML file with the columns of nav.csv as keys",
        );
        InputError::option("--initial", complaint)
    })?;

    let own_start = if args.initial.is_some() { initial.time_s } else { recording.start_s() };
    let begin_s = args.start.unwrap_or(own_start);
    let navigate_s = begin_s + args.align.unwrap_or(0.0);
    let until_s = args.until.unwrap_or(f64::INFINITY);
    // A sample belongs to where its interval lies, up to the rounding of its time.
    let slack = 0.25 * recording.interval_s;
    let within = |from_s: f64, to_s: f64| {
        let first = recording.samples.partition_point(|s| s.time_s <= from_s + slack);
        let last = recording.samples.partition_point(|s| s.time_s <= to_s + slack);
        first..last.max(first)
    };
    let flown = within(navigate_s, until_s);
    if flown.is_empty() {
        let span = (recording.start_s(), recording.samples.last().map_or(0.0, |s| s.time_s));
        let what = format!("there is no sample after {navigate_s} s");
        let accepted = format!("times within {} to {} s", span.0, span.1);
        return Err(InputError::file(&imu, Complaint::new(what, accepted)));
    }
    let mut start = initial;
    if args.align.is_some() {
        let still = &recording.samples[within(begin_s, navigate_s)];
        start = align(&recording, still, &initial)?;
    }
    let at_rest = args.align.is_some().then(|| start.solution());
    let last = fly(&recording, flown.start, flown.end, &start, &options, args)?;
    report(&last, navigate_s, at_rest.as_ref());
    Ok(())
}

/// Level and north from samples at rest.
fn align(
    recording: &Recording,
    still: &[Sample],
    initial: &NavigationRow,
) -> Result<NavigationRow, InputError> {
    let mut alignment = Alignment::default();
    for sample in still {
        alignment.add(&sample.increment);
    }
    let attitude = alignment.attitude().map_err(|error: AlignmentError| {
        InputError::file(&recording.file, Complaint::new(error.to_string(), ""))
    })?;
    let (rate, force) = alignment.mean(recording.interval_s);
    let [roll, pitch, yaw] = [attitude.roll, attitude.pitch, attitude.yaw].map(|a| a / DEGREE);
    println!(
        "aligned on {} samples: roll {roll:.4}°, pitch {pitch:.4}°, heading {:.4}°",
        still.len(),
        yaw.rem_euclid(360.0)
    );
    println!(
        "mean rate {:.3} °/h, mean specific force {:.6} m/s²",
        rate.norm() / DEGREE_PER_HOUR,
        force.norm()
    );
    Ok(NavigationRow { attitude, velocity_ned: Vector::ZERO, ..*initial })
}

/// Refused by the bridge or by the navigator.
enum Refused {
    Missing,
    Rejected(Rejected),
    Output(InputError),
}

impl From<Missing> for Refused {
    fn from(_: Missing) -> Self {
        Self::Missing
    }
}

fn fly(
    recording: &Recording,
    first: usize,
    end: usize,
    start: &NavigationRow,
    options: &Navigator,
    args: &ReplayArgs,
) -> Result<(f64, Solution<f64>), InputError> {
    let unavailable = |error: Unavailable| {
        let option = if let Unavailable::Window(_) = error { "--window" } else { "--initial" };
        InputError::option(option, Complaint::new(error.to_string(), ""))
    };
    let interval_s = interval(recording.interval_s);
    let shape = options.window.unwrap_or_else(|| plan::UNKNOWN.into());
    let initial = start.solution();
    let mut navigator = navigator::start(options, shape, plan::HIGHEST_ORDER, interval_s, &initial)
        .map_err(unavailable)?;
    let mut writer = NavigationWriter::create(&args.out)?;

    let origin_s = recording.samples[first].time_s - recording.interval_s;
    let mut bridge = Bridge::new(options.gap);
    let mut gaps = recording.gaps().filter(|gap| gap.index > first).peekable();
    let mut last = (origin_s, initial);
    let mut written = Ok(());
    // A row's time is its sample's own; a bridged one's lies on the grid.
    let mut times = Vec::with_capacity(end - first);
    let row_of = |n: u64, row: &Solution<f64>, times: &[f64]| {
        let time_s = times.get(n as usize - 1).copied().unwrap_or(origin_s);
        (time_s, *row)
    };
    for index in first..end {
        let sample = recording.samples[index];
        let gap = gaps.next_if(|gap| gap.index == index);
        let missing = missing(recording, index, gap)?;
        for n in (0..missing).map(Some).chain([None]) {
            let lost = n.is_some();
            let behind = n.map_or(0, |n| missing - n) as f64;
            times.push(sample.time_s - behind * recording.interval_s);
            let taken = bridge.take((!lost).then_some(sample.increment), |increment| {
                let mut read = |n: u64, row: &Solution<f64>| {
                    last = row_of(n, row, &times);
                    if written.is_ok() {
                        written = writer.row(&NavigationRow::new(last.0, &last.1));
                    }
                };
                navigator.push(increment, &mut read).map_err(Refused::Rejected)?;
                std::mem::replace(&mut written, Ok(())).map_err(Refused::Output)
            });
            taken.map_err(|refused| refused.at(recording, index))?;
        }
    }
    navigator.finish(&mut |n, row| {
        last = row_of(n, row, &times);
        if written.is_ok() {
            written = writer.row(&NavigationRow::new(last.0, &last.1));
        }
    });
    written?;
    writer.finish()?;
    Ok(last)
}

/// How many samples are missing before one; a step that no whole number of them explains is an error.
fn missing(recording: &Recording, index: usize, gap: Option<Gap>) -> Result<u64, InputError> {
    match gap {
        Some(Gap { missing: 0, step_s, .. }) => {
            let what = format!("the step of {step_s} s is no sample");
            let accepted = format!("steps of {} s", recording.interval_s);
            Err(recording.error(index, Complaint::new(what, accepted)))
        }
        Some(gap) => Ok(gap.missing),
        None => Ok(0),
    }
}

impl Refused {
    fn at(self, recording: &Recording, index: usize) -> InputError {
        let complaint = match self {
            Self::Output(error) => return error,
            Self::Missing => Complaint::new("samples are missing before this one", "--gap bridge"),
            Self::Rejected(why) => Complaint::new(why.to_string(), ""),
        };
        recording.error(index, complaint)
    }
}

/// The interval to about twice the digits, where it is one over a whole rate.
fn interval(interval_s: f64) -> Pair<f64> {
    let rate = (1.0 / interval_s).round();
    if 1.0 / rate == interval_s { Pair::new(rate).reciprocal() } else { Pair::new(interval_s) }
}

/// Where it ends; for a vehicle that was at rest, how far it seems to have moved.
fn report(last: &(f64, Solution<f64>), start_s: f64, at_rest: Option<&Solution<f64>>) {
    let (time_s, solution) = last;
    println!("navigated from {start_s} s to {time_s} s");
    if let Some(rest) = at_rest {
        let moved = drift(solution, rest);
        let [north, east, down] = moved.position_ned.into_array();
        println!(
            "had it stood still: drifted {north:.1} m north, {east:.1} m east, {down:.1} m down,"
        );
        let [north, east, down] = moved.velocity_ned.into_array();
        println!("  at {north:.3} m/s north, {east:.3} m/s east, {down:.3} m/s down,");
        let [x, y, z] = moved.attitude_ned.map(|a| a / ARCSECOND).into_array();
        println!("  turned {x:.1}″ about north, {y:.1}″ about east, {z:.1}″ about down");
    }
}
