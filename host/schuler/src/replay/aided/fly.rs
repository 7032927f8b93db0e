//! The flight of an aided replay.

use super::given::Given;
use super::grid::Grid;
use super::kept::Kept;
use super::rows::{AidedRows, write};
use super::start::{AT_REST, Beginning, GIVEN, How};
use super::withheld::{self, Withheld};
use crate::cli::Span;
use crate::replay::along::{Flies, Flown, Start, along};
use crate::replay::biases::Biases;
use crate::replay::fly::Flight;
use crate::replay::rows::Finished;
use schuler::aiding::aided::measured::Measured;
use schuler::aiding::aided::settings::{Settings, Start as First};
use schuler::aiding::states::Process;
use schuler::math::vector::Vector;
use schuler::solution::Solution;
use schuler_simulator::aided::measurements::Arriving;
use schuler_simulator::aided::navigator::{self, Made};
use schuler_simulator::aided::report::Judgement;
use schuler_simulator::aided::rows;
use schuler_simulator::aided::smoother;
use schuler_simulator::aided::unit;
use schuler_simulator::aided::vehicle::AidedVehicle;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::number::counted;
use schuler_simulator::recording::rows::Recording;
use schuler_simulator::recording::samples::Sample;
use schuler_simulator::recording::survey::Survey;
use schuler_simulator::rest::fine::Refined;
use schuler_simulator::scene::Navigator;
use schuler_simulator::simulate::FlightError;
use std::collections::VecDeque;
use std::path::Path;

/// What flies.
struct Flying<'a> {
    recording: &'a Recording,
    vehicle: AidedVehicle,
    biases: Biases,
    rows: AidedRows,
    /// Where samples are at times of their own.
    grid: Option<Grid>,
    /// Stamps and ends of samples that wait in a block, s.
    ends_s: VecDeque<[f64; 2]>,
    integrated: u64,
    samples: u64,
    /// The velocity at the end of the last block, and when that was, s.
    before: (Vector<f64>, f64),
    withheld: Vec<Withheld>,
    lever_b: Vector<f64>,
    /// When it begins, s, and samples per second.
    began: (f64, f64),
    /// Measurements of times before the start.
    early: usize,
    /// Whether what it leaves is wanted in memory, too.
    keep: bool,
}

/// Flies it; the text is what became of the measurements.
pub fn fly(
    recording: &Recording,
    survey: &Survey,
    beginning: &Beginning,
    given: &Given,
    options: &Navigator,
    (nav, keep): (&Path, bool),
) -> Result<(Flight, String), FlightError> {
    let Beginning { row, args, spans, how } = beginning;
    let spans_s: Vec<_> = args.aiding.withhold.iter().map(|Span(span_s)| *span_s).collect();
    let flown = along(recording, survey, spans, row, args, options.gap, &mut |start, first| {
        let (row, refined) = start;
        let settings = settings(given, *how, start);
        let begin_s = ((first.end_s - first.interval_s) * 1e9).round() / 1e9;
        let mut told = given.fixes.rows.clone();
        let withheld = withheld::hide(&mut told, &spans_s);
        let mut arriving: Vec<Arriving> =
            told.iter().filter_map(|told| told.arriving(begin_s, given.rate_hz)).collect();
        // The order of rows does not count.
        let key = |m: &Measured<f64>| (m.at.samples as f64 + m.at.part, m.sensor());
        arriving.sort_by(|(a, one), (b, other)| {
            let ((t, x), (u, y)) = (key(one), key(other));
            a.total_cmp(b).then(x.cmp(&y)).then(t.total_cmp(&u))
        });
        let end_s = spans.until_s.min(survey.end_s);
        if !told.iter().any(|told| (begin_s..=end_s).contains(&told.time_s)) {
            let times = told.iter().map(|told| told.time_s);
            let first = times.clone().fold(f64::INFINITY, f64::min);
            let last = times.fold(f64::NEG_INFINITY, f64::max);
            let what = format!(
                "has measurements of {first:.3} to {last:.3} s alone, by the recording's time, of which {begin_s:.3} to {end_s:.3} s are flown"
            );
            let accepted = "some between, by --time-tag, or by --gnss-lag, which shifts them";
            return Err(InputError::file(&given.fixes.name, Complaint::new(what, accepted)).into());
        }
        let Given { interval, rate_hz, .. } = *given;
        let initial = row.solution();
        let smoother = args.aiding.smooth.is_some();
        if smoother {
            smoother::check(end_s - begin_s, settings.step_s, arriving.len())
                .map_err(|complaint| InputError::option("--smooth", complaint))?;
        }
        let made = Made { navigator: options, interval, rate_hz, settings: &settings, smoother };
        let navigator = navigator::begin(&made, &initial).map_err(blamed)?;
        let mcap = args.mcap.as_deref();
        let at = (spans.navigate_s, initial);
        let is_compared = args.reference.is_some();
        let rows =
            AidedRows::new((nav, keep), mcap, args.every, at, is_compared, navigator.as_ref())?;
        Ok(Flying {
            recording,
            began: (begin_s, rate_hz),
            early: told.len() - arriving.len(),
            vehicle: AidedVehicle::with(navigator, arriving, rate_hz),
            biases: refined.map(|refined| Biases::of(&refined.aligned)).unwrap_or_default(),
            rows,
            keep,
            grid: (!given.is_even).then(|| Grid::new(begin_s, interval.hi)),
            ends_s: VecDeque::new(),
            integrated: 0,
            samples: 0,
            before: (row.velocity_ned, begin_s),
            withheld,
            lever_b: settings.lever_b,
        })
    })?;
    let Flown { flying, start, bridged, outside } = flown;
    let smooth = args.aiding.smooth.as_deref();
    let (flight, text) = flying.finish(start.solution(), smooth)?;
    Ok((Flight { bridged, outside, ..flight }, text))
}

