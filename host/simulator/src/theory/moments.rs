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
    /// q = E[(x − m)y] for each bias that is felt as y, behind a bandwidth.
    pub behind: Vec<ErrorState<f64>>,
}

/// Biases that are faster than a step, and white noise, summed over a sensor: E[(x − m)b] follows from
/// b at once, (I/T − F)p = g σ², so p = Σ σ²T(I + TF + T²F²)g. White noise N² is σ²T = ½N², T → 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fast {
    /// Σσ²T, Σσ²T², Σσ²T³ of each sensor.
    pub powers: [[f64; 3]; SENSORS],
}

impl Fast {
    /// White noise, and the biases after the first `slow` ones, but those behind one of the first `lagging` lags.
    pub fn new(sources: &Sources, slow: usize, lagging: usize) -> Self {
        let mut powers = std::array::from_fn(|sensor| {
            let n2 = if sources.lag_s[sensor] > 0.0 { 0.0 } else { sources.white[sensor] };
            [0.5 * n2, 0.0, 0.0]
        });
        for (index, bias) in sources.biases.iter().enumerate().skip(slow) {
            let mut own = [bias.variance; 3];
            let mut term = bias.variance;
            for power in &mut own {
                term *= bias.correlation_s;
                *power = term;
            }
            if let Some(lag) = sources.lags.iter().position(|lag| lag.bias == index) {
                own = if lag < lagging { [0.0; 3] } else { sources.lags[lag].powers(bias) };
            }
            for (power, own) in powers[bias.sensor].iter_mut().zip(own) {
                *power += own;
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
        for (behind, growth) in self.behind.iter_mut().zip(&rate.behind) {
            *behind = *behind + *growth * k;
        }
    }

    /// Becomes a copy of another, keeping its memory.
    pub fn copy(&mut self, other: &Self) {
        self.mean = other.mean;
        self.second = other.second;
        self.covariance = other.covariance;
        self.cross.clone_from(&other.cross);
        self.behind.clone_from(&other.behind);
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
        // So long after the first sample, which a bandwidth takes as it is.
        let after_s = at.time_s - sources.sample_interval_s;
        to.cross.truncate(self.cross.len());
        for ((p, bias), growth) in self.cross.iter().zip(&sources.biases).zip(&mut to.cross) {
            // ṗ = F p + g E[b²] − p/T
            let variance = bias.square(at.time_s, after_s.max(0.0));
            let stays = bias.is_filtered && after_s < 0.0;
            let decay = if stays { 0.0 } else { bias.correlation_s.recip() };
            *growth = dynamics.growth(p) + drive[bias.sensor] * variance + *p * -decay;
            pull[bias.sensor] = pull[bias.sensor] + *p;
        }
        to.behind.truncate(self.behind.len());
        for (index, lag) in sources.lags.iter().enumerate() {
            let bias = &sources.biases[lag.bias];
            let (g, pull) = (&drive[bias.sensor], &mut pull[bias.sensor]);
            let [by, square] = lag.moments(bias, at.time_s, after_s.max(0.0));
            let (decay, faster) = (bias.correlation_s.recip(), lag.lag_s.recip());
            let follow = |e: ErrorState<f64>, t: f64| (e + dynamics.growth(&e) * t) * t;
            let p = match (self.cross.get(lag.bias), to.cross.get_mut(lag.bias)) {
                (Some(p), Some(growth)) => {
                    // ṗ has g E[by]; what was felt of it was b.
                    *growth = *growth + *g * (by - bias.square(at.time_s, after_s.max(0.0)));
                    *pull = *pull + *p * -1.0;
                    *p
                }
                _ if index >= self.behind.len() => continue,
                // p = T_b(I + T_b F)g E[by]
                _ => follow(*g * by, bias.correlation_s),
            };
            match (self.behind.get(index), to.behind.get_mut(index)) {
                (Some(q), Some(growth)) => {
                    // q̇ = F q + g E[y²] + (p − q)/T; in the first sample y is b.
                    let pulled = if after_s < 0.0 { p * -decay } else { (p + *q * -1.0) * faster };
                    *growth = dynamics.growth(q) + *g * square + pulled;
                    *pull = *pull + *q;
                }
                // q = p − T(I + TF)(g E[y(b − y)] − p/T_b)
                _ => *pull = *pull + p + follow(*g * (square - by) + p * decay, lag.lag_s),
            }
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
