//! Scenes from TOML: keys, defaults and limits. Units are turned into SI here and nowhere else.

mod aiding;
mod sensors;
mod trajectory;

use super::keys::general as keys;
use super::{
    Algorithm, Alignment, Axes, Base, Gap, InitialError, Link, Navigator, Precision, Scene,
    Trajectory, Vertical, WindowShape, limits,
};
use crate::flight::Nine;
use crate::input::document::{Document, Section, Value};
use crate::input::{Complaint, InputError, Range};
use crate::navigator;
use crate::units::{ARCSECOND, DEGREE};
use sha2::{Digest as _, Sha256};
use std::f64::consts::TAU;
use std::path::Path;

/// The length of a flight of which nothing is said but its sensors, s.
const LENGTH_S: f64 = 3600.0;
/// More samples than any window spans.
const MOST_SAMPLES: u64 = 1000;

/// A scene from its text; `file` names it in errors, and its stem is the scene's name.
pub fn scene(file: &str, text: &str) -> Result<Scene, InputError> {
    let document = Document::parse(file, text)?;
    let root = document.root(&keys::ROOT.names())?;
    let name = Path::new(file).file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let title = root.get("title").map(|v| v.text("text")).transpose()?;
    let trajectory = trajectory::read(&root, file)?;
    let duration_s = duration_s(&root, &trajectory)?;
    let rate_hz = root.number("rate_hz", &limits::RATE_HZ)?;
    let [gyro, accelerometer] = sensors::both(&root, Some(rate_hz), duration_s)?;
    let scene = Scene {
        title: title.unwrap_or(&name).to_owned(),
        name,
        text_sha256: hash(text),
        duration_s,
        rate_hz,
        seed: root.get("seed").map_or(Ok(1), |v| v.integer(0, u64::MAX))?,
        trajectory,
        gyro,
        accelerometer,
        initial_error: initial_error(&root)?,
        aiding: aiding::read(&root, duration_s)?,
        alignment: alignment(&root)?,
        navigator: navigation(&root)?,
        link: link(&root)?,
    };
    limits::check(&scene).map_err(|(key, complaint)| document.error(key, complaint))?;
    navigator::check(&scene.navigator)
        .map_err(|unavailable| document.error(unavailable.key(), unavailable.complaint()))?;
    Ok(scene)
}

/// What a scene says of its sensors and their filter, from its text; the rest need not be there, and is not looked at.
/// The scene that it gives has no motion.
pub fn sensors(file: &str, text: &str) -> Result<Scene, InputError> {
    let document = Document::parse(file, text)?;
    let root = document.root(&keys::ROOT.names())?;
    let name = Path::new(file).file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let duration_s = root.read(&keys::DURATION)?.unwrap_or(LENGTH_S);
    let rate_hz = root.get("rate_hz").map(|_| root.number("rate_hz", &limits::RATE_HZ));
    let rate_hz = rate_hz.transpose()?;
    let [gyro, accelerometer] = sensors::both(&root, rate_hz, duration_s)?;
    Ok(Scene {
        title: name.clone(),
        name,
        text_sha256: hash(text),
        duration_s,
        rate_hz: 1.0,
        seed: 1,
        trajectory: Trajectory::default(),
        gyro,
        accelerometer,
        initial_error: initial_error(&root)?,
        aiding: aiding::given(&root, duration_s)?,
        alignment: None,
        navigator: Navigator::default(),
        link: Link::default(),
    })
}

/// The length that is given, or that of the path.
fn duration_s(root: &Section<'_>, trajectory: &Trajectory) -> Result<f64, InputError> {
    match (root.read(&keys::DURATION)?, &trajectory.path) {
        (Some(duration_s), _) => Ok(duration_s),
        (None, Some(path)) => Ok(path.end_s()),
        (None, None) => root.need(&keys::DURATION),
    }
}

/// SHA-256, as `sha256sum` prints it.
fn hash(text: &str) -> String {
    Sha256::digest(text).iter().map(|byte| format!("{byte:02x}")).collect()
}

fn initial_error(root: &Section<'_>) -> Result<InitialError, InputError> {
    let keys = [Nine::NAMES, Nine::SIGMAS].concat();
    let section = root.section("initial_error", &keys).map_err(renamed)?;
    let Some(section) = section else { return Ok(InitialError::default()) };
    let three = |keys: &[&str], range: Range, unit| -> Result<[f64; 3], InputError> {
        let mut values = [0.0; 3];
        for (value, key) in values.iter_mut().zip(keys) {
            *value = section.number_or(key, 0.0, &range)? * unit;
        }
        Ok(values)
    };
    let metres = Range::from_to(-1e5, 1e5, "metres, from -1e5 to 1e5");
    let speed = Range::from_to(-1e4, 1e4, "m/s, from -1e4 to 1e4");
    let angle = Range::from_to(-648_000.0, 648_000.0, "arcsec, from -648000 to 648000");
    let metres_sigma = Range::from_to(0.0, 1e4, "metres, from 0 to 1e4");
    let speed_sigma = Range::from_to(0.0, 1e3, "m/s, from 0 to 1e3");
    let angle_sigma = Range::from_to(0.0, 64_800.0, "arcsec, from 0 to 64800");
    Ok(InitialError {
        position_m: three(&Nine::NAMES[..3], metres, 1.0)?,
        velocity_m_s: three(&Nine::NAMES[3..6], speed, 1.0)?,
        attitude_rad: three(&Nine::NAMES[6..], angle, ARCSECOND)?,
        position_sigma_m: three(&Nine::SIGMAS[..3], metres_sigma, 1.0)?,
        velocity_sigma_m_s: three(&Nine::SIGMAS[3..6], speed_sigma, 1.0)?,
        attitude_sigma_rad: three(&Nine::SIGMAS[6..], angle_sigma, ARCSECOND)?,
    })
}

