//! What aids a navigator: sensors beside the inertial unit, and the filter that takes their measurements.

use schuler::aiding::aided::settings::Lockout;
use schuler::sensor::aiding::barometer::Barometer;
use schuler::sensor::aiding::gnss::Gnss;
use schuler::sensor::aiding::odometer::Odometer;
use schuler::sensor::aiding::still::Still;
use schuler::sensor::aiding::wheels::Wheels;

/// The sensors that aid a navigator, and its filter.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Aiding {
    /// A satellite receiver.
    pub gnss: Option<Gnss<f64>>,
    /// A barometer.
    pub barometer: Option<Barometer<f64>>,
    /// An odometer.
    pub odometer: Option<Odometer<f64>>,
    /// What says that the vehicle stands still.
    pub still: Option<Still<f64>>,
    /// Wheels, which go neither sideways nor up.
    pub wheels: Option<Wheels<f64>>,
    /// How they are filtered.
    pub filter: Filtering,
}

impl Aiding {
    /// Whether there is any sensor.
    pub fn is_there(&self) -> bool {
        self.gnss.is_some()
            || self.barometer.is_some()
            || self.odometer.is_some()
            || self.still.is_some()
            || self.wheels.is_some()
    }
}

/// How measurements are filtered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Filtering {
    /// Standard deviation of the lever arm's error, m, if that is estimated.
    pub lever_arm_m: Option<f64>,
    /// Standard deviation of the receiver's latency, s, if that is estimated.
    pub latency_s: Option<f64>,
    /// How often a vector that fits is refused.
    pub false_refusal: f64,
    /// Refusals in a row that are a lockout.
    pub patience: u32,
    /// What a lockout leads to.
    pub lockout: Lockout,
    /// How long measurements wait for others, s.
    pub horizon_s: Option<f64>,
    /// Whether the flight is smoothed afterwards.
    pub smoother: bool,
    /// First standard deviations: position, m; velocity, m/s; level and heading, rad. Absent: those of the initial
    /// error.
    pub start: [Option<f64>; 4],
}

impl Default for Filtering {
    fn default() -> Self {
        Self {
            lever_arm_m: None,
            latency_s: None,
            false_refusal: 1e-4,
            patience: 5,
            lockout: Lockout::Inflate,
            horizon_s: None,
            smoother: false,
            start: [None; 4],
        }
    }
}
