//! `[trajectory.log]`: a path from a file of positions.

use super::path::{Lie, MOST_ROWS, Made, along, lie, made, unflyable};
use super::points::{near_origin, radians, swapped};
use super::through::pieces;
use super::{positions, thinned};
use crate::course::Path;
use crate::input::document::{Section, Value};
use crate::input::{Complaint, InputError, Range, read_text};
use crate::number;
use crate::quartile::quartile;
use crate::recording::table::{self, Column, Table};
use crate::reference::Track;
use crate::scene::keys::{motion, path as keys};
use crate::scene::limits::ALTITUDE_M;
use crate::scene::route::Origin;
use crate::units::DEGREE;
use schuler::earth::Geodetic;
use schuler::solution::Euler;
use schuler::trajectory::log::{Log, LogError, Noise, Outcome, Part, rows};
use schuler::trajectory::piecewise::{Attitude, Piecewise};
use schuler::trajectory::segment::attitude::AttitudeRule;
use schuler::trajectory::spline::place::Pace;
use std::sync::Arc;

const COLUMNS: [Column; 7] = [
    Column { name: "time_s", range: Range::FINITE },
    Column { name: "latitude_deg", range: keys::LATITUDE_RANGE },
    Column { name: "longitude_deg", range: keys::TURN_RANGE },
    Column { name: "altitude_m", range: ALTITUDE_M },
    Column { name: "roll_deg", range: keys::TURN_RANGE },
    Column { name: "pitch_deg", range: keys::TURN_RANGE },
    Column { name: "yaw_deg", range: keys::TURN_RANGE },
];
/// The first columns, which must be there.
const NEEDED: usize = 4;
/// A gap that is accepted, in median steps.
const GAP: f64 = 10.0;

/// A log as it was read.
struct Rows {
    file: String,
    table: Table,
    /// From its first row on, s.
    times_s: Vec<f64>,
    places: Vec<Geodetic<f64>>,
}

impl Rows {
    fn error(&self, row: usize, column: &str, complaint: Complaint) -> InputError {
        let line = self.table.lines.get(row).copied().unwrap_or(1);
        InputError::key(&self.file, line, column, complaint)
    }

    fn has_angles(&self) -> bool {
        self.table.is_there.iter().skip(NEEDED).all(|is_there| *is_there)
    }

    /// A number of a row.
    fn number(&self, row: &[f64], column: usize) -> f64 {
        row.get(column).copied().unwrap_or_default()
    }

    fn angles(&self) -> Vec<Euler<f64>> {
        let of = |row: &Vec<f64>| {
            let [roll, pitch, yaw] = [4, 5, 6].map(|column| self.number(row, column) * DEGREE);
            Euler { roll, pitch, yaw }
        };
        self.table.rows.iter().map(of).collect()
    }
}

/// The path of a log, whose file lies beside the scene's.
pub fn read(root: &Section<'_>, scene: &str) -> Result<Made, InputError> {
    let value = root.require(motion::RECORD.name, "a table")?;
    let section = value.section(&keys::LOG.names())?;
    let log = rows(&section, scene)?;
    if let Some(complaint) = radians(&log.places, DEGREE)
        && !near_origin(&section, &keys::LOG_NEAR_ORIGIN)?
    {
        return Err(log.error(0, "latitude_deg", complaint));
    }
    let (attitude, lie) = match lie(root)? {
        Some((_, Lie::Log)) | None if log.has_angles() => ("log", Lie::Log),
        Some((_, Lie::Log)) => {
            let what = format!("\"log\" asks for angles, and {} has none", log.file);
            let accepted = "\"coordinated\", \"upright\", \"level\"";
            return Err(root.blame(motion::ATTITUDE.name, Complaint::new(what, accepted)));
        }
        None => ("coordinated", Lie::Rule(AttitudeRule::Coordinated)),
        Some(said) => said,
    };
    let noise = noise(&section)?;
    let max_gap_s = section.read(&keys::GAP)?.unwrap_or_else(|| {
        let steps = log.times_s.windows(2).map(|two| two[1] - two[0]);
        GAP * quartile(&steps.collect::<Vec<_>>(), 2)
    });

    let count = log.places.len();
    let mut positions = vec![[0.0; 4]; count];
    let blame = |error| blame(error, &log, &section);
    rows::positions(&log.places, &mut positions).map_err(blame)?;
    let mut attitudes = vec![[0.0; 4]; if lie == Lie::Log { count } else { 0 }];
    if lie == Lie::Log {
        rows::attitudes(&log.places, &log.angles(), &mut attitudes).map_err(blame)?;
    }
    let rows = Log {
        times_s: &log.times_s,
        positions: &positions,
        attitudes: (lie == Lie::Log).then_some(attitudes.as_slice()),
        noise,
        max_gap_s,
    };
    let (pieces, outcome) = match thinned::pieces_of(&rows) {
        Some(pieces) => (pieces, Outcome::default()),
        None => pieces(&rows).map_err(blame)?,
    };
    if let Some(row) = pieces.iter().position(|piece| Pace::largest(piece).is_too_large()) {
        let Pace { speed_m_s, acceleration_m_s2 } = Pace::largest(&pieces[row]);
        let (speed, pull) = (number::short(speed_m_s), number::short(acceleration_m_s2));
        let what = format!("jumps: takes {speed} m/s and {pull} m/s² there");
        let accepted = "at most 1e5 m/s and 1e5 m/s²; noise_m smooths";
        return Err(log.error(row + 1, "latitude_deg", Complaint::new(what, accepted)));
    }
    let along = match lie {
        Lie::Log => Attitude::Stored,
        Lie::Rule(rule) => along(rule),
    };
    let path =
        Piecewise::new(pieces, along).map_err(|error| value.error(unflyable(error, attitude)))?;
    let origin = Origin::Log { file: log.file.clone(), rows: count, outcome };
    Ok(made(Path::Spline(Arc::new(path)), origin, attitude))
}

