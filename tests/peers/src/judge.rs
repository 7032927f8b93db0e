//! Rows against the truth: one definition for all filters.
//!
//! Position and velocity errors are norms of three components; tilt is the norm of the attitude error's components about
//! north and east, heading the one about down. They count at every row of the spans in which the filters have settled.
//! Consistency is the mean of (error / σ)² over the three components of position: 1 if σ is right.

use crate::flight::{COLUMNS, Row};
use crate::{Failed, files};
use std::path::Path;

/// When filters have settled after the start and after an outage, s.
const SETTLED_S: f64 = 150.0;
const SETTLED_AGAIN_S: f64 = 40.0;

/// WGS-84: semi-major axis and squared eccentricity.
const AXIS_M: f64 = 6_378_137.0;
const ECCENTRICITY2: f64 = 0.006_694_379_990_141_3;

/// Sums over rows of squares.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sums {
    rows: f64,
    squares: [f64; 4],
    by_sigma: f64,
    flights: f64,
    outage_end: f64,
}

impl Sums {
    /// Adds the rows of a filter in a folder.
    pub fn add(&mut self, folder: &Path, name: &str) -> Result<(), Failed> {
        let settings = files::Numbers::read(&folder.join("settings.toml"))?;
        let rate_hz = settings.get("rate_hz")?;
        let [from, until] = settings.all(["outage_from_s", "outage_until_s"])?;
        let [_, motion @ .., _, _, _] = COLUMNS;
        let truth = files::columns(&folder.join("truth.csv"), motion)?;
        let mut last = None;
        for row in files::columns(&folder.join(format!("{name}.csv")), COLUMNS)? {
            let [time_s, ..] = row;
            let true_ = truth.get((time_s * rate_hz).round() as usize);
            let errors =
                errors(&row, true_.ok_or_else(|| format!("{name}: no truth at {time_s} s"))?);
            if time_s <= until {
                last = Some(errors.square_m2());
            }
            if (SETTLED_S..=from).contains(&time_s) || time_s >= until + SETTLED_AGAIN_S {
                self.count(&errors);
            }
        }
        self.flights += 1.0;
        self.outage_end += last.ok_or_else(|| format!("{name}: no rows before {until} s"))?;
        Ok(())
    }

    fn count(&mut self, errors: &Errors) {
        let [north, east, down] = errors.attitude_rad;
        let squares = [
            errors.square_m2(),
            square(errors.velocity_m_s),
            north * north + east * east,
            down * down,
        ];
        for (sum, square) in self.squares.iter_mut().zip(squares) {
            *sum += square;
        }
        let of = errors.position_m.iter().zip(errors.sigma_m);
        self.by_sigma += of.map(|(error, sigma)| (error / sigma).powi(2)).sum::<f64>() / 3.0;
        self.rows += 1.0;
    }

    /// Root mean squares: position m, velocity m/s, tilt and heading in minutes of arc, position at the outage's end m;
    /// and the mean of (error / σ)².
    pub fn figures(&self) -> [f64; 6] {
        let [position, velocity, tilt, heading] = self.squares.map(|sum| (sum / self.rows).sqrt());
        let minutes = |rad: f64| rad.to_degrees() * 60.0;
        let end = (self.outage_end / self.flights).sqrt();
        [position, velocity, minutes(tilt), minutes(heading), end, self.by_sigma / self.rows]
    }
}

struct Errors {
    position_m: [f64; 3],
    velocity_m_s: [f64; 3],
    attitude_rad: [f64; 3],
    sigma_m: [f64; 3],
}

impl Errors {
    fn square_m2(&self) -> f64 {
        square(self.position_m)
    }
}

fn errors(row: &Row, truth: &[f64; 9]) -> Errors {
    let [_, latitude, longitude, altitude, north, east, down, roll, pitch, yaw, n, e, d] = *row;
    let [lat, lon, alt, vn, ve, vd, r, p, y] = *truth;
    let (sine, cosine) = lat.to_radians().sin_cos();
    let w2 = 1.0 - ECCENTRICITY2 * sine * sine;
    let prime = AXIS_M / w2.sqrt();
    let meridian = prime * (1.0 - ECCENTRICITY2) / w2;
    Errors {
        position_m: [
            (latitude - lat).to_radians() * (meridian + alt),
            (longitude - lon).to_radians() * (prime + alt) * cosine,
            alt - altitude,
        ],
        velocity_m_s: [north - vn, east - ve, down - vd],
        attitude_rad: turn(&to_ned([roll, pitch, yaw]), &to_ned([r, p, y])),
        sigma_m: [n, e, d],
    }
}

/// The small rotation in north, east, down from the true to the computed body axes.
fn turn(computed: &[[f64; 3]; 3], truth: &[[f64; 3]; 3]) -> [f64; 3] {
    // E = Ĉ Cᵀ ≈ I + [φ×]
    let e = |i: usize, j: usize| (0..3).map(|k| computed[i][k] * truth[j][k]).sum::<f64>();
    [(e(2, 1) - e(1, 2)) / 2.0, (e(0, 2) - e(2, 0)) / 2.0, (e(1, 0) - e(0, 1)) / 2.0]
}

/// From body to north, east, down by roll, pitch and yaw in degrees.
fn to_ned(degrees: [f64; 3]) -> [[f64; 3]; 3] {
    let [(sr, cr), (sp, cp), (sy, cy)] = degrees.map(|angle| angle.to_radians().sin_cos());
    [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
}

fn square(vector: [f64; 3]) -> f64 {
    vector.iter().map(|x| x * x).sum()
}
