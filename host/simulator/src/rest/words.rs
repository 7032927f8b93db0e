//! Contradictions of readings at rest, in words: the number, the likely cause, and a remedy.

use super::units::{force_name, rate_name};
use crate::input::Complaint;
use crate::number::rounded;
use crate::units::{DEGREE, DEGREE_PER_HOUR, STANDARD_GRAVITY};
use schuler::alignment::judge::Contradiction;
use schuler::alignment::place::Place;
use schuler::alignment::signs::Signs;
use schuler::alignment::still::Readings;
use schuler::alignment::units::{Explanation, Explanations, ForceUnit, Kind, RateUnit};

/// Rates above this are told in °/s, rad/s.
const FAST: f64 = 1000.0 * DEGREE_PER_HOUR;
/// A bias of cheap gyros, rad/s: what makes sense of gyros in a unit that nothing else tells.
const CHEAP_BIAS: f64 = 5.0 * DEGREE;

/// A rate for people.
pub fn rate(rad_s: f64) -> String {
    if rad_s.abs() < FAST {
        format!("{} °/h", rounded(rad_s / DEGREE_PER_HOUR, 4))
    } else {
        format!("{} °/s", rounded(rad_s / DEGREE, 4))
    }
}

/// A specific force for people.
pub fn force(m_s2: f64) -> String {
    format!("{} m/s²", rounded(m_s2, 5))
}

/// What contradicts, and what would be accepted. `upside_down`: whether the level found is that of a
/// unit the other way up than the initial state says.
pub fn complaint(
    contradiction: &Contradiction<f64>,
    readings: &Readings<f64>,
    said: Kind,
    place: &Place<f64>,
    upside_down: bool,
) -> Complaint {
    let norm = readings.specific_force_b.norm();
    let (mean, turn) = (force(norm), rate(readings.rate_ib_b.norm()));
    let gravity = force(place.gravity);
    let still = "a stretch in which the vehicle stands still (--start, --align)";
    match contradiction {
        Contradiction::Units { force, rate } => units(force, rate, readings, said, place),
        Contradiction::Moving => {
            let spread = self::force(readings.force_spread);
            let what = format!(
                "the vehicle is not still: specific force, {mean} on average, varies by {spread}"
            );
            Complaint::new(what, still)
        }
        Contradiction::Force if norm < 0.1 * place.gravity => {
            let what = format!(
                "mean specific force is {mean}, where gravity is {gravity}: it looks like free fall, \
                 or like accelerometers whose gravity was taken away"
            );
            Complaint::new(
                what,
                "accelerometers that feel −g at rest, in m/s² or a unit of --units",
            )
        }
        Contradiction::Force => {
            let what = format!(
                "mean specific force is {mean}, where gravity is {gravity}: it fits no unit, so it \
                 looks like a vehicle that accelerates, an accelerometer's scale factor or bias, or \
                 another altitude"
            );
            Complaint::new(what, format!("{still}, or a unit of --units"))
        }
        Contradiction::Accelerating => {
            let off = self::force((norm - place.gravity).abs());
            let least = (norm * norm - place.gravity * place.gravity).abs().sqrt();
            let what = format!(
                "mean specific force is {mean}, where gravity is {gravity}: {off} apart, and steadier \
                 than accelerometers so wrong: it looks like a vehicle that accelerates, level by {} \
                 or vertically by {off}",
                self::force(least)
            );
            Complaint::new(what, still)
        }
        Contradiction::Turning => {
            let what = format!(
                "the vehicle turns: mean angular rate is {turn}, the Earth's {}, and the direction of \
                 specific force turns along",
                rate(EARTH)
            );
            Complaint::new(what, still)
        }
        Contradiction::Rate => {
            let what = format!(
                "mean angular rate is {turn}, the Earth's {}: it looks like a vehicle that turns, or \
                 like gyros in deg/s ({} then)",
                rate(EARTH),
                rate(readings.rate_ib_b.norm() * DEGREE)
            );
            Complaint::new(what, format!("--units deg/s or another unit, or {still}"))
        }
        Contradiction::Directions(signs) => directions(signs, place, upside_down),
    }
}

/// Earth's rate, rad/s.
pub const EARTH: f64 = schuler::earth::ROTATION_RATE;

fn kind_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Increments => "increments",
        Kind::Rates => "rates",
    }
}

/// What one explanation says: its unit, unless that is SI, and its kind, unless that is stated.
fn looks<U: Copy>(explanation: &Explanation<U, f64>, name: &str, si: f64, said: Kind) -> String {
    let unit = (si != 1.0).then(|| format!("{name} (× {})", factor(si)));
    let kind = (explanation.kind != said)
        .then(|| format!("{} under a header of {}", kind_name(explanation.kind), kind_name(said)));
    [unit, kind].into_iter().flatten().collect::<Vec<_>>().join(", ")
}

fn factor(si: f64) -> String {
    let digits = format!("{si}");
    if digits.len() <= 8 { digits } else { rounded(si, 6) }
}

