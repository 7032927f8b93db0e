//! A channel with faults that a seed determines: the same faults every time.
//!
//! It knows how many answers are due, and reports silence at once if there is none. So nobody waits for a
//! frame that it dropped, and the result does not depend on the clock. Every fault has its own effect: if a
//! request is hit, its answer is not, nor is an answer that nobody waits for. Faults that delay frames occur once
//! per request, even if it is repeated. A target is rebooted only when all of its counters are known.

use super::channel::{Broken, Channel};
use super::cutter::Cutter;
use super::faults::{Fault, Injected, Rates};
use super::wait::Wait;
use schuler::link::decoder::Decoder;
use schuler::link::frame::{Header, MOST_ENCODED, encode};
use schuler::link::kind::Kind;
use schuler::link::message::{Answer, Request};
use schuler::noise::{Stream, Streams};
use std::collections::VecDeque;
use std::time::Duration;

/// Frames that a stalled target lets wait after the first.
const STALL: u32 = 2;

/// A channel with faults.
pub struct Injector<C> {
    channel: C,
    rates: Rates,
    random: Stream,
    injected: Injected,
    is_armed: bool,
    /// Frames to the target that wait for the next one, or for the one after it.
    waiting: Vec<Vec<u8>>,
    overtaken: Vec<Vec<u8>>,
    /// Frames that a stalled target still lets wait.
    stalled: u32,
    /// Sequence number of the last request, and whether it was hit.
    newest: u32,
    is_hit: bool,
    /// Whether the host may not know yet of something that was hit.
    is_untold: bool,
    /// The last request, its sequence number apart, and whether something has kept it waiting.
    request: (Kind, Vec<u8>),
    has_waited: bool,
    /// Answers that are due.
    due: u64,
    /// Bytes from the target that nobody has asked for, and those that begin a frame.
    unread: VecDeque<u8>,
    from_target: Cutter,
    /// Answers for the host: now, after the next request, after the next answer.
    ready: VecDeque<u8>,
    late: Vec<u8>,
    overtaken_answers: Vec<u8>,
}

impl<C: Channel> Injector<C> {
    /// Puts faults into a channel on which no answer is due.
    pub fn new(channel: C, rates: Rates, seed: u64) -> Self {
        Self {
            channel,
            rates,
            random: Streams::new(seed, 0).branch(Streams::LINK).open(),
            injected: Injected::default(),
            is_armed: true,
            waiting: Vec::new(),
            overtaken: Vec::new(),
            stalled: 0,
            newest: 0,
            is_hit: false,
            is_untold: false,
            request: (Kind::Greet, Vec::new()),
            has_waited: false,
            due: 0,
            unread: VecDeque::new(),
            from_target: Cutter::default(),
            ready: VecDeque::new(),
            late: Vec::new(),
            overtaken_answers: Vec::new(),
        }
    }

    /// Sends a frame as it is, and after it those that it has overtaken.
    fn pass(&mut self, frame: &[u8]) -> Result<(), Broken> {
        self.deliver(frame)?;
        for frame in std::mem::take(&mut self.overtaken) {
            self.deliver(&frame)?;
        }
        Ok(())
    }

    fn deliver(&mut self, frame: &[u8]) -> Result<(), Broken> {
        self.due += 1;
        self.channel.send(frame)
    }

    fn pick_for_request(&mut self, header: &Header) -> Option<Fault> {
        // A greeting is where the target begins to count.
        if !self.is_armed || header.kind == Kind::Greet {
            return None;
        }
        let fault = self.rates.pick(self.random.uniform(), Fault::ALL.len())?;
        let is_quiet = self.waiting.is_empty() && self.overtaken.is_empty() && self.late.is_empty();
        let possible = match fault {
            Fault::Delay | Fault::Stall => !self.has_waited,
            Fault::Reboot => {
                let nothing_comes = self.overtaken_answers.is_empty() && self.due == 0;
                let is_known = is_quiet && nothing_comes && !self.is_untold;
                !self.has_waited && is_known && header.kind == Kind::Sample
            }
            _ => true,
        };
        let waits = matches!(fault, Fault::Delay | Fault::Stall | Fault::Reboot);
        self.has_waited |= possible && waits;
        possible.then_some(fault)
    }

    /// Passes a frame on to the host, whole or not.
    fn answer(&mut self, bytes: Vec<u8>) {
        let answers = answers(&bytes);
        let fault = self.pick_for_answer(answers);
        if let Some(fault) = fault {
            self.injected.count(fault, false);
            self.is_untold = true;
        } else if answers == Some(self.newest) && !self.is_hit {
            self.is_untold = false;
        }
        match fault {
            None => self.ready.extend(&bytes),
            Some(Fault::Duplicate) => self.ready.extend([&bytes[..], &bytes].concat()),
            Some(Fault::Reorder) => return self.overtaken_answers.extend(bytes),
            Some(Fault::Delay) => return self.late.extend(bytes),
            Some(Fault::Truncate) => {
                let broken = self.truncated(&bytes);
                return self.ready.extend(broken);
            }
            Some(Fault::Flip) => {
                let broken = self.flipped(&bytes);
                return self.ready.extend(broken);
            }
            Some(Fault::Drop | Fault::Stall | Fault::Reboot) => return,
        }
        self.ready.extend(self.overtaken_answers.drain(..));
    }

