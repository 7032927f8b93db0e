//! `schuler trajectory`: what a flight is like, and its path for other tools.
//!
//! | file | what |
//! |---|---|
//! | `words` | the flight in words |
//! | [`fidelity`] | how well a path does what it was asked for |
//! | `files` | its path as a file |

pub mod fidelity;
mod files;
mod words;

use crate::cli::TrajectoryArgs;
use files::Format;
use schuler_simulator::output::say;
use schuler_simulator::portrait::Portrait;
use schuler_simulator::simulate::FlightError;
use schuler_simulator::source::SourceError;

/// Prints what a flight is like, and writes its path.
pub fn trajectory(args: &TrajectoryArgs) -> Result<(), FlightError> {
    let out = args.out.as_deref().map(|out| Format::of(out).map(|format| (out, format)));
    let out = out.transpose()?;
    let scene = args.scene()?;
    let course = scene.trajectory.build().map_err(SourceError::Trajectory)?;
    let portrait = Portrait::new(&course, scene.duration_s);
    let mut text = words::describe(&scene, &portrait);
    if let Some((path, format)) = out {
        let rows = files::write(args, &scene, &course, path, format)?;
        text += &format!("{rows} rows written to {}{}\n", path.display(), format.note());
    }
    say(&text)?;
    Ok(())
}
