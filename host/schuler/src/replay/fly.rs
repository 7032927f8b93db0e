//! The flight through a recording, by inertia alone.

use super::aided::kept::Kept;
use super::along::{Flies, Flown, along};
use super::biases::Biases;
pub use super::bridged::Bridged;
use super::held::Held;
use super::rows::{Finished, Rows};
use super::spans::Spans;
use crate::cli::ReplayArgs;
use schuler::flight::plan;
use schuler::solution::Solution;
use schuler_simulator::aided::report::Report;
use schuler_simulator::high::Neglected;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::navigator::{self, Navigate, Unavailable};
use schuler_simulator::output::{NumberRows, OutputFile, large_table, say_error};
use schuler_simulator::recording::clock::Clock;
use schuler_simulator::recording::heights::Heights;
use schuler_simulator::recording::navigation::{COLUMNS, NavigationRow};
use schuler_simulator::recording::rows::Recording;
use schuler_simulator::recording::samples::Sample;
use schuler_simulator::recording::survey::Survey;
use schuler_simulator::recording::track::Track;
use schuler_simulator::rest::opening::Opening;
use schuler_simulator::scene::{Navigator, WindowShape};
use schuler_simulator::simulate::FlightError;
use std::path::Path;

/// What came of it.
pub struct Flight {
    /// Where it started.
    pub start: Solution<f64>,
    /// The last row and its time, s.
    pub last: (f64, Solution<f64>),
    /// What was made up for.
    pub bridged: Bridged,
    /// Lines that could not be read outside what was flown: how many, and the first.
    pub outside: (u64, Option<InputError>),
    /// What the series of gravity neglects at the height reached.
    pub neglected: Option<Neglected>,
    /// Samples that were flown.
    pub samples: u64,
    /// Digest of every state.
    pub digest: u64,
    /// `nav.csv` and the messages, not in their places yet.
    pub nav: Vec<OutputFile>,
    /// Every row, where they are to be compared.
    pub track: Option<Track>,
    /// The rows of `nav.csv`, where they are wanted.
    pub rows: NumberRows,
    /// What became of an aided flight's measurements.
    pub measurements: Option<Report>,
    /// What an aided flight leaves beside them, where that is wanted.
    pub aided: Option<Kept>,
}

/// What a flight is flown by.
pub struct Orders<'a> {
    /// The command line.
    pub args: &'a ReplayArgs,
    /// How to navigate.
    pub options: Navigator,
    /// The window.
    pub shape: WindowShape,
    /// The height that the vertical is held to.
    pub heights: Option<Heights>,
    /// Where the rows go.
    pub nav: &'a Path,
    /// Whether they are wanted in memory, too.
    pub keep: bool,
}

/// What every sample is flown with.
struct Flying<'a> {
    recording: &'a Recording,
    even: bool,
    navigator: Box<dyn Navigate>,
    rows: Rows,
    held: Option<Held<'a>>,
    samples: u64,
    /// Where it was not aligned.
    opening: Option<Opening<'a>>,
    biases: Biases,
}

/// Flies a recording and writes its rows.
pub fn fly(
    recording: &Recording,
    survey: &Survey,
    spans: &Spans,
    initial: &NavigationRow,
    orders: &Orders,
) -> Result<Flight, FlightError> {
    let (args, gap) = (orders.args, orders.options.gap);
    let flown = along(recording, survey, spans, initial, args, gap, &mut |(start, refined), _| {
        let biases = refined.map(|refined| Biases::of(&refined.aligned)).unwrap_or_default();
        Ok(Flying { biases, ..Flying::new(recording, survey, spans, orders, start)? })
    })?;
    let Flown { flying, start, bridged, outside } = flown;
    let flight = flying.finish(start.solution())?;
    Ok(Flight { bridged, outside, ..flight })
}

impl<'a> Flying<'a> {
    fn new(
        recording: &'a Recording,
        survey: &Survey,
        spans: &Spans,
        orders: &'a Orders,
        start: &NavigationRow,
    ) -> Result<Self, FlightError> {
        let Orders { args, options, shape, heights, nav, keep } = orders;
        let (order, interval) = (plan::HIGHEST_ORDER, survey.clock.interval());
        let opening = args.align.is_none();
        let opening = opening.then(|| Opening::new(&recording.name, recording.kind, start));
        let start = (spans.navigate_s, start.solution());
        let navigator =
            navigator::start(options, *shape, order, interval, &start.1).map_err(unavailable)?;
        let interval_s = survey.clock.interval_s();
        let samples = (spans.until_s.min(survey.end_s) - start.0) / interval_s;
        let kept =
            args.every.map_or(samples as u64, |every| every.kept(samples as u64, interval_s));
        if let Some(warning) = large_table(nav, kept, COLUMNS.len()) {
            say_error(&warning);
        }
        let even = matches!(survey.clock, Clock::Even { .. });
        let mcap = args.mcap.as_deref();
        let rows = Rows::new(nav, mcap, args.every, start, args.reference.is_some(), *keep)?;
        let held = heights.as_ref().map(Held::new);
        let biases = Biases::default();
        Ok(Self { recording, even, navigator, rows, held, samples: 0, opening, biases })
    }

    /// The end of a flight that started in a state.
    fn finish(self, start: Solution<f64>) -> Result<Flight, InputError> {
        let Self { mut navigator, mut rows, mut opening, samples, .. } = self;
        if let Some(opening) = &mut opening {
            opening.finish()?;
        }
        navigator.finish(&mut |_, row| rows.add(row));
        let (neglected, last) = (rows.highest.neglected(), rows.last);
        let Finished { files: nav, track, kept: rows } = rows.finish()?;
        let (bridged, outside) = (Bridged::default(), (0, None));
        let digest = navigator.digest();
        let aided = None;
        Ok(Flight {
            start,
            last,
            bridged,
            outside,
            neglected,
            samples,
            digest,
            nav,
            track,
            rows,
            measurements: None,
            aided,
        })
    }
}

impl Flies for Flying<'_> {
    fn take(&mut self, sample: &Sample) -> Result<(), FlightError> {
        let Self { recording, even, navigator, rows, held, samples, opening, biases } = self;
        if let Some(opening) = opening {
            opening.add(&sample.increment, sample.interval_s)?;
        }
        rows.expect(sample.time_s, sample.end_s);
        *samples += 1;
        let increment = biases.taken_off(sample);
        let taken = if *even {
            navigator.push(&increment, &mut |_, row| rows.add(row))
        } else {
            let interval_s = sample.interval_s;
            navigator.push_over(&increment, interval_s, &mut |_, row| rows.add(row))
        };
        let taken = taken.and_then(|()| match held {
            Some(held) => held.hold(navigator.as_mut(), sample.end_s),
            None => Ok(()),
        });
        taken.map_err(|why| {
            let complaint = Complaint::new(why.to_string(), "");
            FlightError::Stopped(recording.error(sample.line, complaint))
        })?;
        Ok(rows.check()?)
    }
}

fn unavailable(error: Unavailable) -> InputError {
    let option = match error {
        Unavailable::Window { .. } | Unavailable::NoWindow => "--window",
        Unavailable::TwoFloat => "--precision",
        Unavailable::Start(_) => "--initial",
        Unavailable::Alignment { .. } | Unavailable::NoAlignment(_) => "--align",
    };
    InputError::option(option, error.complaint())
}
