//! The state that a replay starts from.

use crate::cli::ReplayArgs;
use schuler::earth::Geodetic;
use schuler::math::vector::Vector;
use schuler::solution::Euler;
use schuler_simulator::input::name::name_of;
use schuler_simulator::input::{Complaint, InputError, read_text};
use schuler_simulator::output::say;
use schuler_simulator::recording::navigation::NavigationRow;
use schuler_simulator::recording::rows::Recording;
use schuler_simulator::reference::Track;
use schuler_simulator::units::DEGREE;

/// What a replay starts from, and its options as they then are: where positions that were measured say where it
/// is, time is the recording's own.
pub fn initial(
    args: &ReplayArgs,
    recording: &Recording,
) -> Result<(NavigationRow, ReplayArgs), InputError> {
    const ACCEPTED: &str = "a TOML file with the columns of nav.csv as keys, or with --align a file of positions (.pos, NMEA, GPX, KML)";
    or_accepted(args, recording, ACCEPTED)
}

/// The same for a command that takes something else.
pub fn or_accepted(
    args: &ReplayArgs,
    recording: &Recording,
    accepted: &str,
) -> Result<(NavigationRow, ReplayArgs), InputError> {
    let missing = || {
        let complaint =
            Complaint::new("is missing, and the recording brings no initial state", accepted);
        InputError::option("--initial", complaint)
    };
    let Some(path) = &args.initial else {
        return Ok((recording.initial.ok_or_else(missing)?, args.clone()));
    };
    let file = name_of(path);
    let text = read_text(&file)?;
    if !Track::is_one(&text) {
        return Ok((NavigationRow::parse(&file, &text)?, args.clone()));
    }
    if args.align.is_none() {
        let what = "holds positions and no attitude";
        let accepted = "it with --align S, which finds the attitude of a vehicle at rest";
        return Err(InputError::option("--initial", Complaint::new(what, accepted)));
    }
    let track = Track::parse(&file, &text)?;
    Ok((position(&track, recording, args.start)?, ReplayArgs { initial: None, ..args.clone() }))
}

/// The first position, or the one nearest to the start where the times of both are known.
fn position(
    track: &Track,
    recording: &Recording,
    start_s: Option<f64>,
) -> Result<NavigationRow, InputError> {
    let on_one = track.scale.zip(recording.scale).zip(start_s);
    let off = |time_s: Option<f64>| match (on_one, time_s) {
        (Some(((theirs, own), start_s)), Some(time_s)) => (theirs.to(own, time_s) - start_s).abs(),
        _ => 0.0,
    };
    let fixes = track.fixes.iter();
    let fix =
        fixes.min_by(|a, b| off(a.time_s).total_cmp(&off(b.time_s))).copied().unwrap_or_default();
    let altitude = fix.height.unwrap_or(0.0);
    let height = if fix.height.is_some() { "" } else { ", as no height is given" };
    for line in &track.said {
        say(&format!("{line}\n"))?;
    }
    say(&format!(
        "{}:{}: starts at {:.7}°, {:.7}°, {altitude:.2} m{height}\n",
        track.name,
        fix.line,
        fix.latitude / DEGREE,
        fix.longitude / DEGREE,
    ))?;
    Ok(NavigationRow {
        time_s: 0.0,
        position: Geodetic { latitude: fix.latitude, longitude: fix.longitude, altitude },
        velocity_ned: Vector::ZERO,
        attitude: Euler { roll: 0.0, pitch: 0.0, yaw: 0.0 },
    })
}
