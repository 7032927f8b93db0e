//! `schuler ensemble`: its runs are those flown alone, its statistics are right, its errors clear.

mod bits;
mod command;
mod statistics;

use schuler_host::scene::{Scene, builtin};

/// A built-in motion with the paper's sensor errors, so long.
fn erring(name: &str, duration_s: f64) -> Scene {
    let mut scene = builtin::scene(name).unwrap();
    let paper = builtin::scene("paper").unwrap();
    (scene.gyro, scene.accelerometer) = (paper.gyro, paper.accelerometer);
    scene.duration_s = duration_s;
    scene
}
