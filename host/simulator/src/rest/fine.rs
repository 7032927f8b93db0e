//! Fine alignment on a stretch at rest: attitude and biases, with their uncertainty and what theory allows.

use super::warn;
use crate::input::{Complaint, InputError};
use crate::output::say;
use crate::recording::navigation::NavigationRow;
use crate::units::{DEGREE, DEGREE_PER_HOUR};
use schuler::aiding::alignment::aligned::Aligned;
use schuler::aiding::alignment::base::STILL_M;
use schuler::aiding::alignment::fine::Fine15;
use schuler::aiding::alignment::limit::Limit;
use schuler::aiding::alignment::settings::Settings;
use schuler::aiding::model::Model;
use schuler::aiding::states::Process;
use schuler::aiding::surroundings::Surroundings;
use schuler::alignment::judge::Quality;
use schuler::alignment::still::Readings;
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::navigators::Navigator4;
use schuler::sample::Increment;
use schuler::units::MICRO_G;

/// Biases that no reading shows are taken for at least these: of a good gyro, and of the Earth's real field.
const LEAST_GYRO: f64 = 0.01 * DEGREE_PER_HOUR;
const LEAST_ACCELEROMETER: f64 = 100.0 * MICRO_G;
/// Noise below these is none, rad/√s and m/s/√s.
const LEAST_NOISE: [f64; 2] = [1e-8, 1e-6];
/// Standard deviation of a level from the means, rad.
const LEVEL: f64 = 0.01;
/// A first heading has at least this standard deviation, rad.
const HEADING: f64 = 0.09;
/// A heading that is not known at all, rad.
const UNKNOWN: f64 = 1.8;

/// A stretch at rest.
#[derive(Clone, Debug)]
pub struct Stretch {
    samples: Vec<Increment<f64>>,
    interval: Pair<f64>,
}

/// What a stretch gives.
#[derive(Clone, Copy, Debug)]
pub struct Refined {
    /// The attitude at its end, at rest.
    pub row: NavigationRow,
    /// All of it.
    pub aligned: Aligned<f64>,
    /// What the sensors are taken for.
    pub sensors: Limit<f64>,
}

impl Refined {
    /// How long an alignment takes that knows the heading to a standard deviation, s; `None` if none does.
    pub fn seconds_for(&self, sigma: f64) -> Option<f64> {
        self.sensors.seconds(&Surroundings::at(&self.row.position), sigma)
    }
}

impl Stretch {
    /// For samples of an interval.
    pub fn new(interval: Pair<f64>) -> Self {
        Self { samples: Vec::new(), interval }
    }

    /// Takes the next sample.
    pub fn add(&mut self, sample: &Increment<f64>) {
        self.samples.push(*sample);
    }

    /// Whether it is long enough for the filter.
    pub fn suffices(&self) -> bool {
        self.samples.len() >= 16
    }

    /// Aligns from the attitude of the means. `piece_s` is the length of the pieces that the noise is of.
    pub fn refine(
        &self,
        file: &str,
        coarse: &NavigationRow,
        readings: &Readings<f64>,
        quality: &Quality<f64>,
        piece_s: f64,
    ) -> Result<Refined, InputError> {
        let refuse = |what: String, accepted: &str| {
            InputError::file(file, Complaint::new(what, accepted.to_owned()))
        };
        let sensors = sensors(readings, quality, piece_s);
        let model = Model::new(
            sensors.gyro_noise,
            sensors.accelerometer_noise,
            Process::constant(sensors.gyro_bias),
            Process::constant(sensors.accelerometer_bias),
        );
        let heading_rad = (3.0 * quality.heading_sigma).clamp(HEADING, UNKNOWN);
        let settings = Settings { level_rad: LEVEL, heading_rad, ..Settings::new(model) };
        let stopped = |fault: &dyn core::fmt::Display| refuse(format!("no alignment: {fault}"), "");
        let navigator = Navigator4::new(self.interval).map_err(|fault| stopped(&fault))?;
        let place = coarse.position;
        let fine = Fine15::new(navigator, self.interval, &place, settings)
            .map_err(|fault| stopped(&fault))?;
        let mut state = fine.start(coarse.attitude).map_err(|fault| stopped(&fault))?;
        for sample in &self.samples {
            fine.push(&mut state, *sample).map_err(|fault| stopped(&fault))?;
        }
        let aligned = fine.aligned(&state);
        if let Some(moved_s) = aligned.moved_s {
            let what = format!(
                "the vehicle moved: after {moved_s:.1} s of the stretch at rest it is farther from its \
                 place than a filter with a displacement of {} mm explains",
                1e3 * STILL_M
            );
            return Err(refuse(what, "a stretch at rest: --start and --align"));
        }
        if !aligned.fits() {
            warn(&format!(
                "the vehicle is displaced by about {:.1} mm, where {} mm is taken for standing still: \
                 the standard deviations are too small",
                1e3 * STILL_M * aligned.residual.sqrt(),
                1e3 * STILL_M
            ));
        }
        say(&text(&aligned, &sensors, &Surroundings::at(&place)))?;
        let row =
            NavigationRow { attitude: aligned.attitude, velocity_ned: Vector::ZERO, ..*coarse };
        Ok(Refined { row, aligned, sensors })
    }
}

/// The sensors as the readings show them. |ω| shows the errors of two axes of three, |f| those of one.
pub fn sensors(readings: &Readings<f64>, quality: &Quality<f64>, piece_s: f64) -> Limit<f64> {
    Limit {
        gyro_noise: (readings.rate_noise * piece_s.sqrt()).max(LEAST_NOISE[0]),
        accelerometer_noise: (readings.force_noise * piece_s.sqrt()).max(LEAST_NOISE[1]),
        gyro_bias: (quality.rate_off * 0.5_f64.sqrt()).max(LEAST_GYRO),
        accelerometer_bias: quality.force_off.abs().max(LEAST_ACCELEROMETER),
    }
}

/// What an alignment found.
fn text(aligned: &Aligned<f64>, sensors: &Limit<f64>, here: &Surroundings<f64>) -> String {
    let degrees = |x: f64| x / DEGREE;
    let [north, east] = aligned.level_sigma;
    let limit = degrees(sensors.heading(here, aligned.seconds));
    let three = |v: Vector<f64>, unit: f64, decimals: usize| {
        format!(
            "{:.*}, {:.*}, {:.*}",
            decimals,
            v.x / unit,
            decimals,
            v.y / unit,
            decimals,
            v.z / unit
        )
    };
    let [gyro, gyro_sigma] = aligned.gyro_bias;
    let [force, force_sigma] = aligned.accelerometer_bias;
    format!(
        "fine: roll {:.4}°, pitch {:.4}°, heading {:.4}° (1σ: level {:.4}°, heading {:.4}°; theory allows \
         {limit:.4}°)\n\
         gyro biases {} °/h (1σ {}), accelerometer biases {} µg (1σ {}); noise {} °/√h; residuals {:.2} of \
         what is expected\n",
        degrees(aligned.attitude.roll),
        degrees(aligned.attitude.pitch),
        degrees(aligned.attitude.yaw).rem_euclid(360.0),
        degrees(north.max(east)),
        degrees(aligned.heading_sigma),
        three(gyro, DEGREE_PER_HOUR, 4),
        three(gyro_sigma, DEGREE_PER_HOUR, 4),
        three(force, MICRO_G, 1),
        three(force_sigma, MICRO_G, 1),
        format!("{:.2e}", sensors.gyro_noise / DEGREE * 60.0),
        aligned.residual,
    )
}
