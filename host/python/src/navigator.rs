//! A navigator step by step, one of the catalogue.

use crate::arrays::{Samples, increment, numbers};
use crate::error::{Answer, Fault, refused};
use crate::interrupt::Watch;
use crate::options::{OF_NAVIGATOR, Options};
use crate::state::State;
use crate::table::{Rows, Table};
use numpy::ndarray::{ArrayView1, ArrayView2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use schuler::flight::catalogue::{Catalogue as _, Every};
use schuler::flight::configuration::{Algorithm, Configuration};
use schuler::flight::plan;
use schuler::math::compensated::Pair;
use schuler::solution::Solution;
use schuler::strapdown::correction::Correction;
use schuler::strapdown::limits::Rejected;
use schuler_simulator::input::{Complaint, Range};
use schuler_simulator::navigator::{self, Navigate};
use schuler_simulator::recording::navigation::{COLUMNS, NavigationRow};
use schuler_simulator::scene::{self, limits};
use std::collections::VecDeque;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A sample's own interval, s.
const INTERVAL_S: Range = Range::above(0.0, 1.0, "seconds, above 0 and at most 1");

/// A navigator in flight.
#[pyclass(frozen, module = "schuler")]
pub struct Navigator {
    configuration: Configuration,
    rate_hz: f64,
    flying: Mutex<Flying>,
}

/// What a sample changes.
struct Flying {
    navigator: Box<dyn Navigate>,
    /// Where it started, s.
    start_s: f64,
    /// Samples taken.
    taken: u64,
    /// The end of the last sample, s.
    end_s: f64,
    /// Whether every sample so far had the nominal interval.
    even: bool,
    /// Ends of the samples whose rows are still to come, s.
    ends_s: VecDeque<f64>,
    /// The end of the last block, s.
    block_end_s: f64,
    /// Samples whose ends are behind that.
    integrated: u64,
    /// Ends of the samples that are not integrated yet, s.
    waiting_s: VecDeque<f64>,
}

impl Flying {
    fn new(navigator: Box<dyn Navigate>, start_s: f64) -> Self {
        Self {
            navigator,
            start_s,
            taken: 0,
            end_s: start_s,
            even: true,
            ends_s: VecDeque::new(),
            block_end_s: start_s,
            integrated: 0,
            waiting_s: VecDeque::new(),
        }
    }

    /// Takes a sample, and shows the rows that it completes with their times, s.
    fn push(
        &mut self,
        sample: ArrayView1<'_, f64>,
        interval_s: Option<f64>,
        rate_hz: f64,
        see: &mut dyn FnMut(f64, &Solution<f64>),
    ) -> Result<(), (f64, Rejected)> {
        let even = self.even && interval_s.is_none();
        let end_s = match interval_s {
            None if even => self.start_s + (self.taken + 1) as f64 / rate_hz,
            None => self.end_s + 1.0 / rate_hz,
            Some(interval_s) => self.end_s + interval_s,
        };
        self.ends_s.push_back(end_s);
        let (navigator, ends_s) = (&mut self.navigator, &mut self.ends_s);
        let mut read = |_: u64, row: &Solution<f64>| {
            see(ends_s.pop_front().unwrap_or(end_s), row);
        };
        let sample = increment(sample);
        let pushed = match interval_s {
            None => navigator.push(&sample, &mut read),
            Some(interval_s) => navigator.push_over(&sample, interval_s, &mut read),
        };
        if let Err(why) = pushed {
            self.ends_s.pop_back();
            return Err((end_s, why));
        }
        (self.even, self.end_s) = (even, end_s);
        self.taken += 1;
        self.waiting_s.push_back(end_s);
        self.settle();
        Ok(())
    }

    /// Completes the rows that wait for samples.
    fn finish(&mut self, see: &mut dyn FnMut(f64, &Solution<f64>)) {
        let (ends_s, end_s) = (&mut self.ends_s, self.end_s);
        self.navigator.finish(&mut |_, row| see(ends_s.pop_front().unwrap_or(end_s), row));
        self.settle();
    }

    /// Notes how far it is integrated.
    fn settle(&mut self) {
        while self.integrated < self.navigator.integrated() {
            self.block_end_s = self.waiting_s.pop_front().unwrap_or(self.block_end_s);
            self.integrated += 1;
        }
    }
}

/// A sample that is not taken: the text of the program.
fn said(taken: u64, end_s: f64, why: Rejected) -> String {
    format!("sample {} at {end_s} s: {why}", taken + 1)
}

/// A navigator of the catalogue by its name, or by options as a scene has them.
fn configuration(name: Option<&str>, options: Option<&Bound<'_, PyDict>>) -> Answer<Configuration> {
    let mut asked = scene::Navigator::default();
    let options = Options::among(OF_NAVIGATOR, options)?;
    if let Some(name) = name {
        let unknown = |what: String| {
            Fault::argument(
                "name",
                what,
                "a name of navigators(), as \"f64 local-level taylor 2,4,2\"",
            )
        };
        let one: Configuration =
            name.parse().map_err(|_| unknown(format!("{name:?} is no navigator")))?;
        asked.precision = one.precision;
        asked.frame = one.axes;
        asked.algorithm = one.algorithm;
        asked.window = (one.algorithm == Algorithm::Taylor).then_some(one.window);
    }
    options.navigator.apply(&mut asked)?;
    Ok(asked.configuration(asked.window.unwrap_or(plan::UNKNOWN)))
}

#[pymethods]
impl Navigator {
    #[new]
    #[pyo3(signature = (initial, rate, *, name=None, **options))]
    fn new(
        initial: &Bound<'_, PyAny>,
        rate: f64,
        name: Option<&str>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> Answer<Self> {
        let initial = State::of(initial)?;
        let rate_hz = limits::RATE_HZ.check(rate);
        let rate_hz = rate_hz.map_err(|complaint| Fault::option("--rate", complaint))?;
        let configuration = configuration(name, options)?;
        let asked = scene::Navigator {
            frame: configuration.axes,
            precision: configuration.precision,
            algorithm: configuration.algorithm,
            ..scene::Navigator::default()
        };
        let interval_s = Pair::new(rate_hz).reciprocal();
        let (window, order) = (configuration.window, plan::HIGHEST_ORDER);
        let navigator = navigator::start(&asked, window, order, interval_s, &initial.solution)?;
        let flying = Mutex::new(Flying::new(navigator, initial.time_s()));
        Ok(Self { configuration, rate_hz, flying })
    }

    /// Its name in the catalogue.
    #[getter]
    fn name(&self) -> String {
        self.configuration.to_string()
    }

    #[getter]
    fn rate_hz(&self) -> f64 {
        self.rate_hz
    }

    /// Navigation at the end of the last block.
    #[getter]
    fn state(&self) -> State {
        let flying = self.flying();
        State::new(flying.block_end_s, &flying.navigator.solution())
    }

    /// Samples integrated so far.
    #[getter]
    fn integrated(&self) -> u64 {
        self.flying().navigator.integrated()
    }

    /// Samples taken so far.
    #[getter]
    fn taken(&self) -> u64 {
        self.flying().taken
    }

    /// Digest of every state so far.
    #[getter]
    fn digest(&self) -> String {
        format!("{:016x}", self.flying().navigator.digest())
    }

    /// Takes a sample; the rows that it completes.
    #[pyo3(signature = (angle_rad, velocity_m_s, interval_s=None))]
    fn push(
        &self,
        angle_rad: [f64; 3],
        velocity_m_s: [f64; 3],
        interval_s: Option<f64>,
    ) -> Answer<Vec<State>> {
        let interval_s = interval_s.map(interval).transpose()?;
        let ([x, y, z], [u, v, w]) = (angle_rad, velocity_m_s);
        let mut rows = Vec::new();
        let mut flying = self.flying();
        let taken = flying.taken;
        let mut see = |time_s: f64, row: &Solution<f64>| rows.push(State::new(time_s, row));
        flying
            .push(ArrayView1::from(&[x, y, z, u, v, w]), interval_s, self.rate_hz, &mut see)
            .map_err(|(end_s, why)| refused(said(taken, end_s, why), None))?;
        Ok(rows)
    }

    /// Takes samples in order, without the interpreter; the rows that they complete.
    #[pyo3(signature = (increments, interval_s=None))]
    fn fly(
        &self,
        py: Python<'_>,
        increments: &Bound<'_, PyAny>,
        interval_s: Option<&Bound<'_, PyAny>>,
    ) -> Answer<Py<Table>> {
        let samples = Samples::new(increments)?;
        let view = samples.view();
        let intervals = interval_s.map(|given| numbers("interval_s", given)).transpose()?;
        let intervals = intervals.as_ref().map(|intervals| intervals.as_array());
        if let Some(intervals) = &intervals {
            if intervals.len() != view.nrows() {
                let what = format!("has {} values", intervals.len());
                return Err(Fault::argument("interval_s", what, format!("{}", view.nrows())));
            }
            intervals.iter().try_for_each(|&interval_s| interval(interval_s).map(drop))?;
        }
        let mut watch = Watch::new();
        let (rows, end) = py.detach(|| self.flown(view, intervals, &mut watch));
        watch.raised()?;
        let table = rows.table(py)?;
        match end {
            Ok(()) => Ok(table),
            Err(text) => Err(refused(text, Some(table.into_any())).into()),
        }
    }

    /// Ends the stream; the rows that wait for samples.
    fn finish(&self) -> Vec<State> {
        let mut rows = Vec::new();
        self.flying().finish(&mut |time_s, row| rows.push(State::new(time_s, row)));
        rows
    }

    /// Sets height and vertical velocity at the end of the last block.
    fn hold_vertical(&self, altitude_m: f64, down_m_s: f64) -> Answer<()> {
        let held = self.flying().navigator.hold_vertical(altitude_m, down_m_s);
        Ok(held.map_err(|why| refused(why.to_string(), None))?)
    }

    /// Corrects the state at the end of the last block.
    #[pyo3(signature = (*, position_ned_m=[0.0; 3], velocity_ned_m_s=[0.0; 3], attitude_ned_rad=[0.0; 3]))]
    fn correct(
        &self,
        position_ned_m: [f64; 3],
        velocity_ned_m_s: [f64; 3],
        attitude_ned_rad: [f64; 3],
    ) -> Answer<()> {
        let correction = Correction {
            position_ned: position_ned_m.into(),
            velocity_ned: velocity_ned_m_s.into(),
            attitude_ned: attitude_ned_rad.into(),
        };
        let corrected = self.flying().navigator.correct(&correction);
        Ok(corrected.map_err(|why| refused(why.to_string(), None))?)
    }

    fn __repr__(&self) -> String {
        let flying = self.flying();
        format!("<schuler.Navigator {}, {} samples taken>", self.configuration, flying.taken)
    }
}

impl Navigator {
    /// A panic elsewhere leaves nothing half done that matters.
    fn flying(&self) -> MutexGuard<'_, Flying> {
        self.flying.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn flown(
        &self,
        samples: ArrayView2<'_, f64>,
        intervals: Option<ArrayView1<'_, f64>>,
        watch: &mut Watch,
    ) -> (Rows, Result<(), String>) {
        let mut rows = Rows::new(&COLUMNS, samples.nrows() as u64);
        let mut flying = self.flying();
        let mut see = |time_s: f64, row: &Solution<f64>| {
            rows.add(&NavigationRow::new(time_s, row).columns());
        };
        let mut end = Ok(());
        for (place, sample) in samples.rows().into_iter().enumerate() {
            let interval_s = intervals.as_ref().and_then(|intervals| intervals.get(place)).copied();
            let taken = flying.taken;
            if let Err(interrupted) = watch.look() {
                end = Err(interrupted.to_string());
                break;
            }
            if let Err((end_s, why)) = flying.push(sample, interval_s, self.rate_hz, &mut see) {
                end = Err(said(taken, end_s, why));
                break;
            }
        }
        (rows, end)
    }
}

fn interval(interval_s: f64) -> Answer<f64> {
    INTERVAL_S
        .check(interval_s)
        .map_err(|Complaint { what, accepted }| Fault::argument("interval_s", what, accepted))
}

/// The names of all navigators.
#[pyfunction]
pub fn navigators() -> Vec<String> {
    let mut names = Vec::new();
    Every::each(&mut |one| names.push(one.to_string()));
    names
}
