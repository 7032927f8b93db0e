//! `schuler replay`: navigates a recorded stream.

use crate::cli::ReplayArgs;
use crate::input::{Complaint, InputError};
use crate::navigator::{self, Unavailable};
use crate::output::say;
use crate::progress::Progress;
use crate::recording::navigation::{NavigationRow, NavigationWriter};
use crate::recording::{Gap, Recording};
use crate::rest::align;
use crate::rest::opening::Opening;
use crate::scene::{Gap as Policy, Navigator};
use crate::simulate::{FlightError, Refused};
use crate::units::{ARCSECOND, DEGREE};
use schuler::drift::compare::drift;
use schuler::link::gap::Bridge;
use schuler::math::compensated::Pair;
use schuler::solution::Solution;
use schuler::strapdown::plan;
use std::collections::VecDeque;
use std::ops::Range;
use std::path::Path;

/// Samples that a gap may be bridged over, at most.
const MOST_BRIDGED: u64 = 100_000;

/// Navigates a recording and writes `nav.csv`, a row per sample. Prints what was aligned to, and where
/// the vehicle ends up.
pub fn replay(args: &ReplayArgs) -> Result<(), FlightError> {
    args.check()?;
    let recording =
        Recording::read_in(&args.imu.display().to_string(), &args.units.unwrap_or_default())?;
    let mut options = Navigator::default();
    args.navigator.apply(&mut options)?;
    options.gap = args.gap.unwrap_or(options.gap);
    let given = args.initial.as_ref().map(|file| NavigationRow::read(&file.display().to_string()));
    let initial = given.transpose()?.or(recording.initial).ok_or_else(|| {
        let complaint = Complaint::new(
            "is missing, and the recording brings no initial state",
            "a TOML file with the columns of nav.csv as keys",
        );
        InputError::option("--initial", complaint)
    })?;

    let spans = Spans::new(args, &recording, &initial)?;
    let start = match args.align {
        Some(_) => align(&recording, spans.still, options.gap, &initial, args.heading)?,
        None => initial,
    };
    let last = fly(&recording, spans.flown, &start, args.align.is_some(), &options, &args.out)?;
    say(&report(&last, spans.navigate_s, args.align.is_some().then(|| start.solution())))?;
    Ok(())
}

/// Which samples are aligned on, which are flown.
struct Spans {
    navigate_s: f64,
    still: Range<usize>,
    flown: Range<usize>,
}

impl Spans {
    fn new(
        args: &ReplayArgs,
        recording: &Recording,
        initial: &NavigationRow,
    ) -> Result<Self, InputError> {
        let (first_s, last_s) = (recording.start_s(), recording.end_s());
        let own_s = if args.initial.is_some() { initial.time_s } else { first_s };
        let begin_s = args.start.unwrap_or(own_s);
        let navigate_s = begin_s + args.align.unwrap_or(0.0);
        // A sample belongs to where its interval lies, up to the rounding of its time.
        let slack = 0.25 * recording.interval_s;
        let reached = |time_s: f64| {
            recording.samples.partition_point(|sample| sample.time_s <= time_s + slack)
        };
        let lies_inside = |time_s: f64| time_s >= first_s - slack && time_s <= last_s - slack;
        let starts_s = |index: usize| recording.samples[index].time_s - recording.interval_s;
        let inside = format!("times within the recording, {first_s} to {last_s} s");
        let complain = |option: &str, what: String, accepted: &str| {
            Err(InputError::option(option, Complaint::new(what, accepted)))
        };
        // The recording's own start is always right.
        let begins = match (args.start, &args.initial) {
            (Some(_), _) => "--start",
            (None, Some(_)) => "--initial",
            (None, None) => "--align",
        };
        if !lies_inside(begin_s) || !lies_inside(navigate_s) {
            let what = format!("navigation would start at {navigate_s} s");
            let option = if lies_inside(begin_s) { "--align" } else { begins };
            return complain(option, what, &inside);
        }
        if args.align.is_none() && (begin_s - own_s).abs() > slack {
            let what = format!("the initial state is that of {own_s} s, not of {begin_s} s");
            return complain(begins, what, "the time of the initial state, or --align");
        }
        let flown = reached(navigate_s)..reached(args.until.unwrap_or(f64::INFINITY));
        if flown.is_empty() {
            let what = format!("there is no sample between it and {navigate_s} s");
            return complain("--until", what, &inside);
        }
        let start_s = starts_s(flown.start);
        if (start_s - navigate_s).abs() > 2.0 * slack {
            let what = format!("no sample starts at {navigate_s} s");
            let near = format!("a sample's boundary, {start_s} s");
            let begin_is_one = (starts_s(reached(begin_s)) - begin_s).abs() <= 2.0 * slack;
            return complain(if begin_is_one { "--align" } else { begins }, what, &near);
        }
        Ok(Self { navigate_s, still: reached(begin_s)..flown.start, flown })
    }
}

/// Level and north from samples at rest.
fn align(
    recording: &Recording,
    still: Range<usize>,
    policy: Policy,
    initial: &NavigationRow,
    heading_deg: Option<f64>,
) -> Result<NavigationRow, FlightError> {
    let mut lost = 0;
    for gap in recording.gaps().filter(|gap| gap.index > still.start && gap.index <= still.end) {
        let missing = missing(recording, gap.index, Some(gap))?;
        if policy == Policy::Error {
            return Err(refused_at(Refused::Missing, recording, gap.index, missing));
        }
        lost += missing;
    }
    let samples = &recording.samples[still];
    let mut stretch = align::gather(samples.len() as f64 * recording.interval_s);
    for sample in samples {
        stretch.add(&sample.increment, recording.interval_s);
    }
    let heading = heading_deg.map(|heading| heading * DEGREE);
    let (file, kind) = (&recording.file, recording.kind);
    Ok(align::align(&stretch, kind, file, initial, heading, samples.len(), lost)?)
}

