//! Requests and their answers: requests are repeated if no answer comes, and surplus answers are recognised.

use super::channel::{Broken, Channel};
use super::patience::Patience;
use super::reply::Reply;
use super::tally::Tally;
use super::wait::Wait;
use schuler::link::counters::Counters;
use schuler::link::decoder::Decoder;
use schuler::link::frame::{Header, MOST_ENCODED, TooLong, encode};
use schuler::link::message::{Answer, Request};
use schuler::link::refusal::Refusal;
use schuler::link::sequence::{Arrival, Sequence};
use std::collections::VecDeque;
use std::ops::RangeInclusive;
use std::time::{Duration, Instant};

/// How often what a flight cannot do without is sent again, at least.
const INSISTING: u32 = 10;

/// How often somebody is greeted who may not be there.
const GREETINGS: u32 = 2;

/// What came of a request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It was answered.
    Answered(Reply),
    /// However often it was sent: no answer came.
    Silence,
    /// The target has been switched off and on, and knows nothing of what it was asked before.
    Rebooted,
}

/// The host's end of a link.
pub struct Conversation {
    channel: Box<dyn Channel>,
    decoder: Decoder,
    inbox: VecDeque<u8>,
    retries: u32,
    /// How long an answer is waited for.
    patience: Patience,
    /// Sequence number of the last frame sent.
    sent: u32,
    received: Sequence,
    /// The boots of the target that were met, the present one last.
    boots: Vec<u32>,
    /// What the target has noticed since its last boot.
    noticed: Counters,
    /// The frames of each request that was given up, whose answers may still come.
    given_up: Vec<RangeInclusive<u32>>,
    tally: Tally,
}

/// An answer, and how it stands to those before it.
struct Heard {
    answers: u32,
    is_new: bool,
    /// It answers a frame that a later one had overtaken.
    is_of_late: bool,
    is_new_boot: bool,
    sequence: u32,
    reply: Reply,
}

impl Conversation {
    /// Over a channel; a sample is sent again so many times.
    pub fn new(channel: Box<dyn Channel>, retries: u32) -> Self {
        Self {
            channel,
            decoder: Decoder::default(),
            inbox: VecDeque::new(),
            retries,
            patience: Patience::default(),
            sent: 0,
            received: Sequence::default(),
            boots: Vec::new(),
            noticed: Counters::default(),
            given_up: Vec::new(),
            tally: Tally::default(),
        }
    }

    /// With another patience than the usual one.
    pub fn patient(self, patience: Patience) -> Self {
        Self { patience, ..self }
    }

    /// Puts something between this end and the channel.
    pub fn wrap(self, wrap: impl FnOnce(Box<dyn Channel>) -> Box<dyn Channel>) -> Self {
        Self { channel: wrap(self.channel), ..self }
    }

    /// Faults put in so far, and requests sent again.
    pub fn happened(&self) -> [u64; 2] {
        [self.channel.injected().map_or(0, |injected| injected.total()), self.tally.resent]
    }

    /// What happened so far.
    pub fn tally(&self) -> Tally {
        let mut tally = self.tally.clone();
        tally.host.dropped = self.decoder.dropped();
        tally.add_target(&self.noticed);
        tally.injected = self.channel.injected();
        tally
    }

    /// From here on no fault is put in any more; whether any was put in before.
    pub fn calm(&mut self) -> bool {
        self.channel.calm();
        self.channel.injected().is_some()
    }

    /// Asks who is there, of somebody who may not be.
    pub fn greet(&mut self) -> Result<Outcome, Broken> {
        self.ask_again(&Request::Greet, 0, GREETINGS - 1)
    }

    /// How long a greeting is waited for.
    pub fn greeting_lasts(&self) -> Duration {
        (0..GREETINGS).map(|attempt| self.patience.at(attempt)).sum()
    }

    /// Asks what a flight cannot do without.
    pub fn insist(&mut self, request: &Request, time_ns: u64) -> Result<Outcome, Broken> {
        self.ask_again(request, time_ns, self.retries.max(INSISTING))
    }

    /// Asks, and waits for the answer.
    pub fn ask(&mut self, request: &Request, time_ns: u64) -> Result<Outcome, Broken> {
        self.ask_again(request, time_ns, self.retries)
    }

