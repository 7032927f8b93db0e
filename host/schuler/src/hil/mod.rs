//! `schuler hil`: a scene flown by a target and by its twin on the host, every bit compared.
//!
//! [`device`] opens a [`channel`], into which an [`injector`] may inject [`faults`]; a [`conversation`] sends
//! requests and receives answers; [`lockstep`] flies both sides with it, and [`tally`] counts errors on the link.
//! [`identify`] lets a target identify a unit at rest in place of flying.

pub mod channel;
pub mod child;
pub mod choice;
pub mod conversation;
pub mod cutter;
pub mod device;
pub mod difference;
pub mod faults;
pub mod identify;
pub mod in_process;
pub mod injector;
pub mod lockstep;
pub mod pace;
pub mod parted;
mod parts;
pub mod patience;
pub mod reply;
pub mod serve;
pub mod tally;
pub mod wait;
pub mod wire;

use crate::cli::HilArgs;
use crate::report::lockstep::{Latency, latency};
use crate::report::{self, FlightFiles, link_table};
use channel::Channel;
use conversation::{Conversation, Outcome};
use faults::Rates;
use injector::Injector;
use lockstep::{Boarded, Ended, Lockstep, Log};
use patience::{PATIENCE, Patience};
use reply::Reply;
use schuler::link::message::VERSION;
use schuler::link::offer::Offer;
use schuler_simulator::flight::{Flight, LinkReport};
use schuler_simulator::input::name::path_of;
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::output::{say, say_error};
use schuler_simulator::plan::Plan;
use schuler_simulator::progress::Progress;
use schuler_simulator::scene::Scene;
use schuler_simulator::simulate::{FlightError, Simulation, Vehicle};
use schuler_simulator::source::Source;
use std::path::{Path, PathBuf};
use std::sync::PoisonError;
use std::time::Duration;

/// How often a target is greeted that is just being switched on.
const GREETINGS: u32 = 3;

/// How a flight is flown in step with a target.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Manner {
    /// How often a sample is sent again before it is given up.
    pub retries: u32,
    /// Faults to put in, and their seed.
    pub faults: Option<(Rates, u64)>,
    /// In real time.
    pub stream: bool,
    /// How long each answer is waited for; by the round trips so far, unless given.
    pub timeout: Option<Duration>,
}

/// Flies a scene with a target as far as it goes, prints the drift and the link's table, and writes the
/// files of `run`.
pub fn hil(args: &HilArgs) -> Result<(), FlightError> {
    let scene = args.scene()?;
    if args.allan {
        return identify::identify(args, &scene);
    }
    let directory =
        args.out.clone().unwrap_or_else(|| PathBuf::from("out").join(path_of(&scene.name)));
    report::files::tell_replaced(&directory);
    let log = Log::default();
    let (flight, end) = fly_to_files(args, &scene, &directory, &log).inspect_err(|_| {
        if let Some(note) = report::files::of_earlier(&directory) {
            say_error(&note);
        }
    })?;
    let latencies_s = log.lock().unwrap_or_else(PoisonError::into_inner).latencies_s.clone();
    let latency = latency(&latencies_s, flight.scene.rate_hz);
    say(&text(&flight, latency.as_ref(), &directory.display().to_string()))?;
    end.and_then(|()| check(&flight))
}

/// Flies, and puts the files in their places; a flight that does not even begin leaves the link's table.
fn fly_to_files(
    args: &HilArgs,
    scene: &Scene,
    directory: &Path,
    log: &Log,
) -> Result<(Flight, Result<(), FlightError>), FlightError> {
    let channel = args.device.open(args.image()?)?;
    let device = args.device.to_string();
    let met = meet(channel, &args.manner(), &device)?;
    let progress = Progress::new(scene.samples());
    let mut files = FlightFiles::create(directory, args.wanted())?;
    let flown =
        fly_as_far(scene, met, &args.manner(), log, &mut |instant| files.row(instant), &|sample| {
            progress.reach(sample)
        });
    progress.finish();
    let Ended { tally, planned_window, latencies_s, events, parted } =
        log.lock().unwrap_or_else(PoisonError::into_inner).clone();
    let link = LinkReport { planned_window, ..tally.report(device) };
    match flown {
        Ok((flight, end)) => {
            let flight = Flight { link: Some(link), ..flight };
            let latency = latency(&latencies_s, scene.rate_hz);
            let ended = flight.ended.as_ref().map(|ended| ended.reason.clone());
            let end_s = flight.last.time_s;
            let lockstep =
                report::Lockstep::new([parted, ended], &flight.digest, latency, &events, end_s);
            files.finish(&flight, Vec::new(), Some(lockstep))?;
            Ok((flight, end))
        }
        Err(error) => {
            if link.frames_sent > 0 {
                say(&link_table::text(&link))?;
            }
            Err(error)
        }
    }
}

fn text(flight: &Flight, latency: Option<&Latency>, directory: &str) -> String {
    let mut text = report::table(flight);
    if let Some(planned) = flight.link.as_ref().and_then(|link| link.planned_window)
        && let Some(flown) = flight.window
    {
        text += &format!("\nThe target has no window {planned}: flown with {flown}.\n");
    }
    if let Some(link) = &flight.link {
        text += &link_table::text(link);
    }
    if let Some(latency) = latency {
        text += &latency.text();
    }
    if flight.ended.is_none() {
        text += &format!("Target and twin agree in every bit: digest {}.\n", flight.digest);
    }
    format!("{text}written to {directory}\n")
}

