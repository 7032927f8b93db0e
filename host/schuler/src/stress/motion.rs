//! Motion: fast rotation, large acceleration, every attitude, pure coning and sculling.

use super::case::{Case, Check, Outcome};
use super::floor::{self, UNIT};
use super::flown::{fly, fly_forced, scene};
use super::residual::{self, Shape};
use schuler::earth::{EQUATORIAL_GRAVITY, SEMI_MAJOR_AXIS};
use schuler::strapdown::block::window::{H0B4A0, H2B2A2, H2B4A2, H4B4A4};
use schuler_simulator::progress::CaseProgress;
use schuler_simulator::scene::Scene;
use schuler_simulator::units::{ARCSECOND, DEGREE, STANDARD_GRAVITY};
use std::f64::consts::TAU;

const GROUP: &str = "motion";

/// From the cheapest window to the widest.
const WINDOWS: [Shape; 4] =
    [Shape::of::<H0B4A0>(), Shape::of::<H2B2A2>(), Shape::of::<H2B4A2>(), Shape::of::<H4B4A4>()];

/// The group's cases.
pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for frame in ["local-level", "earth-fixed"] {
        let mut add = |what: &str, run: fn(&str, &CaseProgress) -> Outcome| {
            cases.push(Case::new(GROUP, format!("{what}, {frame}"), move |p| run(frame, p)));
        };
        add("3600 °/s on every axis", spinning);
        add("100 g on every axis", shaken);
        add("tumbling through every attitude", tumbling);
        add("rolling at pitch +90°", |frame, p| upright(90.0, frame, p));
        add("rolling at pitch -90°", |frame, p| upright(-90.0, frame, p));
    }
    for samples in [5, 10, 20, 50] {
        for window in WINDOWS {
            let Shape { history: h, block: b, lookahead: a, .. } = window;
            cases.push(Case::new(
                GROUP,
                format!("coning, {samples} samples per cycle, window {h},{b},{a}"),
                move |p| coning(samples, window, p),
            ));
        }
    }
    for samples in [10, 20, 50] {
        for window in WINDOWS {
            let Shape { history: h, block: b, lookahead: a, .. } = window;
            cases.push(Case::new(
                GROUP,
                format!("sculling, {samples} samples per cycle, window {h},{b},{a}"),
                move |p| sculling(samples, window, p),
            ));
            cases.push(Case::new(
                GROUP,
                format!("order planned, {samples} samples per cycle, window {h},{b},{a}"),
                move |p| planned_order(samples, window, p),
            ));
        }
    }
    cases
}

/// Roll, pitch and yaw each at 62.8 rad/s, so that every axis of the body exceeds 3600 °/s.
fn spinning(frame: &str, progress: &CaseProgress) -> Outcome {
    let (duration_s, rate_hz) = (30.0, 2000.0);
    let scene = scene(&format!(
        "duration_s = {duration_s}\nrate_hz = {rate_hz}\n[trajectory]\nlatitude_deg = 45\n\
         altitude_m = 1000\nroll_deg = {{ rate = 3600 }}\npitch_deg = {{ rate = 3600 }}\n\
         yaw_deg = {{ rate = 3600 }}\n[navigator]\nframe = \"{frame}\"\n\
         window = {{ history = 2, block = 4, lookahead = 2 }}\n"
    ))?;
    let rate = 3600.0 * DEGREE;
    // Products of two angles' sines turn at twice the rate; as coning with an amplitude of 1.
    let drift = residual::coning(Shape::of::<H2B4A2>(), 2.0 * rate / rate_hz) * rate_hz;
    let turned = 3.0 * rate * duration_s;
    // The true angles are rounded themselves, to UNIT of the turns so far.
    let truth = 3.0 * UNIT * rate * duration_s;
    let tilt = EQUATORIAL_GRAVITY * drift * duration_s.powi(3) / 6.0;
    let flown = fly(&scene, progress)?;
    let floor_m = floor::free_m(duration_s);
    let attitude =
        floor::attitude_arcsec(floor_m, turned) + (truth + drift * duration_s) / ARCSECOND;
    Ok(vec![
        Check::at_most(
            "position",
            floor_m + tilt,
            flown.position_m,
            "m",
            "the floor, and the window's residual drift as tilt, gεt³/6",
        ),
        Check::at_most(
            "attitude",
            attitude,
            flown.attitude_arcsec,
            "arcsec",
            "8 roundings per radian turned, the truth's angle, the window's residual drift",
        ),
    ])
}

