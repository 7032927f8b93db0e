//! `schuler replay`: navigates a recorded stream.

pub(crate) mod aided;
mod along;
mod biases;
mod bridged;
mod comparison;
mod files;
mod fly;
mod held;
pub(crate) mod initial;
mod page;
pub mod places;
mod report;
mod rows;
pub(crate) mod spans;
mod summary;
mod table;

pub use aided::kept::Kept;

use crate::cli::{Height, ReplayArgs};
use crate::report::sensors::Sensors;
use crate::report::traces::Traces;
use comparison::Has;
use files::ReportFiles;
use fly::{Flight, Orders};
use places::Places;
use schuler::flight::plan;
use schuler::solution::Solution;
use schuler::strapdown::block::window::{H0B4A0, Window as _};
use schuler_simulator::flight::Instant;
use schuler_simulator::input::name::name_of;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::number::parameter;
use schuler_simulator::output::{self, NumberRows, OutputFile, say};
use schuler_simulator::recording::heights::Heights;
use schuler_simulator::recording::navigation::NavigationRow;
use schuler_simulator::recording::reference::Reference;
use schuler_simulator::recording::rows::Recording;
use schuler_simulator::recording::samples::Samples;
use schuler_simulator::recording::survey::Survey;
use schuler_simulator::scene::{Algorithm, Navigator, Vertical, WindowShape};
use schuler_simulator::simulate::FlightError;
use std::path::Path;
use summary::About;

/// Navigates a recording and writes `nav.csv`, a row per sample or fewer. Prints what its stamps say, what
/// was aligned to, and where the vehicle ends up.
///
/// The recording is gone through twice, once to look and once to navigate (once more for a report's page), and never
/// held in memory; the rows are, where there is a reference to compare them with.
pub fn replay(args: &ReplayArgs) -> Result<(), FlightError> {
    args.check()?;
    let recording = Recording::open_as(&name_of(&args.imu), &args.given())?;
    let places = Places::new(&args.out, args.reference.is_some(), args.svg);
    let stale = places.stale();
    let Replayed { text, files, .. } = fly(args, &recording, false)?;
    output::place(files, &stale)?;
    let report = places.report.map(|folder| format!(", its report to {}", folder.display()));
    let messages = args.mcap.as_deref().map(|file| format!(", messages to {}", file.display()));
    let nav = places.nav.display();
    let [report, messages] = [report, messages].map(Option::unwrap_or_default);
    say(&format!("{text}written to {nav}{messages}{report}\n"))?;
    Ok(())
}

/// A replay that has reached its end.
pub struct Replayed {
    /// What is said of its end.
    pub text: String,
    /// Where it started, at a time, s.
    pub start: (f64, Solution<f64>),
    /// Digest of every state.
    pub digest: u64,
    /// The window.
    pub window: Option<WindowShape>,
    /// The rows of `nav.csv`, where they are wanted.
    pub rows: NumberRows,
    /// What an aided flight leaves beside them, where that is wanted.
    pub aided: Option<Kept>,
    /// `summary.json` and `report.html`, where it is compared and its rows are wanted.
    pub report: Option<[String; 2]>,
    /// Every file, not in its place yet.
    pub files: Vec<OutputFile>,
}

