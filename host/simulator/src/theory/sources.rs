//! A scene's sensor errors in the linear model: a systematic part that determines the mean, and
//! independent scalar processes that determine the covariance.

use super::bias::Bias;
use super::lag::{self, Lag};
use crate::scene::felt::Felt;
use crate::scene::terms::{Source, TERMS, Term};
use crate::scene::values::Values;
use crate::scene::{Scene, SensorErrors};
use schuler::math::vector::Vector;
use schuler::sample::Rates;
use schuler::sensor::{Timing, flicker};
use std::f64::consts::TAU;
use std::mem;

/// The six sensors: gyros x, y, z, then accelerometers x, y, z.
pub const SENSORS: usize = 6;

/// All error sources of a scene.
#[derive(Clone, Debug)]
pub struct Sources {
    gyro: SensorErrors,
    accelerometer: SensorErrors,
    /// Random biases, slowest first.
    pub biases: Vec<Bias>,
    /// N² of each sensor, angle²/s.
    pub white: [f64; SENSORS],
    /// T = 1/(2πf) of each sensor's bandwidth, s; 0 where it has none.
    pub lag_s: [f64; SENSORS],
    /// The biases that lag, those that lag longest first.
    pub lags: Vec<Lag>,
    /// Q² = step²/12 of each sensor, angle².
    pub quantization: [f64; SENSORS],
    /// τ₀, s.
    pub sample_interval_s: f64,
}

impl Sources {
    /// Of a scene.
    pub fn new(scene: &Scene) -> Self {
        let triads = [&scene.gyro, &scene.accelerometer];
        let sample_interval_s = scene.rate_hz.recip();
        let mut biases = Vec::new();
        for (triad, errors) in triads.into_iter().enumerate() {
            for axis in 0..3 {
                let at = |source| values(errors, source)[axis];
                let sensor = 3 * triad + axis;
                let mut push = |rms: f64, walk: f64, correlation_s: f64| {
                    if rms != 0.0 || walk != 0.0 {
                        let (variance, walk) = (rms * rms, walk * walk);
                        let (is_filtered, early) = (false, 0.0);
                        biases.push(Bias {
                            sensor,
                            variance,
                            walk,
                            correlation_s,
                            is_filtered,
                            early,
                        });
                    }
                };
                push(at(Source::Stays), at(Source::Walks), f64::INFINITY);
                if let Some(process) = errors.gauss_markov {
                    push(process.rms[axis], 0.0, process.correlation_s[axis]);
                }
                if let Ok(timing) = Timing::new(sample_interval_s, scene.samples()) {
                    for (correlation_s, rms) in flicker::poles(timing) {
                        push(rms * at(Source::Flickers), 0.0, correlation_s);
                    }
                }
            }
        }
        let squares = |source| {
            let values = triads.map(|errors| values(errors, source));
            std::array::from_fn(|i| values[i / 3][i % 3] * values[i / 3][i % 3])
        };
        let white: [f64; SENSORS] = squares(Source::White);
        let lag_s: [f64; SENSORS] = std::array::from_fn(|i| {
            triads[i / 3].bandwidth.map_or(0.0, |frequency_hz| (TAU * frequency_hz[i % 3]).recip())
        });
        for (sensor, (n2, lag_s)) in white.into_iter().zip(lag_s).enumerate() {
            if lag_s > 0.0 && n2 > 0.0 {
                biases.push(lag::filtered(sensor, n2, lag_s, sample_interval_s));
            }
        }
        biases.sort_by(|a, b| b.correlation_s.total_cmp(&a.correlation_s));
        let lag = |(index, bias): (usize, &Bias)| Lag::new(index, bias, lag_s[bias.sensor]);
        let mut lags: Vec<_> = biases.iter().enumerate().filter_map(lag).collect();
        lags.sort_by(|a, b| b.lag_s.total_cmp(&a.lag_s));
        Self {
            gyro: scene.gyro.clone(),
            accelerometer: scene.accelerometer.clone(),
            biases,
            white,
            lag_s,
            lags,
            quantization: squares(Source::Steps).map(|step| step / 12.0),
            sample_interval_s,
        }
    }

    /// Whether anything is random.
    pub fn are_random(&self) -> bool {
        !self.biases.is_empty() || [self.white, self.quantization] != [[0.0; SENSORS]; 2]
    }

    /// Whether noise is felt behind a bandwidth.
    pub fn are_filtered(&self) -> bool {
        !self.lags.is_empty() || self.biases.iter().any(|bias| bias.is_filtered)
    }

    /// The variance of a sensor's white noise in one sample, angle².
    pub fn noise_of_a_sample(&self, sensor: usize) -> f64 {
        let interval_s = self.sample_interval_s;
        self.white[sensor] * interval_s * lag::share_of_a_sample(self.lag_s[sensor], interval_s)
    }

    /// Whether anything is systematic.
    pub fn are_systematic(&self) -> bool {
        [&self.gyro, &self.accelerometer].into_iter().any(|errors| {
            let systematic = TERMS.iter().filter(|t| matches!(t.source, Source::Systematic(_)));
            systematic.filter_map(|term| (term.values)(errors)).any(|values| !values.are_zero())
        })
    }

    /// What the sensors read too much on average at a time, s, when they should read `rates`, and should have
    /// read `earlier` so many seconds before.
    pub fn systematic(
        &self,
        rates: &Rates<f64>,
        time_s: f64,
        earlier: &dyn Fn(f64) -> Rates<f64>,
    ) -> Rates<f64> {
        let part = |errors: &SensorErrors, of: fn(Rates<f64>) -> Vector<f64>| {
            let felt = Felt {
                x: of(*rates),
                f: rates.specific_force_b,
                warmer_k: errors.temperature.map_or(0.0, |temperature| temperature.at(time_s)),
                earlier: &|seconds| of(earlier(seconds)),
            };
            // constant + S·x − m × x + G·f + …
            let parts = TERMS.iter().filter_map(|term| match term.source {
                Source::Systematic(part) => Some(part((term.values)(errors)?, &felt)),
                _ => None,
            });
            parts.fold(Vector::ZERO, |sum, part| sum + part)
        };
        Rates {
            rate_ib_b: part(&self.gyro, |rates| rates.rate_ib_b),
            specific_force_b: part(&self.accelerometer, |rates| rates.specific_force_b),
        }
    }
}

/// The values of the term that theory takes so; 0 where it is absent.
fn values(errors: &SensorErrors, source: Source) -> [f64; 3] {
    let is_it = |term: &&Term| mem::discriminant(&term.source) == mem::discriminant(&source);
    let found = TERMS.iter().find(is_it).and_then(|term| (term.values)(errors));
    found.map_or([0.0; 3], Values::axes)
}

/// One unit of error of one sensor.
pub fn unit(sensor: usize) -> Rates<f64> {
    let [x, y, z, u, v, w] = std::array::from_fn(|i| f64::from(u8::from(i == sensor)));
    Rates { rate_ib_b: Vector::new(x, y, z), specific_force_b: Vector::new(u, v, w) }
}
