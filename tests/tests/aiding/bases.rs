//! Vehicles that are aligned: still, swaying, turning; with the sensors of a navigation-grade unit.

use schuler::aiding::alignment::aligned::Aligned;
use schuler::aiding::alignment::base::Base;
use schuler::aiding::alignment::fine::Fine;
use schuler::aiding::alignment::limit::Limit;
use schuler::aiding::alignment::settings::Settings;
use schuler::aiding::model::Model;
use schuler::aiding::states::Process;
use schuler::earth::Radii;
use schuler::imu::Quadrature;
use schuler::math::real::Scalar;
use schuler::prelude::*;
use schuler::sensor::Timing;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::turn_on::TurnOn;
use schuler::sensor::white::White;
use schuler::strapdown::block::body::BodyMotion;
use schuler::trajectory::Trajectory;
use schuler::trajectory::harmonic::{Channel, Channels, Harmonic, HarmonicTrajectory};
use schuler::units::{DEGREE, DEGREE_PER_HOUR, MICRO_G};

/// 0.01 °/h, 0.002 °/√h, 50 µg, 10 µg/√Hz.
pub const SENSORS: Limit<f64> = Limit {
    gyro_noise: 0.002 * DEGREE / 60.0,
    accelerometer_noise: 10.0 * MICRO_G,
    gyro_bias: 0.01 * DEGREE_PER_HOUR,
    accelerometer_bias: 50.0 * MICRO_G,
};

pub const LATITUDE: f64 = 45.0 * DEGREE;
pub const ARCMINUTE: f64 = DEGREE / 60.0;

#[derive(Clone, Copy, PartialEq)]
pub enum Motion {
    Still,
    /// About the vertical, rad/s.
    Turning(f64),
    /// 7°/4°/3° of 8/6/10 s, and 0.3/0.2/0.4 m of 7/6.5/8.5 s.
    Swaying,
}

impl Motion {
    pub fn rate_hz(self) -> f64 {
        match self {
            Self::Still => 10.0,
            Self::Turning(_) => 20.0,
            Self::Swaying => 50.0,
        }
    }

    pub fn place(self) -> Geodetic<f64> {
        let altitude = if self == Self::Swaying { 0.0 } else { 1000.0 };
        Geodetic { latitude: LATITUDE, longitude: 100.0 * DEGREE, altitude }
    }

    /// Perfect increments, and the attitude at the end of each.
    pub fn perfect(self, seconds: f64) -> (Vec<Increment<f64>>, Vec<Quaternion<f64>>) {
        let at = self.place();
        let radii = Radii::at(LATITUDE.sin(), LATITUDE.cos());
        let wave = |amplitude: f64, period: f64, phase: f64| {
            [Harmonic { amplitude, angular_rate: core::f64::consts::TAU / period, phase }]
        };
        let (roll, pitch, yaw) = (
            wave(7.0 * DEGREE, 8.0, 0.3),
            wave(4.0 * DEGREE, 6.0, 1.1),
            wave(3.0 * DEGREE, 10.0, 2.0),
        );
        let north = wave(0.3 / radii.meridian, 7.0, 0.5);
        let east = wave(0.2 / (radii.prime_vertical * LATITUDE.cos()), 6.5, 0.9);
        let up = wave(0.4, 8.5, 0.0);
        let fixed = Channel::constant;
        let channels = match self {
            Self::Still | Self::Turning(_) => {
                let rate = if let Self::Turning(rate) = self { rate } else { 0.0 };
                Channels {
                    roll: fixed(3.0 * DEGREE),
                    pitch: fixed(-7.0 * DEGREE),
                    yaw: Channel::steady(40.0 * DEGREE, rate),
                    latitude: fixed(at.latitude),
                    longitude: fixed(at.longitude),
                    altitude: fixed(at.altitude),
                }
            }
            Self::Swaying => Channels {
                roll: Channel { harmonics: &roll, ..fixed(0.0) },
                pitch: Channel { harmonics: &pitch, ..fixed(0.0) },
                yaw: Channel { harmonics: &yaw, ..fixed(40.0 * DEGREE) },
                latitude: Channel { harmonics: &north, ..fixed(at.latitude) },
                longitude: Channel { harmonics: &east, ..fixed(at.longitude) },
                altitude: Channel { harmonics: &up, ..fixed(at.altitude) },
            },
        };
        let flight = HarmonicTrajectory::<f64, 8>::new(channels).unwrap();
        let hz = self.rate_hz();
        let quadrature = Quadrature::plan(flight.bound().bandwidth, 1.0 / hz);
        let samples = (seconds * hz).round() as u64;
        let increments = (1..=samples).map(|k| quadrature.sample(&flight, k, hz)).collect();
        let attitudes = (1..=samples).map(|k| {
            let motion = flight.at(k as f64 / hz);
            let angles = [motion.roll, motion.pitch, motion.yaw].map(|jet| jet.value);
            Euler { roll: angles[0], pitch: angles[1], yaw: angles[2] }.quaternion()
        });
        (increments, attitudes.collect())
    }
}

