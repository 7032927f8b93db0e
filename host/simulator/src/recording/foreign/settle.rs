//! What a map leaves open, settled by physics where that can: a unit at rest reads gravity and the Earth's rate.
//! What physics cannot tell is asked for.

use super::super::Kind;
use super::super::mounting::Mounting;
use super::look::{ForceGuess, Look, likely_unit};
use super::map::Map;
use crate::input::{Complaint, InputError};
use crate::number::rounded;
use crate::rest::units::{force_name, rate_name};
use crate::units::{DEGREE, DEGREE_PER_HOUR};
use schuler::alignment::units::{ForceUnit, RateUnit};
use schuler::math::vector::Vector;

/// Units that logs have without saying so.
pub const USUAL: [ForceGuess; 4] = [
    (ForceUnit::MetrePerSecondSquared, Kind::Rates),
    (ForceUnit::G, Kind::Rates),
    (ForceUnit::MilliG, Kind::Rates),
    (ForceUnit::MetrePerSecondSquared, Kind::Increments),
];
/// Units of gyros that are good enough to read the Earth's rate.
const GOOD: [RateUnit; 3] =
    [RateUnit::RadianPerSecond, RateUnit::DegreePerSecond, RateUnit::DegreePerHour];
const EARTH: f64 = schuler::earth::ROTATION_RATE;
/// Gyros that read the Earth's rate are this near to it, of the rate itself.
const EARTH_FIT: f64 = 0.2;
/// A bias that no gyro has, rad/s.
const NO_BIAS: f64 = 5.0 * DEGREE;
/// Noise from reading to reading that no gyro has, rad/s.
const NO_NOISE: f64 = 20.0 * DEGREE;
/// A rate that no vehicle turns at and no small gyro measures, rad/s.
const NO_RATE: f64 = 2500.0 * DEGREE;
/// An axis this much along the vertical is the vertical one.
const UPRIGHT: f64 = 0.7;

/// Settles units, kind of samples and axes; what was found is said.
pub fn settle(name: &str, look: Option<&Look>, map: &mut Map) -> Result<Vec<String>, InputError> {
    let mut said = Vec::new();
    let open = map.units.kind.is_none() || map.units.force.is_none() || map.units.rate.is_none();
    if !open && map.mounting.is_some() {
        return Ok(said);
    }
    let Some(look) = look else {
        let what = "has too few rows to tell units and axes from";
        return Err(InputError::file(
            name,
            Complaint::new(what, "a map (--map) or --units and --axes"),
        ));
    };
    let h =
        look.step * map.units.time.map_or_else(|| likely_unit(look.step), |unit| unit.counted().1);
    if map.units.kind.is_none() || map.units.force.is_none() {
        said.push(force(name, look, h, map)?);
    }
    if map.units.rate.is_none() {
        said.push(rate(name, look, h, map)?);
    }
    if map.mounting.is_none() {
        said.push(axes(name, look, map)?);
    }
    Ok(said)
}

/// Units of accelerometers and the kind of samples: those that make gravity of what is read.
fn force(name: &str, look: &Look, h: f64, map: &mut Map) -> Result<String, InputError> {
    let units = map.units;
    let stated = units.force.map(|unit| [(unit, Kind::Rates), (unit, Kind::Increments)]);
    let guesses = stated.as_ref().map_or(&USUAL[..], |stated| &stated[..]);
    let guesses: Vec<_> =
        guesses.iter().filter(|(_, kind)| units.kind.is_none_or(|k| k == *kind)).copied().collect();
    let read = rounded(look.force(), 4);
    match look.gravity(h, &guesses)[..] {
        [(unit, kind)] => {
            (map.units.force, map.units.kind) = (Some(unit), Some(kind));
            Ok(format!("{name}: accelerometers read {read}: gravity, {}", words(unit, kind)))
        }
        [] => {
            let tried: Vec<_> = guesses.iter().map(|(unit, kind)| words(*unit, *kind)).collect();
            let what = format!(
                "accelerometers read {read} in the middle, which is gravity neither in {}",
                tried.join(" nor in ")
            );
            let accepted = "--units, with their unit and increments or rates; or accelerometers that feel gravity";
            Err(InputError::file(name, Complaint::new(what, accepted)))
        }
        ref several => {
            let options: Vec<_> = several.iter().map(|(unit, kind)| option(*unit, *kind)).collect();
            let what = format!("accelerometers read {read}, which may be gravity in several units");
            Err(InputError::file(name, Complaint::new(what, options.join(", or "))))
        }
    }
}

