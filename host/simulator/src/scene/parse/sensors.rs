//! The `[gyro]` and `[accelerometer]` tables.

use crate::allan::TRIADS;
use crate::datasheet::{self, entries};
use crate::input::document::Section;
use crate::input::{InputError, Range};
use crate::scene::terms::{Key, TERMS, Term};
use crate::scene::{GaussMarkov, SensorErrors};
use crate::units::{DEGREE_PER_HOUR, MICRO_G};

const RMS: Range = Range::NOT_NEGATIVE;

/// The `[gyro]` table: rad, rad/s.
pub fn gyro(root: &Section<'_>) -> Result<SensorErrors, InputError> {
    sensor(root, 0, |term| term.gyro, "rms_deg_h", DEGREE_PER_HOUR)
}

/// The `[accelerometer]` table: m/s, m/s².
pub fn accelerometer(root: &Section<'_>) -> Result<SensorErrors, InputError> {
    sensor(root, 1, |term| term.accelerometer, "rms_ug", MICRO_G)
}

fn sensor(
    root: &Section<'_>,
    triad: usize,
    key_of: fn(&Term) -> Option<Key>,
    rms: &str,
    rms_unit: f64,
) -> Result<SensorErrors, InputError> {
    let mut errors = SensorErrors::default();
    let mut known: Vec<_> = TERMS.iter().filter_map(key_of).map(|key| key.key).collect();
    known.push("gauss_markov");
    let units = entries::of(triad).iter().filter(|entry| entry.is_unit());
    known.extend(units.map(|entry| entry.key));
    let Some(section) = root.section(TRIADS[triad], &known)? else { return Ok(errors) };
    for term in TERMS {
        let Some(Key { key, unit, .. }) = key_of(term) else { continue };
        if let Some(value) = section.get(key) {
            *(term.values_mut)(&mut errors) = Some(value.axes(&term.range)?.map(|x| x * unit));
        }
    }
    datasheet::read_units(&section, triad, &mut errors)?;
    if let Some(process) = section.section("gauss_markov", &[rms, "correlation_s"])? {
        let time = Range { accepted: "seconds, above 0", ..Range::POSITIVE };
        let rms = process.require(rms, RMS.accepted)?.axes(&RMS)?.map(|x| x * rms_unit);
        let correlation_s = process.require("correlation_s", time.accepted)?.axes(&time)?;
        errors.gauss_markov = Some(GaussMarkov { rms, correlation_s });
    }
    Ok(errors)
}