    fn ask_again(
        &mut self,
        request: &Request,
        time_ns: u64,
        retries: u32,
    ) -> Result<Outcome, Broken> {
        let first = self.sent.wrapping_add(1);
        for attempt in 0..=retries {
            self.send(request, time_ns)?;
            self.tally.resent += u64::from(attempt > 0);
            let asked = Instant::now();
            let mut wait = Wait::new(self.patience.at(attempt));
            while let Some(heard) = self.hear(&mut wait)? {
                let is_answer = (first..=self.sent).contains(&heard.answers);
                if heard.is_new_boot {
                    return Ok(Outcome::Rebooted);
                }
                if is_answer && matches!(heard.reply, Reply::Refused(Refusal::NotStarted, _)) {
                    // It counts its boots no more than its frames.
                    self.begin_boot(Sequence::after(heard.sequence));
                    return Ok(Outcome::Rebooted);
                }
                if is_answer && heard.is_new {
                    let is_overdue = heard.answers != self.sent && !heard.is_of_late;
                    self.tally.answered(attempt, is_overdue);
                    if attempt == 0 {
                        self.patience.learn(asked.elapsed());
                    }
                    return Ok(Outcome::Answered(heard.reply));
                }
                self.note(&heard);
            }
        }
        self.given_up.push(first..=self.sent);
        Ok(Outcome::Silence)
    }

    /// A sample was given up.
    pub fn lose(&mut self) {
        self.tally.lost += 1;
    }

    fn send(&mut self, request: &Request, time_ns: u64) -> Result<(), Broken> {
        self.sent = self.sent.wrapping_add(1);
        self.tally.sent += 1;
        let header = Header { kind: request.kind(), sequence: self.sent, time_ns };
        let mut buffer = [0; MOST_ENCODED];
        let frame = encode(&header, &mut buffer, |to| request.write(to));
        self.channel.send(frame.map_err(|too_long: TooLong| Broken(too_long.to_string()))?)
    }

    /// The next answer that comes, whatever it answers; none within the wait.
    fn hear(&mut self, wait: &mut Wait) -> Result<Option<Heard>, Broken> {
        loop {
            while let Some(byte) = self.inbox.pop_front() {
                let Some(frame) = self.decoder.take(byte) else { continue };
                let Header { sequence, time_ns, .. } = frame.header;
                let Some(answer) = Answer::read(&frame) else {
                    self.tally.not_understood += 1;
                    continue;
                };
                let (answers, boot, counters) = (answer.answers, answer.boot, answer.counters);
                let reply = Reply::of(answer.body, time_ns);
                self.tally.received += 1;
                let is_new_boot = self.meet(boot);
                let is_present = self.boots.last() == Some(&boot);
                let is_new = is_present
                    && self.received.arrive(sequence, &mut self.tally.host) == Arrival::New;
                let is_of_late = is_new && counters.late != self.noticed.late;
                if is_new {
                    self.noticed = counters;
                }
                let heard = Heard { answers, is_new, is_of_late, is_new_boot, sequence, reply };
                return Ok(Some(heard));
            }
            let Some(patience) = wait.left() else { return Ok(None) };
            let mut bytes = Vec::new();
            self.channel.receive(&mut bytes, patience)?;
            if bytes.is_empty() {
                return Ok(None);
            }
            self.inbox.extend(bytes);
        }
    }

    /// Whether a frame is the first from a target that was switched on since.
    fn meet(&mut self, boot: u32) -> bool {
        if self.boots.contains(&boot) {
            return false;
        }
        self.boots.push(boot);
        let is_first = self.boots.len() == 1;
        if !is_first {
            // It counts its frames from 1.
            self.begin_boot(Sequence::after(0));
        }
        !is_first
    }

    fn begin_boot(&mut self, received: Sequence) {
        self.tally.reboots += 1;
        self.tally.add_target(&std::mem::take(&mut self.noticed));
        self.received = received;
    }

    /// An answer that is not waited for.
    fn note(&mut self, heard: &Heard) {
        if !heard.is_new || heard.answers == 0 {
            return;
        }
        let given_up = self.given_up.iter().position(|frames| frames.contains(&heard.answers));
        if let Some(place) = given_up
            && !heard.is_of_late
        {
            self.given_up.swap_remove(place);
            self.tally.overdue += 1;
        }
    }
}