/// The filter from how it starts.
fn settings(given: &Given, how: How, (_, refined): Start) -> Settings<f64> {
    let mut settings = given.settings;
    let First { position_m, velocity_m_s, level_rad, heading_rad } = settings.start;
    let known = [position_m, velocity_m_s, level_rad, heading_rad];
    let sigma = match how {
        How::Given => unit::start(&given.unit, true, known, GIVEN),
        How::Fix(sigma) => unit::start(&given.unit, false, known, sigma),
        How::Rest => {
            let found = refined.map_or(AT_REST, |Refined { aligned, .. }| {
                let [north, east] = aligned.level_sigma;
                [AT_REST[0], AT_REST[1], north.max(east), aligned.heading_sigma]
            });
            unit::start(&given.unit, false, known, found)
        }
    };
    let [position_m, velocity_m_s, level_rad, heading_rad] = sigma;
    settings.start = First { position_m, velocity_m_s, level_rad, heading_rad };
    if let Some(Refined { aligned, .. }) = refined {
        let most = |v: Vector<f64>| v.into_array().into_iter().fold(0.0, f64::max);
        let states = &mut settings.states;
        states.gyro_bias = found(states.gyro_bias, most(aligned.gyro_bias[1]));
        states.accelerometer_bias =
            found(states.accelerometer_bias, most(aligned.accelerometer_bias[1]));
    }
    settings
}

/// A bias of which an alignment has found a part: what is left.
fn found(bias: Process<f64>, sigma: f64) -> Process<f64> {
    match bias {
        Process::Constant(_) => Process::constant(sigma),
        Process::RandomWalk(walk) => Process::random_walk(sigma, walk.per_root_s),
        stationary => stationary,
    }
}

/// A complaint of a scene's key as one of the option that stands for it.
fn blamed(error: InputError) -> InputError {
    let key = error.key.as_deref().map(|key| match key.strip_prefix("navigator.") {
        Some(option) => format!("--{option}"),
        None => "--sensors".to_owned(),
    });
    InputError { key, ..error }
}

impl Flies for Flying<'_> {
    fn take(&mut self, sample: &Sample) -> Result<(), FlightError> {
        match &mut self.grid {
            None => self.push(sample),
            Some(grid) => grid.cut(sample).iter().try_for_each(|sample| self.push(sample)),
        }
    }
}

impl Flying<'_> {
    fn push(&mut self, sample: &Sample) -> Result<(), FlightError> {
        self.ends_s.push_back([sample.time_s, sample.end_s]);
        self.samples += 1;
        self.vehicle.push(&self.biases.taken_off(sample)).map_err(|fault| {
            let complaint = Complaint::new(fault.to_string(), "");
            FlightError::Stopped(self.recording.error(sample.line, complaint))
        })?;
        let navigator = self.vehicle.navigator();
        let mut block = None;
        while self.integrated < navigator.integrated() {
            block = self.ends_s.pop_front();
            self.integrated += 1;
        }
        let Some([time_s, end_s]) = block else { return Ok(()) };
        let state = navigator.solution();
        self.rows.add([time_s, end_s], &state, navigator)?;
        let (velocity, before_s) = self.before;
        for withheld in &mut self.withheld {
            let block = (velocity, end_s - before_s);
            withheld.look(end_s, &state, block, &|| navigator.covariance(), self.lever_b);
        }
        self.before = (state.velocity_ned.map(|v| v.hi), end_s);
        Ok(())
    }

    fn finish(
        mut self,
        start: Solution<f64>,
        smooth: Option<&Path>,
    ) -> Result<(Flight, String), FlightError> {
        self.vehicle.finish().map_err(|fault| {
            let complaint = Complaint::new(fault.to_string(), "");
            FlightError::Stopped(InputError::file(&self.recording.name, complaint))
        })?;
        let navigator = self.vehicle.navigator();
        if self.integrated > 0 {
            self.rows.correct(&navigator.solution(), navigator);
        }
        let report = self.vehicle.report().since(self.began.0);
        let mut text = crate::aided::lines(&report);
        text += &crate::aided::found(&navigator.found());
        if self.early > 0 {
            let early = counted(self.early as u64, "measurement is", "measurements are");
            text += &format!("{early} of times before the start\n");
        }
        text += &withheld::lines(&self.withheld);
        let digest = navigator.digest();
        let (neglected, last, samples) =
            (self.rows.highest.neglected(), self.rows.last, self.samples);
        let (Finished { files: mut nav, track, kept: rows }, estimates) = self.rows.finish()?;
        let (begin_s, rate_hz) = self.began;
        let mut smoothed = None;
        if let Some(smooth) = smooth {
            let states = navigator.smoothed();
            let states = rows::smoothed(&states, |samples| begin_s + samples as f64 / rate_hz);
            nav.push(write(smooth, &states)?);
            text += &format!("smoothed {} states, written to {}\n", states.len(), smooth.display());
            smoothed = Some(states);
        }
        let measurements = Some(report.clone());
        let aided = self.keep.then(|| {
            let judged = navigator.judged().iter();
            let judged = judged.map(|one| Judgement { time_s: begin_s + one.time_s, ..*one });
            let judged = judged.collect();
            Kept { report, judged, estimates, smoothed, withheld: withheld::table(&self.withheld) }
        });
        let (bridged, outside) = (Default::default(), (0, None));
        let flight = Flight {
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
            measurements,
            aided,
        };
        Ok((flight, text))
    }
}