/// The unit of gyros: the one in which they read the Earth's rate, or the only one that makes sense.
fn rate(name: &str, look: &Look, h: f64, map: &mut Map) -> Result<String, InputError> {
    let kind = map.units.kind.unwrap_or(Kind::Rates);
    let of = |rate: f64, unit: RateUnit| look.rate_in(rate, unit, kind, h);
    let usual = look.rate();
    let is_earth = |unit: &&RateUnit| (of(usual, **unit) / EARTH - 1.0).abs() < EARTH_FIT;
    let mut earths = GOOD.iter().filter(|_| look.steady(EARTH_FIT)).filter(is_earth);
    if let (Some(&unit), None) = (earths.next(), earths.next()) {
        map.units.rate = Some(unit);
        let rate = rounded(of(usual, unit) / DEGREE_PER_HOUR, 4);
        return Ok(format!(
            "{name}: gyros read the Earth's rate, {rate} °/h, in {}",
            rate_name(unit)
        ));
    }
    let (radians, degrees) = (RateUnit::RadianPerSecond, RateUnit::DegreePerSecond);
    // What a unit would make of the readings, and whether that can be.
    let senseless = |unit: RateUnit| -> Option<String> {
        let told = |rate: f64| rounded(of(rate, unit) / DEGREE, 4);
        if of(look.scatter, unit) > NO_NOISE {
            Some(format!("would scatter by {} °/s from one to the next", told(look.scatter)))
        } else if of(look.peak, unit) > NO_RATE {
            Some(format!("would turn by up to {} °/s", told(look.peak)))
        } else {
            let across = look.across().filter(|&across| of(across, unit) > NO_BIAS)?;
            Some(format!("would turn by {} °/s across a vertical that stays", told(across)))
        }
    };
    if let (Some(why), None) = (senseless(radians), senseless(degrees)) {
        map.units.rate = Some(degrees);
        return Ok(format!("{name}: gyros read deg/s: in rad/s they {why}"));
    }
    let what = format!(
        "nothing tells the unit of the gyros: their usual reading is {} °/s in rad/s, {} °/s in deg/s",
        rounded(of(usual, radians) / DEGREE, 3),
        rounded(of(usual, degrees) / DEGREE, 3),
    );
    let known = map.units.force.map_or("m/s2", force_name);
    let accepted = format!("--units {known},rad/s or --units {known},deg/s");
    Err(InputError::file(name, Complaint::new(what, accepted)))
}

/// The axes, if z points down; what points up may be turned in more than one way.
fn axes(name: &str, look: &Look, map: &mut Map) -> Result<String, InputError> {
    let sign = if map.reversed { -1.0 } else { 1.0 };
    let Vector { x, y, z } = look.direction() * sign;
    if z < -UPRIGHT {
        map.mounting = Some(Mounting::FORWARD_RIGHT_DOWN);
        return Ok(format!(
            "{name}: z reads −g, so axes are forward-right-down (--axes states others)"
        ));
    }
    let (axis, accepted) = if z > UPRIGHT {
        ("z", "--axes forward-left-up, --axes right-forward-up or others with z up")
    } else if x.abs() > UPRIGHT {
        let up = if x > 0.0 {
            "up-right-forward, up-left-backward"
        } else {
            "down-right-backward, down-left-forward"
        };
        return Err(asked(name, "x", x > 0.0, &format!("--axes with x first, such as {up}")));
    } else if y.abs() > UPRIGHT {
        let up = if y > 0.0 {
            "right-up-backward, forward-up-right"
        } else {
            "right-down-forward, forward-down-left"
        };
        return Err(asked(name, "y", y > 0.0, &format!("--axes with y second, such as {up}")));
    } else {
        let what = "nothing tells the axes: no axis stands upright";
        let accepted = "--axes, or a mounting in a map";
        return Err(InputError::file(name, Complaint::new(what, accepted)));
    };
    Err(asked(name, axis, true, accepted))
}

fn asked(name: &str, axis: &str, up: bool, accepted: &str) -> InputError {
    let (reads, way) = if up { ("+g", "up") } else { ("−g", "down") };
    let what =
        format!("{axis} reads {reads}, so it points {way}, and nothing tells where forward is");
    InputError::file(name, Complaint::new(what, accepted))
}

fn words(unit: ForceUnit, kind: Kind) -> String {
    match kind {
        Kind::Rates => force_name(unit).to_owned(),
        Kind::Increments => format!("increments of {}·s", force_name(unit)),
    }
}

fn option(unit: ForceUnit, kind: Kind) -> String {
    match kind {
        Kind::Rates => format!("--units {},rates", force_name(unit)),
        Kind::Increments => format!("--units {},increments", force_name(unit)),
    }
}
