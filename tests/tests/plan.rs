//! The plan's window: flights that limits fitted to a few scenes lost, and what turns too far.

use schuler::strapdown::plan::{self, Digits, Flight};
use schuler_host::scene::{Frame, Scene, parse};
use schuler_host::simulate;

fn scene(text: &str, frame: Frame) -> Scene {
    let mut scene = parse::scene("plan.toml", text).unwrap();
    scene.navigator.frame = frame;
    scene
}

fn position_m(scene: &Scene, force_all: bool) -> f64 {
    let flight = simulate::fly(scene, force_all, &mut |_| Ok(()), &|_| {}).unwrap();
    flight.max.norms[0]
}

const TURNS: &str = "duration_s = 2000\nrate_hz = 50\n[trajectory]\nlatitude_deg = 45\n\
    roll_deg = { harmonics = [{ amplitude = 40, period_s = 16, phase_deg = 30 }] }\n";
const ROLL: &str = "duration_s = 600\nrate_hz = 100\n[trajectory]\nlatitude_deg = 45\n\
    roll_deg = { rate = 1000 }\n";
const SPIN: &str = "duration_s = 1\nrate_hz = 60\n[trajectory]\nyaw_deg = { rate = 2000 }\n";

/// 2.5e-6 and 9.5e-5 m, and a refusal, by limits of bandwidth alone.
#[test]
fn swings_and_spins_fly_with_the_window_they_need() {
    for frame in [Frame::LocalLevel, Frame::EarthFixed] {
        for (text, most_m) in [(TURNS, 3e-8), (ROLL, 1e-6), (SPIN, 2e-9)] {
            let found = position_m(&scene(text, frame), false);
            assert!(found <= most_m, "{frame:?} {found:e} m\n{text}");
        }
    }
}

#[test]
fn a_refused_turn_names_what_would_do() {
    let mut scene = scene(SPIN, Frame::LocalLevel);
    scene.navigator.window = Some(schuler::strapdown::plan::UNKNOWN.into());
    let error = simulate::fly(&scene, false, &mut |_| Ok(()), &|_| {}).unwrap_err().to_string();
    assert!(error.contains("turns a block of 4 samples by over 2 rad"), "{error}");
    assert!(error.contains("(--window 2,2,2)") && error.contains("a rate of 70 Hz"), "{error}");
}

/// On a target: no planned block turns by over 2 rad, and a spin gets a series that follows it.
#[test]
fn the_cores_plan_keeps_to_blocks_that_a_navigator_takes() {
    let of = |rate_deg_s: f64, interval_s: f64| Flight {
        bandwidth: rate_deg_s.to_radians(),
        angular_rate: rate_deg_s.to_radians(),
        interval_s,
        digits: Digits::Double,
        earth_fixed: true,
    };
    assert_eq!(plan::window(&of(2000.0, 1.0 / 60.0)), (2, 2, 2));
    assert_eq!(plan::window(&of(1000.0, 0.01)), (2, 4, 2));
}
