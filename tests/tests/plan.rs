//! The plan's window: flights that limits fitted to a few scenes lost, and what turns too far.
//!
//! `schuler stress --case random` flies many more scenes.

use schuler::flight::configuration::Precision;
use schuler::flight::plan::{self, Demand};
use schuler_simulator::scene::{Axes, Scene, WindowShape, builtin, parse};
use schuler_simulator::simulate;

fn scene(text: &str, frame: Axes) -> Scene {
    let mut scene = parse::scene("plan.toml", text).unwrap();
    scene.navigator.frame = frame;
    scene
}

fn position_m(scene: &Scene, force_all: bool) -> f64 {
    let flight = simulate::fly(scene, force_all, &mut |_| Ok(()), &|_| {}).unwrap();
    flight.max.norms[0]
}

/// Windows of each kind.
const NAMED: [[usize; 3]; 8] =
    [[0, 40, 0], [0, 8, 0], [0, 6, 0], [0, 2, 0], [2, 4, 2], [4, 4, 4], [2, 2, 2], [4, 4, 0]];

fn shape([history, block, lookahead]: [usize; 3]) -> WindowShape {
    WindowShape { history, block, lookahead }
}

const TURNS: &str = "duration_s = 2000\nrate_hz = 50\n[trajectory]\nlatitude_deg = 45\n\
    roll_deg = { harmonics = [{ amplitude = 40, period_s = 16, phase_deg = 30 }] }\n";
const ROLL: &str = "duration_s = 600\nrate_hz = 100\n[trajectory]\nlatitude_deg = 45\n\
    roll_deg = { rate = 1000 }\n";
const SPIN: &str = "duration_s = 1\nrate_hz = 60\n[trajectory]\nyaw_deg = { rate = 2000 }\n";

/// 2.5e-6 and 9.5e-5 m, and a refusal, by limits of bandwidth alone.
#[test]
fn swings_and_spins_fly_with_the_window_they_need() {
    for frame in [Axes::LocalLevel, Axes::EarthFixed] {
        for (text, most_m) in [(TURNS, 3e-8), (ROLL, 1e-6), (SPIN, 2e-9)] {
            let found = position_m(&scene(text, frame), false);
            assert!(found <= most_m, "{frame:?} {found:e} m\n{text}");
        }
    }
}

#[test]
fn a_refused_turn_names_what_would_do() {
    let mut scene = scene(SPIN, Axes::LocalLevel);
    scene.navigator.window = Some(schuler::flight::plan::UNKNOWN);
    let error = simulate::fly(&scene, false, &mut |_| Ok(()), &|_| {}).unwrap_err().to_string();
    assert!(error.contains("turns a block of 4 samples by over 2 rad"), "{error}");
    assert!(error.contains("(--window 2,2,2)") && error.contains("a rate of 70 Hz"), "{error}");
}

/// Scenes whose errors swing, or begin with an edge, which rates of stretches alone mistook.
const MISTAKEN: &[(&str, &str)] = &[
    (
        "the swing of the step's errors, 27 Hz: 5.9 times worse than promised",
        "duration_s = 539\nrate_hz = 27\n[trajectory]\n\
        yaw_deg = { offset = 30, harmonics = [{ amplitude = 1.492, period_s = 10.481, phase_deg = 162 }] }\n\
        latitude_deg = 40\nlongitude_deg = 100\n\
        altitude_m = { offset = 5000, harmonics = [\
        { amplitude = 7.025e-3, period_s = 0.488857, phase_deg = 41 }] }\n\
        [navigator]\nframe = \"local-level\"\n",
    ),
    (
        "the first block's edge at 3.4 samples a cycle: 11 times",
        "duration_s = 80\nrate_hz = 45\n[trajectory]\nroll_deg = { rate = 9.391 }\n\
        yaw_deg = { offset = 30, harmonics = [\
        { amplitude = 8.3e-2, period_s = 225.472, phase_deg = 29 }] }\n\
        latitude_deg = { offset = 40, harmonics = [\
        { amplitude = 6.128e-8, period_s = 7.61593e-2, phase_deg = 153 },\
        { amplitude = 1.411e-8, period_s = 9.51413e-2, phase_deg = 43 }] }\n\
        longitude_deg = { offset = 100, harmonics = [\
        { amplitude = 1.036e-4, period_s = 15.3839, phase_deg = 298 }] }\n\
        altitude_m = { offset = 5000, rate = 9.906e-2 }\n[navigator]\nframe = \"earth-fixed\"\n",
    ),
    (
        "heights that swing twice, 7 Hz: 7.8 times",
        "duration_s = 1183\nrate_hz = 7\n[trajectory]\nyaw_deg = 30\n\
        latitude_deg = { offset = 40, harmonics = [\
        { amplitude = 0.6262, period_s = 2604.96, phase_deg = 358 }] }\n\
        longitude_deg = { offset = 100, rate = 2.087e-4, harmonics = [\
        { amplitude = 1.215e-2, period_s = 113.013, phase_deg = 254 },\
        { amplitude = 0.3589, period_s = 3427.13, phase_deg = 244 }] }\n\
        altitude_m = { offset = 5000, harmonics = [\
        { amplitude = 16.59, period_s = 5.76942, phase_deg = 286 },\
        { amplitude = 2.719e-3, period_s = 1.3993, phase_deg = 152 }] }\n\
        [navigator]\nframe = \"earth-fixed\"\n",
    ),
    (
        "a spin about a slanting axis that blocks of four do take, 9 Hz: 855 times",
        "duration_s = 260\nrate_hz = 9\n[trajectory]\nroll_deg = { rate = 52.24 }\n\
        pitch_deg = { harmonics = [{ amplitude = 0.4798, period_s = 167.682, phase_deg = 7 }] }\n\
        yaw_deg = { offset = 30, rate = 232.6 }\nlatitude_deg = { offset = 40, rate = 4.264e-6 }\n\
        longitude_deg = 100\naltitude_m = { offset = 5000, rate = 1.153e-2 }\n\
        [navigator]\nframe = \"local-level\"\n",
    ),
    (
        "rows within blocks of 40 at rest by a series of order 3: 1.8 times",
        "duration_s = 57\nrate_hz = 10\n[trajectory]\nyaw_deg = 30\nlatitude_deg = 40\n\
        longitude_deg = 100\naltitude_m = 5000\n[navigator]\nframe = \"local-level\"\n",
    ),
];

