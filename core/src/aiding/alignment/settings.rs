//! What an alignment rests on.
//!
//! ```
//! use schuler::aiding::alignment::settings::Settings;
//! use schuler::aiding::model::Model;
//! use schuler::aiding::states::Process;
//!
//! let bias = Process::constant(1e-7_f64);
//! let settings = Settings::new(Model::new(1e-6, 1e-4, bias, bias));
//! assert_eq!(settings.heading_rad, 1.8);
//! ```

use super::base::Base;
use crate::aiding::model::Model;
use crate::math::real::Real;

/// What an alignment rests on.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Settings<R> {
    /// Noise and biases; its further states are those of the base.
    pub model: Model<R>,
    /// How the vehicle moves.
    pub base: Base<R>,
    /// Standard deviation of the first roll and pitch, rad.
    pub level_rad: R,
    /// Standard deviation of the first heading, rad.
    pub heading_rad: R,
    /// Standard deviation of the first velocity, m/s per axis.
    pub velocity_m_s: R,
}

impl<R: Real> Settings<R> {
    /// A vehicle at rest, a level that is known to some degrees, and no heading.
    pub fn new(model: Model<R>) -> Self {
        Self {
            model,
            base: Base::still(),
            level_rad: R::of(0.05),
            heading_rad: R::of(1.8),
            velocity_m_s: R::of(0.01),
        }
    }
}
