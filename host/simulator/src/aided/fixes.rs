//! Measurements for a recording: from our own CSV, or from positions that a receiver wrote (RTKLIB `.pos`, NMEA and
//! the like), on the recording's own time.

use super::told::{self, Assumed, Told};
use crate::input::{Complaint, InputError, read_text};
use crate::recording::instant::Scale;
use crate::reference::{Fix, Track};
use schuler::aiding::aided::instant::Instant;
use schuler::aiding::aided::measured::{Kind, Measured};
use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;

/// What a recording's time is: what it is counted from, and where that is on its own count, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Epoch {
    /// The scale.
    pub scale: Scale,
    /// A time of the scale less the same time of the recording, s.
    pub ahead_s: f64,
}

/// How late what a file tells is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Late {
    /// Its stamps, s.
    pub stamps_s: f64,
    /// The velocities beside them.
    pub velocities: Velocities,
}

/// What becomes of velocities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Velocities {
    /// They were true so long before their stamps, s: a receiver may tell the mean since its last fix.
    Late(f64),
    /// They are no measurements.
    Unused,
}

/// The measurements of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Fixes {
    /// The file.
    pub name: String,
    /// In its order; at least one.
    pub rows: Vec<Told>,
    /// What was found, a line each.
    pub said: Vec<String>,
}

impl Fixes {
    /// From a file. Times that are counted from an epoch become those of the recording.
    pub fn read(
        file: &str,
        epoch: Option<Epoch>,
        late: Late,
        assumed: &Assumed,
    ) -> Result<Self, InputError> {
        let text = read_text(file)?;
        let (rows, said) = if Track::is_one(&text) {
            of_track(Track::parse(file, &text)?, epoch, assumed)?
        } else if told::is_one(&text) {
            told::read(file, &text, assumed)?
        } else {
            let what = "is no file of measurements";
            let accepted = "a CSV with the columns of emulate --gnss (time_s, latitude_deg, …), an RTKLIB .pos, NMEA, GPX or KML";
            return Err(InputError::file(file, Complaint::new(what, accepted)));
        };
        let rows = rows.into_iter().flat_map(|row| in_time(row, late).into_iter().flatten());
        let rows: Vec<_> = rows.collect();
        if rows.is_empty() {
            let complaint = Complaint::new("has no measurement", "one or more");
            return Err(InputError::file(file, complaint));
        }
        Ok(Self { name: file.to_owned(), rows, said })
    }

    /// An error about one of its lines.
    pub fn error(&self, line: u64, complaint: Complaint) -> InputError {
        InputError::line(&self.name, line, complaint)
    }

    /// Those that have positions, in the order of their times.
    pub fn positions(&self) -> Vec<&Told> {
        let mut fixes: Vec<_> = self.rows.iter().filter(|row| row.has_position()).collect();
        fixes.sort_by(|a, b| a.time_s.total_cmp(&b.time_s));
        fixes
    }
}

/// What a row tells at the times when it was true.
fn in_time(row: Told, Late { stamps_s, velocities }: Late) -> [Option<Told>; 2] {
    let row = Told { time_s: row.time_s - stamps_s, arrives_s: row.arrives_s - stamps_s, ..row };
    let Measured { at, position, position_sigma, velocity, velocity_sigma, kind } = row.measured;
    let alone = Measured::position(at, position, position_sigma);
    let place = Told { measured: alone, course: row.north_east(), ..row };
    match (kind, velocities) {
        (Kind::PositionVelocity, Velocities::Late(late_s)) if late_s != 0.0 => {
            let measured = Measured::velocity(at, velocity, velocity_sigma);
            let moves = Told { measured, time_s: row.time_s - late_s, ..row };
            let arrives_s = moves.arrives_s.max(moves.time_s);
            [Some(Told { course: None, ..place }), Some(Told { arrives_s, ..moves })]
        }
        (Kind::Velocity, Velocities::Late(late_s)) => {
            let time_s = row.time_s - late_s;
            [Some(Told { time_s, arrives_s: row.arrives_s.max(time_s), ..row }), None]
        }
        (Kind::PositionVelocity, Velocities::Unused) => [Some(place), None],
        (Kind::Velocity, Velocities::Unused) => [None, None],
        _ => [Some(row), None],
    }
}