#[test]
fn no_named_window_is_three_times_better() {
    for (what, text) in MISTAKEN {
        let scene = parse::scene("plan.toml", text).unwrap();
        let best_m = NAMED.iter().fold(f64::INFINITY, |best: f64, &window| {
            let mut other = scene.clone();
            other.navigator.window = Some(shape(window));
            let flight = simulate::fly(&other, false, &mut |_| Ok(()), &|_| {});
            flight.map_or(best, |flight| best.min(flight.max.norms[0]))
        });
        let found = position_m(&scene, false);
        assert!(found <= (3.0 * best_m).max(3e-8), "{found:e} m against {best_m:e} m: {what}");
        let forced = position_m(&scene, true);
        assert!((found - forced).abs() <= 3e-8, "{found:e} m, --force-all {forced:e} m: {what}");
    }
}

/// A series of order 3 in blocks of 20 cost 7.9e-9 m, a rest that adds up where roundings do not.
#[test]
fn the_papers_flight_stays_below_its_rounding() {
    for (frame, most_m) in [(Axes::LocalLevel, 2.2e-9), (Axes::EarthFixed, 8.5e-9)] {
        let mut scene = builtin::scene("paper-perfect").unwrap();
        scene.navigator.frame = frame;
        let found = position_m(&scene, false);
        assert!(found <= most_m, "{frame:?} {found:e} m");
    }
}

/// On a target: no planned block turns by over 2 rad, and a spin gets a series that follows it.
#[test]
fn the_cores_plan_keeps_to_blocks_that_a_navigator_takes() {
    let of = |rate_deg_s: f64, interval_s: f64| Demand {
        bandwidth: rate_deg_s.to_radians(),
        angular_rate: rate_deg_s.to_radians(),
        speed: 0.0,
        interval_s,
        precision: Precision::F64,
        axes: Axes::EarthFixed,
    };
    assert_eq!(plan::window(&of(2000.0, 1.0 / 60.0)), shape([2, 2, 2]));
    assert_eq!(plan::window(&of(1000.0, 0.01)), shape([2, 4, 2]));
}

/// On a target: a local-level block flies half a kilometre at most, or is of two samples. A meridian flight at
/// 7.2 km/s and 10 Hz is 1.5e-7 m off after 1000 s in blocks of eight, 4e-9 m in blocks of two.
#[test]
fn the_cores_plan_counts_the_way_of_a_local_level_block() {
    let of = |speed: f64, interval_s: f64, axes: Axes| Demand {
        bandwidth: speed / 6.4e6,
        angular_rate: speed / 6.4e6,
        speed,
        interval_s,
        precision: Precision::F64,
        axes,
    };
    assert_eq!(plan::window(&of(300.0, 0.2, Axes::LocalLevel)), shape([0, 8, 0]));
    assert_eq!(plan::window(&of(300.0, 0.25, Axes::LocalLevel)), shape([0, 4, 0]));
    assert_eq!(plan::window(&of(7200.0, 0.1, Axes::LocalLevel)), shape([0, 2, 0]));
    assert_eq!(plan::window(&of(300.0, 0.25, Axes::EarthFixed)), shape([0, 8, 0]));
}
