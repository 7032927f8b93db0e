//! The way along a recording: sample by sample, through alignment and on.

use super::bridged::Bridged;
use super::spans::{Place, Spans};
use crate::cli::ReplayArgs;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::number::counted;
use schuler_simulator::progress::Progress;
use schuler_simulator::recording::clock::Clock;
use schuler_simulator::recording::navigation::NavigationRow;
use schuler_simulator::recording::rows::Recording;
use schuler_simulator::recording::samples::{MOST_BRIDGED, Sample, Samples};
use schuler_simulator::recording::survey::Survey;
use schuler_simulator::recording::timeline::Misfit;
use schuler_simulator::rest::align::{self, Heading};
use schuler_simulator::rest::fine::{Refined, Stretch};
use schuler_simulator::scene::Gap as Policy;
use schuler_simulator::simulate::FlightError;
use schuler_simulator::units::DEGREE;

/// What takes samples.
pub(super) trait Flies {
    /// Takes the next one.
    fn take(&mut self, sample: &Sample) -> Result<(), FlightError>;
}

/// How far something flew.
pub(super) struct Flown<F> {
    /// It.
    pub flying: F,
    /// Where it started.
    pub start: NavigationRow,
    /// What was made up for.
    pub bridged: Bridged,
    /// Lines that could not be read outside what was flown: how many, and the first.
    pub outside: (u64, Option<InputError>),
}

/// Where something starts: the row, and what an alignment found.
pub(super) type Start<'a> = (&'a NavigationRow, Option<&'a Refined>);

/// Goes along a recording: aligns where that is asked, and lets what then begins take the samples that are flown.
pub(super) fn along<F: Flies>(
    recording: &Recording,
    survey: &Survey,
    spans: &Spans,
    initial: &NavigationRow,
    args: &ReplayArgs,
    gap: Policy,
    begin: &mut dyn FnMut(Start, &Sample) -> Result<F, FlightError>,
) -> Result<Flown<F>, FlightError> {
    let mut samples = Samples::new(recording, survey, Some(spans.begin_s))?;
    let mut still = align::gather(spans.navigate_s - spans.begin_s);
    // Stamps that are no constant rate give the means alone.
    let even = matches!(survey.clock, Clock::Even { .. });
    let mut stretch = (even && !args.coarse).then(|| Stretch::new(survey.clock.interval()));
    // Of the stretch at rest: samples that were there, and that were missing.
    let (mut there, mut lost) = (0, 0);
    let mut flying: Option<F> = None;
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
                bridgeable(recording, &sample, gap, within)?;
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
                        bridgeable(recording, &sample, gap, true)?;
                        flying
                    }
                    none => {
                        bridgeable(recording, &sample, gap, sample.filled)?;
                        spans.check_first(&sample, begun)?;
                        let mut refined = None;
                        if args.align.is_some() {
                            let stated = |heading| Heading::Known(heading * DEGREE);
                            let heading = args.heading.map_or(Heading::FoundOrStated, stated);
                            let (name, kind) = (&recording.name, recording.kind);
                            let fine = stretch.as_ref();
                            (start, refined) = align::align(
                                &still, kind, name, initial, heading, there, lost, fine,
                            )?;
                        }
                        none.insert(begin((&start, refined.as_ref()), &sample)?)
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
    Ok(Flown { flying, start, bridged, outside })
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
        "{} missing before this one, {:.6} s",
        counted(missing, "sample is", "samples are"),
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
