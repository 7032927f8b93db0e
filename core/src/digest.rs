//! A running hash of states: runs with equal digests had, but for a chance of 2⁻⁶⁴, equal
//! bits in every field after every block. A chain keeps it at checkpoints, between which two runs
//! that part can be told apart.
//!
//! Every word goes into one of four lanes in turn, each state beginning with the first, so that the
//! multiplications overlap; it is no cryptographic hash. Words are numbers, not bytes in memory, so
//! that endianness does not show.
//!
//! The promise behind it: for one scene, seed, precision and configuration every state has the same
//! bits on every target. It rests on IEEE 754's + − × ÷ √, a pinned libm, no float function of the
//! standard library, no fused multiplication and addition, no NaN in a state, and subnormal numbers
//! that survive. −0 counts as what it is: it comes about by the same operations everywhere.

use crate::record::{Record, record};

/// The state of a running digest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Digest {
    lanes: [u64; 4],
    words: u64,
}

/// Odd, with bits well spread: ⌊2⁶⁴/golden ratio⌋.
const MULTIPLIER: u64 = 0x9e37_79b9_7f4a_7c15;

/// Words that nobody counts beyond: a state of a hundred a nanosecond for years.
#[cfg(feature = "link")]
const MOST_WORDS: u64 = 1 << 62;

impl Default for Digest {
    fn default() -> Self {
        Self { lanes: [1, 2, 3, 4], words: 0 }
    }
}

impl Digest {
    /// Takes in every field of a state.
    #[inline(always)]
    pub fn add<S: Record>(&mut self, state: &S) {
        let mut adding = Adding { digest: *self, lane: 0 };
        state.record("", &mut |_, bits| adding.word(bits));
        *self = adding.digest;
    }

    /// The same for a state given as words.
    pub fn add_words(&mut self, words: impl IntoIterator<Item = u64>) {
        let mut adding = Adding { digest: *self, lane: 0 };
        words.into_iter().for_each(|bits| adding.word(bits));
        *self = adding.digest;
    }

    /// The digest of everything so far.
    pub fn value(&self) -> u64 {
        self.lanes.iter().fold(mix(0, self.words), |sum, &lane| mix(sum, lane))
    }
}

#[cfg(feature = "link")]
impl Digest {
    /// Whether it can be one: any lanes are, but not any number of words.
    pub(crate) fn is_plausible(&self) -> bool {
        self.words <= MOST_WORDS
    }
}

impl Record for Digest {
    record!(lanes, words;);
}

/// A digest while it takes in a state.
struct Adding {
    digest: Digest,
    lane: usize,
}

impl Adding {
    #[inline(always)]
    fn word(&mut self, bits: u64) {
        let lanes = &mut self.digest.lanes;
        lanes[self.lane % 4] = mix(lanes[self.lane % 4], bits);
        self.lane += 1;
        self.digest.words += 1;
    }
}

/// A digest with a checkpoint at every so many samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Chain {
    digest: Digest,
    every: u64,
    next: u64,
}

/// The digest of everything up to a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Checkpoint {
    /// The number of samples behind it.
    pub sample: u64,
    /// The digest there.
    pub digest: u64,
}

impl Chain {
    /// With a checkpoint at the first state that lies so many samples, at least one, behind the last.
    pub fn new(every: u64) -> Self {
        let every = every.max(1);
        Self { digest: Digest::default(), every, next: every }
    }

    /// Takes in the state after so many samples; a checkpoint if one is due.
    #[inline(always)]
    pub fn add<S: Record>(&mut self, sample: u64, state: &S) -> Option<Checkpoint> {
        self.digest.add(state);
        self.checkpoint(sample)
    }

    /// The same for a state given as words.
    pub fn add_words(
        &mut self,
        sample: u64,
        words: impl IntoIterator<Item = u64>,
    ) -> Option<Checkpoint> {
        self.digest.add_words(words);
        self.checkpoint(sample)
    }

    #[inline(always)]
    fn checkpoint(&mut self, sample: u64) -> Option<Checkpoint> {
        if sample < self.next {
            return None;
        }
        self.next = (sample / self.every).saturating_add(1).saturating_mul(self.every);
        Some(Checkpoint { sample, digest: self.digest.value() })
    }

    /// The digest of everything so far.
    pub fn value(&self) -> u64 {
        self.digest.value()
    }
}

#[inline(always)]
fn mix(sum: u64, word: u64) -> u64 {
    // Each round is a bijection of the sum, so two runs that differ once stay apart.
    let x = (sum ^ word).wrapping_mul(MULTIPLIER);
    x ^ (x >> 32)
}
