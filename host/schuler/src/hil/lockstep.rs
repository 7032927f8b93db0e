//! Target and twin in step: one sample out, one answer back, and every bit compared.
//!
//! | file | what it has |
//! |---|---|
//! | `start` | starting a target, and putting it back to where its twin stands |
//! | `aiding` | measurements, and what a filter says |
//! | `read` | the whole state of a target, beside its twin's |
//! | `vehicle` | both sides as the vehicle of a flight |

mod aiding;
mod read;
mod start;
mod vehicle;

use super::conversation::{Conversation, Outcome};
use super::difference::{self, Difference};
use super::pace::Pace;
use super::parted::{MOST_REBOOTS, Parted};
use super::reply::Reply;
use super::tally::Tally;
use crate::report::lockstep::Event;
use schuler::link::bytes::Bytes;
use schuler::link::gap::{MOST_BRIDGED, Policy};
use schuler::link::{message::Request, refusal::Refusal};
use schuler::sample::Increment;
use schuler_simulator::input::Complaint;
use schuler_simulator::navigator::Reader;
use schuler_simulator::scene::WindowShape;
use schuler_simulator::simulate::Refused;
use schuler_simulator::twin::{Beginning, Standing, Twin};
use std::sync::{Arc, Mutex, PoisonError};

pub use aiding::Aiding;
pub use vehicle::Boarded;

/// What is left of a lockstep flight when it has ended, well or not.
#[derive(Clone, Debug, Default)]
pub struct Ended {
    /// What happened on the link.
    pub tally: Tally,
    /// How long each sample's answer took, s.
    pub latencies_s: Vec<f64>,
    /// Samples during which something happened on the link.
    pub events: Vec<Event>,
    /// Why target and twin part, if they do.
    pub parted: Option<String>,
    /// The window that was planned, where the target does not have it.
    pub planned_window: Option<WindowShape>,
}

/// Where it is left.
pub type Log = Arc<Mutex<Ended>>;

/// What a lockstep flight is made of.
pub struct Parts {
    /// The line to the target.
    pub conversation: Conversation,
    /// How both sides start.
    pub beginning: Beginning,
    /// The host's side.
    pub twin: Twin,
    /// Samples per second.
    pub rate_hz: f64,
    /// In real time, if there is one.
    pub pace: Option<Pace>,
    /// What aids the flight, if anything does.
    pub aiding: Option<Aiding>,
}

/// A target and its twin.
pub struct Lockstep {
    conversation: Conversation,
    beginning: Beginning,
    twin: Twin,
    rate_hz: f64,
    /// Samples so far.
    samples: u32,
    /// The newest of them that both sides have flown.
    reached: u32,
    /// Samples that were given up, while it is not known which of them the target has.
    open: Vec<(u32, Vec<u8>)>,
    pace: Option<Pace>,
    aiding: Option<Aiding>,
    log: Log,
}

impl Lockstep {
    /// Starts both sides; what happens is left in the log.
    pub fn start(parts: Parts, log: Log) -> Result<Self, Parted> {
        let Parts { conversation, beginning, twin, rate_hz, pace, aiding } = parts;
        let mut lockstep = Self {
            conversation,
            beginning,
            twin,
            rate_hz,
            samples: 0,
            reached: 0,
            open: Vec::new(),
            pace,
            aiding,
            log,
        };
        lockstep.claim();
        let reply = lockstep.begin()?;
        lockstep.agree(reply)?;
        Ok(lockstep)
    }

    /// Asks, and puts a target that was switched off and on back to where its twin stands.
    fn ask(&mut self, request: &Request) -> Result<Option<Reply>, Parted> {
        for _ in 0..MOST_REBOOTS {
            let time_ns = self.time_ns(self.samples);
            let outcome = match request {
                Request::Sample { .. } => self.conversation.ask(request, time_ns)?,
                _ => self.conversation.insist(request, time_ns)?,
            };
            match outcome {
                Outcome::Answered(reply) => return Ok(Some(reply)),
                Outcome::Silence => return Ok(None),
                Outcome::Rebooted => self.restore()?,
            }
        }
        Err(Parted::Reboots)
    }

    /// End of a sample, ns.
    fn time_ns(&self, number: u32) -> u64 {
        (f64::from(number) / self.rate_hz * 1e9).round() as u64
    }

    /// The twin flies those of the open samples that the target has.
    fn settle(&mut self, standing: &Standing, read: &mut Reader) -> Result<(), Parted> {
        for (number, increment) in std::mem::take(&mut self.open) {
            let age = standing.taken.wrapping_sub(number);
            if standing.came.checked_shr(age).is_some_and(|came| came & 1 == 1) {
                self.take(number, &increment, read)?;
            }
        }
        Ok(())
    }

    /// The twin takes what the target has taken.
    fn take(&mut self, number: u32, increment: &[u8], read: &mut Reader) -> Result<(), Parted> {
        let taken = self.by_twin(read, |twin, read| twin.take(number, increment, read));
        taken.map_err(|twin| Parted::Refusal { target: None, twin: Some(twin) })?;
        self.reached = number;
        Ok(())
    }

