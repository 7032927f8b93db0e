//! A scene flown as `schuler run` flies it: from its text, through the parser, or built in.

use super::case::Check;
use super::floor;
use crate::flight::Instant;
use crate::progress::CaseProgress;
use crate::scene::{Scene, builtin, parse};
use crate::simulate;

/// The largest errors over every sample of a flight.
#[derive(Clone, Copy, Debug)]
pub struct Flown {
    /// m.
    pub position_m: f64,
    /// Of north and east alone, m.
    pub horizontal_m: f64,
    /// m/s.
    pub velocity_m_s: f64,
    /// ″.
    pub attitude_arcsec: f64,
}

impl Flown {
    /// Position and attitude against the floor, for a body that turned by some angle, rad, at some
    /// tangent of the latitude at most: that is how east turns into heading.
    pub fn floor(&self, turned: f64, tangent: f64) -> Vec<Check> {
        let position_m = floor::POSITION_M;
        vec![
            Check::at_most("position", position_m, self.position_m, "m", floor::POSITION_WHY),
            Check::at_most(
                "attitude",
                floor::attitude_arcsec(position_m * tangent.max(1.0), turned),
                self.attitude_arcsec,
                "arcsec",
                floor::ATTITUDE_WHY,
            ),
        ]
    }
}

/// A scene from its text.
pub fn scene(text: &str) -> Result<Scene, String> {
    parse::scene("stress.toml", text).map_err(|error| error.to_string())
}

/// A built-in scene with perfect sensors, changed.
pub fn built_in(name: &str, change: impl FnOnce(&mut Scene)) -> Result<Scene, String> {
    let mut scene = builtin::scene(name).ok_or_else(|| format!("there is no scene {name}"))?;
    (scene.gyro, scene.accelerometer) = Default::default();
    change(&mut scene);
    Ok(scene)
}

/// Flies a scene.
pub fn fly(scene: &Scene, progress: &CaseProgress) -> Result<Flown, String> {
    watch(scene, progress, &mut |_| ())
}

/// Flies a scene and shows every instant.
pub fn watch(
    scene: &Scene,
    progress: &CaseProgress,
    see: &mut dyn FnMut(&Instant),
) -> Result<Flown, String> {
    let all = scene.samples();
    let mut horizontal_m: f64 = 0.0;
    let mut observe = |instant: &Instant| {
        let [north, east, _] = instant.drift.position_m;
        horizontal_m = horizontal_m.max(north.hypot(east));
        see(instant);
        Ok(())
    };
    let flight = simulate::fly(scene, false, &mut observe, &|n| progress.reach(n, all))
        .map_err(|error| error.to_string())?;
    let [position_m, velocity_m_s, attitude_arcsec] = flight.max.norms;
    Ok(Flown { position_m, horizontal_m, velocity_m_s, attitude_arcsec })
}
