//! Fine alignment on a stretch at rest: attitude and biases, with their uncertainty and what theory allows.

use super::warn;
use crate::input::{Complaint, InputError};
use crate::number::fixed;
use crate::output::say;
use crate::recording::navigation::NavigationRow;
use crate::units::{DEGREE, DEGREE_PER_HOUR, DEGREE_PER_ROOT_HOUR};
use schuler::aiding::alignment::aligned::Aligned;
use schuler::aiding::alignment::base::STILL_M;
use schuler::aiding::alignment::fine::Fine15;
use schuler::aiding::alignment::limit::Limit;
use schuler::aiding::alignment::settings::Settings;
use schuler::aiding::alignment::verdict::AlignmentFault;
use schuler::aiding::model::Model;
use schuler::aiding::states::Process;
use schuler::aiding::surroundings::Surroundings;
use schuler::alignment::judge::Quality;
use schuler::alignment::still::Readings;
use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::navigators::Navigator4;
use schuler::sample::Increment;
use schuler::solution::Euler;
use schuler::units::MICRO_G;

/// Biases that no reading shows are taken for at least these: of a good gyro, and of the Earth's real field.
const LEAST_GYRO: f64 = 0.01 * DEGREE_PER_HOUR;
const LEAST_ACCELEROMETER: f64 = 100.0 * MICRO_G;
/// By how many standard deviations the residuals may rise where the gyros are taken for quieter.
const RISE: f64 = 3.0;
/// Noise of a good sensor, rad/√s and m/s/√s: a short stretch does not show less.
const LEAST_NOISE: [f64; 2] = [1e-3 * DEGREE_PER_ROOT_HOUR, 5.0 * MICRO_G];
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

    /// The alignment with sensors that are taken for these.
    fn filter(
        &self,
        sensors: &Limit<f64>,
        place: &Geodetic<f64>,
        first: Euler<f64>,
        heading_rad: f64,
    ) -> Result<Aligned<f64>, AlignmentFault> {
        let model = Model::new(
            sensors.gyro_noise,
            sensors.accelerometer_noise,
            Process::constant(sensors.gyro_bias),
            Process::constant(sensors.accelerometer_bias),
        );
        let settings = Settings { level_rad: LEVEL, heading_rad, ..Settings::new(model) };
        let navigator = Navigator4::new(self.interval).map_err(|_| AlignmentFault::Settings)?;
        let fine = Fine15::new(navigator, self.interval, place, settings)?;
        let mut state = fine.start(first)?;
        for sample in &self.samples {
            fine.push(&mut state, *sample)?;
        }
        Ok(fine.aligned(&state))
    }

    /// Aligns from the attitude of the means.
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
        let place = coarse.position;
        let heading_rad = (3.0 * quality.heading_sigma).clamp(HEADING, UNKNOWN);
        let filtered = |sensors: &Limit<f64>| {
            let stopped = |fault: AlignmentFault| refuse(format!("no alignment: {fault}"), "");
            self.filter(sensors, &place, coarse.attitude, heading_rad).map_err(stopped)
        };
        // The scatter of the sensors, and the gyros' mean, have the vehicle's own motion in them. The filter follows
        // that: what its residuals bear, and the biases that it finds, are the sensors' own.
        let sensors = sensors(readings, quality, piece_s);
        let seen = filtered(&sensors)?;
        let borne = seen.residual * (1.0 + RISE * seen.residual_spread());
        let bears = |aligned: &Aligned<f64>| aligned.residual <= borne && aligned.moved_s.is_none();
        let (sensors, found) = quietest((sensors, seen), &filtered, &bears)?;
        let sensors = Limit { gyro_bias: bias_seen(&found), ..sensors };
        let aligned = filtered(&sensors)?;
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
fn sensors(readings: &Readings<f64>, quality: &Quality<f64>, piece_s: f64) -> Limit<f64> {
    Limit {
        gyro_noise: (readings.rate_noise * piece_s.sqrt()).max(LEAST_NOISE[0]),
        accelerometer_noise: (readings.force_noise * piece_s.sqrt()).max(LEAST_NOISE[1]),
        gyro_bias: (quality.rate_off * 0.5_f64.sqrt()).max(LEAST_GYRO),
        accelerometer_bias: quality.force_off.abs().max(LEAST_ACCELEROMETER),
    }
}

/// An alignment with sensors that are taken for something.
type Filtered<'a> = dyn Fn(&Limit<f64>) -> Result<Aligned<f64>, InputError> + 'a;

/// The sensors with the least noise that the residuals bear, by halves: the gyros', then the accelerometers'.
fn quietest(
    (mut sensors, mut found): (Limit<f64>, Aligned<f64>),
    filtered: &Filtered<'_>,
    bears: &dyn Fn(&Aligned<f64>) -> bool,
) -> Result<(Limit<f64>, Aligned<f64>), InputError> {
    let noises: [fn(&mut Limit<f64>) -> &mut f64; 2] =
        [|sensors| &mut sensors.gyro_noise, |sensors| &mut sensors.accelerometer_noise];
    for (noise, least) in noises.into_iter().zip(LEAST_NOISE) {
        loop {
            let mut quieter = sensors;
            *noise(&mut quieter) = (0.5 * *noise(&mut quieter)).max(least);
            if quieter == sensors {
                break;
            }
            let tried = filtered(&quieter)?;
            if !bears(&tried) {
                break;
            }
            (sensors, found) = (quieter, tried);
        }
    }
    Ok((sensors, found))
}

/// Rms of the gyro biases that an alignment shows: those of two axes of three, the third is what limits its heading.
fn bias_seen(aligned: &Aligned<f64>) -> f64 {
    let [bias, sigma] = aligned.gyro_bias;
    (0.5 * bias.dot(bias)).sqrt().max(sigma.x.min(sigma.y).min(sigma.z)).max(LEAST_GYRO)
}

/// What an alignment found.
fn text(aligned: &Aligned<f64>, sensors: &Limit<f64>, here: &Surroundings<f64>) -> String {
    let degrees = |x: f64| x / DEGREE;
    let [north, east] = aligned.level_sigma;
    let limit = degrees(sensors.heading(here, aligned.seconds));
    let three = |v: Vector<f64>, unit: f64, decimals: usize| {
        v.into_array().map(|x| fixed(x / unit, decimals)).join(", ")
    };
    let [gyro, gyro_sigma] = aligned.gyro_bias;
    let [force, force_sigma] = aligned.accelerometer_bias;
    format!(
        "fine: roll {}°, pitch {}°, heading {:.4}° (1σ: level {:.4}°, heading {:.4}°; theory allows \
         {limit:.4}°)\n\
         gyro biases {} °/h (1σ {}), accelerometer biases {} µg (1σ {}); noise {:.2e} °/√h; residuals {:.2} of \
         what is expected\n",
        fixed(degrees(aligned.attitude.roll), 4),
        fixed(degrees(aligned.attitude.pitch), 4),
        degrees(aligned.attitude.yaw).rem_euclid(360.0),
        degrees(north.max(east)),
        degrees(aligned.heading_sigma),
        three(gyro, DEGREE_PER_HOUR, 4),
        three(gyro_sigma, DEGREE_PER_HOUR, 4),
        three(force, MICRO_G, 1),
        three(force_sigma, MICRO_G, 1),
        sensors.gyro_noise / DEGREE * 60.0,
        aligned.residual,
    )
}
