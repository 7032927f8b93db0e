//! The `[gyro]` and `[accelerometer]` tables.

use crate::allan::TRIADS;
use crate::datasheet::{self, entries, entries::LEFT_OUT};
use crate::input::document::Section;
use crate::input::{Complaint, InputError, Range};
use crate::scene::keys::general as keys;
use crate::scene::terms::{Key, TERMS, Term};
use crate::scene::{GaussMarkov, SensorErrors, Temperature};
use crate::units::{DEGREE_PER_HOUR, MICRO_G};

const RMS: Range = Range::NOT_NEGATIVE;

/// The `[gyro]` table, rad, rad/s, and the `[accelerometer]` table, m/s, m/s².
pub fn both(
    root: &Section<'_>,
    rate_hz: Option<f64>,
    duration_s: f64,
) -> Result<[SensorErrors; 2], InputError> {
    let units = [("rms_deg_h", DEGREE_PER_HOUR), ("rms_ug", MICRO_G)];
    let mut gyro = sensor(root, 0, |term| term.gyro, rate_hz, units[0])?;
    let mut accelerometer = sensor(root, 1, |term| term.accelerometer, rate_hz, units[1])?;
    let temperature = temperature(root, duration_s)?;
    let mut warmed = false;
    for errors in [&mut gyro, &mut accelerometer] {
        if errors.temperature_bias.is_some() || errors.temperature_scale.is_some() {
            errors.temperature = temperature;
            warmed = true;
        }
    }
    let complaint = match (warmed, temperature) {
        (true, None) => Complaint::new(
            "is missing, and a sensor has a coefficient of it",
            "a table with ramp_k_min or offset_k",
        ),
        (false, Some(_)) => Complaint::new(
            "changes nothing: no sensor has a coefficient of it",
            "temperature_bias or temperature_scale_factor in [gyro] or [accelerometer]",
        ),
        _ => return Ok([gyro, accelerometer]),
    };
    Err(root.blame("temperature", complaint))
}

/// The `[temperature]` table.
fn temperature(root: &Section<'_>, duration_s: f64) -> Result<Option<Temperature>, InputError> {
    let Some(section) = root.table("temperature", &keys::TEMPERATURE)? else { return Ok(None) };
    Ok(Some(Temperature {
        offset_k: section.read(&keys::OFFSET)?.unwrap_or(0.0),
        rate_k_s: section.read(&keys::RAMP)?.unwrap_or(0.0) / 60.0,
        until_s: section.read(&keys::UNTIL)?.unwrap_or(duration_s),
    }))
}

fn sensor(
    root: &Section<'_>,
    triad: usize,
    key_of: fn(&Term) -> Option<Key>,
    rate_hz: Option<f64>,
    (rms, rms_unit): (&str, f64),
) -> Result<SensorErrors, InputError> {
    let mut errors = SensorErrors::default();
    let mut known: Vec<_> = TERMS.iter().filter_map(key_of).map(|key| key.key).collect();
    known.push("gauss_markov");
    known.extend(entries::of(triad).iter().map(|entry| entry.key));
    let but = known.len();
    known.extend(LEFT_OUT.iter().map(|(key, _)| *key));
    let Some(section) = root.section(TRIADS[triad], &known)? else { return Ok(errors) };
    if let Some((key, why)) = LEFT_OUT.iter().find(|(key, _)| section.get(key).is_some()) {
        let what = format!("cannot be emulated: {why}");
        return Err(section.blame(key, Complaint::new(what, known[..but].join(", "))));
    }
    for term in TERMS {
        let Some(Key { key, unit, .. }) = key_of(term) else { continue };
        if let Some(value) = section.get(key) {
            (term.set)(&mut errors, Some(term.read(&value)?.map(|x| x * unit)));
        }
    }
    // What is assumed of them is said in the reference of keys.
    datasheet::read(&section, triad, rate_hz.map(|hz| 1.0 / hz), &mut errors)?;
    if let Some(process) = section.section("gauss_markov", &[rms, "correlation_s"])? {
        let time = Range { accepted: "seconds, above 0", ..Range::POSITIVE };
        let rms = process.require(rms, RMS.accepted)?.axes(&RMS)?.map(|x| x * rms_unit);
        let correlation_s = process.require("correlation_s", time.accepted)?.axes(&time)?;
        errors.gauss_markov = Some(GaussMarkov { rms, correlation_s });
    }
    Ok(errors)
}