/// Flies a recording. Its rows are wanted in memory, too, where `keep` says so.
pub fn fly(args: &ReplayArgs, recording: &Recording, keep: bool) -> Result<Replayed, FlightError> {
    let mut options = Navigator::default();
    args.navigator.apply(&mut options)?;
    args.handling.apply(&mut options);
    options.vertical = args.vertical();
    let reference =
        args.reference.as_ref().map(|file| Reference::open(&name_of(file), recording.scale));
    let reference = reference.transpose()?;
    if let Some(gnss) = &args.aiding.gnss {
        return aided(args, gnss, recording, &options, reference.as_ref(), keep);
    }
    let (initial, args) = &initial::initial(args, recording)?;

    let measured = spans::about(args, initial);
    let survey = Survey::of(recording, args.rate.map(|rate_hz| 1.0 / rate_hz), measured)?;
    let spans = spans::Spans::new(args, &survey, initial)?;
    let end_s = spans.until_s.min(survey.end_s);
    if let Some(reference) = &reference {
        comparison::check(reference, spans.navigate_s, end_s)?;
    }
    let shape = shape(&options, &survey);
    for line in survey.said(recording) {
        say(&format!("{line}\n"))?;
    }
    if options.algorithm == Algorithm::Taylor {
        let WindowShape { history, block, lookahead } = shape;
        let how = if options.window.is_some() { "as asked" } else { "by the samples" };
        let motion = survey.motion_said();
        say(&format!("window {history},{block},{lookahead} {how}: {motion}\n"))?;
    }
    let heights = heights(args, &options, initial, [spans.navigate_s, end_s])?;
    let window = (options.algorithm == Algorithm::Taylor).then_some(shape);
    let tail = Tail {
        args,
        recording,
        survey: &survey,
        spans: &spans,
        options: &options,
        shape,
        reference: reference.as_ref(),
        keep,
    };
    let replayed = tail.tell(&mut |nav| {
        let orders = Orders { args, options, shape, heights: heights.clone(), nav, keep };
        let flight = fly::fly(recording, &survey, &spans, initial, &orders)?;
        let text = report::text(&flight, &spans, args.align.is_some());
        Ok((flight, text))
    })?;
    Ok(Replayed { window, ..replayed })
}

/// The same with what aids it.
fn aided(
    args: &ReplayArgs,
    gnss: &Path,
    recording: &Recording,
    options: &Navigator,
    reference: Option<&Reference>,
    keep: bool,
) -> Result<Replayed, FlightError> {
    let span = (args.start.unwrap_or(f64::NEG_INFINITY), args.until.unwrap_or(f64::INFINITY));
    let survey = Survey::of(recording, args.rate.map(|rate_hz| 1.0 / rate_hz), span)?;
    for line in survey.said(recording) {
        say(&format!("{line}\n"))?;
    }
    let given = aided::given::given(args, gnss, recording, &survey)?;
    let beginning = aided::start::beginning(args, recording, &survey, &given)?;
    let (args, spans) = (&beginning.args, &beginning.spans);
    if let Some(reference) = reference {
        comparison::check(reference, spans.navigate_s, spans.until_s.min(survey.end_s))?;
    }
    let shape = H0B4A0::SHAPE;
    let tail = Tail { args, recording, survey: &survey, spans, options, shape, reference, keep };
    let replayed = tail.tell(&mut |nav| {
        let places = (nav, keep);
        let (flight, text) =
            aided::fly::fly(recording, &survey, &beginning, &given, options, places)?;
        let text = report::text(&flight, spans, false) + &text;
        Ok((flight, text))
    })?;
    Ok(Replayed { window: Some(shape), ..replayed })
}

/// What comes after a flight is known to be possible: it, its files, and what is told of it.
struct Tail<'a> {
    args: &'a ReplayArgs,
    recording: &'a Recording,
    survey: &'a Survey,
    spans: &'a spans::Spans,
    options: &'a Navigator,
    shape: WindowShape,
    reference: Option<&'a Reference>,
    keep: bool,
}

/// A flight whose rows go to a file, and what is said of it.
type Fly<'a> = dyn FnMut(&Path) -> Result<(Flight, String), FlightError> + 'a;