fn units(
    forces: &Explanations<ForceUnit, f64>,
    rates: &Explanations<RateUnit, f64>,
    readings: &Readings<f64>,
    said: Kind,
    place: &Place<f64>,
) -> Complaint {
    let mut told = Vec::new();
    let spin = readings.rate_ib_b.norm();
    if !forces.is_empty() {
        let looks: Vec<_> =
            forces.iter().map(|e| looks(e, force_name(e.unit), e.unit.si(), said)).collect();
        told.push(format!(
            "mean specific force is {}, where gravity is {}: these look like {}",
            force(readings.specific_force_b.norm()),
            force(place.gravity),
            looks.join(", or like ")
        ));
    }
    // Nothing tells the unit of gyros whose bias hides the Earth's rate, but nobody's bias is 5 °/s.
    let cheap = rates.is_empty() && spin > CHEAP_BIAS && spin * DEGREE < CHEAP_BIAS;
    if cheap {
        told.push(format!(
            "mean angular rate is {}: gyros at rest that look like deg/s ({} then)",
            rate(spin),
            rate(spin * DEGREE)
        ));
    } else if !rates.is_empty() {
        let looks: Vec<_> =
            rates.iter().map(|e| looks(e, rate_name(e.unit), e.unit.si(), said)).collect();
        told.push(format!(
            "mean angular rate is {}, the Earth's {}: these look like {}",
            rate(spin),
            rate(EARTH),
            looks.join(", or like ")
        ));
    }
    let mut accepted: Vec<String> = Vec::new();
    for kind in [said, said.other()] {
        let of_force: Vec<_> = forces.iter().filter(|e| e.kind == kind).map(|e| e.unit).collect();
        let of_rate: Vec<_> = rates.iter().filter(|e| e.kind == kind).map(|e| e.unit).collect();
        if of_force.is_empty() && of_rate.is_empty() {
            continue;
        }
        let some = |names: Vec<&'static str>| if names.is_empty() { vec![""] } else { names };
        for force in some(of_force.into_iter().map(force_name).collect()) {
            for rate in some(of_rate.iter().copied().map(rate_name).collect()) {
                let rate = if cheap { "deg/s" } else { rate };
                let kind = if kind == said { "" } else { kind_name(kind) };
                let words = [force, rate, kind];
                let words: Vec<_> = words
                    .into_iter()
                    .filter(|word| !["", "m/s2", "rad/s"].contains(word))
                    .collect();
                accepted.push(format!("--units {}", words.join(",")));
            }
        }
    }
    Complaint::new(told.join("; "), accepted.join(", or "))
}

fn directions(signs: &Signs<f64>, place: &Place<f64>, upside_down: bool) -> Complaint {
    const AXES: [&str; 3] = ["x", "y", "z"];
    const PAIRS: [&str; 3] = ["x and y", "y and z", "z and x"];
    let named = |flags: [bool; 3], names: [&'static str; 3]| {
        flags.into_iter().zip(names).filter_map(|(flag, name)| flag.then_some(name))
    };
    let latitude = place.position.latitude / DEGREE;
    let mut looks = Vec::new();
    if signs.reversed {
        let reversed =
            "specific force of the wrong sign (counted down: at rest it is −g, upwards)".to_owned();
        let hemisphere =
            format!("the latitude of the other hemisphere ({}°)", rounded(-latitude, 4));
        let gyros = "all gyros of the wrong sign".to_owned();
        // The level found tells which is the likelier.
        looks.extend(if upside_down {
            [reversed, hemisphere, gyros]
        } else {
            [hemisphere, gyros, reversed]
        });
    }
    let axes = named(signs.axis, AXES);
    looks.extend(axes.map(|axis| format!("gyro {axis} or accelerometer {axis} reversed")));
    let pairs = named(signs.exchanged, PAIRS);
    looks.extend(pairs.map(|pair| format!("axes {pair} of gyros or accelerometers exchanged")));
    if signs.longitude {
        looks.push("latitude and longitude exchanged".to_owned());
    }
    if signs.radians {
        looks.push("a latitude in radians".to_owned());
    }
    if looks.is_empty() {
        looks.push("another latitude, or axes out of order".to_owned());
    }
    let what = format!(
        "gyros and accelerometers at rest speak of latitude {}°, the initial state of {}°: it looks \
         like {}",
        rounded(signs.latitude / DEGREE, 4),
        rounded(latitude, 4),
        looks.join(", or like ")
    );
    let accepted = "axes forward, right, down, and specific force −g at rest; a latitude in degrees, north positive";
    Complaint::new(what, accepted)
}

/// What a unit the other way up looks like.
pub fn upside_down(roll: f64, given: f64) -> Complaint {
    let what = format!(
        "level is upside down: roll is {:.1}° by the accelerometers, {:.1}° in the initial state; it \
         looks like axes whose z points up (forward-left-up, right-forward-up), or like specific force \
         counted down (at rest it is −g, upwards)",
        roll / DEGREE,
        given / DEGREE
    );
    let accepted = "--axes with z up, such as forward-left-up; accelerometers that read −g, upwards; or in \
        --initial the roll of a unit that hangs upside down";
    Complaint::new(what, accepted)
}

/// What |f| says of accelerometers that are not quite right.
pub fn force_is_off(off: f64, place: &Place<f64>) -> String {
    format!(
        "mean specific force is {} {} gravity's {}: a bias of {} mg, a scale factor of {} %, or a \
         vehicle that accelerates",
        force(off.abs()),
        if off < 0.0 { "below" } else { "above" },
        force(place.gravity),
        rounded(off / (1e-3 * STANDARD_GRAVITY), 2),
        rounded(100.0 * off / place.gravity, 2)
    )
}