fn of_track(
    track: Track,
    epoch: Option<Epoch>,
    assumed: &Assumed,
) -> Result<(Vec<Told>, Vec<String>), InputError> {
    let (scale, ahead_s) = epoch.map_or((Scale::Utc, 0.0), |epoch| (epoch.scale, epoch.ahead_s));
    let track = track.on(scale);
    let mut said = track.said.clone();
    let (mut without, mut level) = (0u64, 0u64);
    let mut rows = Vec::new();
    for (i, fix) in track.fixes.iter().enumerate() {
        let (Some(time_s), Some(_)) = (fix.time_s, fix.height) else {
            if let Some((line, complaint)) = track.damaged_about(i) {
                return Err(InputError::line(&track.name, *line, complaint.clone()));
            }
            let complaint = Complaint::new("has no time or no height", "both in every place");
            return Err(InputError::line(&track.name, fix.line, complaint));
        };
        without += u64::from(fix.position_sigma_ned.is_none());
        level += u64::from(fix.north_east.is_some() && fix.down.is_none());
        let time_s = time_s - ahead_s;
        let measured = measured(&track.name, fix, assumed)?;
        let (line, course) = (fix.line, fix.north_east);
        rows.push(Told { line, time_s, arrives_s: time_s, measured, course });
    }
    if without > 0 {
        said.push(format!(
            "{}: no standard deviations in {without} places: positions taken as good to {} m level and {} m in \
             height, velocities to {} m/s (--gnss-sigma)",
            track.name, assumed.level_m, assumed.down_m, assumed.velocity_m_s
        ));
    }
    if level > 0 {
        said.push(format!(
            "{}: velocities that are level alone, {level}: not taken as measurements",
            track.name
        ));
    }
    Ok((rows, said))
}

/// A position, with a velocity if the fix has a whole one.
fn measured(file: &str, fix: &Fix, assumed: &Assumed) -> Result<Measured<f64>, InputError> {
    let at = Instant::of_sample(0);
    let altitude = fix.height.unwrap_or_default();
    let place =
        Geodetic { latitude: fix.latitude, longitude: fix.longitude, altitude }.map(Pair::new);
    let Assumed { level_m, down_m, velocity_m_s } = *assumed;
    let sigma = fix.position_sigma_ned.unwrap_or(Vector::new(level_m, level_m, down_m));
    let all = Vector::new(velocity_m_s, velocity_m_s, velocity_m_s);
    let velocity_sigma = fix.velocity_sigma_ned.unwrap_or(all);
    let above = |sigma: Vector<f64>, key: &str, unit: &str| {
        let wrong = sigma.into_array().into_iter().find(|x| !(*x > 0.0 && *x <= 1e6));
        wrong.map_or(Ok(()), |x| {
            let complaint = Complaint::new(
                format!("{x} is out of range"),
                format!("{unit} above 0, up to 1e6"),
            );
            Err(InputError::key(file, fix.line, key, complaint))
        })
    };
    above(sigma, "sdn, sde, sdu", "metres")?;
    if altitude.abs() > 1e6 {
        let complaint =
            Complaint::new(format!("{altitude} is out of range"), "metres, from -1e6 to 1e6");
        return Err(InputError::key(file, fix.line, "height", complaint));
    }
    let (Some([north, east]), Some(down)) = (fix.north_east, fix.down) else {
        return Ok(Measured::position(at, place, sigma));
    };
    above(velocity_sigma, "sdvn, sdve, sdvu", "m/s")?;
    let velocity = Vector::new(north, east, down);
    if !velocity.is_within(1e5) {
        let complaint = Complaint::new("is out of range", "m/s, from -1e5 to 1e5");
        return Err(InputError::key(file, fix.line, "vn, ve, vu", complaint));
    }
    Ok(Measured::position_velocity(at, place, sigma, velocity, velocity_sigma))
}