/// Tells the name of today where a key has one of before.
fn renamed(mut error: InputError) -> InputError {
    let key = error.key.as_deref().unwrap_or_default();
    let former = Nine::FORMER.iter().zip(&Nine::NAMES[6..]);
    let found =
        former.zip(["north", "east", "down"]).find(|((former, _), _)| key.ends_with(*former));
    if let Some(((_, name), axis)) = found {
        let what =
            format!("is not a key of [initial_error]: the rotation about {axis} is `{name}`");
        error.complaint = Complaint::new(what, Nine::NAMES.join(", "));
    }
    error
}

fn alignment(root: &Section<'_>) -> Result<Option<Alignment>, InputError> {
    let Some(section) = root.table("alignment", &keys::ALIGNMENT)? else { return Ok(None) };
    let rest = Alignment::new(section.need(&keys::ALIGNING)?);
    let read = |key| section.read(key);
    let mut sway = rest.sway;
    sway.rms_m = read(&keys::SWAY_RMS)?.unwrap_or(sway.rms_m);
    sway.rate = read(&keys::SWAY_PERIOD)?.map_or(sway.rate, |period_s| TAU / period_s);
    sway.damping = read(&keys::SWAY_DAMPING)?.unwrap_or(sway.damping);
    let alignment = Alignment {
        sway,
        base: section.get("base").map_or(Ok(rest.base), |value| value.choice(Base::NAMES))?,
        heading_sigma_rad: read(&keys::HEADING_SIGMA)?.map(|degrees| degrees * DEGREE),
        velocity_sigma_m_s: read(&keys::VELOCITY_SIGMA)?.unwrap_or(rest.velocity_sigma_m_s),
        velocity_interval_s: read(&keys::VELOCITY_EVERY)?.unwrap_or(rest.velocity_interval_s),
        ..rest
    };
    let of_bases = [
        (Base::Swaying, [&keys::SWAY_RMS, &keys::SWAY_PERIOD, &keys::SWAY_DAMPING].as_slice()),
        (Base::Moving, &[&keys::VELOCITY_SIGMA, &keys::VELOCITY_EVERY]),
    ];
    for (base, keys) in of_bases.into_iter().filter(|(base, _)| *base != alignment.base) {
        if let Some(key) = keys.iter().find(|key| section.get(key.name).is_some()) {
            let what = format!("is of another base than \"{}\"", alignment.base.name());
            let accepted = format!("base = \"{}\"", base.name());
            return Err(section.blame(key.name, Complaint::new(what, accepted)));
        }
    }
    Ok(Some(alignment))
}

fn navigation(root: &Section<'_>) -> Result<Navigator, InputError> {
    let default = Navigator::default();
    let Some(section) = root.table("navigator", &keys::NAVIGATOR)? else { return Ok(default) };
    fn choice<T: Copy>(
        section: &Section<'_>,
        key: &str,
        names: &[(&str, T)],
        default: T,
    ) -> Result<T, InputError> {
        section.get(key).map_or(Ok(default), |value| value.choice(names))
    }
    Ok(Navigator {
        frame: choice(&section, "frame", Axes::NAMES, default.frame)?,
        precision: choice(&section, "precision", Precision::NAMES, default.precision)?,
        algorithm: choice(&section, "algorithm", Algorithm::NAMES, default.algorithm)?,
        window: section.get("window").map_or(Ok(None), |value| window(&value))?,
        vertical: choice(&section, "vertical", Vertical::NAMES, default.vertical)?,
        gap: choice(&section, "gap", Gap::NAMES, default.gap)?,
    })
}

fn window(value: &Value<'_>) -> Result<Option<WindowShape>, InputError> {
    if value.is_text() {
        let text = value.text(&limits::windows())?;
        return limits::window_of(text).map_err(|complaint| value.error(complaint));
    }
    if !value.is_table() {
        let complaint = Complaint::new("is neither text nor a table", limits::windows());
        return Err(value.error(complaint));
    }
    let section = value.section(&keys::WINDOW.names())?;
    let get = |key| section.require(key, "a number of samples")?.integer(0, MOST_SAMPLES);
    let shape = limits::window(get("history")?, get("block")?, get("lookahead")?);
    shape.map(Some).map_err(|complaint| value.error(complaint))
}

fn link(root: &Section<'_>) -> Result<Link, InputError> {
    let Some(section) = root.table("link", &keys::LINK)? else { return Ok(Link::default()) };
    Ok(Link {
        loss: section.number_or("loss", 0.0, &limits::LOSS)?,
        jitter_s: section.number_or("jitter_s", 0.0, &Range::NOT_NEGATIVE)?,
    })
}