fn fly(
    recording: &Recording,
    flown: Range<usize>,
    start: &NavigationRow,
    is_aligned: bool,
    options: &Navigator,
    out: &Path,
) -> Result<(f64, Solution<f64>), FlightError> {
    let interval_s = interval(recording.interval_s);
    let shape = options.window.unwrap_or_else(|| plan::UNKNOWN.into());
    let initial = start.solution();
    let mut navigator = navigator::start(options, shape, plan::HIGHEST_ORDER, interval_s, &initial)
        .map_err(unavailable)?;
    let mut rows = Rows {
        writer: NavigationWriter::create(out)?,
        times_s: VecDeque::new(),
        last: (start.time_s, initial),
        written: Ok(()),
    };
    let progress = Progress::new(flown.len() as u64);
    let mut opening = (!is_aligned).then(|| Opening::new(&recording.file, recording.kind, start));
    let mut bridge = Bridge::new(options.gap.into());
    let mut gaps = recording.gaps().filter(|gap| gap.index > flown.start).peekable();
    for index in flown.clone() {
        let sample = recording.samples[index];
        if let Some(opening) = &mut opening {
            opening.add(&sample.increment, recording.interval_s)?;
        }
        let missing = missing(recording, index, gaps.next_if(|gap| gap.index == index))?;
        for behind in (0..=missing).rev() {
            rows.times_s.push_back(sample.time_s - behind as f64 * recording.interval_s);
            let taken = bridge.take((behind == 0).then_some(sample.increment), |increment| {
                navigator.push(increment, &mut |_, row| rows.add(row)).map_err(Refused::Rejected)
            });
            taken.map_err(|refused| refused_at(refused, recording, index, missing))?;
        }
        std::mem::replace(&mut rows.written, Ok(()))?;
        progress.reach((index - flown.start) as u64);
    }
    if let Some(opening) = &mut opening {
        opening.finish()?;
    }
    navigator.finish(&mut |_, row| rows.add(row));
    progress.finish();
    rows.written?;
    rows.writer.finish()?;
    Ok(rows.last)
}

/// The rows on their way to the file. A row's time is its sample's own; a bridged one's lies between.
struct Rows {
    writer: NavigationWriter,
    /// Times of the rows that are still to come.
    times_s: VecDeque<f64>,
    last: (f64, Solution<f64>),
    written: Result<(), InputError>,
}

impl Rows {
    fn add(&mut self, row: &Solution<f64>) {
        self.last = (self.times_s.pop_front().unwrap_or(self.last.0), *row);
        if self.written.is_ok() {
            self.written = self.writer.row(&NavigationRow::new(self.last.0, row));
        }
    }
}

fn unavailable(error: Unavailable) -> InputError {
    let option = match error {
        Unavailable::Window { .. } | Unavailable::NoWindow => "--window",
        Unavailable::TwoFloat => "--precision",
        Unavailable::Start(_) => "--initial",
    };
    InputError::option(option, error.complaint())
}

/// How many samples are missing before one. An error is a step that no whole number of them explains,
/// and one too long to bridge.
fn missing(recording: &Recording, index: usize, gap: Option<Gap>) -> Result<u64, InputError> {
    let Some(Gap { missing, step_s, .. }) = gap else { return Ok(0) };
    let complaint = if missing == 0 {
        let accepted = format!("steps of {} s", recording.interval_s);
        Complaint::new(format!("the step of {step_s} s is no sample"), accepted)
    } else if missing > MOST_BRIDGED {
        let accepted = format!("at most {MOST_BRIDGED}");
        Complaint::new(format!("{missing} samples are missing before this one"), accepted)
    } else {
        return Ok(missing);
    };
    Err(recording.error(index, complaint))
}

fn refused_at(refused: Refused, recording: &Recording, index: usize, missing: u64) -> FlightError {
    let complaint = match refused {
        Refused::Missing => {
            let what = format!("{missing} samples are missing before this one");
            Complaint::new(what, "--gap bridge, which fills them from their neighbours")
        }
        Refused::Rejected(why) => Complaint::new(why.to_string(), ""),
        Refused::Stopped(complaint) => complaint,
    };
    FlightError::Stopped(recording.error(index, complaint))
}

/// The interval to about twice the digits, where it is one over a whole rate.
fn interval(interval_s: f64) -> Pair<f64> {
    let rate = (1.0 / interval_s).round();
    if 1.0 / rate == interval_s { Pair::new(rate).reciprocal() } else { Pair::new(interval_s) }
}

/// Where it ends; for a vehicle that was at rest, how far it seems to have moved.
fn report(last: &(f64, Solution<f64>), start_s: f64, at_rest: Option<Solution<f64>>) -> String {
    let (time_s, solution) = last;
    let mut text = format!("navigated from {start_s} s to {time_s} s\n");
    if let Some(rest) = at_rest {
        let moved = drift(solution, &rest);
        let [north, east, down] = moved.position_ned.into_array();
        text += &format!(
            "had it stood still: drifted {north:.1} m north, {east:.1} m east, {down:.1} m down,\n"
        );
        let [north, east, down] = moved.velocity_ned.into_array();
        text += &format!("  at {north:.3} m/s north, {east:.3} m/s east, {down:.3} m/s down,\n");
        let [x, y, z] = moved.attitude_ned.map(|a| a / ARCSECOND).into_array();
        text += &format!("  turned {x:.1}″ about north, {y:.1}″ about east, {z:.1}″ about down\n");
    }
    text
}
