//! Where navigation starts: the truth, off by the scene's initial error and by what the run draws.
//!
//! Each of the nine numbers has a stream of its own, a function of (seed, run) alone: its first normal
//! deviate times the number's σ is added to the fixed error. So a run starts alike alone and in an ensemble, and
//! a σ changes no other random number.

use crate::scene::{Scene, Vertical};
use schuler::drift::compare::Drift;
use schuler::math::vector::Vector;
use schuler::noise::Streams;
use schuler::solution::Solution;

/// The start of the run of a number, for the truth at the start. What is held is not off.
pub fn of_run(truth: &Solution<f64>, scene: &Scene, run: u64) -> Solution<f64> {
    let error = error(scene, run);
    if error == Drift::default() { *truth } else { error.added_to(truth) }
}

/// What the start of the run of a number is off by.
pub fn error(scene: &Scene, run: u64) -> Drift {
    let initial = &scene.initial_error;
    let streams = Streams::new(scene.seed, run).branch(Streams::START);
    let drawn = |group: u64, fixed: [f64; 3], sigma: [f64; 3]| -> Vector<f64> {
        let mut axes = streams.branch(group).axes();
        let deviates: [f64; 3] = axes.each_mut().map(|stream| stream.normal());
        let at = |axis: usize| match sigma[axis] {
            0.0 => fixed[axis],
            sigma => fixed[axis] + sigma * deviates[axis],
        };
        Vector::new(at(0), at(1), at(2))
    };
    let mut error = Drift {
        position_ned: drawn(0, initial.position_m, initial.position_sigma_m),
        velocity_ned: drawn(1, initial.velocity_m_s, initial.velocity_sigma_m_s),
        attitude_ned: drawn(2, initial.attitude_rad, initial.attitude_sigma_rad),
    };
    if scene.navigator.vertical == Vertical::Held {
        (error.position_ned.z, error.velocity_ned.z) = (0.0, 0.0);
    }
    error
}
