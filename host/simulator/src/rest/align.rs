//! `--align`: level and north from a stretch at rest, with their uncertainty.

use super::fine::{Refined, Stretch};
use super::{warn, words};
use crate::input::{Complaint, InputError};
use crate::number::fixed;
use crate::output::say;
use crate::recording::navigation::NavigationRow;
use crate::units::{DEGREE, DEGREE_PER_HOUR};
use schuler::alignment::AlignmentError;
use schuler::alignment::judge::{Judgement, Quality, judge};
use schuler::alignment::place::Place;
use schuler::alignment::still::{Readings, Still};
use schuler::alignment::units::Kind;
use schuler::math::real::Real as _;
use schuler::math::vector::Vector;
use schuler::solution::Euler;

/// Length of the pieces whose scatter is measured, s.
const PIECE_S: f64 = 1.0;
/// A stretch that is shorter is cut into so many pieces.
const FEWEST_PIECES: f64 = 16.0;
/// A heading of a larger standard deviation is none: the gyros show no more of the Earth's rate than of
/// their own errors, rad.
const WORST_HEADING: f64 = 1.0;
/// A heading of a larger standard deviation, or one of level, is worth a warning, rad.
const POOR_HEADING: f64 = DEGREE;
const POOR_LEVEL: f64 = 0.5 * DEGREE;
/// Specific force further from gravity than this is worth a warning, of gravity: anomalies of the
/// field and 5 km of altitude stay below.
pub const NOTICED_FORCE: f64 = 0.002;

/// Where the heading comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Heading {
    /// It is known otherwise, rad.
    Known(f64),
    /// The gyros find it; `--heading` could have stated it.
    FoundOrStated,
    /// The gyros find it, and nothing else does.
    Found,
}

impl Heading {
    fn known(self) -> Option<f64> {
        match self {
            Self::Known(heading) => Some(heading),
            Self::FoundOrStated | Self::Found => None,
        }
    }

    /// What is accepted where the gyros find none.
    fn accepted(self) -> &'static str {
        match self {
            Self::Known(_) | Self::FoundOrStated => {
                "--heading DEG, a heading that is known otherwise"
            }
            Self::Found => {
                "gyros of smaller errors, a stretch at rest, or `schuler replay` with --align S and --heading DEG"
            }
        }
    }
}

/// What gathers a stretch of a length, s.
pub fn gather(length_s: f64) -> Still<f64> {
    Still::new(piece_s(length_s))
}

/// Length of the pieces of a stretch of a length, s.
fn piece_s(length_s: f64) -> f64 {
    PIECE_S.min(length_s / FEWEST_PIECES)
}

/// The state at rest that a stretch speaks of, judged and said; `missing` counts the samples that the stretch lacks.
/// With the samples themselves, the fine alignment on them.
#[expect(clippy::too_many_arguments, reason = "what is said of one stretch")]
pub fn align(
    still: &Still<f64>,
    said: Kind,
    file: &str,
    initial: &NavigationRow,
    sought: Heading,
    samples: usize,
    missing: u64,
    fine: Option<&Stretch>,
) -> Result<(NavigationRow, Option<Refined>), InputError> {
    let heading = sought.known();
    let refuse = |complaint| Err(InputError::file(file, complaint));
    let Some(readings) = still.readings() else {
        return refuse(Complaint::new(AlignmentError::Empty.to_string(), ""));
    };
    let place = Place::new(initial.position);
    let Judgement { quality, contradiction } = judge(&readings, said, &place);
    let level = still.alignment().level(heading.unwrap_or(0.0));
    let upside_down = level.is_ok_and(|level| faces_away(&level, &initial.attitude));
    if let Some(contradiction) = contradiction {
        let complaint = words::complaint(&contradiction, &readings, said, &place, upside_down);
        return refuse(complaint);
    }
    let level = match level {
        Ok(level) => level,
        Err(error) => return refuse(Complaint::new(error.to_string(), "")),
    };
    if upside_down {
        return refuse(words::upside_down(level.roll, initial.attitude.roll));
    }
    let attitude = match heading {
        Some(_) => level,
        None => {
            if !quality.heading_sigma.is_within(WORST_HEADING) {
                return refuse(no_heading(&readings, &quality, &place, sought));
            }
            let found = still.alignment().attitude();
            found.map_err(|e| {
                InputError::file(file, Complaint::new(e.to_string(), sought.accepted()))
            })?
        }
    };
    poor(&readings, &quality, &place, sought);
    say(&text(&readings, &quality, &attitude, heading.is_some(), samples, missing))?;
    let coarse = NavigationRow { attitude, velocity_ned: Vector::ZERO, ..*initial };
    // A heading that is known otherwise is better than one that a filter would find.
    let fine = fine.filter(|stretch| heading.is_none() && stretch.suffices());
    let Some(stretch) = fine else { return Ok((coarse, None)) };
    let piece_s = piece_s(still.seconds());
    let refined = stretch.refine(file, &coarse, &readings, &quality, piece_s)?;
    Ok((refined.row, Some(refined)))
}

