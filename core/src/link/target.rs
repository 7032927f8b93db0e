//! The target's application: bytes in, bytes out; the same on a board, in an emulator and on a host.
//!
//! A damaged frame changes nothing but a counter. Every whole frame of a host is answered once: a new one
//! according to its content, a repeated or late one with the state of the navigator, which it does not change.
//! Frames of a kind that only targets send are not answered.
//!
//! ```
//! use schuler::link::fleet::Single;
//! use schuler::link::target::Target;
//!
//! let mut target = Target::<Single>::new(0);
//! let mut sent = 0;
//! target.hello(&mut |frame: &[u8]| sent += frame.len());
//! assert!(sent > 0 && target.flight().is_none());
//! ```

use super::answer::{Answer, MOST_READ};
use super::counters::{Counters, count};
use super::decoder::Decoder;
use super::fleet::Fleet;
use super::flight::Taken;
use super::frame::{Frame, Header, MOST_ENCODED, Writer, encode};
use super::kind::Kind;
use super::message::{Request, VERSION};
use super::refusal::Refusal;
use super::sequence::{Arrival, Sequence};

/// A target that flies one of the mechanizations of `F`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Target<F> {
    decoder: Decoder,
    application: Application<F>,
}

/// All of it but the decoder, from which a frame is borrowed.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Application<F> {
    flight: Option<F>,
    /// Words of a stored state that it has, while some are missing.
    restored: Option<u16>,
    received: Sequence,
    counters: Counters,
    /// Frames sent.
    sent: u32,
    boot: u32,
    /// End of the last sample, ns.
    time_ns: u64,
}

/// What a frame is answered by.
enum Reply {
    Hello,
    Standing,
    Restoring(u16),
    /// The words of the state from this one on.
    State(u16),
    Refused(Refusal),
}

impl<F: Fleet> Target<F> {
    /// Switched on; `boot` is how often it was before, or another number that differs every time.
    pub fn new(boot: u32) -> Self {
        Self { decoder: Decoder::default(), application: Application::new(boot) }
    }

    /// Announces the target: the first frame that it sends.
    pub fn hello(&mut self, send: &mut impl FnMut(&[u8])) {
        self.application.send(0, Reply::Hello, send);
    }

    /// Takes a received byte. A frame that it completes is answered through `send`, which gets all bytes of
    /// the answer at once.
    pub fn take(&mut self, byte: u8, send: &mut impl FnMut(&[u8])) {
        let Some(frame) = self.decoder.take(byte) else { return };
        let number = frame.header.sequence;
        if frame.header.kind == Kind::Reset {
            *self = Self::new(self.application.boot.wrapping_add(1));
            return self.hello(send);
        }
        let is_greeting = frame.header.kind == Kind::Greet;
        let Some(reply) = self.application.serve(&frame) else { return };
        if is_greeting {
            self.decoder.forget_dropped();
        }
        self.application.counters.dropped = self.decoder.dropped();
        self.application.send(number, reply, send);
    }

    /// What it flies.
    pub fn flight(&self) -> Option<&F> {
        self.application.flight.as_ref()
    }
}

impl<F: Fleet> Application<F> {
    fn new(boot: u32) -> Self {
        Self {
            flight: None,
            restored: None,
            received: Sequence::default(),
            counters: Counters::default(),
            sent: 0,
            boot,
            time_ns: 0,
        }
    }

    fn counters(&self) -> Counters {
        let bridged = self.flight.as_ref().map_or(0, F::bridged);
        Counters { bridged, ..self.counters }
    }

    /// Carries out a frame; frames that no host sends are not answered.
    fn serve(&mut self, frame: &Frame) -> Option<Reply> {
        let Header { kind, sequence, time_ns } = frame.header;
        if matches!(
            kind,
            Kind::Hello | Kind::Solution | Kind::Restoring | Kind::State | Kind::Refused
        ) {
            return None;
        }
        if kind == Kind::Greet {
            // A new host counts its frames from the beginning, and the counters start anew for it.
            self.received = Sequence::after(sequence);
            self.counters = Counters::default();
            return Some(Reply::Hello);
        }
        let reply = match self.received.arrive(sequence, &mut self.counters) {
            Arrival::Duplicate | Arrival::Late => self.standing(),
            Arrival::New => match Request::read(frame) {
                Some(request) => self.ask(&request, time_ns).unwrap_or_else(Reply::Refused),
                None => Reply::Refused(Refusal::Malformed),
            },
        };
        Some(reply)
    }

