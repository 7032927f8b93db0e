//! Motion that the sampling does not resolve, noise and coarse steps: no window may spoil a flight.

use super::case::{Case, Check, Outcome};
use super::floor;
use super::flown::{built_in, fly, scene};
use super::residual::{self, Shape};
use schuler::earth::EQUATORIAL_GRAVITY;
use schuler::strapdown::block::window::{H2B4A2, H4B4A4};
use schuler_simulator::progress::CaseProgress;
use schuler_simulator::scene::{Algorithm, Axes, Scene, WindowShape};
use schuler_simulator::units::{ARCSECOND, DEGREE, DEGREE_PER_ROOT_HOUR};
use std::f64::consts::TAU;

const GROUP: &str = "motion";
const RATE_HZ: f64 = 100.0;
const CONE_S: f64 = 60.0;

/// What noise and steps are tried with: with look-ahead, without, lines and parabolas.
const TRIED: [(usize, usize, usize); 9] = [
    (0, 2, 0),
    (2, 2, 0),
    (2, 2, 2),
    (4, 4, 0),
    (2, 4, 2),
    (4, 4, 4),
    (0, 8, 0),
    (0, 12, 0),
    (0, 40, 0),
];

/// The group's cases.
pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for frame in [Axes::LocalLevel, Axes::EarthFixed] {
        let name = frame.name();
        for angle_deg in [0.1, 1.0] {
            for samples in [2.2, 2.5, 3.0, 4.0, 6.0, 10.0] {
                let what = format!("cone of {angle_deg}°, {samples} samples per cycle, {name}");
                let case = Case::new(GROUP, what, move |p| cone(angle_deg, samples, frame, p));
                let short = angle_deg < 1.0 && frame == Axes::LocalLevel;
                cases.push(if short { case } else { case.long() });
            }
        }
        for (noise, step_arcsec, step_m_s) in [
            (0.1, 0.0, 0.0),
            (30.0, 0.0, 0.0),
            (0.0, 100.0, 0.05),
            (0.0, 1000.0, 0.05),
            (0.0, 0.0, 0.05),
        ] {
            for duration_s in [0.5, 0.55, 10.65] {
                let what = format!(
                    "{noise} °/√h, steps of {step_arcsec}″ and {step_m_s} m/s, {duration_s} s, {name}"
                );
                let sensors = Sensors { noise, step_arcsec, step_m_s };
                let case = Case::new(GROUP, what, move |p| erring(sensors, duration_s, frame, p));
                cases.push(if frame == Axes::LocalLevel { case } else { case.long() });
            }
        }
    }
    cases
}

/// Roll and pitch as cosines, pitch a quarter ahead.
fn cone_scene(angle_deg: f64, samples_per_cycle: f64, frame: Axes) -> Result<Scene, String> {
    let period_s = samples_per_cycle / RATE_HZ;
    let mut scene = scene(&format!(
        "duration_s = {CONE_S}\nrate_hz = {RATE_HZ}\n[trajectory]\nlatitude_deg = 45\n\
         roll_deg = {{ harmonics = [{{ amplitude = {angle_deg}, period_s = {period_s} }}] }}\n\
         pitch_deg = {{ harmonics = [{{ amplitude = {angle_deg}, period_s = {period_s}, \
         phase_deg = 90 }}] }}\n"
    ))?;
    scene.navigator.frame = frame;
    Ok(scene)
}

/// Against the textbook, which follows such a motion badly and never runs away from it.
fn cone(angle_deg: f64, samples: f64, frame: Axes, progress: &CaseProgress) -> Outcome {
    let mut scene = cone_scene(angle_deg, samples, frame)?;
    let planned = fly(&scene, progress)?.position_m;
    let mut checks = Vec::new();
    scene.navigator.algorithm = Algorithm::Textbook;
    let textbook_m = fly(&scene, progress)?.position_m;
    scene.navigator.algorithm = Algorithm::Taylor;
    let part = if samples < 6.0 { 1.5 } else { 0.1 };
    let mut check = |what: &str, shape: Shape, measured: f64| {
        let bound_m = (part * textbook_m).max(locked_m(shape, angle_deg * DEGREE, samples));
        let why = "1.5 times the textbook, from 6 samples per cycle on a tenth; or, where blocks meet \
                   the motion in a few phases only, what the window's interpolation leaves in them";
        checks.push(Check::at_most(what, bound_m, measured, "m", why));
    };
    check("window planned", Shape::of::<H4B4A4>(), planned);
    for shape in [Shape::of::<H2B4A2>(), Shape::of::<H4B4A4>()] {
        let Shape { history, block, lookahead, .. } = shape;
        scene.navigator.window = Some(WindowShape { history, block, lookahead });
        let what = format!("window {history},{block},{lookahead}");
        check(&what, shape, fly(&scene, progress)?.position_m);
    }
    Ok(checks)
}

/// Where a block's length times a harmonic of the motion is a whole number of cycles, its error does not
/// average out: an acceleration, and a turning tilt, m.
fn locked_m(shape: Shape, angle: f64, samples_per_cycle: f64) -> f64 {
    let beta = TAU / samples_per_cycle;
    let cycles = shape.block as f64 / samples_per_cycle;
    let is_locked = |harmonic: f64| (harmonic * cycles - (harmonic * cycles).round()).abs() < 1e-9;
    // ½g·a·(∫δα dt/T)·t² of the angle itself, ⅙g·a³(δε/T)·t³ of the third order, whose harmonic is the third
    let block = shape.block as f64;
    let first = residual::first_order(shape, beta) / block * angle;
    let third = residual::third_order(shape, beta) / block * RATE_HZ * angle * angle * angle;
    let level = if is_locked(1.0) { 0.5 * first * CONE_S * CONE_S } else { 0.0 };
    let tilt = if is_locked(3.0) { third * CONE_S * CONE_S * CONE_S / 6.0 } else { 0.0 };
    EQUATORIAL_GRAVITY * (level + tilt) + floor::free_m(CONE_S)
}

/// White noise of gyros, °/√h, and the steps of gyros and accelerometers.
#[derive(Clone, Copy)]
struct Sensors {
    noise: f64,
    step_arcsec: f64,
    step_m_s: f64,
}

/// Every window against four samples to a block, whose edges are like any of its blocks.
fn erring(sensors: Sensors, duration_s: f64, frame: Axes, progress: &CaseProgress) -> Outcome {
    let positive = |x: f64| (x > 0.0).then_some([x; 3]);
    let mut scene = built_in("paper", |scene| {
        scene.duration_s = duration_s;
        scene.navigator.frame = frame;
        scene.gyro.white = positive(sensors.noise * DEGREE_PER_ROOT_HOUR);
        scene.gyro.quantization = positive(sensors.step_arcsec * ARCSECOND);
        scene.accelerometer.quantization = positive(sensors.step_m_s);
    })?;
    let mut squares = |(history, block, lookahead)| -> Result<f64, String> {
        scene.navigator.window = Some(WindowShape { history, block, lookahead });
        let mut sum = 0.0;
        for seed in 1..=8 {
            scene.seed = seed;
            let position_m = fly(&scene, progress)?.last_position_m.norm();
            sum += position_m * position_m;
        }
        Ok(sum)
    };
    let four = squares((0, 4, 0))?;
    let mut worst: f64 = 0.0;
    for shape in TRIED {
        worst = schuler_simulator::simulate::largest(worst, (squares(shape)? / four).sqrt());
    }
    let why = "rms over eight seeds against that of 0,4,0: the sums are the same, edges must not add to them";
    Ok(vec![Check::at_most("worst window over 0,4,0", 1.5, worst, "", why)])
}
