//! `schuler align`: level, north and biases of a recorded vehicle that stands still.

use crate::cli::{AlignArgs, Method};
use crate::replay::{initial, spans};
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::output::{say, write};
use schuler_simulator::recording::clock::Clock;
use schuler_simulator::recording::navigation::NavigationRow;
use schuler_simulator::recording::rows::Recording;
use schuler_simulator::recording::samples::Samples;
use schuler_simulator::recording::survey::Survey;
use schuler_simulator::recording::timeline::Misfit;
use schuler_simulator::rest::align;
use schuler_simulator::rest::fine::{Refined, Stretch};
use schuler_simulator::simulate::FlightError;
use schuler_simulator::units::{DEGREE, DEGREE_PER_HOUR};
use spans::Place;

/// Aligns on a stretch of a recording, prints what is found, and writes it.
pub fn align(args: &AlignArgs) -> Result<(), FlightError> {
    let replay = args.as_replay()?;
    let recording = Recording::open_as(&args.imu.display().to_string(), &replay.given())?;
    let (initial, replay) = initial::initial(&replay, &recording)?;
    let about = spans::about(&replay, &initial);
    let survey = Survey::of(&recording, args.rate.map(|rate_hz| 1.0 / rate_hz), about)?;
    let spans = spans::Spans::new(&replay, &survey, &initial)?;
    for line in survey.said(&recording) {
        say(&format!("{line}\n"))?;
    }
    let mut still = align::gather(spans.navigate_s - spans.begin_s);
    let even = matches!(survey.clock, Clock::Even { .. });
    if !even && args.method == Method::Fine {
        let complaint = Complaint::new(
            "takes samples of one length, and these stamps are no constant rate",
            "--rate HZ, or --method two-vector",
        );
        return Err(InputError::option("--method", complaint).into());
    }
    let mut stretch = Stretch::new(survey.clock.interval());
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
                let what = format!("{} samples are missing before this one", sample.missing);
                let accepted = "--from and --for a stretch without a gap";
                let complaint = Complaint::new(what, accepted);
                return Err(FlightError::Stopped(recording.error(sample.line, complaint)));
            }
            Place::Still => {
                there += 1;
                still.add(&sample.increment, sample.interval_s);
                stretch.add(&sample.increment);
            }
            Place::Flown | Place::After => break,
        }
    }
    let fine = (args.method == Method::Fine).then_some(&stretch);
    let (name, kind) = (&recording.name, recording.kind);
    let (row, refined) = align::align(&still, kind, name, &initial, None, there, 0, fine)?;
    if let (Some(wanted), Some(refined)) = (args.sigma, &refined) {
        good_enough(wanted * DEGREE, refined)?;
    }
    if let Some(out) = &args.out {
        let row = NavigationRow { time_s: spans.navigate_s, ..row };
        write(out, toml(&row, refined.as_ref()))?;
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

/// An initial.toml, below what is known of it.
fn toml(row: &NavigationRow, refined: Option<&Refined>) -> String {
    let mut text = row.toml("schuler align: at the end of the stretch, at rest");
    if let Some(Refined { aligned, .. }) = refined {
        let [north, east] = aligned.level_sigma.map(|x| x / DEGREE);
        let heading = aligned.heading_sigma / DEGREE;
        text += &format!("# 1σ: level {north:.6}°, {east:.6}°, heading {heading:.6}°\n");
        let [bias, sigma] = aligned.gyro_bias.map(|v| v.map(|x| x / DEGREE_PER_HOUR));
        text += &format!(
            "# gyro biases {:.6}, {:.6}, {:.6} °/h, 1σ {:.6}, {:.6}, {:.6}\n",
            bias.x, bias.y, bias.z, sigma.x, sigma.y, sigma.z
        );
        let [bias, sigma] = aligned.accelerometer_bias;
        text += &format!(
            "# accelerometer biases {:.3e}, {:.3e}, {:.3e} m/s², 1σ {:.3e}, {:.3e}, {:.3e}\n",
            bias.x, bias.y, bias.z, sigma.x, sigma.y, sigma.z
        );
    }
    text
}
