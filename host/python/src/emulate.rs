//! `emulate`: the sensors' samples of a scene, the truth, and the state to start from.

use crate::error::Answer;
use crate::fixes::delivered;
use crate::interrupt::Watch;
use crate::scene::{self, Scene};
use crate::state::State;
use crate::table::{Rows, Table};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use schuler_simulator::input::InputError;
use schuler_simulator::recording::csv::{INCREMENTS, RATES};
use schuler_simulator::recording::navigation::{COLUMNS, NavigationRow};
use schuler_simulator::scene::Scene as Flown;
use schuler_simulator::simulate::start;
use schuler_simulator::source::Source;

/// A stream of samples with what belongs to it.
#[pyclass(frozen, get_all, module = "schuler")]
pub struct Emulation {
    scene: Py<Scene>,
    /// A row per sample that arrived: `imu.csv`.
    imu: Py<Table>,
    /// The start and a row per sample: `truth.csv`.
    truth: Py<Table>,
    /// What aiding sensors deliver, in the order of arrival, by what they measure: `gnss.csv`.
    gnss: Py<PyDict>,
    /// Where navigation starts: `initial.toml`.
    initial: Py<State>,
    /// Samples lost on the link.
    lost: u64,
}

#[pymethods]
impl Emulation {
    fn __repr__(&self, py: Python<'_>) -> String {
        let scene = &self.scene.get().scene;
        let imu = self.imu.bind(py).len().unwrap_or_default();
        format!("<schuler.Emulation of {}: {imu} samples, {} lost>", scene.name, self.lost)
    }
}

/// Samples and truth while they grow.
struct Growing {
    imu: Rows,
    truth: Rows,
}

fn emulated(
    scene: &Flown,
    source: &Source,
    rates: bool,
    run: u64,
    watch: &mut Watch,
) -> Result<Growing, InputError> {
    let samples = scene.samples();
    let names = if rates { &RATES } else { &INCREMENTS };
    let mut rows =
        Growing { imu: Rows::new(names, samples), truth: Rows::new(&COLUMNS, 1 + samples) };
    let mut stream = source.start(run);
    let truth = |sample: u64| NavigationRow::new(source.time_s(sample), &source.truth(sample));
    rows.truth.add(&truth(0).columns());
    for sample in 1..=samples {
        watch.look()?;
        let six = if rates {
            stream.advance_rates().map(|rates| [rates.rate_ib_b, rates.specific_force_b])
        } else {
            stream.advance().map(|increment| [increment.angle_b, increment.velocity_b])
        };
        if let Some(six) = six {
            rows.imu.add(&[source.time_s(sample)]);
            six.iter().for_each(|three| rows.imu.add(&three.into_array()));
        }
        rows.truth.add(&truth(sample).columns());
    }
    Ok(rows)
}

/// The sensors' samples of a scene.
#[pyfunction]
#[pyo3(signature = (scene=None, *, perfect=false, rates=false, run=0, **options))]
pub fn emulate(
    py: Python<'_>,
    scene: Option<&Bound<'_, PyAny>>,
    perfect: bool,
    rates: bool,
    run: u64,
    options: Option<&Bound<'_, PyDict>>,
) -> Answer<Emulation> {
    let mut scene = scene::of(scene, options)?;
    if perfect {
        scene.gyro = Default::default();
        scene.accelerometer = Default::default();
    }
    let mut watch = Watch::new();
    let (rows, delivered, initial) = py.detach(|| -> Answer<_> {
        let source = Source::new(&scene, false)?;
        let initial =
            State::start(source.time_s(0), &start::of_run(&source.initial(0), &scene, run));
        let delivered = delivered(&scene, &source, run);
        Ok((emulated(&scene, &source, rates, run, &mut watch), delivered, initial))
    })?;
    watch.raised()?;
    let Growing { imu, truth } = rows?;
    let gnss = PyDict::new(py);
    for (word, rows) in delivered {
        gnss.set_item(word, Rows::from(rows).table(py)?)?;
    }
    let (arrived, samples) = (imu.len() as u64, scene.samples());
    Ok(Emulation {
        scene: Py::new(py, Scene { scene })?,
        imu: imu.table(py)?,
        truth: truth.table(py)?,
        gnss: gnss.unbind(),
        initial: Py::new(py, initial)?,
        lost: samples - arrived,
    })
}
