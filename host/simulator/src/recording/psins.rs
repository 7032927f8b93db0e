//! The PSINS toolbox's text format `.imu`: three lines of settings, then counts of Δθ and Δv.
//!
//! Lines that start with `%` are comments. The settings are
//! 1. pitch, roll, yaw (degrees, yaw positive to the west), velocity east, north, up (m/s);
//! 2. latitude, longitude (degrees), height (m), start (s), sample interval (ms), g (m/s²);
//! 3. per count: arcsec of the three gyros, µg·s of the three accelerometers, µg of the file's own g.
//!
//! Axes are right, forward, up. The n-th sample ends n intervals after the start.

use super::Unread;
use super::lines::Lines;
use super::navigation::NavigationRow;
use crate::input::{Complaint, InputError, Range};
use crate::scene::limits::ALTITUDE_M;
use crate::units::{ARCSECOND, DEGREE};
use schuler::earth::Geodetic;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::solution::Euler;

type Columns = [(&'static str, Range); 6];

const ANGLE: Range = Range::from_to(-360.0, 360.0, "degrees, from -360 to 360");
const SPEED: Range = Range::from_to(-1e5, 1e5, "m/s, from -1e5 to 1e5");
const COUNTS: Range = Range { accepted: "counts", ..Range::FINITE };

const ATTITUDE_AND_VELOCITY: Columns = [
    ("pitch", ANGLE),
    ("roll", ANGLE),
    ("yaw", ANGLE),
    ("velocity_east", SPEED),
    ("velocity_north", SPEED),
    ("velocity_up", SPEED),
];
const POSITION_AND_TIME: Columns = [
    ("latitude", Range::from_to(-90.0, 90.0, "degrees, from -90 to 90")),
    ("longitude", ANGLE),
    ("height", ALTITUDE_M),
    ("start", Range { accepted: "seconds", ..Range::FINITE }),
    ("interval", Range::above(0.0, 1000.0, "milliseconds, above 0 and at most 1000")),
    ("g", Range::from_to(9.0, 10.0, "m/s², from 9 to 10")),
];
const SCALES: Columns = [
    ("gyro_right", Range::POSITIVE),
    ("gyro_forward", Range::POSITIVE),
    ("gyro_up", Range::POSITIVE),
    ("accelerometer_right", Range::POSITIVE),
    ("accelerometer_forward", Range::POSITIVE),
    ("accelerometer_up", Range::POSITIVE),
];
const SAMPLE: Columns = [
    ("dtheta_right", COUNTS),
    ("dtheta_forward", COUNTS),
    ("dtheta_up", COUNTS),
    ("dvel_right", COUNTS),
    ("dvel_forward", COUNTS),
    ("dvel_up", COUNTS),
];

/// What stands before the counts, as far as the counts need it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Settings {
    start_s: f64,
    interval_ms: f64,
    /// The sample interval, s.
    pub(super) interval_s: f64,
    /// rad per count, right, forward, up.
    angle: [f64; 3],
    /// µg·s per count.
    velocity: [f64; 3],
    /// m/s².
    micro_g: f64,
}

/// Whether a file looks like one from its first line: six numbers with blanks between in each line of settings, of
/// which at most one is out of range.
pub(super) fn is_one(lines: &mut Lines) -> Result<bool, InputError> {
    let (mut found, mut wrong) = (0, 0);
    for columns in [&ATTITUDE_AND_VELOCITY, &POSITION_AND_TIME, &SCALES] {
        let mut filled = lines.next_filled()?;
        while filled && lines.text().starts_with(b"%") {
            filled = lines.next_filled()?;
        }
        if !filled {
            break;
        }
        let Ok(line) = std::str::from_utf8(lines.text()) else { return Ok(false) };
        let fields: Vec<_> = line.split_ascii_whitespace().map(str::parse::<f64>).collect();
        if fields.len() != columns.len() || fields.iter().any(Result::is_err) {
            return Ok(false);
        }
        found += 1;
        let values = fields.into_iter().flatten().zip(columns);
        wrong += values.filter(|(value, (_, range))| range.check(*value).is_err()).count();
    }
    Ok(found > 0 && wrong <= 1)
}

/// The settings, and the state that they start from. The first line is at hand.
pub(super) fn settings(
    name: &str,
    lines: &mut Lines,
) -> Result<(Settings, NavigationRow), InputError> {
    let (mut filled, mut read) = (true, false);
    let mut next = |columns: &Columns| {
        while filled && (read || lines.text().starts_with(b"%")) {
            filled = lines.next_filled()?;
            read = false;
        }
        if !filled {
            let names = columns.each_ref().map(|(name, _)| *name).join(" ");
            return Err(InputError::file(name, Complaint::new("ends within its settings", names)));
        }
        read = true;
        numbers(name, lines.number, lines.text(), columns)
    };
    let [pitch, roll, yaw, east, north, up] = next(&ATTITUDE_AND_VELOCITY)?;
    let [latitude, longitude, altitude, start_s, interval_ms, g] = next(&POSITION_AND_TIME)?;
    let [gx, gy, gz, ax, ay, az] = next(&SCALES)?;

    let position =
        Geodetic { latitude: latitude * DEGREE, longitude: longitude * DEGREE, altitude };
    let attitude = Euler { roll: roll * DEGREE, pitch: pitch * DEGREE, yaw: -yaw * DEGREE };
    let velocity_ned = Vector::new(north, east, -up);
    let initial = NavigationRow { time_s: start_s, position, velocity_ned, attitude };
    let settings = Settings {
        start_s,
        interval_ms,
        interval_s: interval_ms / 1000.0,
        angle: [gx, gy, gz],
        velocity: [ax, ay, az],
        micro_g: 1e-6 * g,
    };
    Ok((settings, initial))
}

impl Settings {
    /// The n-th row, from 1.
    pub(super) fn row(
        &self,
        name: &str,
        line: u64,
        n: u64,
        text: &[u8],
        whole: bool,
    ) -> Result<(f64, Increment<f64>), Unread> {
        // One division, so that round times come out round.
        let time_s = self.start_s + n as f64 * self.interval_ms / 1000.0;
        if !whole {
            return Ok((time_s, Increment::ZERO));
        }
        let counts = numbers(name, line, text, &SAMPLE);
        let [tx, ty, tz, vx, vy, vz] =
            counts.map_err(|error| Unread { stamp: Some(time_s), error: Box::new(error) })?;
        let ([gx, gy, gz], [ax, ay, az]) = (self.angle, self.velocity);
        let increment = Increment {
            angle_b: forward_right_down([tx * gx, ty * gy, tz * gz]) * ARCSECOND,
            velocity_b: forward_right_down([vx * ax, vy * ay, vz * az]) * self.micro_g,
        };
        Ok((time_s, increment))
    }
}

fn forward_right_down([right, forward, up]: [f64; 3]) -> Vector<f64> {
    Vector::new(forward, right, -up)
}

fn numbers(
    file: &str,
    number: u64,
    line: &[u8],
    columns: &Columns,
) -> Result<[f64; 6], InputError> {
    let line = std::str::from_utf8(line)
        .map_err(|_| InputError::line(file, number, Complaint::new("is not text", "UTF-8")))?;
    let mut values = [0.0; 6];
    let mut fields = line.split_ascii_whitespace();
    for (value, (name, range)) in values.iter_mut().zip(columns) {
        let Some(field) = fields.next() else {
            let found = line.split_ascii_whitespace().count();
            let names = columns.each_ref().map(|(name, _)| *name).join(" ");
            let complaint =
                Complaint::new(format!("the row has {found} values"), format!("6: {names}"));
            return Err(InputError::line(file, number, complaint));
        };
        let parsed = field
            .parse()
            .map_err(|_| Complaint::new(format!("\"{field}\" is not a number"), range.accepted));
        *value = parsed
            .and_then(|x| range.check(x))
            .map_err(|complaint| InputError::key(file, number, name, complaint))?;
    }
    match fields.count() {
        0 => Ok(values),
        more => {
            let complaint = Complaint::new(format!("the row has {} values", 6 + more), "6");
            Err(InputError::line(file, number, complaint))
        }
    }
}
