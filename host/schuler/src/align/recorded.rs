//! A recorded vehicle that stands still.

use super::{table, toml};
use crate::cli::{AlignArgs, Method};
use crate::replay::{initial, spans};
use schuler::alignment::inertial::Inertial;
use schuler::alignment::place::Place as AtRest;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::number::counted;
use schuler_simulator::output::{say, write};
use schuler_simulator::recording::clock::Clock;
use schuler_simulator::recording::navigation::NavigationRow;
use schuler_simulator::recording::rows::Recording;
use schuler_simulator::recording::samples::Samples;
use schuler_simulator::recording::survey::Survey;
use schuler_simulator::recording::timeline::Misfit;
use schuler_simulator::rest::align::{self, Heading};
use schuler_simulator::rest::fine::{Refined, Stretch};
use schuler_simulator::simulate::FlightError;
use schuler_simulator::units::DEGREE;
use spans::Place;
use std::path::Path;

/// What says where the vehicle is.
const PLACE: &str = "a TOML file with the columns of nav.csv as keys, or a file of positions (.pos, NMEA, GPX, KML)";

/// Aligns on a stretch of a recording, prints what is found, and writes it.
pub fn align(args: &AlignArgs, imu: &Path) -> Result<(), FlightError> {
    let replay = args.as_replay(imu)?;
    let recording = Recording::open_as(&imu.display().to_string(), &replay.given())?;
    let (initial, replay) = initial::or_accepted(&replay, &recording, PLACE)?;
    let about = spans::about(&replay, &initial);
    let survey = Survey::of(&recording, args.rate.map(|rate_hz| 1.0 / rate_hz), about)?;
    let spans = spans::Spans::named(&replay, &survey, &initial, &spans::Options::ALIGN)?;
    for line in survey.said(&recording) {
        say(&format!("{line}\n"))?;
    }
    let mut still = align::gather(spans.navigate_s - spans.begin_s);
    let even = matches!(survey.clock, Clock::Even { .. });
    if !even && args.method == Method::Fine {
        let complaint = Complaint::new(
            "takes samples of one length, and these stamps are no constant rate",
            "--rate HZ, or --method auto",
        );
        return Err(InputError::option("--method", complaint).into());
    }
    let mut stretch = Stretch::new(survey.clock.interval());
    let mut inertial = Inertial::new(&AtRest::new(initial.position));
    let mut samples = Samples::new(&recording, &survey, Some(spans.begin_s))?;
    let mut there = 0;
    while let Some(sample) = samples.advance()? {
        let within = |misfit: &&Misfit| spans.place(misfit.time_s) == Place::Still;
        if let Some(unread) = sample.unread.iter().find(within) {
            return Err(unread.error.clone().into());
        }
        match spans.place(sample.end_s) {
            Place::Before => continue,
            Place::Still if sample.missing > 0 && there > 0 => {
                let missing = counted(sample.missing, "sample is", "samples are");
                let what = format!("{missing} missing before this one");
                let accepted = "--from and --for a stretch without a gap";
                let complaint = Complaint::new(what, accepted);
                return Err(FlightError::Stopped(recording.error(sample.line, complaint)));
            }
            Place::Still => {
                there += 1;
                still.add(&sample.increment, sample.interval_s);
                stretch.add(&sample.increment);
                inertial.add(&sample.increment, sample.interval_s);
            }
            Place::Flown | Place::After => break,
        }
    }
    let filtered = args.method == Method::Fine || (args.method == Method::Auto && even);
    let fine = filtered.then_some(&stretch);
    let (name, kind) = (&recording.name, recording.kind);
    let (row, refined) =
        align::align(&still, kind, name, &initial, Heading::Found, there, 0, fine)?;
    let row = match args.method {
        Method::Inertial => {
            let found = inertial.attitude().map_err(|error| {
                InputError::file(name, Complaint::new(error.to_string(), "--method fine"))
            })?;
            say(&table::attitude("inertial", &found))?;
            NavigationRow { attitude: found, ..row }
        }
        _ => row,
    };
    if let (Some(wanted), Some(refined)) = (args.sigma, &refined) {
        good_enough(wanted * DEGREE, refined)?;
    }
    if let Some(out) = &args.out {
        let row = NavigationRow { time_s: spans.navigate_s, ..row };
        write(out, toml::initial(&row, refined.map(|refined| refined.aligned).as_ref()))?;
    }
    Ok(())
}

/// Refuses a heading that is poorer than wanted, with the time that would do.
fn good_enough(wanted: f64, refined: &Refined) -> Result<(), InputError> {
    let sigma = refined.aligned.heading_sigma;
    if sigma <= wanted {
        return Ok(());
    }
    let what = format!(
        "{} s give the heading to {:.4}° (1σ), not to {:.4}°",
        refined.aligned.seconds,
        sigma / DEGREE,
        wanted / DEGREE
    );
    let accepted = match refined.seconds_for(wanted) {
        Some(seconds) => format!("--for {:.0}", seconds.ceil()),
        None => "a larger one: with the biases of these sensors no time would do".to_owned(),
    };
    Err(InputError::option("--sigma", Complaint::new(what, accepted)))
}
