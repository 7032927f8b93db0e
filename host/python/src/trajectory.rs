//! A motion: of a scene, or of a `[trajectory]` table alone.

use crate::arrays;
use crate::error::{Answer, Fault};
use crate::options::Options;
use crate::scene::{self, Scene};
use crate::state::State;
use crate::table::{Rows, Table};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};
use schuler::math::compensated::Pair;
use schuler::trajectory::Trajectory as _;
use schuler_simulator::course::Course;
use schuler_simulator::input::Range;
use schuler_simulator::portrait::{Extremes, Portrait};
use schuler_simulator::recording::csv::RATES;
use schuler_simulator::recording::navigation::{COLUMNS, NavigationRow};
use schuler_simulator::source::SourceError;
use schuler_simulator::units::DEGREE;

/// Samples per second of a scene that has a motion alone.
const RATE_HZ: f64 = 100.0;

/// The motion of a scene.
#[pyclass(frozen, module = "schuler")]
pub struct Trajectory {
    scene: Scene,
    course: Course,
}

/// A scene of a `[trajectory]` table, as long as it says or the path is.
fn of_motion(
    motion: &Bound<'_, PyMapping>,
    options: Option<&Bound<'_, PyDict>>,
) -> Answer<schuler_simulator::scene::Scene> {
    let py = motion.py();
    let given = Options::new(options)?;
    let table = PyDict::new(py);
    table.set_item("rate_hz", given.flight.rate.unwrap_or(RATE_HZ))?;
    table.set_item("duration_s", given.flight.duration)?;
    table.set_item("trajectory", motion)?;
    let table = table.as_any().cast::<PyMapping>().map_err(PyErr::from)?;
    let mut scene = scene::of_table(table)?;
    given.apply(&mut scene)?;
    Ok(scene)
}

#[pymethods]
impl Trajectory {
    #[new]
    #[pyo3(signature = (source=None, **options))]
    fn new(source: Option<&Bound<'_, PyAny>>, options: Option<&Bound<'_, PyDict>>) -> Answer<Self> {
        let motion = source.and_then(|source| source.cast::<PyMapping>().ok());
        let motion = match motion {
            Some(motion) if !motion.contains("trajectory")? => Some(motion),
            _ => None,
        };
        let scene = match motion {
            Some(motion) => of_motion(motion, options)?,
            None => scene::of(source, options)?,
        };
        let course = scene.trajectory.build().map_err(SourceError::Trajectory)?;
        Ok(Self { scene: Scene { scene }, course })
    }

    /// The scene that flies it, with perfect sensors unless it has some.
    #[getter]
    fn scene(&self) -> Scene {
        Scene { scene: self.scene.scene.clone() }
    }

    #[getter]
    fn duration_s(&self) -> f64 {
        self.scene.scene.duration_s
    }

    /// The state at a time, s.
    fn state(&self, time_s: f64) -> Answer<State> {
        let time_s =
            Range::FINITE.check(time_s).map_err(|complaint| Fault::option("time_s", complaint))?;
        Ok(State::start(time_s, &self.course.initial_at(Pair::new(time_s))))
    }

    /// Position, velocity and attitude at some times, s.
    fn at(&self, py: Python<'_>, times_s: &Bound<'_, PyAny>) -> Answer<Py<Table>> {
        self.table(py, times_s, &COLUMNS, |course, time_s| {
            NavigationRow::new(time_s, &course.solution_at(Pair::new(time_s))).columns()
        })
    }

    /// What perfect sensors read at some times, s.
    fn rates(&self, py: Python<'_>, times_s: &Bound<'_, PyAny>) -> Answer<Py<Table>> {
        self.table(py, times_s, &RATES, |course, time_s| {
            let rates = course.rates_at(Pair::new(time_s));
            let (w, f) = (rates.rate_ib_b, rates.specific_force_b);
            [time_s, w.x, w.y, w.z, f.x, f.y, f.z]
        })
    }

    /// What the flight is like: its length, the least and the greatest of what matters.
    fn extremes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let portrait = py.detach(|| Portrait::new(&self.course, self.scene.scene.duration_s));
        let table = PyDict::new(py);
        let pair = |extremes: Extremes, unit: f64| (extremes.least / unit, extremes.most / unit);
        table.set_item("length_m", portrait.length_m)?;
        for (name, extremes, unit) in [
            ("speed_m_s", portrait.speed, 1.0),
            ("climb_m_s", portrait.climb, 1.0),
            ("altitude_m", portrait.altitude, 1.0),
            ("load_g", portrait.load, 1.0),
            ("acceleration_m_s2", portrait.acceleration, 1.0),
            ("roll_deg", portrait.roll, DEGREE),
            ("pitch_deg", portrait.pitch, DEGREE),
        ] {
            table.set_item(name, pair(extremes, unit))?;
        }
        for (axis, extremes) in ["x", "y", "z"].into_iter().zip(portrait.rates) {
            table.set_item(format!("rate_{axis}_deg_s"), pair(extremes, DEGREE))?;
        }
        Ok(table)
    }

    fn __repr__(&self) -> String {
        let scene = &self.scene.scene;
        format!("<schuler.Trajectory of {}, {} s>", scene.name, scene.duration_s)
    }
}

impl Trajectory {
    /// A row for each time, s.
    fn table<const N: usize>(
        &self,
        py: Python<'_>,
        times_s: &Bound<'_, PyAny>,
        names: &[&str; N],
        row: impl Fn(&Course, f64) -> [f64; N] + Sync,
    ) -> Answer<Py<Table>> {
        let times_s = arrays::numbers("times_s", times_s)?;
        let times_s: Vec<f64> = times_s.as_array().iter().copied().collect();
        for time_s in &times_s {
            let checked = Range::FINITE.check(*time_s);
            checked.map_err(|complaint| Fault::option("times_s", complaint))?;
        }
        let rows = py.detach(|| {
            let mut rows = Rows::new(names, times_s.len() as u64);
            times_s.iter().for_each(|time_s| rows.add(&row(&self.course, *time_s)));
            rows
        });
        Ok(rows.table(py)?)
    }
}