/// The rows of the file that a table names.
fn rows(section: &Section<'_>, scene: &str) -> Result<Rows, InputError> {
    let value = section.require(keys::FILE.name, keys::FILE.accepted())?;
    let name = value.text(keys::FILE.accepted())?;
    let folder = std::path::Path::new(scene).parent().unwrap_or(std::path::Path::new(""));
    let file = folder.join(name).to_string_lossy().into_owned();
    let text =
        read_text(&file).map_err(|error| value.error(Complaint::new(error.to_string(), "")))?;
    let table = if Track::is_one(&text) {
        positions::table(&Track::parse(&file, &text)?, COLUMNS.len())?
    } else {
        table::parse(&file, &text, &COLUMNS).map_err(swapped)?
    };
    let missing = COLUMNS.iter().zip(&table.is_there).take(NEEDED).find(|(_, there)| !**there);
    if let Some((column, _)) = missing {
        let names: Vec<_> = COLUMNS.iter().map(|column| column.name).collect();
        let accepted = format!("{}; the last three may be absent", names.join(", "));
        let complaint = Complaint::new("is missing", accepted);
        return Err(InputError::key(&file, 1, column.name, complaint));
    }
    if !(2..=MOST_ROWS).contains(&table.rows.len()) {
        let what = format!("has {} rows", table.rows.len());
        let complaint = Complaint::new(what, format!("from 2 to {MOST_ROWS} rows"));
        return Err(InputError::file(&file, complaint));
    }
    let mut log = Rows { file, table, times_s: Vec::new(), places: Vec::new() };
    let start_s = log.table.rows.first().map_or(0.0, |row| log.number(row, 0));
    log.times_s = log.table.rows.iter().map(|row| log.number(row, 0) - start_s).collect();
    let place = |row: &Vec<f64>| Geodetic {
        latitude: log.number(row, 1) * DEGREE,
        longitude: log.number(row, 2) * DEGREE,
        altitude: log.number(row, 3),
    };
    log.places = log.table.rows.iter().map(place).collect();
    Ok(log)
}

fn noise(section: &Section<'_>) -> Result<Noise, InputError> {
    let metres = Range::from_to(0.0, 1e5, "metres, from 0 to 1e5");
    let [horizontal_m, vertical_m] = match section.get(keys::NOISE.name) {
        None => [0.0; 2],
        Some(value) => two(&value, &metres)?,
    };
    let attitude = section.read(&keys::NOISE_ANGLE)?.unwrap_or(0.0) * DEGREE;
    Ok(Noise { horizontal_m, vertical_m, attitude })
}

/// One number for both, or a list of two.
fn two(value: &Value<'_>, range: &Range) -> Result<[f64; 2], InputError> {
    if !value.is_list() {
        return value.number(range).map(|number| [number; 2]);
    }
    let items = value.items(keys::NOISE.accepted())?;
    let [horizontal, vertical] = items.as_slice() else {
        let what = format!("has {} values", items.len());
        return Err(value.error(Complaint::new(what, keys::NOISE.accepted())));
    };
    Ok([horizontal.number(range)?, vertical.number(range)?])
}

/// An error at its row, or at the key that asks for too much.
fn blame(error: LogError, log: &Rows, section: &Section<'_>) -> InputError {
    let short = number::short;
    let key = |part| if part == Part::Attitude { keys::NOISE_ANGLE } else { keys::NOISE };
    match error {
        LogError::Gap { index, from_s, to_s, max_gap_s } => {
            let [from, to] = [from_s, to_s].map(number::parameter);
            let what = format!("comes after a gap from {from} s to {to} s of the flight");
            let accepted = format!("at most {} s, or a longer max_gap_s", short(max_gap_s));
            log.error(index, "time_s", Complaint::new(what, accepted))
        }
        LogError::TooFast { index, speed_m_s } => {
            let what = format!("jumps: takes {} m/s from the row before", short(speed_m_s));
            log.error(index, "latitude_deg", Complaint::new(what, "at most 1e5 m/s"))
        }
        LogError::NotFinite { index } => {
            log.error(index, "latitude_deg", Complaint::new("is not finite", "a finite number"))
        }
        LogError::NotIncreasing { index } => {
            let complaint = Complaint::new("does not come after the row before", "later times");
            log.error(index, "time_s", complaint)
        }
        LogError::TooStiff { part } | LogError::Undetermined { part } => section
            .blame(key(part).name, Complaint::new(error.to_string(), "a smaller noise, or 0")),
        other => section.error(Complaint::new(other.to_string(), "")),
    }
}