/// 100 g at 1 Hz along north, east and up at once.
fn shaken(frame: &str, progress: &CaseProgress) -> Outcome {
    let duration_s = 60.0;
    let amplitude_m = 100.0 * STANDARD_GRAVITY / (TAU * TAU);
    // An arc of that length, roughly: a degree of latitude is 111.1 km, of longitude 78.8 km at 45°.
    let (north, east) = (amplitude_m / 111.1e3, amplitude_m / 78.8e3);
    let scene = scene(&format!(
        "duration_s = {duration_s}\nrate_hz = 200\n[trajectory]\n\
         roll_deg = 20\npitch_deg = 10\nyaw_deg = 30\n\
         latitude_deg = {{ offset = 45, harmonics = [{{ amplitude = {north}, period_s = 1 }}] }}\n\
         longitude_deg = {{ harmonics = [{{ amplitude = {east}, period_s = 1, phase_deg = 120 }}] }}\n\
         altitude_m = {{ offset = 1000, harmonics = [{{ amplitude = {amplitude_m}, period_s = 1, \
         phase_deg = 240 }}] }}\n[navigator]\nframe = \"{frame}\"\n"
    ))?;
    Ok(fly(&scene, progress)?.floor(0.0, 1.0))
}

/// Three steady rates without a common period, at rest.
fn tumbling(frame: &str, progress: &CaseProgress) -> Outcome {
    let rates = [77.0, 90.0, 53.0];
    turning(&format!("{{ rate = {} }}", rates[1]), rates, frame, progress)
}

/// Roll and yaw about the same axis: where Euler angles end.
fn upright(pitch_deg: f64, frame: &str, progress: &CaseProgress) -> Outcome {
    turning(&format!("{pitch_deg}"), [77.0, 0.0, 53.0], frame, progress)
}

fn turning(pitch: &str, rates: [f64; 3], frame: &str, progress: &CaseProgress) -> Outcome {
    let (duration_s, [roll, _, yaw]) = (300.0, rates);
    let scene = scene(&format!(
        "duration_s = {duration_s}\nrate_hz = 100\n[trajectory]\nlatitude_deg = 45\n\
         altitude_m = 1000\nroll_deg = {{ rate = {roll} }}\npitch_deg = {pitch}\n\
         yaw_deg = {{ rate = {yaw} }}\n[navigator]\nframe = \"{frame}\"\n\
         window = {{ history = 2, block = 4, lookahead = 2 }}\n"
    ))?;
    // The truth's angles are rounded to UNIT of the turns so far: within the roundings per radian.
    let turned = rates.iter().sum::<f64>() * DEGREE * duration_s;
    Ok(fly(&scene, progress)?.floor(turned, 1.0))
}

/// Half-cone angle, frequency and acceleration of the coning and the sculling cases.
const ANGLE: f64 = DEGREE;
const FREQUENCY_HZ: f64 = 10.0;
const ACCELERATION: f64 = 10.0;
const SHAKING_S: f64 = 60.0;

fn navigator(Shape { history, block, lookahead, .. }: Shape) -> String {
    format!(
        "[navigator]\nwindow = {{ history = {history}, block = {block}, lookahead = {lookahead} }}\n"
    )
}

/// Roll in phase with an acceleration to the east, at the equator.
fn sculling_scene(samples_per_cycle: u32, window: Shape) -> Result<Scene, String> {
    let rate_hz = FREQUENCY_HZ * f64::from(samples_per_cycle);
    let amplitude_m = ACCELERATION / (TAU * FREQUENCY_HZ).powi(2);
    let east_deg = amplitude_m / SEMI_MAJOR_AXIS / DEGREE;
    scene(&format!(
        "duration_s = {SHAKING_S}\nrate_hz = {rate_hz}\n[trajectory]\n\
         roll_deg = {{ harmonics = [{{ amplitude = 1, period_s = 0.1 }}] }}\n\
         longitude_deg = {{ harmonics = [{{ amplitude = -{east_deg}, period_s = 0.1 }}] }}\n{}",
        navigator(window)
    ))
}

