//! Nine numbers of a drift, in the units of files.

use crate::units::ARCSECOND;

/// Nine numbers about one instant: position, velocity and attitude in north, east, down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Nine {
    /// m.
    pub position_m: [f64; 3],
    /// m/s.
    pub velocity_m_s: [f64; 3],
    /// Rotation vector, arcsec.
    pub attitude_arcsec: [f64; 3],
}

impl Nine {
    /// Standard deviations by the covariance of a drift; m, m/s, rad.
    pub fn of_covariance(covariance: &[[f64; 9]; 9]) -> Self {
        let three = |first: usize, unit: f64| {
            std::array::from_fn(|i| covariance[first + i][first + i].max(0.0).sqrt() / unit)
        };
        Self {
            position_m: three(0, 1.0),
            velocity_m_s: three(3, 1.0),
            attitude_arcsec: three(6, ARCSECOND),
        }
    }

    /// What files call the nine, in order.
    pub const NAMES: [&str; 9] = [
        "north_m",
        "east_m",
        "down_m",
        "north_m_s",
        "east_m_s",
        "down_m_s",
        "attitude_north_arcsec",
        "attitude_east_arcsec",
        "attitude_down_arcsec",
    ];

    /// What files call their standard deviations, in order.
    pub const SIGMAS: [&str; 9] = [
        "north_m_sigma",
        "east_m_sigma",
        "down_m_sigma",
        "north_m_s_sigma",
        "east_m_s_sigma",
        "down_m_s_sigma",
        "attitude_north_arcsec_sigma",
        "attitude_east_arcsec_sigma",
        "attitude_down_arcsec_sigma",
    ];

    /// What the last three were called before, though they are no errors of Euler's angles.
    pub const FORMER: [&str; 3] = ["roll_arcsec", "pitch_arcsec", "yaw_arcsec"];

    /// Where there is nothing to say.
    pub const UNKNOWN: Self = Self {
        position_m: [f64::NAN; 3],
        velocity_m_s: [f64::NAN; 3],
        attitude_arcsec: [f64::NAN; 3],
    };

    /// In the order of [`Nine::NAMES`].
    pub fn numbers(&self) -> [f64; 9] {
        let parts = [self.position_m, self.velocity_m_s, self.attitude_arcsec];
        std::array::from_fn(|i| parts[i / 3][i % 3])
    }
}
