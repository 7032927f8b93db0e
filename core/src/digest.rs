//! A running hash of states. Two runs with equal digests had equal bits in every field after every block,
//! except with a probability of 2⁻⁶⁴. A chain keeps the digest at checkpoints, so that the interval in which
//! two runs begin to differ can be found.
//!
//! Words go into four lanes in turn, starting each state with the first, so that the
//! multiplications overlap. It is not a cryptographic hash. Words are numbers, not bytes in memory, so
//! the result does not depend on endianness.
//!
//! The promise behind it: for one scene, seed, precision and configuration every state has the same
//! bits on every target. It rests on IEEE 754's + − × ÷ √, one version of libm, no float function of the
//! standard library, no fused multiplication and addition, no NaN in a state, and subnormal numbers that
//! are not flushed to zero. −0 and +0 are different words: the same operations give the same zero everywhere.
//!
//! ```
//! use schuler::digest::{Chain, Digest};
//! use schuler::math::vector::Vector;
//!
//! let (mut one, mut other) = (Digest::default(), Digest::default());
//! one.add(&Vector::new(0.1_f32, 0.2, 0.3));
//! other.add(&Vector::new(0.1_f32, 0.2, 0.3_f32.next_up()));
//! assert_ne!(one.value(), other.value());
//!
//! let mut chain = Chain::new(2);
//! assert_eq!(chain.add(1, &1.0_f64), None);
//! assert_eq!(chain.add(2, &1.0_f64).map(|checkpoint| checkpoint.sample), Some(2));
//! ```

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

/// More words than any run can have: a state of 100 words every nanosecond for a year.
const MOST_WORDS: u64 = 1 << 62;

impl Default for Digest {
    fn default() -> Self {
        Self { lanes: [1, 2, 3, 4], words: 0 }
    }
}

impl Digest {
    /// Adds every field of a state.
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

impl Digest {
    /// Whether it can be a digest: lanes may have any value, but the number of words is limited.
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
    #[expect(clippy::indexing_slicing, reason = "below 4, the number of lanes")]
    #[inline(always)]
    fn word(&mut self, bits: u64) {
        let lanes = &mut self.digest.lanes;
        lanes[self.lane % 4] = mix(lanes[self.lane % 4], bits);
        self.lane += 1;
        self.digest.words += 1;
    }
}

/// A digest with checkpoints at a fixed number of samples.
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
    /// With a checkpoint at the first state at least this many samples (at least one) after the last checkpoint.
    pub fn new(every: u64) -> Self {
        let every = every.max(1);
        Self { digest: Digest::default(), every, next: every }
    }

    /// Adds the state after this many samples; returns a checkpoint if one is due.
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
    // Each round is a bijection of the sum, so two runs that differ once go on to differ.
    let x = (sum ^ word).wrapping_mul(MULTIPLIER);
    x ^ (x >> 32)
}
