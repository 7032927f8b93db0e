//! `replay`: navigates a recorded stream, a file or an array.

use crate::aided::{Aided, Left};
use crate::aiding::Aiding;
use crate::align::warned;
use crate::error::{Answer, Fault};
use crate::notebook;
use crate::options::{self, OF_HANDLING, Options, words};
use crate::recorded::{Source, kept};
use crate::state::State;
use crate::table::{Rows, Table};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use schuler_host::cli::{Height, Lag, ReplayArgs};
use schuler_host::replay::{Kept, Replayed, fly};
use schuler_simulator::input::Range;
use schuler_simulator::output::heard::overheard;
use schuler_simulator::recording::foreign::Columns;
use schuler_simulator::recording::mounting::Mounting;
use schuler_simulator::rest::units::Units;
use schuler_simulator::simulate::FlightError;
use std::path::PathBuf;
use tempfile::TempDir;

/// A recording that was navigated.
#[pyclass(frozen, module = "schuler")]
pub struct Replay {
    nav: Py<Table>,
    start: Py<State>,
    digest: String,
    text: String,
    window: Option<(usize, usize, usize)>,
    report: Option<[String; 2]>,
    aided: Option<Py<Aided>>,
}

#[pymethods]
impl Replay {
    /// The rows: `nav.csv`.
    #[getter]
    fn nav(&self, py: Python<'_>) -> Py<Table> {
        self.nav.clone_ref(py)
    }

    /// Where it started: as given, or as aligned.
    #[getter]
    fn start(&self, py: Python<'_>) -> Py<State> {
        self.start.clone_ref(py)
    }

    /// What became of the measurements; `None` without `gnss`.
    #[getter]
    fn aided(&self, py: Python<'_>) -> Option<Py<Aided>> {
        self.aided.as_ref().map(|aided| aided.clone_ref(py))
    }

    #[getter]
    fn digest(&self) -> &str {
        &self.digest
    }

    #[getter]
    fn window(&self) -> Option<(usize, usize, usize)> {
        self.window
    }

    /// `summary.json` as a dict; `None` without a reference.
    #[getter]
    fn summary<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let summary = self.report.as_ref().map(|[summary, _]| notebook::summary(py, summary));
        summary.transpose()
    }

    /// `report.html`; `None` without a reference.
    fn report(&self) -> Option<&str> {
        self.report.as_ref().map(|[_, page]| page.as_str())
    }

    /// What the program prints.
    fn __str__(&self) -> &str {
        &self.text
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let rows = self.nav.bind(py).len()?;
        Ok(format!("<schuler.Replay of {rows} rows, digest {}>", self.digest))
    }

    fn _repr_html_(&self) -> String {
        match &self.report {
            Some([_, page]) => notebook::framed(page),
            None => format!("<pre>{}</pre>", schuler_report::svg::escape(&self.text)),
        }
    }
}

/// Keywords of `replay` that are not those of a scene.
const OWN: [&str; 14] = [
    "map",
    "columns",
    "axes",
    "units",
    "reference",
    "lag",
    "start",
    "align",
    "coarse",
    "heading",
    "until",
    "rate",
    "height",
    "every",
];

/// Navigates a recording.
#[pyfunction]
#[pyo3(signature = (imu, initial=None, **options))]
pub fn replay(
    py: Python<'_>,
    imu: &Bound<'_, PyAny>,
    initial: Option<&Bound<'_, PyAny>>,
    options: Option<&Bound<'_, PyDict>>,
) -> Answer<Replay> {
    let folder = tempfile::tempdir().map_err(|error| kept(&error))?;
    let (mut args, aiding) = arguments(py, &folder, options)?;
    args.initial = initial.map(|given| start(given, &folder)).transpose()?;
    let recorded = Source::new(imu, &folder)?;
    args.imu = recorded.path().to_owned();
    let (replayed, heard) = py.detach(|| overheard(|| flown(&args, &recorded)));
    let said = warned(py, heard)?;
    let replayed = replayed.map_err(|error| match error {
        FlightError::Input(error) => FlightError::Input(aiding.told(error)),
        FlightError::Stopped(error) => FlightError::Stopped(aiding.told(error)),
        other => other,
    })?;
    let Replayed { text, start, digest, window, rows, aided, report, .. } = replayed;
    let aided = aided.map(|kept| Aided::new(py, left(kept)));
    Ok(Replay {
        nav: Rows::from(rows).table(py)?,
        start: Py::new(py, State::start(start.0, &start.1))?,
        digest: format!("{digest:016x}"),
        text: aiding.named(&(said + &text)),
        window: window.map(|window| (window.history, window.block, window.lookahead)),
        report,
        aided: aided.transpose()?,
    })
}

