//! What is known of a recording's sensors: what a scene says of them, or what a MEMS unit is taken for.

use crate::input::InputError;
use crate::scene::{InitialError, Scene, load_sensors, parse};

/// The sections that stand for a MEMS unit, as TOML.
pub const MEMS: &str = include_str!("../../sensors/mems.toml");

/// By a scene of this name or path, or a MEMS unit.
pub fn unit(scene: Option<&str>, rate_hz: f64) -> Result<Scene, InputError> {
    let sensors = match scene {
        Some(scene) => load_sensors(scene)?,
        None => parse::sensors("mems.toml", MEMS)?,
    };
    Ok(Scene { rate_hz, ..sensors })
}

/// First standard deviations, m, m/s, rad, rad: as the filter is told; by the initial error where that is said and
/// counts; else these.
pub fn start(scene: &Scene, counts: bool, known: [f64; 4], else_: [f64; 4]) -> [f64; 4] {
    let said = counts && scene.initial_error != InitialError::default();
    std::array::from_fn(|i| {
        scene.aiding.filter.start[i].unwrap_or(if said { known[i] } else { else_[i] })
    })
}
