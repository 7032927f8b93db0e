//! The link: samples that are early, late or lost.

use super::case::{Case, Check, Outcome};
use super::floor;
use super::flown::{built_in, fly, scene};
use super::time::{FOUR, GROUP, at_rest};
use schuler::earth::{EQUATORIAL_GRAVITY, ROTATION_RATE, SEMI_MAJOR_AXIS};
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler_simulator::progress::CaseProgress;
use schuler_simulator::scene::{Gap, Scene};
use schuler_simulator::simulate::{self, FlightError, largest};
use schuler_simulator::source::Source;
use schuler_simulator::units::{ARCSECOND, DEGREE};
use std::f64::consts::TAU;

/// Its cases.
pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    cases.push(Case::new(GROUP, "jitter of 0.1 ms at rest, 100 Hz", jitter_at_rest));
    cases.push(Case::new(GROUP, "jitter of 1 ms cruising, 50 Hz", jitter_cruising));
    for loss in [0.01, 0.1, 0.3] {
        cases.push(Case::new(GROUP, format!("{loss} of samples lost, bridged"), move |p| {
            bridged(loss, p)
        }));
    }
    cases.push(Case::new(GROUP, "a lost sample that is not bridged", not_bridged));
    cases
}

/// Deviates of this many sigma are not met within some thousand samples.
const MOST_SIGMA: f64 = 5.0;

/// A sample's end that is late by j leaves v·j, and f·j in velocity until the next: g·h·Σj by and by,
/// weighted like Boole's rule within blocks, 1.09 rms.
fn jittered(scene: &Scene, speed: f64, turning: f64, progress: &CaseProgress) -> Outcome {
    let jitter_s = scene.link.jitter_s;
    let walk = 1.09 * EQUATORIAL_GRAVITY / scene.rate_hz * (scene.samples() as f64).sqrt();
    let position_m = MOST_SIGMA * jitter_s * (speed + walk);
    let velocity = MOST_SIGMA * jitter_s * EQUATORIAL_GRAVITY;
    let attitude = MOST_SIGMA * jitter_s * turning / ARCSECOND;
    let flown = fly(scene, progress)?;
    let why = "5 sigma of v·j and of g·h·Σj; g·j; ω·j";
    Ok(vec![
        Check::at_most("position", position_m, flown.position_m, "m", why),
        Check::at_most("velocity", velocity, flown.velocity_m_s, "m/s", why),
        Check::at_most("attitude", attitude, flown.attitude_arcsec, "arcsec", why),
    ])
}

fn jitter_at_rest(progress: &CaseProgress) -> Outcome {
    let mut scene = at_rest(60.0, 100.0)?;
    scene.link.jitter_s = 1e-4;
    scene.navigator.window = Some(FOUR);
    jittered(&scene, 0.0, ROTATION_RATE, progress)
}

fn jitter_cruising(progress: &CaseProgress) -> Outcome {
    let scene = built_in("cruise-180", |scene| {
        scene.duration_s = 120.0;
        scene.link.jitter_s = 1e-3;
        scene.navigator.window = Some(FOUR);
    })?;
    // 250 m/s; pitch 0.5° every 40 s, yaw 4.8° and roll 1.3° every 600 s; the Earth and its curvature
    let swing = |degrees: f64, period_s: f64| degrees * DEGREE * TAU / period_s;
    let turning = swing(0.5, 40.0) + swing(4.8, 600.0) + swing(1.3, 600.0);
    jittered(&scene, 250.0, turning + ROTATION_RATE + 250.0 / SEMI_MAJOR_AXIS, progress)
}

/// Samples lost with probability p and bridged by straight lines: with x″ the largest second difference
/// of increments, a gap of m adds x″m(m+1)(m+2)/12, which is x″p/2(1−p)² per sample on average.
fn bridged(loss: f64, progress: &CaseProgress) -> Outcome {
    let scene = built_in("paper-perfect", |scene| {
        scene.link.loss = loss;
        scene.navigator.gap = Gap::Bridge;
    })?;
    let source = Source::new(&scene, false).map_err(|error| error.to_string())?;
    let (angle, velocity) = second_differences(&source, scene.samples());
    let mean = loss / (2.0 * (1.0 - loss).powi(2)) * scene.rate_hz;
    let (time_s, kappa) = (scene.duration_s, floor::vertical_rate(0.0));
    // A steady acceleration through the vertical channel, and a steady rate through the level.
    let fall = velocity * mean * ((kappa * time_s).cosh() - 1.0) / (kappa * kappa);
    let tilt = angle * mean * EQUATORIAL_GRAVITY * time_s.powi(3) / 6.0;
    // What is lost varies about its mean by a few per cent; the start and the end of a stream more.
    let bound_m = floor::SCENE_M + 1.5 * (fall + tilt);
    let flown = fly(&scene, progress)?;
    let why = "x″p/2(1−p)² per sample, x″ the increments' second difference, all of one sign";
    Ok(vec![Check::at_most("position", bound_m, flown.position_m, "m", why)])
}

/// The largest second differences of angle and velocity increments over a flight, rad and m/s.
fn second_differences(source: &Source, samples: u64) -> (f64, f64) {
    let increment = |n: u64| source.perfect_sample(n + 1);
    let mut most = (0.0_f64, 0.0_f64);
    let curved = |a: Vector<f64>, b: Vector<f64>, c: Vector<f64>| ((a - b) - (b - c)).norm();
    // The paper's motion is slow: every hundredth sample meets its extremes to a thousandth.
    for n in (0..samples.saturating_sub(2)).step_by(100) {
        let [a, b, c]: [Increment<f64>; 3] = [n, n + 1, n + 2].map(increment);
        most.0 = largest(most.0, curved(a.angle_b, b.angle_b, c.angle_b));
        most.1 = largest(most.1, curved(a.velocity_b, b.velocity_b, c.velocity_b));
    }
    most
}

fn not_bridged(_: &CaseProgress) -> Outcome {
    let scene = scene(
        "duration_s = 60\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\n[link]\nloss = 0.1\n",
    )?;
    let flown = simulate::fly(&scene, false, &mut |_| Ok(()), &|_| ());
    let other = u64::from(!matches!(flown, Err(FlightError::Lost { .. })));
    Ok(vec![Check::never("not refused as lost", other, "gap = \"error\" ends the run")])
}
