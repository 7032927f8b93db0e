//! A random bias of one sensor.

/// A random bias b of one sensor: E[b²] = variance + walk·t, decaying as e^{−t/T}. What white noise becomes behind a
/// bandwidth begins with the first sample's, and E[b²] = variance + early·e^{−2t/T} after it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bias {
    /// Which of the six sensors.
    pub sensor: usize,
    /// At the start, (angle/s)².
    pub variance: f64,
    /// Growth of the variance, (angle/s)²/s.
    pub walk: f64,
    /// T, s; infinite for a bias that stays.
    pub correlation_s: f64,
    /// Whether it is white noise behind a bandwidth.
    pub is_filtered: bool,
    /// By how much the variance begins above, (angle/s)².
    pub early: f64,
}

impl Bias {
    /// E[b²] at a time, and so long after the first sample, s.
    pub fn square(&self, time_s: f64, after_s: f64) -> f64 {
        let variance = self.variance + self.walk * time_s;
        match self.is_filtered {
            true => variance + self.early * (-2.0 * after_s / self.correlation_s).exp(),
            false => variance,
        }
    }
}
