//! A folder's samples and fixes; filters flown and timed.

use crate::{Failed, files};
use rustix::time::{ClockId, clock_gettime};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// The columns of a solution, as in `nav.csv`, with the standard deviations that are judged.
pub const COLUMNS: [&str; 13] = [
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
    "north_m_sigma",
    "east_m_sigma",
    "down_m_sigma",
];

/// One row of them.
pub type Row = [f64; 13];

/// Rows are written each so many samples.
const EVERY: usize = 10;

/// ∫ω dt in rad and ∫f dt in m/s over a sample that ends at a time.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// rad.
    pub angle: [f64; 3],
    /// m/s.
    pub velocity: [f64; 3],
}

/// What a receiver tells of its antenna.
#[derive(Clone, Copy, Debug)]
pub struct Fix {
    /// The number of samples at whose end it is true.
    pub samples: usize,
    /// Latitude and longitude in degrees, altitude in m.
    pub place: [f64; 3],
    /// North, east, down, m/s, if it tells that.
    pub velocity: Option<[f64; 3]>,
}

/// What filters are told.
#[derive(Clone, Copy, Debug)]
pub struct Told {
    pub rate_hz: f64,
    pub gyro_noise: f64,
    pub gyro_bias: f64,
    pub accelerometer_noise: f64,
    pub accelerometer_bias: f64,
    pub position_m: f64,
    pub velocity_m_s: f64,
    pub level_rad: f64,
    pub heading_rad: f64,
    pub fix_position_m: f64,
    pub fix_velocity_m_s: f64,
    pub lever: [f64; 3],
    /// Latitude, longitude, altitude, north, east, down, roll, pitch, yaw: degrees, m, m/s.
    pub initial: [f64; 9],
}

/// A filter in flight.
pub trait Filter {
    /// Takes a sample, and the fix that is true at its end, if there is one.
    fn sample(&mut self, sample: &Sample, fix: Option<&Fix>) -> Result<(), Failed>;
    /// Takes what may wait.
    fn finish(&mut self);
    /// Where it is after so many seconds.
    fn row(&self, time_s: f64) -> Result<Row, Failed>;
}

/// A folder's files.
pub struct Flight {
    folder: PathBuf,
    samples: Vec<Sample>,
    fixes: Vec<Fix>,
    /// What filters are told.
    pub told: Told,
}

impl Flight {
    /// Reads them.
    pub fn read(folder: &Path) -> Result<Self, Failed> {
        let told = told(folder)?;
        let imu = files::columns(
            &folder.join("imu.csv"),
            [
                "dtheta_x_rad",
                "dtheta_y_rad",
                "dtheta_z_rad",
                "dvel_x_m_s",
                "dvel_y_m_s",
                "dvel_z_m_s",
            ],
        )?;
        let [time, rest @ ..] = COLUMNS;
        let [a, b, c, n, e, d, ..] = rest;
        let gnss = files::columns(&folder.join("gnss.csv"), [time, a, b, c, n, e, d])?;
        let fixes = gnss.into_iter().map(|[time_s, a, b, c, n, e, d]| Fix {
            samples: (time_s * told.rate_hz).round() as usize,
            place: [a, b, c],
            velocity: n.is_finite().then_some([n, e, d]),
        });
        let samples = imu
            .into_iter()
            .map(|[x, y, z, u, v, w]| Sample { angle: [x, y, z], velocity: [u, v, w] });
        let (samples, fixes) = (samples.collect(), fixes.collect());
        Ok(Self { folder: folder.to_owned(), samples, fixes, told })
    }

    /// Flies a filter, and shows it after each sample.
    fn fly(
        &self,
        filter: &mut impl Filter,
        mut seen: impl FnMut(usize, &mut dyn Filter) -> Result<(), Failed>,
    ) -> Result<(), Failed> {
        let mut fixes = self.fixes.iter().peekable();
        for (sample, count) in self.samples.iter().zip(1..) {
            filter.sample(sample, fixes.next_if(|fix| fix.samples == count))?;
            seen(count, filter)?;
        }
        filter.finish();
        match fixes.next() {
            None => Ok(()),
            Some(fix) => Err(format!("a fix at {} samples is not taken", fix.samples).into()),
        }
    }

    /// Writes the CPU time of a filter, µs per sample.
    pub fn time<F: Filter>(
        &self,
        name: &str,
        start: impl Fn() -> Result<F, Failed>,
    ) -> Result<(), Failed> {
        let mut filter = start()?;
        let begun = cpu_s();
        self.fly(&mut filter, |_, _| Ok(()))?;
        let cost = (cpu_s() - begun) / self.samples.len() as f64 * 1e6;
        // What nobody reads might not be computed.
        let end = filter.row(self.samples.len() as f64 / self.told.rate_hz)?;
        if !end.iter().all(|number| number.is_finite()) {
            return Err(format!("{name} ends with {end:?}").into());
        }
        files::write(&self.folder.join(format!("{name}.cost")), &format!("{cost}\n"))
    }

    /// Writes a filter's rows.
    pub fn write_rows(&self, name: &str, mut filter: impl Filter) -> Result<(), Failed> {
        let mut text = COLUMNS.join(",") + "\n";
        self.fly(&mut filter, |count, filter| {
            if count % EVERY == 0 {
                let row = filter.row(count as f64 / self.told.rate_hz)?;
                writeln!(text, "{}", row.map(|number| format!("{number:?}")).join(","))?;
            }
            Ok(())
        })?;
        files::write(&self.folder.join(format!("{name}.csv")), &text)
    }
}

fn told(folder: &Path) -> Result<Told, Failed> {
    let settings = files::Numbers::read(&folder.join("settings.toml"))?;
    let [_, place_and_motion @ .., _, _, _] = COLUMNS;
    Ok(Told {
        rate_hz: settings.get("rate_hz")?,
        gyro_noise: settings.get("gyro_noise_rad_root_s")?,
        gyro_bias: settings.get("gyro_bias_rad_s")?,
        accelerometer_noise: settings.get("accelerometer_noise_m_s_root_s")?,
        accelerometer_bias: settings.get("accelerometer_bias_m_s2")?,
        position_m: settings.get("position_m")?,
        velocity_m_s: settings.get("velocity_m_s")?,
        level_rad: settings.get("level_rad")?,
        heading_rad: settings.get("heading_rad")?,
        fix_position_m: settings.get("fix_position_m")?,
        fix_velocity_m_s: settings.get("fix_velocity_m_s")?,
        lever: settings.all(["lever_forward_m", "lever_right_m", "lever_down_m"])?,
        initial: files::Numbers::read(&folder.join("initial.toml"))?.all(place_and_motion)?,
    })
}

/// CPU time of this thread, s.
fn cpu_s() -> f64 {
    let now = clock_gettime(ClockId::ThreadCPUTime);
    now.tv_sec as f64 + now.tv_nsec as f64 * 1e-9
}
