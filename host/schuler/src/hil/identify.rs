//! A target that identifies the sensors of a scene: it gets their errors, and its Allan sums are read back.

use super::choice;
use super::conversation::Conversation;
use super::injector::Injector;
use super::lockstep::{Lockstep, Log, Parts};
use super::parted::Parted;
use super::{Manner, Met, meet, parts, stopped};
use crate::allan::Findings;
use crate::cli::HilArgs;
use crate::report::link_table;
use schuler::allan::octaves::Point;
use schuler::link::offer::Offer;
use schuler::sample::Increment;
use schuler_simulator::allan::record::{self, Record, SceneError, Sums};
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::output::say;
use schuler_simulator::scene::Scene;
use schuler_simulator::simulate::FlightError;
use schuler_simulator::twin::Beginning;
use std::sync::PoisonError;

/// Identifies, and prints what `allan` prints of the scene, with the link's table.
pub(super) fn identify(args: &HilArgs, scene: &Scene) -> Result<(), FlightError> {
    let device = args.device.to_string();
    let met = meet(args.device.open(args.image()?)?, &args.manner(), &device)?;
    let log = Log::default();
    let record = record(scene, met, &args.manner(), &log)?;
    let title = format!("{} by {device}", scene.name);
    let findings = Findings::new(title, record.record, Some(scene), false)?;
    let tally = log.lock().unwrap_or_else(PoisonError::into_inner).tally.clone();
    let link = tally.report(device);
    let mut text = findings.text.clone() + &link_table::text(&link);
    text += &format!(
        "Target and twin agree in every bit of their {} sums: digest {:016x}.\n",
        record.words, record.digest
    );
    Ok(say(&text)?)
}

/// What a target has found.
#[derive(Clone, Debug)]
pub struct Identified {
    /// The points of each axis.
    pub record: Record,
    /// Words that were read back.
    pub words: usize,
    /// Digest of every sample.
    pub digest: u64,
}

/// Lets a target identify the sensors of a scene; what happened on the link is left in the log.
pub fn record(
    scene: &Scene,
    met: Met,
    manner: &Manner,
    log: &Log,
) -> Result<Identified, FlightError> {
    let Met { conversation, offers } = met;
    let precision = scene.navigator.precision;
    choice::exactly(Offer::identification(precision), &offers)?;
    let conversation = match manner.faults {
        Some((rates, seed)) => {
            conversation.wrap(|channel| Box::new(Injector::new(channel, rates, seed)))
        }
        None => conversation,
    };
    let mut sums = Linked::start(scene, conversation, log)?;
    let record = record::of_scene_by(scene, &mut sums).map_err(|error| match error {
        SceneError::Source(error) => FlightError::from(error),
        SceneError::Complaint(complaint) => match sums.is_parted {
            true => stopped(complaint),
            false => InputError::option(&scene.name, complaint).into(),
        },
    })?;
    let (words, digest) = (sums.words, sums.lockstep.digest());
    Ok(Identified { record, words, digest })
}

/// The sums of a target and of its twin.
struct Linked {
    lockstep: Lockstep,
    beginning: Beginning,
    words: usize,
    is_parted: bool,
}

impl Linked {
    fn start(scene: &Scene, conversation: Conversation, log: &Log) -> Result<Self, FlightError> {
        let rate_hz = scene.rate_hz;
        let beginning = Beginning::identification(scene.navigator.precision, rate_hz);
        let twin = parts::twin(&beginning)?;
        let parts = Parts {
            conversation,
            beginning: beginning.clone(),
            twin,
            rate_hz,
            pace: None,
            aiding: None,
        };
        let lockstep = Lockstep::start(parts, log.clone()).map_err(stopped)?;
        Ok(Self { lockstep, beginning, words: 0, is_parted: false })
    }

    /// Of the words that the target has.
    fn read(&mut self) -> Result<[Vec<Point<f64>>; 6], Parted> {
        let words = self.lockstep.read_back()?;
        self.words = words.len() / 8;
        let refused = |twin| Parted::Refusal { target: None, twin: Some(twin) };
        let mut target = schuler_simulator::twin::Twin::start(&self.beginning).map_err(refused)?;
        target.restore(&words).map_err(refused)?;
        target.points().ok_or(Parted::Answer("its sums"))
    }
}

impl Sums for Linked {
    fn add(&mut self, sample: &Increment<f64>) -> Result<(), Complaint> {
        let taken = self.lockstep.take_sample(sample, &mut |_, _| ());
        taken.inspect_err(|_| self.is_parted = true)
    }

    fn points(&mut self) -> Result<[Vec<Point<f64>>; 6], Complaint> {
        let points = self.lockstep.end(&mut |_, _| ()).and_then(|_| self.read());
        points.map_err(|parted| {
            self.is_parted = true;
            parted.into()
        })
    }
}
