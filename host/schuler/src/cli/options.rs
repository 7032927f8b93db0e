//! Options that several commands share, with the limits of a scene's own keys.

use clap::Args;
use clap::builder::{OsStringValueParser, PossibleValuesParser, TypedValueParser};
use schuler_simulator::input::name::name_of;
use schuler_simulator::input::{Complaint, InputError, Range};
use schuler_simulator::navigator;
use schuler_simulator::scene::{
    Algorithm, Axes, Gap, Navigator, Precision, Scene, Vertical, WindowShape, limits,
};
use std::fmt;
use std::ops::RangeInclusive;
use std::path::Path;
use std::str::FromStr;

/// What a scene's own values may be replaced by.
#[derive(Args, Clone, Copy, Debug, Default, PartialEq)]
pub struct FlightOptions {
    /// Seed of everything random
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = seed)]
    pub seed: Option<u64>,
    /// Length, seconds
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = duration_s)]
    pub duration: Option<f64>,
    /// Samples per second
    #[arg(long, value_name = "HZ", allow_negative_numbers = true, value_parser = rate_hz)]
    pub rate: Option<f64>,
}

/// How to navigate.
#[derive(Args, Clone, Copy, Debug, Default, PartialEq)]
pub struct NavigatorOptions {
    /// Axes of the mechanization
    #[arg(long, value_name = "F", value_parser = named(Axes::NAMES))]
    pub frame: Option<Axes>,
    /// Arithmetic of the navigator
    #[arg(long, value_name = "P", value_parser = named(Precision::NAMES))]
    pub precision: Option<Precision>,
    /// Integration method
    #[arg(long, value_name = "A", value_parser = named(Algorithm::NAMES))]
    pub algorithm: Option<Algorithm>,
    /// Window of the taylor algorithm: samples of history, block, look-ahead; or auto
    #[arg(long, value_name = "H,B,A", value_parser = window)]
    pub window: Option<Window>,
}

/// The vertical channel and missing samples.
#[derive(Args, Clone, Copy, Debug, Default, PartialEq)]
pub struct Handling {
    /// The vertical channel: free, or held to what is known of it
    #[arg(long, value_name = "V", value_parser = named(Vertical::NAMES))]
    pub vertical: Option<Vertical>,
    /// What missing samples do: end it with an error, or be bridged
    #[arg(long, value_name = "G", value_parser = named(Gap::NAMES))]
    pub gap: Option<Gap>,
}

impl Handling {
    /// Puts what was given in place of the scene's own.
    pub fn apply(&self, navigator: &mut Navigator) {
        navigator.vertical = self.vertical.unwrap_or(navigator.vertical);
        navigator.gap = self.gap.unwrap_or(navigator.gap);
    }
}

/// The value of `--window`: a shape, or none for "auto".
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window(pub Option<WindowShape>);

impl FlightOptions {
    /// Puts what was given in place of the scene's own, and checks the whole again.
    pub fn apply(&self, scene: &mut Scene) -> Result<(), InputError> {
        let duration_s = scene.duration_s;
        scene.seed = self.seed.unwrap_or(scene.seed);
        scene.duration_s = self.duration.unwrap_or(scene.duration_s);
        scene.rate_hz = self.rate.unwrap_or(scene.rate_hz);
        limits::check(scene).map_err(|(key, complaint)| {
            // The scene was right before, so a change is to blame: the rate, if it alone is wrong.
            let rate_alone = Scene { duration_s, ..scene.clone() };
            let rate = self.duration.is_none() || limits::check(&rate_alone).is_err();
            let option = if rate { "--rate" } else { "--duration" };
            let what = match key {
                "duration_s" => complaint.what,
                _ => format!("with this, {key} {}", complaint.what),
            };
            InputError::option(option, Complaint::new(what, complaint.accepted))
        })
    }
}

