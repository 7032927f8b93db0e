//! A stage's rows on their way into its chain.

use schuler::digest::{Chain, Checkpoint};
use schuler::record::Record;

/// Samples from checkpoint to checkpoint.
pub const EVERY: u64 = 64;

/// Hands a state's words, each with its field's name, to whoever it is given.
pub type Words<'a> = &'a dyn Fn(&mut dyn FnMut(&'static str, u64));

/// Who prints a flight.
pub trait Reader {
    /// The state of a stage after so many samples.
    fn row(&mut self, _stage: &'static str, _sample: u64, _words: Words) {}
    /// The digest on the way.
    fn checkpoint(&mut self, stage: &'static str, at: Checkpoint);
    /// The digest of all of it.
    fn end(&mut self, stage: &'static str, at: Checkpoint);
}

/// The chain of one stage.
pub struct Stage {
    name: &'static str,
    chain: Chain,
    last: u64,
}

impl Stage {
    /// Without rows.
    pub fn new(name: &'static str) -> Self {
        Self { name, chain: Chain::new(EVERY), last: 0 }
    }

    /// Takes in the state after so many samples.
    pub fn row<S: Record>(&mut self, sample: u64, state: &S, reader: &mut dyn Reader) {
        self.last = sample;
        reader.row(self.name, sample, &|visit| state.record("", &mut |name, bits| visit(name, bits)));
        if let Some(checkpoint) = self.chain.add(sample, state) {
            reader.checkpoint(self.name, checkpoint);
        }
    }

    /// There are no more.
    pub fn end(self, reader: &mut dyn Reader) {
        reader.end(self.name, Checkpoint { sample: self.last, digest: self.chain.value() });
    }
}
