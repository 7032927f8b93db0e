//! Times that are more than a unit's own count: dates, weeks, and the scale that they are of.

use crate::input::Complaint;
use time::format_description::well_known::Iso8601;
use time::{OffsetDateTime, PrimitiveDateTime};

/// Seconds in a GPS week.
pub const WEEK_S: f64 = 604_800.0;
/// Weeks after which a counter of ten bits starts over.
pub const WEEKS: u64 = 1024;
/// 1980-01-06, where GPS time begins, in seconds since 1970.
pub const GPS_EPOCH_S: i64 = 315_964_800;

/// Leap seconds since GPS time began: from this time on (seconds since 1970, UTC) GPS time is so much ahead.
const LEAPS: [(i64, i64); 18] = [
    (362_793_600, 1),
    (394_329_600, 2),
    (425_865_600, 3),
    (489_024_000, 4),
    (567_993_600, 5),
    (631_152_000, 6),
    (662_688_000, 7),
    (709_948_800, 8),
    (741_484_800, 9),
    (773_020_800, 10),
    (820_454_400, 11),
    (867_715_200, 12),
    (915_148_800, 13),
    (1_136_073_600, 14),
    (1_230_768_000, 15),
    (1_341_100_800, 16),
    (1_435_708_800, 17),
    (1_483_228_800, 18),
];

/// What seconds are counted from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// 1970-01-01 in UTC, leap seconds not counted.
    Utc,
    /// 1980-01-06 in GPS time.
    Gps,
}

impl Scale {
    /// What maps call them.
    pub const NAMES: &'static [(&'static str, Self)] = &[("utc", Self::Utc), ("gps", Self::Gps)];

    /// The same instant on another scale, s.
    pub fn to(self, other: Self, time_s: f64) -> f64 {
        match (self, other) {
            (Self::Utc, Self::Gps) => time_s - GPS_EPOCH_S as f64 + leaps(time_s) as f64,
            (Self::Gps, Self::Utc) => {
                let without = time_s + GPS_EPOCH_S as f64;
                // The number of leap seconds is that of the result.
                let first = without - leaps(without) as f64;
                without - leaps(first) as f64
            }
            _ => time_s,
        }
    }
}

/// Leap seconds at a time of UTC, s.
fn leaps(utc_s: f64) -> i64 {
    LEAPS.iter().rev().find(|(from, _)| utc_s >= *from as f64).map_or(0, |(_, leaps)| *leaps)
}

/// Seconds of a date and time as ISO 8601 writes them, counted from 1970 without leap seconds; a space may
/// stand for the T, slashes for hyphens. Without an offset it is that of the scale itself.
pub fn date(text: &str) -> Result<f64, Complaint> {
    let wrong = || {
        let accepted = "a date and time, as in 2026-01-31T12:00:00.250Z";
        Complaint::new(format!("\"{text}\" is no time"), accepted)
    };
    let plain = text.trim().replace('/', "-").replacen(' ', "T", 1);
    let at = OffsetDateTime::parse(&plain, &Iso8601::DEFAULT)
        .or_else(|_| PrimitiveDateTime::parse(&plain, &Iso8601::DEFAULT).map(|at| at.assume_utc()))
        .map_err(|_| wrong())?;
    Ok(at.unix_timestamp() as f64 + f64::from(at.nanosecond()) * 1e-9)
}

/// Seconds of GPS time from a week and the seconds in it; a week of ten bits came round so often.
pub fn week(week: f64, seconds: f64, rollovers: u64) -> f64 {
    (week + (rollovers * WEEKS) as f64) * WEEK_S + seconds
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn utc_and_gps_differ_by_the_leap_seconds() {
        for (utc, gps_s) in [
            ("1980-01-06T00:00:00Z", 0.0),
            // GPS week 2329, 2024-08-25, began 18 leap seconds early by UTC.
            ("2024-08-24T23:59:42Z", 2329.0 * WEEK_S),
            ("2016-12-31T23:59:59Z", 1_167_264_016.0),
            ("2017-01-01T00:00:00Z", 1_167_264_018.0),
        ] {
            let utc_s = date(utc).expect(utc);
            assert_eq!(Scale::Utc.to(Scale::Gps, utc_s), gps_s, "{utc}");
            assert_eq!(Scale::Gps.to(Scale::Utc, gps_s), utc_s, "{utc}");
        }
    }

    #[test]
    fn dates_are_read_in_the_forms_that_logs_have() {
        for text in [
            "2025-08-28T17:30:40.250Z",
            "2025-08-28 17:30:40.25",
            "2025/08/28 17:30:40.250",
            "2025-08-28T19:30:40.250+02:00",
            "20250828T173040.25Z",
        ] {
            assert_eq!(date(text), Ok(1_756_402_240.25), "{text}");
        }
        assert!(date("17:30").is_err());
    }
}