/// A series of an order lowered by the plan must not show: the two flights agree to the floor.
fn planned_order(samples_per_cycle: u32, window: Shape, progress: &CaseProgress) -> Outcome {
    let scene = sculling_scene(samples_per_cycle, window)?;
    let (planned, forced) = (fly(&scene, progress)?, fly_forced(&scene, progress)?);
    let apart = (planned.last_position_m - forced.last_position_m).norm();
    let why = "where an order is lowered the answer is the same to the floor";
    Ok(vec![Check::at_most("position apart", floor::free_m(SHAKING_S), apart, "m", why)])
}

/// The residual drift of a window, from its own interpolation; per sample, so over all of them.
fn coning(samples_per_cycle: u32, window: Shape, progress: &CaseProgress) -> Outcome {
    let rate_hz = FREQUENCY_HZ * f64::from(samples_per_cycle);
    let scene = scene(&format!(
        "duration_s = {SHAKING_S}\nrate_hz = {rate_hz}\n[trajectory]\nlatitude_deg = 45\n\
         roll_deg = {{ harmonics = [{{ amplitude = 1, period_s = 0.1 }}] }}\n\
         pitch_deg = {{ harmonics = [{{ amplitude = 1, period_s = 0.1, phase_deg = -90 }}] }}\n{}",
        navigator(window)
    ))?;
    let beta = TAU / f64::from(samples_per_cycle);
    let steady = residual::coning(window, beta) * rate_hz * SHAKING_S;
    // The first and the last blocks have windows of their own, and leave their third order behind; rows
    // inside a block stand off by more than its end.
    let edges = [window.first(), window.last()];
    let once: f64 = edges.iter().map(|&edge| residual::coning_block(edge, beta)).sum();
    let third: f64 = edges.iter().map(|&edge| residual::third_order(edge, beta)).sum();
    let drift = steady + once + residual::coning_within(window, beta) + third * ANGLE;
    let turned = ANGLE * TAU * FREQUENCY_HZ * SHAKING_S;
    // To 2 %, for a² is 3e-4 and the next order that much of it, times a coefficient.
    let bound = 1.02 * ANGLE * ANGLE * drift / ARCSECOND
        + floor::attitude_arcsec(floor::free_m(SHAKING_S), turned);
    let flown = fly_forced(&scene, progress)?;
    let why = "the residual of the window's interpolation and its series' end, and roundings";
    Ok(vec![Check::at_most("attitude", bound, flown.attitude_arcsec, "arcsec", why)])
}

/// Up comes what the window leaves of the product of roll and acceleration.
fn sculling(samples_per_cycle: u32, window: Shape, progress: &CaseProgress) -> Outcome {
    let rate_hz = FREQUENCY_HZ * f64::from(samples_per_cycle);
    let scene = sculling_scene(samples_per_cycle, window)?;
    let beta = TAU / f64::from(samples_per_cycle);
    // The roll also swings gravity through the body's right axis, in the same phase.
    let force = ACCELERATION + EQUATORIAL_GRAVITY * ANGLE;
    let product = ANGLE * force / (TAU * FREQUENCY_HZ);
    let steady = residual::sculling(window, beta) * rate_hz;
    let edges = [window.first(), window.last()];
    // The part at twice the frequency averages out, but not over the first and the last blocks.
    let once: f64 = edges.iter().map(|&edge| 2.0 * residual::sculling_block(edge, beta)).sum();
    let bound_m =
        1.02 * product * (0.5 * steady * SHAKING_S + once) * SHAKING_S + floor::free_m(SHAKING_S);
    let flown = fly_forced(&scene, progress)?;
    let why = "½t² of the window's interpolation and its series' end, and the floor";
    Ok(vec![Check::at_most("position", bound_m, flown.position_m, "m", why)])
}
