//! Mean and covariance of the error state, and their differential equations.
//!
//! Sensor errors stay independent scalars, so their own covariance is known in closed form. Only their
//! covariance with the navigation errors is integrated, nine numbers for each.

use super::course::{Course, Covariance, Instant};
use super::sources::{SENSORS, Sources, unit};
use schuler::drift::linear::ErrorState;
use schuler::math::quaternion::Matrix;
use schuler::math::vector::Vector;

/// First and second moments of the error.
#[derive(Clone, Default)]
pub struct Moments {
    /// m = E[x].
    pub mean: ErrorState<f64>,
    /// P = E[(x − m)(x − m)ᵀ].
    pub covariance: Covariance,
    /// What second-order terms in attitude, which the model leaves out, would add to the mean.
    pub second: ErrorState<f64>,
    /// p = E[(x − m)b] for each of the slow biases.
    pub cross: Vec<ErrorState<f64>>,
}

/// Biases that are faster than a step, and white noise, summed over a sensor: E[(x − m)b] follows from
/// b at once, (I/T − F)p = g σ², so p = Σ σ²T(I + TF + T²F²)g. White noise N² is σ²T = ½N², T → 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fast {
    /// Σσ²T, Σσ²T², Σσ²T³ of each sensor.
    pub powers: [[f64; 3]; SENSORS],
}

impl Fast {
    /// White noise, and the biases after the first `slow` ones.
    pub fn new(sources: &Sources, slow: usize) -> Self {
        let mut powers = sources.white.map(|n2| [0.5 * n2, 0.0, 0.0]);
        for bias in &sources.biases[slow..] {
            let mut term = bias.variance;
            for power in &mut powers[bias.sensor] {
                term *= bias.correlation_s;
                *power += term;
            }
        }
        Self { powers }
    }
}

impl Moments {
    /// self + k·rate.
    pub fn advance(&mut self, rate: &Self, k: f64) {
        self.mean = self.mean + rate.mean * k;
        self.second = self.second + rate.second * k;
        for (row, growth) in self.covariance.iter_mut().zip(&rate.covariance) {
            for (entry, growth) in row.iter_mut().zip(growth) {
                *entry += k * growth;
            }
        }
        for (cross, growth) in self.cross.iter_mut().zip(&rate.cross) {
            *cross = *cross + *growth * k;
        }
    }

    /// Becomes a copy of another, keeping its memory.
    pub fn copy(&mut self, other: &Self) {
        self.mean = other.mean;
        self.second = other.second;
        self.covariance = other.covariance;
        self.cross.clone_from(&other.cross);
    }

    /// E[ψψᵀ].
    fn attitude_square(&self) -> Matrix<f64> {
        let mean = self.mean.attitude.into_array();
        let row = |i: usize| {
            Vector::from(std::array::from_fn(|j| self.covariance[6 + i][6 + j] + mean[i] * mean[j]))
        };
        Matrix { rows: [row(0), row(1), row(2)] }
    }

    /// How fast the moments change at an instant of a course.
    pub fn rate(&self, at: &Instant, course: &Course, fast: &Fast, to: &mut Self) {
        let (dynamics, sources) = (&at.dynamics, &course.sources);
        // ṁ = F m + G u
        to.mean = dynamics.growth(&self.mean) + dynamics.drive(&at.systematic);
        to.second = dynamics.growth(&self.second) + dynamics.second_order(&self.attitude_square());
        if !course.random {
            return;
        }
        // With q = Σ p over a sensor's biases and ½N²g for its white noise, and
        // H = F P + Σ q gᵀ, the covariance grows by Ṗ = H + Hᵀ.
        let drive: [_; SENSORS] = std::array::from_fn(|i| dynamics.drive(&unit(i)));
        let mut pull = [ErrorState::default(); SENSORS];
        for ((sensor, g), powers) in pull.iter_mut().zip(&drive).zip(fast.powers) {
            if powers != [0.0; 3] {
                let fg = dynamics.growth(g);
                let ffg = dynamics.growth(&fg);
                *sensor = *g * powers[0] + fg * powers[1] + ffg * powers[2];
            }
        }
        to.cross.truncate(self.cross.len());
        for ((p, bias), growth) in self.cross.iter().zip(&sources.biases).zip(&mut to.cross) {
            // ṗ = F p + g E[b²] − p/T
            let variance = bias.variance + bias.walk * at.time_s;
            *growth = dynamics.growth(p)
                + drive[bias.sensor] * variance
                + *p * -bias.correlation_s.recip();
            pull[bias.sensor] = pull[bias.sensor] + *p;
        }
        let mut half = self.covariance.map(|row| dynamics.growth(&row.into()).into_array());
        let mut couple = |a: ErrorState<f64>, b: ErrorState<f64>, k: f64| {
            let a = a.into_array();
            for (row, b) in half.iter_mut().zip(b.into_array()) {
                let kb = k * b;
                if kb != 0.0 {
                    for (entry, a) in row.iter_mut().zip(a) {
                        *entry += a * kb;
                    }
                }
            }
        };
        for ((q, g), index) in pull.into_iter().zip(drive).zip(0..) {
            couple(q, g, 1.0);
            let q2 = sources.quantization[index];
            if q2 != 0.0 {
                // A step's rounding e stays in the integral until the next one's: white, of
                // density Q²τ₀, on F·G − Ġ; its direct share G·e is added on reading.
                let turned = dynamics.drive_of_integral(&unit(index));
                couple(turned, turned, 0.5 * q2 * sources.sample_interval_s);
            }
        }
        to.covariance = std::array::from_fn(|i| std::array::from_fn(|j| half[i][j] + half[j][i]));
    }
}
