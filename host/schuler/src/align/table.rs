//! What is printed of an alignment of a scene.

use schuler::solution::Euler;
use schuler_simulator::alignment::outcome::Outcome;
use schuler_simulator::alignment::spread::{AXES, Claimed, Spread};
use schuler_simulator::number::rounded;
use schuler_simulator::units::{DEGREE, DEGREE_PER_HOUR};

/// 1′, rad.
const ARCMINUTE: f64 = DEGREE / 60.0;
/// Digits of an angle.
const DIGITS: i32 = 4;

/// An attitude by a method.
pub fn attitude(method: &str, found: &Euler<f64>) -> String {
    format!(
        "{method}: roll {:.4}°, pitch {:.4}°, heading {:.4}°\n",
        found.roll / DEGREE,
        found.pitch / DEGREE,
        (found.yaw / DEGREE).rem_euclid(360.0)
    )
}

/// Errors of many runs beside what the filters say and theory allows, in minutes of arc.
pub fn spread(spread: &Spread) -> String {
    let minutes = |x: f64| rounded(x / ARCMINUTE, DIGITS);
    let or_none = |x: Option<f64>| x.map_or_else(|| "–".to_owned(), minutes);
    let mut text =
        format!("{:10}{:>12}{:>12}{:>12}{:>12}\n", "\u{2032}", "rms", "mean", "1σ said", "theory");
    for (name, axis) in AXES.iter().zip(&spread.axes) {
        text += &format!(
            "{name:10}{:>12}{:>12}{:>12}{:>12}\n",
            minutes(axis.rms),
            minutes(axis.mean),
            or_none(axis.sigma),
            or_none(axis.limit)
        );
    }
    spread.claimed.map_or(text.clone(), |claimed| text + &said(&claimed))
}

fn said(claimed: &Claimed) -> String {
    let Claimed { nees, expected: [least, most], residual } = *claimed;
    let verdict = if nees < least {
        "the errors are smaller than the filter says"
    } else if nees > most {
        "the errors are larger than the filter says"
    } else {
        "the errors are what the filter says"
    };
    format!(
        "NEES {nees:.3} of 1 ({least:.3} to {most:.3} in 95 % of cases): {verdict}\n\
         residuals {residual:.3} of what is expected\n"
    )
}

/// What the alignment before a flight found.
pub fn begun(outcome: &Outcome) -> String {
    let degrees = |x: f64| rounded(x / DEGREE, DIGITS);
    let [north, east, heading] = outcome.error.map(degrees);
    let [level, other, sure] = outcome.sigma;
    format!(
        "aligned until {} s: off by {north}° about north, {east}° about east, {heading}° of heading \
         (1σ {}°, {}°)\n",
        rounded(outcome.time_s, 6),
        degrees(level.max(other)),
        degrees(sure)
    )
}

/// What one run found, and what it is off by.
pub fn one(outcome: &Outcome, limit: Option<f64>) -> String {
    let degrees = |x: f64| rounded(x / DEGREE, DIGITS);
    let found = &outcome.aligned;
    let [[gyro, gyro_sigma], [force, force_sigma]] = [found.gyro_bias, found.accelerometer_bias];
    let list = |axes: [f64; 3], unit: f64| axes.map(|x| rounded(x / unit, DIGITS)).join(", ");
    let allows =
        limit.map_or(String::new(), |limit| format!("; theory allows {}°", degrees(limit)));
    attitude("fine", &found.attitude)
        + &format!(
            "off by {}° about north, {}° about east, {}° of heading\n\
             1σ: level {}°, heading {}°{allows}\n\
             gyro biases {} °/h\n   1σ {}\n\
             accelerometer biases {} m/s²\n   1σ {}\n\
             residuals {:.2} of what is expected\n",
            degrees(outcome.error[0]),
            degrees(outcome.error[1]),
            degrees(outcome.error[2]),
            degrees(found.level_sigma[0].max(found.level_sigma[1])),
            degrees(found.heading_sigma),
            list(gyro.into_array(), DEGREE_PER_HOUR),
            list(gyro_sigma.into_array(), DEGREE_PER_HOUR),
            list(force.into_array(), 1.0),
            list(force_sigma.into_array(), 1.0),
            found.residual,
        )
}