/// What is left of an aided flight; nothing of spans where none was withheld.
fn left(kept: Kept) -> Left {
    let Kept { report, judged, estimates, smoothed, withheld } = kept;
    let withheld = (!withheld.is_empty()).then_some(withheld);
    Left { report, judged, estimates, smoothed, withheld }
}

fn flown(args: &ReplayArgs, source: &Source) -> Result<Replayed, FlightError> {
    args.check()?;
    fly(args, &source.open(&args.given())?, true)
}

/// The file of the state to start from.
fn start(given: &Bound<'_, PyAny>, folder: &TempDir) -> Answer<PathBuf> {
    if given.cast::<State>().is_err()
        && let Ok(path) = given.extract::<PathBuf>()
    {
        return Ok(path);
    }
    let path = folder.path().join("initial.toml");
    std::fs::write(&path, State::of(given)?.toml()).map_err(|error| kept(&error))?;
    Ok(path)
}

/// The options of the command line.
fn arguments(
    py: Python<'_>,
    folder: &TempDir,
    given: Option<&Bound<'_, PyDict>>,
) -> Answer<(ReplayArgs, Aiding)> {
    let none = PyDict::new(py);
    let others = given.unwrap_or(&none).copy()?;
    let aiding = Aiding::take(&others, folder)?;
    let mut args = ReplayArgs {
        aiding: aiding.options.clone(),
        imu: PathBuf::new(),
        map: None,
        columns: None,
        axes: None,
        initial: None,
        out: folder.path().join("nav.csv"),
        reference: None,
        mcap: None,
        svg: false,
        lag: Lag::Seconds(0.0),
        start: None,
        align: None,
        coarse: false,
        heading: None,
        units: None,
        until: None,
        rate: None,
        handling: Default::default(),
        height: None,
        every: None,
        navigator: Default::default(),
    };
    for name in OWN {
        if let Some(value) = others.get_item(name)? {
            others.del_item(name)?;
            if !value.is_none() {
                set(&mut args, name, &value)?;
            }
        }
    }
    let together = [
        (args.heading.is_some() && args.align.is_none(), "--heading", "--align"),
        (args.coarse && args.align.is_none(), "--coarse", "--align"),
        (args.lag != Lag::Seconds(0.0) && args.reference.is_none(), "--lag", "--reference"),
    ];
    if let Some((_, option, needed)) = together.into_iter().find(|(wrong, ..)| *wrong) {
        return Err(Fault::argument(option, "is of use with another option alone", needed));
    }
    if args.map.is_some() && args.columns.is_some() {
        return Err(Fault::argument("--map", "stands beside --columns", "one of them"));
    }
    let others = Options::among(OF_HANDLING, Some(&others))?;
    (args.navigator, args.handling) = (others.navigator, others.handling);
    Ok((args, aiding))
}

fn set(args: &mut ReplayArgs, name: &str, value: &Bound<'_, PyAny>) -> Answer<()> {
    let time = Range { accepted: "seconds of the recording's own time", ..Range::FINITE };
    let length = Range { accepted: "seconds, above 0", ..Range::POSITIVE };
    let number = |range: &Range| options::number(name, value, range);
    let text = || value.str().map(|text| text.to_string());
    let told = |complaint| Fault::option(&format!("--{name}"), complaint);
    match name {
        "map" => args.map = Some(text()?),
        "columns" => args.columns = Some(Columns::parse(&words(value)?).map_err(told)?),
        "axes" => args.axes = Some(Mounting::parse(&text()?).map_err(told)?),
        "units" => args.units = Some(Units::parse(&words(value)?).map_err(told)?),
        "reference" => args.reference = Some(value.extract()?),
        "lag" => args.lag = Lag::parse(&text()?).map_err(told)?,
        "start" => args.start = Some(number(&time)?),
        "align" => args.align = Some(number(&length)?),
        "coarse" => args.coarse = value.extract()?,
        "heading" => {
            args.heading =
                Some(number(&Range::from_to(-360.0, 360.0, "degrees, from -360 to 360"))?);
        }
        "until" => args.until = Some(number(&time)?),
        "rate" => args.rate = Some(number(&schuler_simulator::scene::limits::RATE_HZ)?),
        "height" => args.height = Some(Height::parse(&text()?).map_err(told)?),
        _ => args.every = options::every(Some(value))?,
    }
    Ok(())
}