    fn ask(&mut self, request: &Request, time_ns: u64) -> Result<Reply, Refusal> {
        match request {
            Request::Greet | Request::Reset => return Ok(Reply::Hello),
            Request::Start(start) => {
                // A refusal leaves the flight as it was.
                self.flight = Some(F::start(start)?);
                self.restored = None;
                self.time_ns = 0;
            }
            Request::Restore { words, offset, piece } => {
                return self.restore(*words, *offset, piece.0, time_ns);
            }
            Request::Sample { number, increment } => {
                let taken = self.flying()?.take(*number, *increment)?;
                if taken == Taken::Again {
                    count(&mut self.counters.repeated);
                } else {
                    self.time_ns = time_ns;
                }
            }
            Request::Hold(vertical) => self.flying()?.hold(*vertical)?,
            Request::Aid(settings) => self.flying()?.aid(*settings)?,
            Request::Measure { number, measured } => {
                if self.flying()?.measure(*number, *measured)? == Taken::Again {
                    count(&mut self.counters.repeated);
                }
            }
            Request::Read { offset } => {
                self.flying()?;
                return Ok(Reply::State(*offset));
            }
            Request::Finish { samples } => {
                if self.flying()?.finish(*samples)? == Taken::Again {
                    count(&mut self.counters.repeated);
                }
            }
        }
        Ok(self.standing())
    }

    fn flying(&mut self) -> Result<&mut F, Refusal> {
        let whole = self.restored.is_none();
        self.flight.as_mut().filter(|_| whole).ok_or(Refusal::NotStarted)
    }

    /// Writes a piece over the state: the first starts anew, and every other continues where the last
    /// one ended, or lies before it.
    fn restore(
        &mut self,
        words: u16,
        offset: u16,
        piece: &[u8],
        time_ns: u64,
    ) -> Result<Reply, Refusal> {
        let flight = self.flight.as_mut().ok_or(Refusal::NotStarted)?;
        let (pieces, rest) = piece.as_chunks::<8>();
        let all = words_of(flight);
        let have = if offset == 0 { 0 } else { self.restored.unwrap_or(words) };
        let end = usize::from(offset) + pieces.len();
        if words != all || !rest.is_empty() || offset > have || end > usize::from(words) {
            return Err(Refusal::Malformed);
        }
        let mut index = 0_usize;
        flight.restore(&mut |bits| {
            let word = index.checked_sub(usize::from(offset)).and_then(|n| pieces.get(n));
            index += 1;
            word.map_or(bits, |word| u64::from_le_bytes(*word))
        });
        let have = have.max(end as u16);
        if have < words {
            self.restored = Some(have);
            return Ok(Reply::Restoring(have));
        }
        if let Err(refusal) = flight.check() {
            // What was flown is written over: the state is awaited again.
            self.restored = Some(0);
            return Err(refusal);
        }
        self.restored = None;
        self.time_ns = time_ns;
        Ok(Reply::Standing)
    }

    /// Where the navigator stands, if there is one.
    fn standing(&self) -> Reply {
        match (&self.flight, self.restored) {
            (None, _) => Reply::Refused(Refusal::NotStarted),
            (_, Some(words)) => Reply::Restoring(words),
            (Some(_), None) => Reply::Standing,
        }
    }

    fn send(&mut self, answers: u32, reply: Reply, send: &mut impl FnMut(&[u8])) {
        self.sent = self.sent.wrapping_add(1);
        let kind = match reply {
            Reply::Hello => Kind::Hello,
            Reply::Standing => Kind::Solution,
            Reply::Restoring(_) => Kind::Restoring,
            Reply::State(_) => Kind::State,
            Reply::Refused(_) => Kind::Refused,
        };
        let header = Header { kind, sequence: self.sent, time_ns: self.time_ns };
        let mut buffer = [0; MOST_ENCODED];
        let frame = encode(&header, &mut buffer, |to| {
            Answer::write_begin(to, answers, self.boot, self.counters());
            match reply {
                Reply::Hello => {
                    to.u8(VERSION);
                    F::offers(&mut |offer| to.bytes(&offer.to_bytes()));
                }
                Reply::Standing => {
                    if let Some(flight) = &self.flight {
                        flight.write(to);
                    }
                }
                Reply::Restoring(words) => to.u16(words),
                Reply::State(offset) => {
                    if let Some(flight) = &self.flight {
                        write_words(flight, offset, to);
                    }
                }
                Reply::Refused(refusal) => {
                    to.u8(refusal.code());
                    to.u32(self.flight.as_ref().map_or(0, F::taken));
                }
            }
        });
        // No answer is longer than a frame: an image that offers too much shows at its first word.
        if let Ok(frame) = frame {
            send(frame);
        }
    }
}

/// The number of words of a state.
fn words_of(flight: &impl Fleet) -> u16 {
    let mut all = 0_u16;
    flight.words(&mut |_| all = all.saturating_add(1));
    all
}

/// Writes words of a state from one on, as many as an answer holds.
fn write_words(flight: &impl Fleet, offset: u16, to: &mut Writer) {
    to.u16(words_of(flight));
    to.u16(offset);
    let (first, mut index) = (usize::from(offset), 0_usize);
    flight.words(&mut |bits| {
        if index >= first && index - first < MOST_READ {
            to.u64(bits);
        }
        index += 1;
    });
}
