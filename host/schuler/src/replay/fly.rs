//! The flight through a recording: samples one by one, for alignment or navigation.

use super::biases::Biases;
pub use super::bridged::Bridged;
use super::held::Held;
use super::rows::{Finished, Rows};
use super::spans::{Place, Spans};
use crate::cli::ReplayArgs;
use schuler::flight::plan;
use schuler::solution::Solution;
use schuler_simulator::high::Neglected;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::navigator::{self, Navigate, Unavailable};
use schuler_simulator::output::{OutputFile, large_table};
use schuler_simulator::progress::Progress;
use schuler_simulator::recording::clock::Clock;
use schuler_simulator::recording::heights::Heights;
use schuler_simulator::recording::navigation::{COLUMNS, NavigationRow};
use schuler_simulator::recording::rows::Recording;
use schuler_simulator::recording::samples::{MOST_BRIDGED, Sample, Samples};
use schuler_simulator::recording::survey::Survey;
use schuler_simulator::recording::timeline::Misfit;
use schuler_simulator::recording::track::Track;
use schuler_simulator::rest::align;
use schuler_simulator::rest::fine::Stretch;
use schuler_simulator::rest::opening::Opening;
use schuler_simulator::scene::{Gap as Policy, Navigator, WindowShape};
use schuler_simulator::simulate::FlightError;
use schuler_simulator::units::DEGREE;
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
    pub rows: Vec<NavigationRow>,
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
    let (args, options) = (orders.args, &orders.options);
    let mut samples = Samples::new(recording, survey, Some(spans.begin_s))?;
    let mut still = align::gather(spans.navigate_s - spans.begin_s);
    // Stamps that are no constant rate give the means alone.
    let even = matches!(survey.clock, Clock::Even { .. });
    let mut stretch = (even && !args.coarse).then(|| Stretch::new(survey.clock.interval()));
    // Of the stretch at rest: samples that were there, and that were missing.
    let (mut there, mut lost) = (0, 0);
    let mut flying: Option<Flying> = None;
    let mut start = *initial;
    let mut bridged = Bridged::default();
    let mut outside = (0, None);
    let mut begun = false;
    let progress = Progress::new(survey.rows);
    let mut count = 0;
    while let Some(sample) = samples.advance()? {
        pass_over(&sample.unread, spans, &mut outside)?;
        count += 1;
        match spans.place(sample.end_s) {
            Place::Before => continue,
            Place::Still => {
                begun |= there == 0 && spans.begins_at(&sample, spans.begin_s);
                // What is missing before the stretch is no loss to it.
                let within = there > 0 || sample.filled;
                bridgeable(recording, &sample, options.gap, within)?;
                if sample.filled {
                    lost += 1;
                } else {
                    there += 1;
                    still.add(&sample.increment, sample.interval_s);
                }
                // A sample that fills a gap belongs to the filter's time, too.
                if let Some(stretch) = &mut stretch {
                    stretch.add(&sample.increment);
                }
            }
            Place::Flown => {
                let flying = match &mut flying {
                    Some(flying) => {
                        bridgeable(recording, &sample, options.gap, true)?;
                        flying
                    }
                    none => {
                        bridgeable(recording, &sample, options.gap, sample.filled)?;
                        spans.check_first(&sample, begun)?;
                        let mut refined = None;
                        if args.align.is_some() {
                            let heading = args.heading.map(|heading| heading * DEGREE);
                            let (name, kind) = (&recording.name, recording.kind);
                            let fine = stretch.as_ref();
                            (start, refined) = align::align(
                                &still, kind, name, initial, heading, there, lost, fine,
                            )?;
                        }
                        let biases = refined.map(|refined| Biases::of(&refined.aligned));
                        let flying = Flying::new(recording, survey, spans, orders, &start)?;
                        none.insert(Flying { biases: biases.unwrap_or_default(), ..flying })
                    }
                };
                if sample.filled {
                    bridged.add(&sample);
                }
                flying.take(&sample)?;
            }
            Place::After => break,
        }
        progress.reach(count);
    }
    pass_over(samples.trailing(), spans, &mut outside)?;
    progress.finish();
    let flying = flying.ok_or_else(|| spans.empty())?;
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
            eprintln!("{warning}");
        }
        let even = matches!(survey.clock, Clock::Even { .. });
        let mcap = args.mcap.as_deref();
        let rows = Rows::new(nav, mcap, args.every, start, args.reference.is_some(), *keep)?;
        let held = heights.as_ref().map(Held::new);
        let biases = Biases::default();
        Ok(Self { recording, even, navigator, rows, held, samples: 0, opening, biases })
    }

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
        let flown =
            Flight { start, last, bridged, outside, neglected, samples, digest, nav, track, rows };
        Ok(flown)
    }
}

/// Refuses lines that could not be read where they are needed, and counts the others.
fn pass_over(
    unread: &[Misfit],
    spans: &Spans,
    outside: &mut (u64, Option<InputError>),
) -> Result<(), InputError> {
    for misfit in unread {
        if matches!(spans.place(misfit.time_s), Place::Still | Place::Flown) {
            return Err(misfit.error.clone());
        }
        outside.0 += 1;
        outside.1.get_or_insert_with(|| misfit.error.clone());
    }
    Ok(())
}

/// Refuses a sample that fills a gap, unless gaps are bridged, and one after a gap that is too long.
fn bridgeable(
    recording: &Recording,
    sample: &Sample,
    policy: Policy,
    within: bool,
) -> Result<(), FlightError> {
    let missing = sample.missing;
    if missing == 0 || !within {
        return Ok(());
    }
    let what = format!(
        "{missing} samples are missing before this one, {:.6} s",
        missing as f64 * sample.interval_s
    );
    let complaint = if missing > MOST_BRIDGED {
        Complaint::new(what, format!("at most {MOST_BRIDGED}"))
    } else if policy == Policy::Error {
        Complaint::new(what, "--gap bridge, which fills them from their neighbours")
    } else {
        return Ok(());
    };
    Err(FlightError::Stopped(recording.error(sample.line, complaint)))
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
