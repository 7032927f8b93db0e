//! A target's answer, independent of the bytes that it was received in.

use schuler::link::message::Body;
use schuler::link::offer::Offer;
use schuler::link::refusal::Refusal;
use schuler_simulator::twin::Standing;

/// An answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reply {
    /// Who is there.
    Hello {
        /// Its version of the protocol.
        version: u8,
        /// What it can do.
        offers: Vec<Offer>,
    },
    /// Where it stands.
    Standing(Standing),
    /// How many words of a stored state it has.
    Restoring(u16),
    /// A piece of its state.
    State {
        /// Words of the whole state.
        words: u16,
        /// Where the piece begins.
        offset: u16,
        /// Some words of it, eight bytes each.
        piece: Vec<u8>,
    },
    /// It does not do what was asked, at a sample.
    Refused(Refusal, u32),
}

impl Reply {
    /// Why it is not done, if it is not.
    pub fn refusal(&self) -> Option<Refusal> {
        if let Self::Refused(refusal, _) = self { Some(*refusal) } else { None }
    }

    /// Of a target's frame.
    pub fn of(body: Body, time_ns: u64) -> Self {
        match body {
            Body::Hello { version, mut offers } => {
                let offers = std::iter::from_fn(|| Some(Offer::from_bytes(offers.array()?)));
                Self::Hello { version, offers: offers.flatten().collect() }
            }
            Body::Solution(standing) => Self::Standing(Standing {
                time_ns,
                taken: standing.taken,
                came: standing.came,
                integrated: standing.integrated,
                digest: standing.digest,
                solution: standing.solution.0.to_vec(),
            }),
            Body::Restoring { words } => Self::Restoring(words),
            Body::State { words, offset, piece } => {
                Self::State { words, offset, piece: piece.0.to_vec() }
            }
            Body::Refused { refusal, taken } => Self::Refused(refusal, taken),
        }
    }
}
