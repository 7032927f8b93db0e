//! The `[trajectory]` table: six channels, each a number or offset + rate·t + harmonics.

use crate::input::document::{Section, Value};
use crate::input::{InputError, Range};
use crate::scene::{Channel, Trajectory};
use crate::units::DEGREE;
use schuler::trajectory::harmonic::Harmonic;
use std::f64::consts::TAU;

const KEYS: &[&str] =
    &["roll_deg", "pitch_deg", "yaw_deg", "latitude_deg", "longitude_deg", "altitude_m"];
const CHANNEL: &[&str] = &["offset", "rate", "harmonics"];
const HARMONIC: &[&str] = &["amplitude", "period_s", "phase_deg"];
const ACCEPTED: &str = "a finite number, or { offset, rate, harmonics }";

/// The table, or rest at the origin where there is none.
pub fn read(root: &Section<'_>) -> Result<Trajectory, InputError> {
    let Some(section) = root.section("trajectory", KEYS)? else {
        return Ok(Trajectory::default());
    };
    let get = |key, unit| section.get(key).map_or(Ok(Channel::default()), |v| channel(&v, unit));
    Ok(Trajectory {
        roll: get("roll_deg", DEGREE)?,
        pitch: get("pitch_deg", DEGREE)?,
        yaw: get("yaw_deg", DEGREE)?,
        latitude: get("latitude_deg", DEGREE)?,
        longitude: get("longitude_deg", DEGREE)?,
        altitude: get("altitude_m", 1.0)?,
    })
}

fn channel(value: &Value<'_>, unit: f64) -> Result<Channel, InputError> {
    if !value.is_table() {
        let constant = Range { accepted: ACCEPTED, ..Range::FINITE };
        return Ok(Channel { offset: value.number(&constant)? * unit, ..Channel::default() });
    }
    let section = value.section(CHANNEL)?;
    let harmonics = match section.get("harmonics") {
        None => Vec::new(),
        Some(list) => list
            .items("a list of { amplitude, period_s, phase_deg }")?
            .iter()
            .map(|item| harmonic(item, unit))
            .collect::<Result<_, _>>()?,
    };
    Ok(Channel {
        offset: section.number_or("offset", 0.0, &Range::FINITE)? * unit,
        rate: section.number_or("rate", 0.0, &Range::FINITE)? * unit,
        harmonics,
    })
}

fn harmonic(value: &Value<'_>, unit: f64) -> Result<Harmonic<f64>, InputError> {
    let section = value.section(HARMONIC)?;
    let period = Range { accepted: "seconds, above 0", ..Range::POSITIVE };
    Ok(Harmonic {
        amplitude: section.number("amplitude", &Range::FINITE)? * unit,
        angular_rate: TAU / section.number("period_s", &period)?,
        phase: section.number_or("phase_deg", 0.0, &Range::FINITE)? * DEGREE,
    })
}
