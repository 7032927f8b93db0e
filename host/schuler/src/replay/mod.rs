//! `schuler replay`: navigates a recorded stream.

mod fly;
mod initial;
mod report;
mod rows;
mod spans;

use crate::cli::ReplayArgs;
use schuler::flight::plan;
use schuler_simulator::output::say;
use schuler_simulator::recording::rows::Recording;
use schuler_simulator::recording::survey::Survey;
use schuler_simulator::scene::{Algorithm, Navigator, WindowShape};
use schuler_simulator::simulate::FlightError;

/// Navigates a recording and writes `nav.csv`, a row per sample or fewer. Prints what its stamps say, what
/// was aligned to, and where the vehicle ends up.
///
/// The recording is gone through twice, once to look and once to navigate, and never held in memory.
pub fn replay(args: &ReplayArgs) -> Result<(), FlightError> {
    args.check()?;
    let recording = Recording::open_as(&args.imu.display().to_string(), &args.given())?;
    let mut options = Navigator::default();
    args.navigator.apply(&mut options)?;
    options.gap = args.gap.unwrap_or(options.gap);
    let (initial, args) = &initial::initial(args, &recording)?;

    let measured = spans::about(args, initial);
    let survey = Survey::of(&recording, args.rate.map(|rate_hz| 1.0 / rate_hz), measured)?;
    let spans = spans::Spans::new(args, &survey, initial)?;
    let shape = shape(&options, &survey);
    for line in survey.said(&recording) {
        say(&format!("{line}\n"))?;
    }
    if options.algorithm == Algorithm::Taylor {
        let WindowShape { history, block, lookahead } = shape;
        let how = if options.window.is_some() { "as asked" } else { "by the samples" };
        let motion = survey.motion_said();
        say(&format!("window {history},{block},{lookahead} {how}: {motion}\n"))?;
    }
    let flight = fly::fly(&recording, &survey, &spans, initial, &options, shape, args)?;
    say(&report::text(&flight, &spans, args.align.is_some()))?;
    Ok(())
}

/// The window to fly: what is asked for, else what the samples support.
fn shape(options: &Navigator, survey: &Survey) -> WindowShape {
    let supported = survey.window.unwrap_or(plan::UNKNOWN);
    options.window.unwrap_or(supported)
}