/// The increments that the sensors read in a run.
pub fn read(
    perfect: &[Increment<f64>],
    rate_hz: f64,
    run: u64,
    sensors: &Limit<f64>,
) -> Vec<Increment<f64>> {
    let timing = Timing::new(1.0 / rate_hz, perfect.len() as u64).unwrap();
    let three = |x: f64| Vector::new(x, x, x);
    let terms = |noise: f64, bias: f64| {
        (TurnOn::new(three(bias), timing).unwrap(), White::new(three(noise), timing).unwrap())
    };
    let gyro = terms(sensors.gyro_noise, sensors.gyro_bias);
    let accelerometer = terms(sensors.accelerometer_noise, sensors.accelerometer_bias);
    let unit = Emulator::new(gyro, accelerometer, timing);
    let mut state = unit.start(17, run);
    perfect.iter().map(|sample| unit.emulate(&mut state, sample)).collect()
}

/// The filter's model of the sensors.
pub fn model<R: Scalar>(sensors: &Limit<f64>) -> Model<R> {
    let of = |x: f64| R::narrow(x);
    Model::new(
        of(sensors.gyro_noise),
        of(sensors.accelerometer_noise),
        Process::constant(of(sensors.gyro_bias)),
        Process::constant(of(sensors.accelerometer_bias)),
    )
}

/// Settings for a base, with a first level and heading of these standard deviations.
pub fn settings<R: Scalar>(base: Base<R>, level: f64, heading: f64, velocity: f64) -> Settings<R> {
    Settings {
        base,
        level_rad: R::narrow(level),
        heading_rad: R::narrow(heading),
        velocity_m_s: R::narrow(velocity),
        ..Settings::new(model(&SENSORS))
    }
}

/// One alignment read at some times.
pub struct Read {
    /// Standard deviations of the rotation vector from the true to the computed attitude, north, east, down, rad.
    pub sigma: [f64; 3],
    /// eᵀP⁻¹e of that vector.
    pub nees: f64,
    pub residual: f64,
    pub refused: u32,
}

/// Aligns on samples from a first attitude, and reads it at the times.
pub fn align<R, M, const N: usize, const P: usize, const E: usize>(
    mechanization: M,
    motion: Motion,
    samples: &[Increment<f64>],
    truth: &[Quaternion<f64>],
    first: Euler<f64>,
    settings: Settings<R>,
    times: &[f64],
) -> Vec<Read>
where
    R: Scalar + schuler::math::real::Real<Mask = bool>,
    M: Mechanization<Real = R, Body = BodyMotion<R>>,
{
    let hz = motion.rate_hz();
    let place = motion.place().map(R::narrow);
    let interval = Pair::narrow(Pair::new(hz).reciprocal());
    let fine = Fine::<M, N, P, E>::new(mechanization, interval, &place, settings).unwrap();
    let narrow = |x: f64| R::narrow(x);
    let euler =
        Euler { roll: narrow(first.roll), pitch: narrow(first.pitch), yaw: narrow(first.yaw) };
    let mut state = fine.start(euler).unwrap();
    let mut reads = Vec::new();
    for (k, sample) in samples.iter().enumerate() {
        let sample = Increment {
            angle_b: sample.angle_b.map(R::narrow),
            velocity_b: sample.velocity_b.map(R::narrow),
        };
        fine.push(&mut state, sample).unwrap();
        let now = (k + 1) as f64 / hz;
        if times.iter().any(|time| (time - now).abs() < 0.5 / hz) {
            reads.push(compare(&fine, &state, &fine.aligned(&state), truth[k]));
        }
    }
    reads
}

fn compare<R, M, const N: usize, const P: usize, const E: usize>(
    fine: &Fine<M, N, P, E>,
    state: &schuler::aiding::alignment::fine::FineState<M, N, P, E>,
    aligned: &Aligned<R>,
    truth: Quaternion<f64>,
) -> Read
where
    R: Scalar + schuler::math::real::Real<Mask = bool>,
    M: Mechanization<Real = R, Body = BodyMotion<R>>,
{
    let euler = Euler {
        roll: aligned.attitude.roll.widen(),
        pitch: aligned.attitude.pitch.widen(),
        yaw: aligned.attitude.yaw.widen(),
    };
    let e = (euler.quaternion() * truth.conjugate()).rotation_vector();
    let covariance = fine.attitude_covariance(state).map(|row| row.map(Scalar::widen));
    let sigma = [0, 1, 2].map(|n| covariance[n][n].sqrt());
    Read {
        sigma,
        nees: quadratic(covariance, [e.x, e.y, e.z]),
        residual: aligned.residual.widen(),
        refused: aligned.refused,
    }
}

/// eᵀP⁻¹e by Cholesky's factors.
fn quadratic(p: [[f64; 3]; 3], e: [f64; 3]) -> f64 {
    let mut l = [[0.0; 3]; 3];
    let mut sum = 0.0;
    let mut z = [0.0; 3];
    for i in 0..3 {
        for j in 0..=i {
            let rest: f64 = p[i][j] - (0..j).map(|k| l[i][k] * l[j][k]).sum::<f64>();
            l[i][j] = if i == j { rest.sqrt() } else { rest / l[j][j] };
        }
        z[i] = (e[i] - (0..i).map(|k| l[i][k] * z[k]).sum::<f64>()) / l[i][i];
        sum += z[i] * z[i];
    }
    sum
}
