//! Data sheets: their units and their words turned into a scene's sensor sections.
//!
//! `entries` lists the numbers; here they are read, converted, and what was assumed is said.

pub mod entries;

use crate::allan::TRIADS;
use crate::input::document::{Document, Section};
use crate::input::{Complaint, InputError, Range};
use crate::number::parameter;
use crate::scene::SensorErrors;
use crate::scene::limits;
use crate::scene::terms::{TERMS, Term};
use entries::{Entry, LEFT_OUT};
use std::fmt::Write as _;

const RATE: &str = "sample_rate_hz";
const LATENCY: &str = "latency_s";
const MODEL: &str = "bias_model";
/// How a lowest point of the Allan curve is explained.
const MODELS: &[(&str, bool)] = &[("flicker", false), ("random-walk", true)];

/// The sections of a scene for a data sheet; `file` names it in errors.
pub fn sections(file: &str, text: &str) -> Result<String, InputError> {
    let document = Document::parse(file, text)?;
    let root = document.root(&[TRIADS[0], TRIADS[1], RATE, MODEL])?;
    let interval_s = root.get(RATE).map(|value| value.number(&limits::RATE_HZ)).transpose()?;
    let interval_s = interval_s.map(|rate_hz| 1.0 / rate_hz);
    let walks = root.get(MODEL).map_or(Ok(false), |value| value.choice(MODELS))?;
    let mut out = format!("# From {file}\n");
    let mut any = false;
    for (triad, table) in TRIADS.iter().enumerate() {
        let known: Vec<_> = names(triad);
        let section = root.section(table, &known).map_err(|error| misplaced(error, table))?;
        if let Some(section) = section {
            out += &one(&section, triad, interval_s, walks)?;
            any = true;
        }
    }
    if out.lines().any(|line| line.starts_with("temperature_")) {
        out += "[temperature]\noffset_k = 0 # what the sensors are warmer than when they were calibrated\n";
    }
    if !any {
        let complaint =
            Complaint::new("has no table of a sensor", "[gyro], [accelerometer] or both");
        return Err(InputError::file(file, complaint));
    }
    Ok(out)
}

/// An error about a sensor's table, in the words of what belongs to the whole file if it is about that.
fn misplaced(error: InputError, table: &str) -> InputError {
    let is_it = |key: &&str| error.key.as_ref().is_some_and(|it| *it == format!("{table}.{key}"));
    let Some(key) = [RATE, MODEL].into_iter().find(is_it) else { return error };
    let what = format!("is of the whole file, not of [{table}]");
    let accepted = format!("{key} at the top, before the first table");
    InputError { complaint: Complaint::new(what, accepted), ..error }
}

fn names(triad: usize) -> Vec<&'static str> {
    let own = entries::of(triad).iter().map(|entry| entry.key);
    let scene = TERMS.iter().filter_map(|term| [term.gyro, term.accelerometer][triad]);
    let left_out = LEFT_OUT.iter().map(|(key, _)| *key);
    own.chain(scene.map(|key| key.key)).chain(left_out).collect()
}

/// Reads the keys of a data sheet in a sensor's table, of a sheet or of a scene, and those that were there.
///
/// The steps of an output are held for `interval_s`, the length of a sample.
pub fn read(
    section: &Section<'_>,
    triad: usize,
    interval_s: Option<f64>,
    errors: &mut SensorErrors,
) -> Result<Vec<&'static Entry>, InputError> {
    let mut found = Vec::new();
    for entry in in_order(triad) {
        let Some(value) = section.get(entry.key) else { continue };
        let told = value.axes(&entry.range)?;
        let mut values = told.map(|x| x * entry.factor);
        if entry.is_step() {
            let Some(interval_s) = interval_s else {
                let what =
                    format!("is a step of the rate, and needs {RATE} at the top of the file");
                return Err(section.blame(entry.key, Complaint::new(what, "samples per second")));
            };
            values = values.map(|x| x * interval_s);
        }
        let values = whole(entry, values, errors, section)?;
        within(entry, triad, told, values).map_err(|complaint| value.error(complaint))?;
        if !entry.slot.set(errors, values) {
            let what = format!("gives {}, which another key gives, too", entry.gives);
            return Err(section.blame(entry.key, Complaint::new(what, "one of the two")));
        }
        found.push(entry);
    }
    Ok(found)
}

/// Refuses what a scene's own key does not take.
fn within(entry: &Entry, triad: usize, told: [f64; 3], values: [f64; 3]) -> Result<(), Complaint> {
    let own = |term: &Term| [term.gyro, term.accelerometer][triad];
    let of = |term: &'static Term| {
        own(term).filter(|key| key.key == entry.gives).map(|key| (term.range, key))
    };
    let Some((range, key)) = TERMS.iter().find_map(of) else { return Ok(()) };
    let outside = |value: f64| range.check(value / key.unit).is_err();
    let Some(i) = values.iter().position(|value| outside(*value)) else { return Ok(()) };
    let gives = values[i] / key.unit;
    let [told, gives_told] = [told[i], gives].map(parameter);
    let what = format!("{told} is out of range: it gives {} = {gives_told}", key.key);
    Err(Complaint::new(what, format!("what gives {}: {}", key.key, range.accepted)))
}

/// The entries of a triad, shares of the full scale last.
fn in_order(triad: usize) -> impl Iterator<Item = &'static Entry> {
    let [own, shares] = [false, true].map(|shares| {
        entries::of(triad).iter().filter(move |entry| entry.is_of_full_scale() == shares)
    });
    own.chain(shares)
}

