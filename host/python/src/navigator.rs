//! A navigator step by step, one of the catalogue.

use crate::arrays::{Samples, numbers};
use crate::error::{Answer, Fault, refused};
use crate::flying::Flying;
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
use schuler_simulator::navigator;
use schuler_simulator::recording::navigation::{COLUMNS, NavigationRow};
use schuler_simulator::scene::{self, limits};
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

/// A sample that is not taken: the text of the program.
pub fn said(taken: u64, end_s: f64, why: Rejected) -> String {
    format!("sample {} at {end_s} s: {why}", taken + 1)
}

/// A navigator of the catalogue by its name, or by options as a scene has them.
pub fn configuration(
    name: Option<&str>,
    options: Option<&Bound<'_, PyDict>>,
) -> Answer<Configuration> {
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

/// A number of samples per second.
pub fn rate(rate_hz: f64) -> Answer<f64> {
    limits::RATE_HZ.check(rate_hz).map_err(|complaint| Fault::option("--rate", complaint))
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
        let rate_hz = self::rate(rate)?;
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