/// Faults that were put in must be noticed, and no others.
fn check(flight: &Flight) -> Result<(), FlightError> {
    let traces = match &flight.link {
        Some(LinkReport { faults, traces, .. }) if !faults.is_empty() => traces.as_slice(),
        _ => &[],
    };
    let failed = traces.iter().filter(|trace| !trace.is_explained()).count();
    let checks = traces.len();
    if failed == 0 { Ok(()) } else { Err(FlightError::Failed { failed, checks }) }
}

/// A target that has answered.
pub struct Met {
    conversation: Conversation,
    /// What it can fly.
    offers: Vec<Offer>,
}

/// Flies a scene in step with a target to its end; what happened on the link is left in the log,
/// whatever the outcome.
pub fn fly(
    scene: &Scene,
    met: Met,
    manner: &Manner,
    log: &Log,
    observe: &mut dyn FnMut(&schuler_simulator::flight::Instant) -> Result<(), InputError>,
    progress: &dyn Fn(u64),
) -> Result<Flight, FlightError> {
    let (flight, end) = fly_as_far(scene, met, manner, log, observe, progress)?;
    end.map(|()| flight)
}

/// The same as far as it goes: what was flown, and what ended it early, if anything.
pub fn fly_as_far(
    scene: &Scene,
    met: Met,
    manner: &Manner,
    log: &Log,
    observe: &mut dyn FnMut(&schuler_simulator::flight::Instant) -> Result<(), InputError>,
    progress: &dyn Fn(u64),
) -> Result<(Flight, Result<(), FlightError>), FlightError> {
    let Met { mut conversation, offers } = met;
    let planned = Plan::new(scene, &Source::new(scene, false)?, false).window;
    let is_aided = scene.aiding.is_there();
    let configuration = if is_aided {
        parts::aided(scene, &offers)?
    } else {
        choice::choose(&scene.navigator, planned, &offers)?
    };
    let mut scene = scene.clone();
    let flown = if is_aided { scene.navigator.window } else { configuration.window() };
    if scene.navigator.window.is_none() && flown.is_some_and(|flown| flown != planned) {
        log.lock().unwrap_or_else(PoisonError::into_inner).planned_window = Some(planned);
    }
    scene.navigator.window = flown;
    if let Some((rates, seed)) = manner.faults {
        conversation = conversation.wrap(|channel| Box::new(Injector::new(channel, rates, seed)));
    }
    let simulation = Simulation::new(&scene, false)?;
    let claims = simulation.claims();
    let simulation = simulation.aboard(|plan, initial| {
        let asked = (configuration, claims);
        let (parts, navigator) = parts::of(&scene, plan, initial, conversation, asked, manner)?;
        let lockstep = Lockstep::start(parts, log.clone()).map_err(stopped)?;
        Ok::<Box<dyn Vehicle>, FlightError>(Box::new(Boarded::new(lockstep, navigator)))
    })?;
    let (mut flight, end) = simulation.fly_as_far(observe, progress)?;
    // What the target has filled in is no more the scene's than what the scene itself has lost.
    let bridged = log.lock().unwrap_or_else(PoisonError::into_inner).tally.bridged;
    flight.lost += bridged;
    if bridged > 0 {
        flight.forget_theory();
    }
    Ok((flight, end))
}

/// Greets the target at the end of a channel; `device` is what users call it.
pub fn meet(channel: Box<dyn Channel>, manner: &Manner, device: &str) -> Result<Met, FlightError> {
    // Who is just being switched on takes its time.
    let greeting = Patience::Fixed(manner.timeout.unwrap_or_default().max(PATIENCE));
    let mut conversation = Conversation::new(channel, manner.retries).patient(greeting);
    for _ in 0..GREETINGS {
        match conversation.greet().map_err(stopped)? {
            Outcome::Answered(Reply::Hello { version: VERSION, offers }) => {
                // Where faults are put in, no answer is waited for that does not come, and the clock
                // must have no say in what happens.
                let patience = match (manner.timeout, manner.faults) {
                    (Some(timeout), _) => Patience::Fixed(timeout),
                    (None, Some(_)) => Patience::Fixed(PATIENCE),
                    (None, None) => Patience::default(),
                };
                return Ok(Met { conversation: conversation.patient(patience), offers });
            }
            Outcome::Answered(Reply::Hello { version, .. }) => {
                let what = format!("{device} speaks version {version} of the protocol");
                return Err(stopped(Complaint::new(what, format!("version {VERSION}"))));
            }
            Outcome::Answered(_) | Outcome::Silence => break,
            Outcome::Rebooted => {}
        }
    }
    let seconds = conversation.greeting_lasts().as_secs();
    let what = format!("{device} did not answer in {seconds} s");
    let accepted = "a device that runs tests/firmware's navigator, a serial port at its bit rate";
    Err(stopped(Complaint::new(what, accepted)))
}

fn stopped(what: impl Into<Complaint>) -> FlightError {
    FlightError::Stopped(InputError::option("--device", what.into()))
}
