//! Noise behind a sensor's bandwidth: what is felt of a bias b is y, with y′ = (b − y)/T (`schuler::sensor::bandwidth`).
//!
//! White noise of density N² becomes a bias of variance N²/(2T) and correlation time T, and is a [`Bias`]. A bias that
//! moves lags by d = b − y, with d′ = b′ − d/T. With c = 1/T_b, a = 1/T and b′ = −c b + noise of density η:
//!
//! E[bd]′ = −(a + c)E[bd] + η − c E[b²],  E[d²]′ = −2a E[d²] − 2c E[bd] + η.
//!
//! The first sample is read as it is, and y begins with its mean.

use super::bias::Bias;

/// The lag of a bias that moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lag {
    /// Which of the biases.
    pub bias: usize,
    /// T, s.
    pub lag_s: f64,
}

impl Lag {
    /// Of a bias, if it moves.
    pub fn new(index: usize, bias: &Bias, lag_s: f64) -> Option<Self> {
        let stays = bias.correlation_s == f64::INFINITY && bias.walk == 0.0;
        let lags = lag_s > 0.0 && !stays && !bias.is_filtered;
        lags.then_some(Self { bias: index, lag_s })
    }

    /// E[by] and E[y²] at a time, and so long after the first sample, s.
    pub fn moments(&self, bias: &Bias, time_s: f64, after_s: f64) -> [f64; 2] {
        let (a, c) = (self.lag_s.recip(), bias.correlation_s.recip());
        // η, and η − c E[b²]
        let noise = 2.0 * c * bias.variance + bias.walk;
        let push = c * bias.variance + bias.walk;
        let steady = push / (a + c);
        let with_bias = steady * -(-(a + c) * after_s).exp_m1();
        let square = (noise - 2.0 * c * steady) * -(-2.0 * a * after_s).exp_m1() / (2.0 * a)
            + 2.0 * c * steady * between(a + c, 2.0 * a, after_s);
        let bias_square = bias.square(time_s, after_s);
        [bias_square - with_bias, bias_square - 2.0 * with_bias + square]
    }

    /// Σ as in `Fast`, of a bias that is faster than a step, as its lag is. With E[by] = E[y²] = σ²T_b/(T_b + T),
    /// (I/T_b − F)p = g E[by] and (I/T − F)q = g E[y²] + p/T.
    pub fn powers(&self, bias: &Bias) -> [f64; 3] {
        let (t, b) = (self.lag_s, bias.correlation_s);
        let square = bias.variance * b / (b + t);
        [t + b, b * b + t * (t + b), b * b * b + t * b * b + t * t * (t + b)].map(|x| square * x)
    }
}

/// White noise of density N² behind a lag T, with samples of so many seconds.
pub fn filtered(sensor: usize, n2: f64, lag_s: f64, interval_s: f64) -> Bias {
    let variance = n2 / (2.0 * lag_s);
    Bias {
        sensor,
        variance,
        walk: 0.0,
        correlation_s: lag_s,
        is_filtered: true,
        early: n2 / interval_s - variance,
    }
}

/// The variance of white noise in a sample behind a lag, over that before it.
pub fn share_of_a_sample(lag_s: f64, interval_s: f64) -> f64 {
    if lag_s == 0.0 {
        return 1.0;
    }
    // (1 − u/h)² + (u/h)²u/(2 − u), h = Δt/T, u = 1 − e^{−h}
    let h = interval_s / lag_s;
    let u = -(-h).exp_m1();
    let share = u / h;
    (1.0 - share).powi(2) + share * share * u / (2.0 - u)
}

/// (e^{−kt} − e^{−lt})/(l − k), which is t e^{−kt} where k = l.
fn between(k: f64, l: f64, t: f64) -> f64 {
    let apart = (k - l).abs() * t;
    let slower = (-k.min(l) * t).exp() * t;
    if apart > 0.0 { slower * -(-apart).exp_m1() / apart } else { slower }
}
