//! NMEA 0183: positions and heights of GGA, velocities and dates of RMC. Sentences of one time are one place.

use super::{Fix, Track, place};
use crate::input::{Complaint, InputError};
use crate::recording::instant::{self, Scale};
use ::nmea::sentences::FixType;
use ::nmea::sentences::rmc::RmcStatusOfFix;
use ::nmea::{Error, ParseResult, parse_str};

/// 1 knot, m/s.
const KNOT: f64 = 1852.0 / 3600.0;
const DAY_S: f64 = 86_400.0;
/// Characters that say what a sentence is, `$GPGGA`.
const SHORTEST: usize = 6;

/// Whether a line among the first is a sentence.
pub fn is_one(text: &str) -> bool {
    text.lines().take(100).filter_map(sentence).any(|s| s.contains("GGA,") || s.contains("RMC,"))
}

/// A line's sentence, which may stand behind something else.
fn sentence(line: &str) -> Option<&str> {
    line.find('$').map(|at| line[at..].trim())
}

/// What a sentence adds.
enum Part {
    Height(Option<f64>),
    Velocity(Option<[f64; 2]>),
}

/// All sentences.
pub fn read(file: &str, text: &str) -> Result<Track, InputError> {
    let mut fixes: Vec<Fix> = Vec::new();
    let mut damaged = Vec::new();
    let mut without = 0u64;
    let (mut days, mut before_s) = (0.0, 0.0);
    // Midnight of the first day, s since 1970.
    let mut midnight_s = None;
    for (line, text) in (1..).zip(text.lines()) {
        let Some(sentence) = sentence(text) else { continue };
        let relevant = sentence.get(3..6).is_some_and(|kind| kind == "GGA" || kind == "RMC");
        if sentence.len() < SHORTEST && sentence[1..].bytes().all(|b| b.is_ascii_uppercase()) {
            damaged.push((line, cut(sentence)));
        }
        if !relevant {
            continue;
        }
        let (clock, at, date, part) = match parse_str(sentence) {
            Ok(ParseResult::GGA(gga)) if gga.fix_type != Some(FixType::Invalid) => {
                // Above the ellipsoid is above the geoid and that above the ellipsoid.
                let height = match (gga.altitude, gga.geoid_separation) {
                    (Some(altitude), Some(separation)) => {
                        Some(decimal(altitude) + decimal(separation))
                    }
                    _ => None,
                };
                (gga.fix_time, (gga.latitude, gga.longitude), None, Part::Height(height))
            }
            Ok(ParseResult::RMC(rmc)) if rmc.status_of_fix != RmcStatusOfFix::Invalid => {
                let velocity = rmc.speed_over_ground.map(|knots| {
                    // Standing still it has no course.
                    let (sine, cosine) =
                        rmc.true_course.map_or((0.0, 0.0), |c| decimal(c).to_radians().sin_cos());
                    [cosine, sine].map(|part| part * decimal(knots) * KNOT)
                });
                let moves = rmc.true_course.is_some() || rmc.speed_over_ground == Some(0.0);
                let velocity = velocity.filter(|_| moves);
                (rmc.fix_time, (rmc.lat, rmc.lon), rmc.fix_date, Part::Velocity(velocity))
            }
            Ok(_) => {
                without += 1;
                continue;
            }
            Err(error) => {
                damaged.push((line, complaint(&error, sentence)));
                continue;
            }
        };
        let (Some(clock), (Some(latitude), Some(longitude))) = (clock, at) else {
            without += 1;
            continue;
        };
        let of_day_s = seconds(&clock.to_string());
        if of_day_s < before_s - 0.5 * DAY_S {
            days += 1.0;
        }
        before_s = of_day_s;
        if let (None, Some(date)) = (midnight_s, date) {
            midnight_s = instant::date(&format!("{date} 00:00:00")).ok().map(|s| s - days * DAY_S);
        }
        let time_s = Some(of_day_s + days * DAY_S);
        let fix = match fixes.last_mut() {
            Some(last) if last.time_s == time_s => last,
            _ => {
                fixes.push(Fix { time_s, ..place(file, line, latitude, longitude)? });
                let last = fixes.len() - 1;
                &mut fixes[last]
            }
        };
        match part {
            Part::Height(height) => fix.height = height,
            Part::Velocity(velocity) => fix.north_east = velocity,
        }
    }
    let mut said = Vec::new();
    if let Some((first, complaint)) = damaged.first() {
        let (what, count) = (&complaint.what, damaged.len());
        said.push(format!("{file}:{first}: {what}; sentences that are damaged, left out: {count}"));
    }
    if without > 0 {
        said.push(format!("{file}: sentences without a position, left out: {without}"));
    }
    match midnight_s {
        Some(midnight_s) => {
            for fix in &mut fixes {
                fix.time_s = fix.time_s.map(|time_s| midnight_s + time_s);
            }
        }
        None => said.push(format!("{file}: no RMC tells the date, so times are those of the day")),
    }
    let scale = midnight_s.map(|_| Scale::Utc);
    Ok(Track { scale, fixes, said, damaged, ..Track::default() })
}

/// Why a sentence cannot be read.
fn complaint(error: &Error<'_>, sentence: &str) -> Complaint {
    match error {
        Error::ChecksumMismatch { calculated, found } => {
            let what =
                format!("the checksum is {found:02X}, that of what stands here {calculated:02X}");
            Complaint::new(what, "sentences as the receiver wrote them")
        }
        // The checksum is the end.
        _ if !sentence.contains('*') => cut(sentence),
        _ => Complaint::new("the sentence cannot be read", "GGA and RMC of NMEA 0183"),
    }
}

fn cut(sentence: &str) -> Complaint {
    let what = format!("the sentence is cut: it ends in \"{}\"", tail(sentence));
    Complaint::new(what, "sentences with their checksum, as in *5C")
}

/// The last characters of a sentence, or all of it.
fn tail(sentence: &str) -> String {
    let most = sentence.chars().count().saturating_sub(12);
    sentence.chars().skip(most).collect()
}

/// The decimal number that was read, which single precision stands for.
fn decimal(value: f32) -> f64 {
    value.to_string().parse().unwrap_or(f64::from(value))
}

/// Seconds of the day from hours, minutes and seconds with colons between.
fn seconds(clock: &str) -> f64 {
    clock.split(':').fold(0.0, |sum, part| 60.0 * sum + part.parse().unwrap_or(0.0))
}