/// Values of a share, times the full scale that it is a share of.
fn whole(
    entry: &Entry,
    values: [f64; 3],
    errors: &SensorErrors,
    section: &Section<'_>,
) -> Result<[f64; 3], InputError> {
    if !entry.is_of_full_scale() {
        return Ok(values);
    }
    let Some(full) = errors.saturation else {
        let what = "is a share of the full scale, which is missing";
        let complaint = Complaint::new(what, "full_scale or saturation in the same table");
        return Err(section.blame(entry.key, complaint));
    };
    Ok(std::array::from_fn(|i| values[i] * full[i]))
}

fn one(
    section: &Section<'_>,
    triad: usize,
    interval_s: Option<f64>,
    walks: bool,
) -> Result<String, InputError> {
    let mut errors = SensorErrors::default();
    let mut notes: Vec<String> = Vec::new();
    for term in TERMS {
        let Some(key) = [term.gyro, term.accelerometer][triad] else { continue };
        if let Some(value) = section.get(key.key) {
            (term.set)(&mut errors, Some(term.read(&value)?.map(|x| x * key.unit)));
        }
    }
    let given = read(section, triad, interval_s, &mut errors)?;
    if let Some(interval_s) = interval_s
        && let Err(complaint) = limits::latency_of(&errors, 1.0 / interval_s)
    {
        let key = given.iter().find(|entry| entry.gives == LATENCY).map_or(LATENCY, |e| e.key);
        return Err(section.blame(key, complaint));
    }
    for entry in given {
        let is_walk = walks && entry.gives.starts_with("bias_instability");
        if !entry.assumed.is_empty() && !is_walk {
            notes.push(format!("{}: {}", entry.key, entry.assumed));
        }
    }
    for (key, why) in LEFT_OUT {
        if let Some(value) = section.get(key) {
            value.axes(&Range::FINITE)?;
            notes.push(format!("{key}: left out; {why}"));
        }
    }
    if walks {
        walk(section, &mut errors, &mut notes)?;
    }
    if errors.white.is_none() {
        notes.push("no noise density is given: the section has no white noise".to_owned());
    }
    Ok(written(triad, &errors, &notes))
}

/// The floor as the place where white noise and a random walk of the bias meet.
fn walk(
    section: &Section<'_>,
    errors: &mut SensorErrors,
    notes: &mut Vec<String>,
) -> Result<(), InputError> {
    let Some(floor) = errors.bias_instability.take() else { return Ok(()) };
    let Some(white) = errors.white.filter(|white| white.iter().all(|n| *n > 0.0)) else {
        let what = format!("{MODEL} \"random-walk\" needs a noise density above 0");
        return Err(section.error(Complaint::new(what, "a noise density, or \"flicker\"")));
    };
    if errors.random_walk.is_some() {
        let what = format!("has a random walk of its own beside {MODEL} \"random-walk\"");
        return Err(section.error(Complaint::new(what, "one of the two")));
    }
    // N²/τ + K²τ/3 is least at τ = √3 N/K, where it is 2NK/√3.
    let least = |b: f64| b * entries_floor();
    let walks: [f64; 3] =
        std::array::from_fn(|i| 3f64.sqrt() * least(floor[i]).powi(2) / (2.0 * white[i]));
    if let Some(k) = walks.iter().find(|k| !(**k).is_finite()) {
        let what = format!("{MODEL} \"random-walk\" gives a random walk of {k}");
        return Err(section.error(Complaint::new(what, "a larger noise density, or \"flicker\"")));
    }
    errors.random_walk = Some(walks);
    notes.push(
        "in-run bias stability: taken for the lowest point of white noise and a random walk of the bias \
         with nothing between, K = √3 σ_min²/(2N)"
            .to_owned(),
    );
    Ok(())
}

/// σ_min over B.
fn entries_floor() -> f64 {
    (2.0 * std::f64::consts::LN_2 / std::f64::consts::PI).sqrt()
}

fn written(triad: usize, errors: &SensorErrors, notes: &[String]) -> String {
    let mut text = String::new();
    for note in notes {
        // A String takes all that is written.
        let _ = writeln!(text, "# {} {note}", TRIADS[triad]);
    }
    let _ = writeln!(text, "[{}]", TRIADS[triad]);
    for term in TERMS {
        let Some(key) = [term.gyro, term.accelerometer][triad] else { continue };
        if let Some(values) = (term.values)(errors) {
            let values = values.written(|x| parameter(x / key.unit));
            let _ = writeln!(text, "{} = {values}", key.key);
        }
    }
    text
}

/// Every key of a data sheet, for people.
pub fn keys() -> String {
    let mut text = format!(
        "{RATE}: samples per second, for resolutions\n{MODEL}: \"flicker\" (if absent) or \"random-walk\": what makes \
         the lowest point of the Allan curve\nEach key takes one number, or [x, y, z]; a scene's own keys are \
         taken, too, and a scene takes\nthese, but for what is left out.\n"
    );
    for (triad, table) in TRIADS.iter().enumerate() {
        let _ = writeln!(text, "\n[{table}]");
        for entry in entries::of(triad) {
            let _ = writeln!(text, "{:34} gives {}", entry.key, entry.gives);
        }
        for (key, why) in LEFT_OUT {
            let _ = writeln!(text, "{key:34} is left out: {why}");
        }
    }
    text
}