    fn pick_for_answer(&mut self, answers: Option<u32>) -> Option<Fault> {
        if !self.is_armed || self.is_hit || answers != Some(self.newest) {
            return None;
        }
        let fault = self.rates.pick(self.random.uniform(), Fault::OF_ANSWERS)?;
        if fault == Fault::Delay {
            // What else is due would overtake it.
            if self.due > 0 || self.has_waited {
                return None;
            }
            self.has_waited = true;
        }
        self.is_hit = true;
        Some(fault)
    }

    fn truncated(&mut self, frame: &[u8]) -> Vec<u8> {
        // At least the last byte before the closing one is missing.
        frame[..self.below(frame.len() - 1)].to_vec()
    }

    fn flipped(&mut self, frame: &[u8]) -> Vec<u8> {
        let mut frame = frame.to_vec();
        let bit = self.below(8 * frame.len());
        frame[bit / 8] ^= 1 << (bit % 8);
        frame
    }

    fn below(&mut self, bound: usize) -> usize {
        (self.random.uniform::<f64>() * bound as f64) as usize
    }
}

impl<C: Channel> Channel for Injector<C> {
    fn send(&mut self, frame: &[u8]) -> Result<(), Broken> {
        self.ready.extend(self.late.drain(..));
        let mut decoder = Decoder::default();
        let whole = frame.iter().find_map(|&byte| {
            let frame = decoder.take(byte)?;
            Some((frame.header, frame.payload.to_vec()))
        });
        let Some((header, payload)) = whole else { return self.channel.send(frame) };
        let request = (header.kind, payload);
        if self.request != request {
            self.request = request;
            self.has_waited = false;
            self.stalled = 0;
        }
        (self.newest, self.is_hit) = (header.sequence, false);
        if self.stalled > 0 {
            self.stalled -= 1;
            self.is_hit = true;
            self.waiting.push(frame.to_vec());
            return Ok(());
        }
        for frame in std::mem::take(&mut self.waiting) {
            self.pass(&frame)?;
        }
        let Some(fault) = self.pick_for_request(&header) else { return self.pass(frame) };
        self.injected.count(fault, true);
        (self.is_hit, self.is_untold) = (true, true);
        match fault {
            Fault::Drop => {}
            Fault::Duplicate => {
                self.deliver(frame)?;
                self.pass(frame)?;
            }
            Fault::Reorder => self.overtaken.push(frame.to_vec()),
            Fault::Delay => self.waiting.push(frame.to_vec()),
            Fault::Truncate => {
                let broken = self.truncated(frame);
                self.channel.send(&broken)?;
            }
            Fault::Flip => {
                let broken = self.flipped(frame);
                self.channel.send(&broken)?;
            }
            Fault::Stall => {
                self.stalled = STALL;
                self.waiting.push(frame.to_vec());
            }
            Fault::Reboot => {
                self.deliver(&reset())?;
                self.pass(frame)?;
            }
        }
        Ok(())
    }

    fn receive(&mut self, into: &mut Vec<u8>, patience: Duration) -> Result<(), Broken> {
        // One at a time: what comes is looked at when it is asked for, not when it happens to come.
        let mut wait = Wait::new(patience);
        while self.ready.is_empty() && self.due > 0 {
            if let Some(byte) = self.unread.pop_front() {
                if let Some(frame) = self.from_target.take(byte) {
                    self.due -= 1;
                    self.answer(frame);
                }
                continue;
            }
            let Some(patience) = wait.left() else { break };
            let mut bytes = Vec::new();
            self.channel.receive(&mut bytes, patience)?;
            if bytes.is_empty() {
                break;
            }
            self.unread.extend(bytes);
        }
        into.extend(self.ready.drain(..));
        Ok(())
    }

    fn injected(&self) -> Option<Injected> {
        Some(self.injected)
    }

    fn calm(&mut self) {
        self.is_armed = false;
        self.stalled = 0;
    }
}

/// The sequence number of the frame that an answer answers.
fn answers(bytes: &[u8]) -> Option<u32> {
    let mut decoder = Decoder::default();
    bytes.iter().find_map(|&byte| {
        let frame = decoder.take(byte)?;
        Some(Answer::read(&frame)?.answers)
    })
}

/// The frame that makes a target forget everything.
fn reset() -> Vec<u8> {
    let header = Header { kind: Kind::Reset, sequence: 0, time_ns: 0 };
    let mut buffer = [0; MOST_ENCODED];
    encode(&header, &mut buffer, |to| Request::Reset.write(to)).map_or(Vec::new(), <[u8]>::to_vec)
}
