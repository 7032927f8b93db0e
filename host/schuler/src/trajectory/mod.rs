//! `schuler trajectory`: what a flight is like, and its path for other tools.

mod words;

use crate::cli::TrajectoryArgs;
use schuler_simulator::output::say;
use schuler_simulator::portrait::Portrait;
use schuler_simulator::simulate::FlightError;
use schuler_simulator::source::SourceError;

/// Prints what a flight is like, and writes its path.
pub fn trajectory(args: &TrajectoryArgs) -> Result<(), FlightError> {
    let scene = args.scene()?;
    let course = scene.trajectory.build().map_err(SourceError::Trajectory)?;
    let portrait = Portrait::new(&course, scene.duration_s);
    say(&words::describe(&scene, &portrait))?;
    Ok(())
}
