//! The columns of a file of measurements, `gnss.csv`, and its writer.

use crate::input::{InputError, Range};
use crate::output::OutputFile;
use crate::units::DEGREE;
use schuler::aiding::aided::measured::{Kind, Measured};
use schuler::math::compensated::Pair;
use std::ops::Range as Columns;
use std::path::Path;

/// Their names. A cell is empty where its row has no such number.
pub const COLUMNS: [&str; 17] = [
    "time_s",
    "arrives_s",
    "measures",
    "latitude_deg",
    "longitude_deg",
    "altitude_m",
    "north_m_s",
    "east_m_s",
    "down_m_s",
    "forward_m_s",
    "north_m_sigma",
    "east_m_sigma",
    "down_m_sigma",
    "north_m_s_sigma",
    "east_m_s_sigma",
    "down_m_s_sigma",
    "body_m_s_sigma",
];

/// The column of words.
pub const MEASURES: usize = 2;

/// The columns of positions.
pub const POSITION: Columns<usize> = 3..6;
/// Those of their standard deviations.
pub const POSITION_SIGMAS: Columns<usize> = 10..13;
/// The columns of velocities.
pub const VELOCITY: Columns<usize> = 6..9;
/// Those of their standard deviations.
pub const VELOCITY_SIGMAS: Columns<usize> = 13..16;

/// What each number may be.
pub const RANGES: [Range; COLUMNS.len()] = {
    let angle = Range::from_to(-360.0, 360.0, "degrees, from -360 to 360");
    let latitude = Range::from_to(-90.0, 90.0, "degrees, from -90 to 90");
    let altitude = Range::from_to(-1e6, 1e6, "metres, from -1e6 to 1e6");
    let speed = Range::from_to(-1e5, 1e5, "m/s, from -1e5 to 1e5");
    let metres = Range::above(0.0, 1e6, "metres above 0, up to 1e6");
    let speeds = Range::above(0.0, 1e6, "m/s above 0, up to 1e6");
    let (time, none) = (Range::FINITE, Range::FINITE);
    [
        time, time, none, latitude, angle, altitude, speed, speed, speed, speed, metres, metres,
        metres, speeds, speeds, speeds, speeds,
    ]
};

/// What the column of words may say, and the columns of numbers that belong to it.
pub const KINDS: [(&str, Kind, &[usize]); 7] = [
    ("position", Kind::Position, &[3, 4, 5, 10, 11, 12]),
    ("velocity", Kind::Velocity, &[6, 7, 8, 13, 14, 15]),
    ("position-velocity", Kind::PositionVelocity, &[3, 4, 5, 6, 7, 8, 10, 11, 12, 13, 14, 15]),
    ("height", Kind::Height, &[5, 12]),
    ("speed", Kind::Speed, &[9, 16]),
    ("zero-velocity", Kind::ZeroVelocity, &[16]),
    ("non-holonomic", Kind::NonHolonomic, &[16]),
];

/// The numbers of a measurement that is true at a time and arrives at another, s; of those that its kind does not have,
/// none counts.
pub fn numbers(time_s: f64, arrives_s: f64, measured: &Measured<f64>) -> [f64; COLUMNS.len()] {
    let whole = |pair: Pair<f64>| pair.hi + pair.lo;
    let position = measured.position.map(whole);
    let [north, east, down] = measured.velocity.into_array();
    let [n, e, d] = measured.position_sigma.into_array();
    let [vn, ve, vd] = measured.velocity_sigma.into_array();
    let along = if measured.kind == Kind::Speed { vn } else { vd };
    [
        time_s,
        arrives_s,
        0.0,
        position.latitude / DEGREE,
        position.longitude / DEGREE,
        position.altitude,
        north,
        east,
        down,
        north,
        n,
        e,
        d,
        vn,
        ve,
        vd,
        along,
    ]
}

/// Writes measurements, each with the digits that bring back its bits.
#[derive(Debug)]
pub struct MeasurementWriter {
    file: OutputFile,
}

impl MeasurementWriter {
    /// With its header.
    pub fn create(path: impl AsRef<Path>) -> Result<Self, InputError> {
        let mut file = OutputFile::create(path)?;
        file.put(COLUMNS.join(",") + "\n")?;
        Ok(Self { file })
    }

    /// A measurement that is true at a time and arrives at another, s.
    pub fn row(
        &mut self,
        time_s: f64,
        arrives_s: f64,
        measured: &Measured<f64>,
    ) -> Result<(), InputError> {
        let numbers = numbers(time_s, arrives_s, measured);
        let known = KINDS.iter().find(|(_, kind, _)| *kind == measured.kind);
        let Some((word, _, has)) = known else { return Ok(()) };
        let mut buffer = zmij::Buffer::new();
        let mut line = String::new();
        for (i, number) in numbers.into_iter().enumerate() {
            if i > 0 {
                line.push(',');
            }
            if i == MEASURES {
                line += word;
            } else if i < MEASURES || has.contains(&i) {
                line += buffer.format(number);
            }
        }
        self.file.put(line + "\n")
    }

    /// The file, whole, but not in its place yet.
    pub fn into_file(self) -> OutputFile {
        self.file
    }
}
