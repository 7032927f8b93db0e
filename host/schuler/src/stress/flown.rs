//! A scene flown as `schuler run` flies it: from its text, through the parser, or built in.

use super::case::Check;
use super::floor;
use schuler::math::vector::Vector;
use schuler_simulator::flight::Instant;
use schuler_simulator::progress::CaseProgress;
use schuler_simulator::scene::{Scene, builtin, parse};
use schuler_simulator::simulate::{self, largest};

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
    /// Of the level alone, ″: next to a pole the heading is the position's.
    pub tilt_arcsec: f64,
    /// At the end, ″.
    pub last_attitude_arcsec: f64,
    /// Drift at the end, north, east, down, m.
    pub last_position_m: Vector<f64>,
    duration_s: f64,
}

impl Flown {
    /// Position against the floor of rounding.
    pub fn position(&self) -> Check {
        let bound_m = floor::free_m(self.duration_s);
        Check::at_most("position", bound_m, self.position_m, "m", floor::FREE_WHY)
    }

    /// An attitude against it, for a body that turned by some angle, rad, at some tangent of the latitude
    /// at most: that is how east turns into heading.
    pub fn attitude(&self, what: &str, measured: f64, turned: f64, tangent: f64) -> Check {
        let position_m = floor::free_m(self.duration_s) * tangent.max(1.0);
        let bound = floor::attitude_arcsec(position_m, turned);
        Check::at_most(what, bound, measured, "arcsec", floor::ATTITUDE_WHY)
    }

    /// Both.
    pub fn floor(&self, turned: f64, tangent: f64) -> Vec<Check> {
        let attitude = self.attitude("attitude", self.attitude_arcsec, turned, tangent);
        vec![self.position(), attitude]
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

/// Flies a scene with nothing skipped: every window with its full series.
pub fn fly_forced(scene: &Scene, progress: &CaseProgress) -> Result<Flown, String> {
    flown(scene, true, progress, &mut |_| ())
}

/// Flies a scene and shows every instant.
pub fn watch(
    scene: &Scene,
    progress: &CaseProgress,
    see: &mut dyn FnMut(&Instant),
) -> Result<Flown, String> {
    flown(scene, false, progress, see)
}

fn flown(
    scene: &Scene,
    force_all: bool,
    progress: &CaseProgress,
    see: &mut dyn FnMut(&Instant),
) -> Result<Flown, String> {
    let all = scene.samples();
    let (mut horizontal_m, mut tilt_arcsec) = (0.0_f64, 0.0_f64);
    let mut observe = |instant: &Instant| {
        let [north, east, _] = instant.drift.position_m;
        let [roll, pitch, _] = instant.drift.attitude_arcsec;
        horizontal_m = largest(horizontal_m, north.hypot(east));
        tilt_arcsec = largest(tilt_arcsec, roll.hypot(pitch));
        see(instant);
        Ok(())
    };
    let flight = simulate::fly(scene, force_all, &mut observe, &|n| progress.reach(n, all))
        .map_err(|error| error.to_string())?;
    let [position_m, velocity_m_s, attitude_arcsec] = flight.max.norms;
    let [roll, pitch, yaw] = flight.last.drift.attitude_arcsec;
    Ok(Flown {
        position_m,
        horizontal_m,
        velocity_m_s,
        attitude_arcsec,
        tilt_arcsec,
        last_attitude_arcsec: roll.hypot(pitch).hypot(yaw),
        last_position_m: flight.last.drift.position_m.into(),
        duration_s: scene.duration_s,
    })
}
