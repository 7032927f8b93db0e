//! `nav.csv`, `truth.csv` and `initial.toml`: a time, a position, a velocity and an attitude, in degrees.

use crate::input::document::Document;
use crate::input::{InputError, Range, read_text};
use crate::output::{NumberTable, OutputFile};
use crate::units::DEGREE;
use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::math::real::Scalar;
use schuler::math::vector::Vector;
use schuler::solution::{Euler, Solution};
use std::path::Path;

/// Columns of `nav.csv`, keys of `initial.toml`.
pub const COLUMNS: [&str; 10] = [
    "time_s",
    "latitude_deg",
    "longitude_deg",
    "altitude_m",
    "north_m_s",
    "east_m_s",
    "down_m_s",
    "roll_deg",
    "pitch_deg",
    "yaw_deg",
];

/// What each of them may be.
pub const RANGES: [Range; 10] = {
    let angle = Range::from_to(-360.0, 360.0, "degrees, from -360 to 360");
    let speed = Range::from_to(-1e5, 1e5, "m/s, from -1e5 to 1e5");
    // As far down as up: navigation goes on, and so does what it has printed.
    let altitude = Range::from_to(-1e6, 1e6, "metres, from -1e6 to 1e6");
    let latitude = Range::from_to(-90.0, 90.0, "degrees, from -90 to 90");
    [Range::FINITE, latitude, angle, altitude, speed, speed, speed, angle, angle, angle]
};

/// Nearer to ±90°, a pitch leaves roll and yaw without their last digits: its cosine.
const LEAST_COSINE: f64 = 1e-6;

/// What a row of `nav.csv` says, in SI units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NavigationRow {
    /// s.
    pub time_s: f64,
    /// Latitude and longitude in rad, altitude in m.
    pub position: Geodetic<f64>,
    /// Velocity relative to the Earth, m/s.
    pub velocity_ned: Vector<f64>,
    /// Roll, pitch, yaw, rad.
    pub attitude: Euler<f64>,
}

impl NavigationRow {
    /// A solution at a time, as it stands (a navigator folds its angles itself).
    pub fn new<R: Scalar>(time_s: f64, solution: &Solution<R>) -> Self {
        let whole = |pair: Pair<R>| pair.hi.widen() + pair.lo.widen();
        let Euler { roll, pitch, yaw } = Euler::from_quaternion(solution.attitude.map(whole));
        Self {
            time_s,
            position: solution.position.map(whole),
            velocity_ned: solution.velocity_ned.map(whole),
            attitude: Euler { roll, pitch, yaw },
        }
    }

    /// The same of a start, whose attitude has about twice the digits: the angles to the last digit of each.
    pub fn start(time_s: f64, solution: &Solution<f64>) -> Self {
        let mut row = Self::new(time_s, solution);
        let Euler { roll, pitch, yaw } = row.attitude;
        let ((sine, cosine), (s, c)) = (roll.sin_cos(), pitch.sin_cos());
        // Where the pitch is ±90°, roll and yaw are not told apart.
        if c.abs() > LEAST_COSINE {
            // What is left, a small rotation α in body axes: α = 2 q*⊗q′, and
            // δγ = α_x + (α_y sinγ + α_z cosγ) tanθ,  δθ = α_y cosγ − α_z sinγ,  δψ = (α_y sinγ + α_z cosγ)/cosθ
            let found = row.attitude.quaternion_pair();
            let rest = (found.conjugate() * solution.attitude).v.map(|part| 2.0 * part.hi);
            let across = rest.y * sine + rest.z * cosine;
            row.attitude = Euler {
                roll: roll + (rest.x + across * s / c),
                pitch: pitch + (rest.y * cosine - rest.z * sine),
                yaw: yaw + across / c,
            };
        }
        row
    }

    /// The solution that a navigator starts from.
    pub fn solution(&self) -> Solution<f64> {
        Solution::new(self.position, self.velocity_ned, self.attitude)
    }

    /// From an `initial.toml`: every key of [`COLUMNS`], each once.
    pub fn read(file: &str) -> Result<Self, InputError> {
        Self::parse(file, &read_text(file)?)
    }

    /// From the text of an `initial.toml`; `file` names it in errors.
    pub fn parse(file: &str, text: &str) -> Result<Self, InputError> {
        let document = Document::parse(file, text)?;
        let root = document.root(&COLUMNS)?;
        let mut numbers = [0.0; COLUMNS.len()];
        for (number, (key, range)) in numbers.iter_mut().zip(COLUMNS.iter().zip(&RANGES)) {
            *number = root.number(key, range)?;
        }
        Ok(Self::of_columns(&numbers))
    }

    /// From the numbers of a row, column by column.
    pub fn of_columns(numbers: &[f64; COLUMNS.len()]) -> Self {
        let [time_s, latitude, longitude, altitude, north, east, down, roll, pitch, yaw] = *numbers;
        Self {
            time_s,
            position: Geodetic {
                latitude: latitude * DEGREE,
                longitude: longitude * DEGREE,
                altitude,
            },
            velocity_ned: Vector::new(north, east, down),
            attitude: Euler { roll: roll * DEGREE, pitch: pitch * DEGREE, yaw: yaw * DEGREE },
        }
    }

    /// The text of an `initial.toml`, below a line about what it is.
    pub fn toml(&self, about: &str) -> String {
        let mut text = format!("# {}\n", about.replace(char::is_control, " "));
        for (key, value) in COLUMNS.iter().zip(self.columns()) {
            text += &format!("{key} = {}\n", zmij::Buffer::new().format(value));
        }
        text
    }

    /// The numbers of a row, column by column.
    pub fn columns(&self) -> [f64; COLUMNS.len()] {
        let Self { time_s, position, velocity_ned: v, attitude } = self;
        let degrees = |rad: f64| rad / DEGREE;
        [
            *time_s,
            degrees(position.latitude),
            degrees(position.longitude),
            position.altitude,
            v.x,
            v.y,
            v.z,
            degrees(attitude.roll),
            degrees(attitude.pitch),
            degrees(attitude.yaw),
        ]
    }
}

/// Writes a `nav.csv` or a `truth.csv`.
#[derive(Debug)]
pub struct NavigationWriter {
    table: NumberTable,
}

impl NavigationWriter {
    /// With its header.
    pub fn create(path: impl AsRef<Path>) -> Result<Self, InputError> {
        Ok(Self { table: NumberTable::create(path, &COLUMNS)? })
    }

    /// The next row.
    pub fn row(&mut self, row: &NavigationRow) -> Result<(), InputError> {
        self.table.row(&row.columns())
    }

    /// The file, whole, but not in its place yet.
    pub fn into_file(self) -> OutputFile {
        self.table.into_file()
    }

    /// Puts the file in its place.
    pub fn finish(self) -> Result<(), InputError> {
        self.table.finish()
    }
}
