//! `schuler ensemble`: its runs are those flown alone, its statistics are right, its errors clear.

mod aided;
mod bits;
mod budget;
mod command;
mod damaged;
mod detection;
mod numbers;
mod shards;
mod start;
mod statistics;

use schuler_simulator::scene::{Scene, builtin};

/// A built-in motion with the paper's sensor errors, so long.
fn erring(name: &str, duration_s: f64) -> Scene {
    let mut scene = builtin::scene(name).unwrap();
    let paper = builtin::scene("paper").unwrap();
    (scene.gyro, scene.accelerometer) = (paper.gyro, paper.accelerometer);
    scene.duration_s = duration_s;
    scene
}

/// Turns that come so close to what a block may turn that a gyro's bias decides.
const TURNS: &str = "duration_s = 6\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\n\
    roll_deg = { harmonics = [{ amplitude = 900, period_s = 10 }] }\n\
    [gyro]\nturn_on_bias_deg_h = 20000\nangle_random_walk_deg_sqrt_h = 0.1\n\
    [navigator]\nwindow = { history = 0, block = 4, lookahead = 0 }\n";