/// Whether two attitudes' down axes point to opposite sides.
pub fn faces_away(found: &Euler<f64>, given: &Euler<f64>) -> bool {
    down_b(found).dot(down_b(given)) < 0.0
}

/// Where down is in body axes.
pub fn down_b(attitude: &Euler<f64>) -> Vector<f64> {
    let (sr, cr) = attitude.roll.sin_cos();
    let (sp, cp) = attitude.pitch.sin_cos();
    Vector::new(-sp, cp * sr, cp * cr)
}

/// Why no heading is found.
fn no_heading(
    readings: &Readings<f64>,
    quality: &Quality<f64>,
    place: &Place<f64>,
    sought: Heading,
) -> Complaint {
    let across = words::rate(place.rate_north);
    let latitude = place.position.latitude / DEGREE;
    let (off, sigma) = (words::rate(quality.rate_off), words::rate(readings.rate_sigma));
    let what = if place.rate_north < 1e-3 * words::EARTH {
        format!(
            "no heading can be found at latitude {latitude:.4}°, where {across} of the Earth's rate is \
             level (the mean is good to {sigma})"
        )
    } else {
        let worth = match quality.heading_sigma / DEGREE {
            sigma if sigma < 180.0 => format!("±{sigma:.0}°"),
            _ => "nothing".to_owned(),
        };
        format!(
            "a heading found here would be worth {worth}: mean angular rate is {}, the Earth's {}, of \
             which {across} points north; it is off by {off} at least and good to {sigma} by its \
             scatter. It looks like gyros of too large a bias, or like a vehicle that turns",
            words::rate(readings.rate_ib_b.norm()),
            words::rate(words::EARTH),
        )
    };
    Complaint::new(what, sought.accepted())
}

/// Says what is poor.
fn poor(readings: &Readings<f64>, quality: &Quality<f64>, place: &Place<f64>, sought: Heading) {
    let found = sought.known().is_none();
    if quality.force_off.abs() > NOTICED_FORCE * place.gravity {
        warn(&words::force_is_off(quality.force_off, place));
    }
    if quality.level_sigma > POOR_LEVEL {
        warn(&format!("level is good to {} only", degrees(quality.level_sigma)));
    }
    let (off, sigma) = (words::rate(quality.rate_off), words::rate(readings.rate_sigma));
    if found && quality.heading_sigma > POOR_HEADING {
        let better =
            if sought == Heading::Found { "" } else { "; --heading DEG states a better one" };
        warn(&format!(
            "heading is good to {} only: the gyros are off by {off} at least, and their mean is good to \
             {sigma} by its scatter{better}",
            degrees(quality.heading_sigma)
        ));
    }
    if !found && quality.rate_off > words::EARTH {
        let rate = words::rate(readings.rate_ib_b.norm());
        let degrees = words::rate(readings.rate_ib_b.norm() * DEGREE);
        warn(&format!(
            "mean angular rate is {rate}: the gyros are off by {off} at least, or the vehicle turns \
             (in deg/s they would read {degrees}: --units deg/s)"
        ));
    }
}

/// A standard deviation for people, upwards.
fn degrees(sigma: f64) -> String {
    let sigma = sigma / DEGREE;
    let decimals = decimals(sigma);
    let unit = 10f64.powi(-(decimals as i32));
    format!("{:.decimals$}°", ((sigma / unit).ceil() * unit).max(unit))
}

/// Decimals that a number with this standard deviation has.
fn decimals(sigma_deg: f64) -> usize {
    (0..4).find(|&d| sigma_deg * 10f64.powi(d) >= 10.0).unwrap_or(4) as usize
}

fn text(
    readings: &Readings<f64>,
    quality: &Quality<f64>,
    attitude: &Euler<f64>,
    heading_is_given: bool,
    samples: usize,
    missing: u64,
) -> String {
    let show = |angle: f64, sigma: f64| fixed(angle / DEGREE, decimals(sigma / DEGREE)) + "°";
    let level = |angle| show(angle, quality.level_sigma);
    let lost = if missing > 0 { format!(", {missing} missing") } else { String::new() };
    let mut yaw = attitude.yaw.rem_euclid(360.0 * DEGREE);
    let heading_sigma = if heading_is_given { 0.0 } else { quality.heading_sigma };
    // What rounds to 360° is 0°.
    if show(yaw, heading_sigma) == show(360.0 * DEGREE, heading_sigma) {
        yaw = 0.0;
    }
    let heading = if heading_is_given {
        format!(
            "heading {} as given (1σ of level {})",
            show(yaw, 0.0),
            degrees(quality.level_sigma)
        )
    } else {
        let sigmas = [quality.level_sigma, quality.heading_sigma].map(degrees);
        format!(
            "heading {} (1σ: level {}, heading {})",
            show(yaw, heading_sigma),
            sigmas[0],
            sigmas[1]
        )
    };
    format!(
        "aligned on {samples} samples{lost}: roll {}, pitch {}, {heading}\n\
         mean rate {:.3} °/h, mean specific force {:.6} m/s²\n",
        level(attitude.roll),
        level(attitude.pitch),
        readings.rate_ib_b.norm() / DEGREE_PER_HOUR,
        readings.specific_force_b.norm()
    )
}