impl Tail<'_> {
    fn tell(&self, fly: &mut Fly<'_>) -> Result<Replayed, FlightError> {
        let Self { args, recording, survey, spans, options, shape, reference, keep } = *self;
        let places = Places::new(&args.out, reference.is_some(), args.svg);
        let has = reference.map(|r| Has { velocity: r.has_velocity, attitude: r.has_attitude });
        let files = has.map(|has| ReportFiles::create(&places, has, args.aiding.gnss.is_some()));
        let mut files = files.transpose()?.flatten();
        let (mut flight, mut text) = fly(&places.nav)?;
        let (mut filled, mut report) = (Vec::new(), None);
        if let (Some(reference), Some(track)) = (reference, flight.track.take()) {
            let mut traces = Traces::default();
            let mut row = |instant: &Instant| {
                traces.row(&Instant { time_s: instant.time_s - spans.navigate_s, ..*instant });
                files.as_mut().map_or(Ok(()), |files| files.row(instant))
            };
            let comparison = comparison::compare(&track, reference, args.lag, &mut row)?;
            let (imu, rate_hz) = (recording.name.as_str(), 1.0 / survey.clock.interval_s());
            let about = About { imu, rate_hz, options, shape, spans };
            text += &table::table(&comparison);
            if keep || files.is_some() {
                let sensors = read(recording, survey, [spans.navigate_s, flight.last.0])?;
                let shown = (&traces, &sensors);
                report = keep.then(|| {
                    let summary = summary::json(&flight, &comparison, &about, &[]);
                    [summary, page::page(&flight, &comparison, &about, shown)]
                });
                let files = files.map(|files| files.fill(&flight, &comparison, &about, shown));
                filled = files.transpose()?.unwrap_or_default();
            }
        }
        let start = (spans.navigate_s, flight.start);
        let files = flight.nav.into_iter().chain(filled).collect();
        let Flight { digest, rows, aided, .. } = flight;
        Ok(Replayed { text, start, digest, window: None, rows, aided, report, files })
    }
}

/// What the sensors put out from one time to another, s: the recording read once more.
fn read(
    recording: &Recording,
    survey: &Survey,
    [from_s, to_s]: [f64; 2],
) -> Result<Sensors, FlightError> {
    let mut samples = Samples::new(recording, survey, None)?;
    let mut sensors = Sensors::default();
    while let Some(sample) = samples.advance()? {
        if sample.end_s > from_s && sample.end_s <= to_s && !sample.filled {
            sensors.row(sample.end_s - from_s, &sample.increment, sample.interval_s);
        }
    }
    Ok(sensors)
}

/// The height that the vertical is held to, where it is; it must be known all along, s.
fn heights(
    args: &ReplayArgs,
    options: &Navigator,
    initial: &NavigationRow,
    [from_s, to_s]: [f64; 2],
) -> Result<Option<Heights>, FlightError> {
    if options.vertical == Vertical::Free {
        return Ok(None);
    }
    let own_m = initial.position.altitude;
    let (heights, whose) = match &args.height {
        None => (Heights::constant(own_m), "the altitude of the start".to_owned()),
        Some(Height::Metres(metres)) => (Heights::constant(*metres), format!("{metres} m")),
        Some(Height::File(file)) => {
            let name = name_of(file);
            let heights = Heights::read(&name)?;
            // Half a second beyond the ends is no more than a sample.
            if let Some([first_s, last_s]) = heights.span_s()
                && (first_s > from_s + 0.5 || last_s < to_s - 0.5)
            {
                let what = format!("has heights from {first_s} to {last_s} s alone");
                let accepted = format!("heights from {from_s} to {to_s} s, which is flown");
                return Err(InputError::file(&name, Complaint::new(what, accepted)).into());
            }
            (heights, name)
        }
    };
    let [altitude_m, _] = heights.at(from_s);
    let off = match altitude_m - own_m {
        0.0 => String::new(),
        off_m => format!(", at the start {} m from the initial altitude", parameter(off_m)),
    };
    say(&format!("vertical held to {whose}{off}\n"))?;
    Ok(Some(heights))
}

/// The window to fly: what is asked for, else what the samples support.
fn shape(options: &Navigator, survey: &Survey) -> WindowShape {
    let supported = survey.window.unwrap_or(plan::UNKNOWN);
    options.window.unwrap_or(supported)
}