    fn agree(&mut self, reply: Reply) -> Result<(), Parted> {
        match reply {
            Reply::Standing(standing) => self.compare(&standing),
            Reply::Refused(target, _) => Err(Parted::Refusal { target: Some(target), twin: None }),
            _ => Err(Parted::Answer("what it is asked")),
        }
    }

    fn compare(&mut self, standing: &Standing) -> Result<(), Parted> {
        let twin = Standing { time_ns: self.time_ns(self.reached), ..self.twin.standing() };
        match difference::first(&self.beginning.configuration, standing, &twin) {
            None => Ok(()),
            Some((field, target, twin)) => Err(Parted::Difference(Difference {
                sample: self.samples.into(),
                time_s: f64::from(self.samples) / self.rate_hz,
                field,
                target,
                twin,
            })),
        }
    }

    fn sample(
        &mut self,
        sample: &Increment<f64>,
        read: &mut Reader,
    ) -> Result<Result<(), Refused>, Parted> {
        self.samples += 1;
        let (number, increment) = (self.samples, self.twin.narrow(sample));
        let asked = self.pace.as_ref().map(|pace| pace.wait(number));
        let before = self.conversation.happened();
        let reply = self.ask(&Request::Sample { number, increment: Bytes(&increment) });
        self.note(before);
        let reply = reply?;
        if let Some(asked) = asked {
            self.ended(|ended| ended.latencies_s.push(asked.elapsed().as_secs_f64()));
        }
        match reply {
            Some(Reply::Standing(standing)) => {
                self.settle(&standing, read)?;
                self.take(number, &increment, read)?;
                self.compare(&standing).map(Ok)
            }
            Some(Reply::Refused(target, _)) => {
                let twin = self.by_twin(read, |twin, read| twin.take(number, &increment, read));
                refused(Some(target), twin.err())
            }
            Some(_) => Err(Parted::Answer("a sample")),
            None => {
                self.open.push((number, increment));
                self.conversation.lose();
                if self.beginning.gap() == Policy::Refuse {
                    return Ok(Err(Refused::Missing));
                }
                if self.open.len() > MOST_BRIDGED as usize {
                    return Err(Parted::Lost(self.open.len()));
                }
                Ok(Ok(()))
            }
        }
    }

    /// Notes what has happened on the link during a sample.
    fn note(&self, before: [u64; 2]) {
        let after = self.conversation.happened();
        if after != before {
            let [faults, sent_again] = [0, 1].map(|i| after[i] - before[i]);
            let time_s = f64::from(self.samples) / self.rate_hz;
            self.ended(|ended| ended.events.push(Event { time_s, faults, sent_again }));
        }
    }

    /// The end of the stream: both sides take what waits, and of an aided flight the whole state is compared.
    pub(super) fn end(&mut self, read: &mut Reader) -> Result<Result<(), Refused>, Parted> {
        let request = Request::Finish { samples: self.samples };
        let reply = self.ask(&request)?.ok_or(Parted::Silence("the end of the stream"))?;
        if let Reply::Standing(standing) = &reply {
            self.settle(standing, read)?;
        }
        let samples = self.samples;
        let twin = self.by_twin(read, |twin, read| twin.finish(samples, read)).err();
        if twin.is_some() {
            return refused(reply.refusal(), twin);
        }
        self.agree(reply)?;
        if self.aiding.is_some() {
            self.read_back()?;
        }
        // What was put in shows only in the frames that follow it.
        if self.conversation.calm() {
            for _ in 0..2 {
                let reply = self.ask(&request)?.ok_or(Parted::Silence("the end of the stream"))?;
                self.agree(reply)?;
            }
        }
        Ok(Ok(()))
    }

    fn hold(&mut self, altitude_m: f64, down_m_s: f64) -> Result<Result<(), Refused>, Parted> {
        let vertical = self.twin.vertical(altitude_m, down_m_s);
        let request = Request::Hold(Bytes(&vertical));
        let reply = self.ask(&request)?.ok_or(Parted::Silence("a held height"))?;
        let twin = self.twin.hold(&vertical).err();
        if twin.is_some() {
            return refused(reply.refusal(), twin);
        }
        self.agree(reply).map(Ok)
    }

    fn ended(&self, change: impl FnOnce(&mut Ended)) {
        change(&mut self.log.lock().unwrap_or_else(PoisonError::into_inner));
    }

    /// An end that is not the scene's: where it happened, and what.
    fn stop(&self, parted: &Parted) -> Refused {
        let time_s = f64::from(self.samples) / self.rate_hz;
        let place = match parted {
            Parted::Difference(_) => String::new(),
            _ => format!("sample {} at {time_s} s: ", self.samples),
        };
        let why = format!("{place}{parted}");
        self.ended(|ended| ended.parted = Some(why.clone()));
        Refused::Stopped(Complaint::new(why, ""))
    }
}

/// What it means that one side refuses: both for the same reason, and what is refused cannot be flown.
fn refused(target: Option<Refusal>, twin: Option<Refusal>) -> Result<Result<(), Refused>, Parted> {
    match target {
        Some(Refusal::Rejected(why)) if twin == target => Ok(Err(why.into())),
        Some(Refusal::Aided(why)) if twin == target => Ok(Err(why.into())),
        _ => Err(Parted::Refusal { target, twin }),
    }
}
