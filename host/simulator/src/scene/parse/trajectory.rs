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

/// What a channel's numbers are.
#[derive(Clone, Copy)]
struct Quantity {
    /// Its unit in SI.
    unit: f64,
    /// Offsets and amplitudes.
    range: Range,
    /// What is accepted in place of a table, and the table.
    constant: &'static str,
}

/// Turns of which a double still knows the 10⁻¹⁰th degree.
const DEGREES: Range = Range::from_to(-1e6, 1e6, "degrees, from -1e6 to 1e6");
const ANGLE: Quantity = Quantity {
    unit: DEGREE,
    range: DEGREES,
    constant: "degrees, from -1e6 to 1e6, or { offset, rate, harmonics }",
};
const HEIGHT: Quantity = Quantity {
    unit: 1.0,
    range: Range::FINITE,
    constant: "a finite number, or { offset, rate, harmonics }",
};

/// The table, or rest at the origin where there is none.
pub fn read(root: &Section<'_>) -> Result<Trajectory, InputError> {
    let Some(section) = root.section("trajectory", KEYS)? else {
        return Ok(Trajectory::default());
    };
    let get = |key, of| section.get(key).map_or(Ok(Channel::default()), |v| channel(&v, of));
    Ok(Trajectory {
        path: None,
        roll: get("roll_deg", ANGLE)?,
        pitch: get("pitch_deg", ANGLE)?,
        yaw: get("yaw_deg", ANGLE)?,
        latitude: get("latitude_deg", ANGLE)?,
        longitude: get("longitude_deg", ANGLE)?,
        altitude: get("altitude_m", HEIGHT)?,
    })
}

fn channel(value: &Value<'_>, of: Quantity) -> Result<Channel, InputError> {
    if !value.is_table() {
        let constant = Range { accepted: of.constant, ..of.range };
        return Ok(Channel { offset: value.number(&constant)? * of.unit, ..Channel::default() });
    }
    let section = value.section(CHANNEL)?;
    let harmonics = match section.get("harmonics") {
        None => Vec::new(),
        Some(list) => list
            .items("a list of { amplitude, period_s, phase_deg }")?
            .iter()
            .map(|item| harmonic(item, of))
            .collect::<Result<_, _>>()?,
    };
    Ok(Channel {
        offset: section.number_or("offset", 0.0, &of.range)? * of.unit,
        rate: section.number_or("rate", 0.0, &Range::FINITE)? * of.unit,
        harmonics,
    })
}

fn harmonic(value: &Value<'_>, of: Quantity) -> Result<Harmonic<f64>, InputError> {
    let section = value.section(HARMONIC)?;
    let period = Range { accepted: "seconds, above 0", ..Range::POSITIVE };
    Ok(Harmonic {
        amplitude: section.number("amplitude", &of.range)? * of.unit,
        angular_rate: TAU / section.number("period_s", &period)?,
        phase: section.number_or("phase_deg", 0.0, &DEGREES)? * DEGREE,
    })
}
