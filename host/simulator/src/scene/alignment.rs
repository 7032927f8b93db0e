//! An alignment that comes before navigation.

use schuler::aiding::states::resonator::Resonator;
use std::f64::consts::TAU;

/// A swell of seven seconds, about 0.3 m high.
const SWELL: Resonator<f64> = Resonator { rms_m: 0.2, rate: TAU / 7.0, damping: 0.03 };

/// Samples of a block of the navigator that is aligned: an alignment ends where one does.
pub const BLOCK: u64 = 4;

/// An alignment that comes before navigation, on the scene's own motion and sensors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alignment {
    /// How long, s.
    pub duration_s: f64,
    /// What is known of the motion meanwhile.
    pub base: Base,
    /// Standard deviation of the first heading, rad; `None` if nothing is known of it.
    pub heading_sigma_rad: Option<f64>,
    /// Of a base that sways: how.
    pub sway: Resonator<f64>,
    /// Of a base that moves: standard deviation of a measured velocity, m/s per axis.
    pub velocity_sigma_m_s: f64,
    /// Of a base that moves: time from one measured velocity to the next, s.
    pub velocity_interval_s: f64,
}

impl Alignment {
    /// A vehicle at rest of whose heading nothing is known.
    pub const fn new(duration_s: f64) -> Self {
        Self {
            duration_s,
            base: Base::Still,
            heading_sigma_rad: None,
            sway: SWELL,
            velocity_sigma_m_s: 0.05,
            velocity_interval_s: 1.0,
        }
    }
}

/// What is known of the motion while a vehicle is aligned.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Base {
    /// It stands still, or turns about itself: "still".
    #[default]
    Still,
    /// It sways about its place: "swaying".
    Swaying,
    /// It moves, and its velocity is measured: "moving".
    Moving,
}

super::navigator::names!(Base: Still = "still", Swaying = "swaying", Moving = "moving");