impl NavigatorOptions {
    /// Puts what was given in place of the scene's own.
    pub fn apply(&self, navigator: &mut Navigator) -> Result<(), InputError> {
        navigator.frame = self.frame.unwrap_or(navigator.frame);
        navigator.precision = self.precision.unwrap_or(navigator.precision);
        navigator.algorithm = self.algorithm.unwrap_or(navigator.algorithm);
        match self.window {
            Some(Window(window)) => navigator.window = window,
            // The file's window is that of an algorithm which is not asked for.
            None if self.algorithm == Some(Algorithm::Textbook) => navigator.window = None,
            None => {}
        }
        navigator::check(navigator).map_err(|unavailable| {
            // The scene was right before, so an option is to blame: the one about the key, or another.
            let given = [
                ("navigator.window", "--window", self.window.is_some()),
                ("navigator.precision", "--precision", self.precision.is_some()),
                ("navigator.frame", "--frame", self.frame.is_some()),
                ("navigator.algorithm", "--algorithm", self.algorithm.is_some()),
            ];
            let own = given.iter().find(|(key, _, given)| *given && *key == unavailable.key());
            let other =
                || given.iter().find(|(key, _, given)| *given && *key != "navigator.window");
            let option = own.or_else(other).map_or("--window", |(_, option, _)| option);
            InputError::option(option, unavailable.complaint())
        })
    }
}

/// A built-in name or a path, which need not be Unicode.
pub(super) fn name() -> impl TypedValueParser<Value = String> {
    OsStringValueParser::new().map(|text| name_of(Path::new(&text)))
}

/// One of some names.
pub(super) fn named<T: Copy + Send + Sync + 'static>(
    names: &'static [(&'static str, T)],
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(names.iter().map(|(name, _)| *name)).try_map(move |text| {
        let found = names.iter().find(|(name, _)| *name == text);
        found.map(|(_, value)| *value).ok_or_else(|| Complaint::new("is not a name", ""))
    })
}

pub(super) fn number(text: &str, range: &Range) -> Result<f64, Complaint> {
    text.parse()
        .map_err(|_| Complaint::new("is not a number", range.accepted))
        .and_then(|value| range.check(value))
}

pub(super) fn seed(text: &str) -> Result<u64, Complaint> {
    let accepted = format!("an integer from 0 to {}", u64::MAX);
    text.parse().map_err(|_| Complaint::new("is not a seed", accepted))
}

/// A whole number of something, with its range in the words of a refusal.
pub(super) fn whole<T: FromStr + PartialOrd + fmt::Display>(
    text: &str,
    range: RangeInclusive<T>,
) -> Result<T, Complaint> {
    let accepted = format!("an integer from {} to {}", range.start(), range.end());
    let number = text.parse().ok().filter(|number| range.contains(number));
    number.ok_or_else(|| Complaint::new("is none that is taken", accepted))
}

/// Runs of an ensemble: enough for a spread, and few enough for what is kept of them to stay in memory.
const RUNS: RangeInclusive<u64> = 4..=10_000_000;

/// How many runs to fly.
pub fn runs(text: &str) -> Result<u64, Complaint> {
    let accepted = format!("an integer from {} to {}", RUNS.start(), RUNS.end());
    let runs = text.parse().ok().filter(|runs| RUNS.contains(runs));
    runs.ok_or_else(|| Complaint::new("is not a number of runs", accepted))
}

/// The number of a run.
pub(super) fn run(text: &str) -> Result<u64, Complaint> {
    let accepted = format!("an integer from 0 to {}", u64::MAX);
    text.parse().map_err(|_| Complaint::new("is not the number of a run", accepted))
}

pub(super) fn duration_s(text: &str) -> Result<f64, Complaint> {
    number(text, &limits::DURATION_S)
}

pub(super) fn rate_hz(text: &str) -> Result<f64, Complaint> {
    number(text, &limits::RATE_HZ)
}

pub(super) fn time_s(text: &str) -> Result<f64, Complaint> {
    number(text, &Range { accepted: "seconds of the recording's own time", ..Range::FINITE })
}

pub(super) fn length_s(text: &str) -> Result<f64, Complaint> {
    number(text, &Range { accepted: "seconds, above 0", ..Range::POSITIVE })
}

pub(super) fn heading_sigma_deg(text: &str) -> Result<f64, Complaint> {
    number(text, &Range { accepted: "degrees, above 0", ..Range::POSITIVE })
}

pub(super) fn heading_deg(text: &str) -> Result<f64, Complaint> {
    number(text, &Range::from_to(-360.0, 360.0, "degrees, from -360 to 360"))
}

fn window(text: &str) -> Result<Window, Complaint> {
    limits::window_of(text).map(Window)
}
