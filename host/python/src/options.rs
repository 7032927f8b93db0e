//! What replaces a scene's own values: keywords with the names of the command line.

use crate::error::{Answer, Fault};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use schuler_host::cli::{Every, FlightOptions, Handling, NavigatorOptions, Window};
use schuler_simulator::input::document::{choices, did_you_mean};
use schuler_simulator::input::{Complaint, Range};
use schuler_simulator::scene::{Algorithm, Axes, Gap, Precision, Scene, Vertical, limits};

/// Every name: of the flight, of the navigator, of what is done about the vertical and gaps.
const NAMES: [&str; 9] =
    ["seed", "duration", "rate", "frame", "precision", "algorithm", "window", "vertical", "gap"];
/// Those of a navigator.
pub const OF_NAVIGATOR: &[&str] = &["frame", "precision", "algorithm", "window"];
/// Those of a navigator and its handling.
pub const OF_HANDLING: &[&str] = &["frame", "precision", "algorithm", "window", "vertical", "gap"];
/// Those of an ensemble.
pub const OF_ENSEMBLE: &[&str] =
    &["seed", "duration", "rate", "frame", "precision", "algorithm", "window", "vertical"];

/// The options that were given.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options {
    /// Seed, length, rate.
    pub flight: FlightOptions,
    /// Axes, arithmetic, method, window.
    pub navigator: NavigatorOptions,
    /// The vertical and gaps.
    pub handling: Handling,
}

impl Options {
    /// From keywords. What is `None` is not given.
    pub fn new(given: Option<&Bound<'_, PyDict>>) -> Answer<Self> {
        Self::among(&NAMES, given)
    }

    /// From keywords of some names alone.
    pub fn among(names: &[&str], given: Option<&Bound<'_, PyDict>>) -> Answer<Self> {
        let mut options = Self::default();
        let Some(given) = given else { return Ok(options) };
        for (name, value) in given {
            let name: String = name.extract()?;
            if !names.contains(&name.as_str()) {
                let (hint, accepted) = (did_you_mean(&name, names), names.join(", "));
                let text = format!("there is no option {name:?}{hint}; accepted: {accepted}");
                return Err(PyTypeError::new_err(text).into());
            }
            if !value.is_none() {
                options.set(&name, &value)?;
            }
        }
        Ok(options)
    }

    fn set(&mut self, name: &str, value: &Bound<'_, PyAny>) -> Answer<()> {
        let Self { flight, navigator, handling } = self;
        match name {
            "seed" => flight.seed = Some(seed(value)?),
            "duration" => flight.duration = Some(number(name, value, &limits::DURATION_S)?),
            "rate" => flight.rate = Some(number(name, value, &limits::RATE_HZ)?),
            "frame" => navigator.frame = Some(named(name, value, Axes::NAMES)?),
            "precision" => navigator.precision = Some(named(name, value, Precision::NAMES)?),
            "algorithm" => navigator.algorithm = Some(named(name, value, Algorithm::NAMES)?),
            "window" => navigator.window = Some(window(value)?),
            "vertical" => handling.vertical = Some(named(name, value, Vertical::NAMES)?),
            _ => handling.gap = Some(named(name, value, Gap::NAMES)?),
        }
        Ok(())
    }

    /// Puts what was given in place of a scene's own.
    pub fn apply(&self, scene: &mut Scene) -> Answer<()> {
        self.flight.apply(scene)?;
        self.navigator.apply(&mut scene.navigator)?;
        self.handling.apply(&mut scene.navigator);
        Ok(())
    }
}

/// The option as the command line calls it.
pub fn dashed(name: &str) -> String {
    format!("--{}", name.replace('_', "-"))
}

/// A number within a range.
pub fn number(name: &str, value: &Bound<'_, PyAny>, range: &Range) -> Answer<f64> {
    let number: f64 = value.extract().map_err(|_| {
        Fault::option(&dashed(name), Complaint::new("is not a number", range.accepted))
    })?;
    range.check(number).map_err(|complaint| Fault::option(&dashed(name), complaint))
}

/// An option that the command line parses, as that does.
pub fn parsed<T>(
    option: &str,
    value: Option<&Bound<'_, PyAny>>,
    parse: fn(&str) -> Result<T, Complaint>,
) -> Answer<Option<T>> {
    let Some(value) = value else { return Ok(None) };
    let value = parse(&value.str()?.to_string());
    Ok(Some(value.map_err(|complaint| Fault::option(option, complaint))?))
}

fn seed(value: &Bound<'_, PyAny>) -> Answer<u64> {
    let accepted = format!("an integer from 0 to {}", u64::MAX);
    value.extract().map_err(|_| Fault::option("--seed", Complaint::new("is not a seed", accepted)))
}

/// One of some names.
pub fn named<T: Copy>(name: &str, value: &Bound<'_, PyAny>, names: &[(&str, T)]) -> Answer<T> {
    let refuse = |what: String| Fault::option(&dashed(name), Complaint::new(what, choices(names)));
    let text: String = value.extract().map_err(|_| refuse("is not text".to_owned()))?;
    let found = names.iter().find(|(known, _)| *known == text).map(|(_, value)| *value);
    found.ok_or_else(|| refuse(format!("there is no \"{text}\"")))
}

/// A window: `"auto"`, `"2,4,2"` or `(2, 4, 2)`.
fn window(value: &Bound<'_, PyAny>) -> Answer<Window> {
    let refuse = |complaint| Fault::option("--window", complaint);
    let shape = if let Ok(text) = value.extract::<String>() {
        limits::window_of(&text)
    } else if let Ok([history, block, lookahead]) = value.extract::<[u64; 3]>() {
        limits::window(history, block, lookahead).map(Some)
    } else {
        Err(Complaint::new("is neither text nor three counts", limits::windows()))
    };
    shape.map(Window).map_err(refuse)
}

/// Which rows are kept: a number of them, or seconds as in `"10s"`.
pub fn every(value: Option<&Bound<'_, PyAny>>) -> Answer<Option<Every>> {
    let Some(value) = value else { return Ok(None) };
    let text = value.str()?.to_string();
    let every = Every::parse(&text).map_err(|complaint| Fault::option("--every", complaint))?;
    Ok(Some(every))
}

/// A span of a recording: from and to, s.
pub fn span(option: &str, [from_s, to_s]: [f64; 2]) -> Answer<[f64; 2]> {
    let accepted = "(from, to), seconds of the recording's own time, from before to";
    if from_s < to_s && Range::FINITE.check(from_s).and(Range::FINITE.check(to_s)).is_ok() {
        return Ok([from_s, to_s]);
    }
    Err(Fault::argument(option, "is not a span", accepted))
}

/// Words with commas between, given so or as a list.
pub fn words(value: &Bound<'_, PyAny>) -> Answer<String> {
    if let Ok(text) = value.extract::<String>() {
        return Ok(text);
    }
    let words: Result<Vec<String>, PyErr> =
        value.try_iter()?.map(|word| Ok(word?.str()?.to_string())).collect();
    Ok(words?.join(","))
}
