//! The target's application in this process: no channel at all.

use super::channel::{Broken, Channel};
use schuler::link::fleet::Fleet;
use schuler::link::target::Target;
use std::time::Duration;

/// A target that answers before `send` returns.
pub struct InProcess<F> {
    target: Target<F>,
    answers: Vec<u8>,
}

impl<F: Fleet> InProcess<F> {
    /// Switched on.
    pub fn new() -> Self {
        let (mut target, mut answers) = (Target::new(0), Vec::new());
        target.hello(&mut |bytes| answers.extend_from_slice(bytes));
        Self { target, answers }
    }
}

impl<F: Fleet> Default for InProcess<F> {
    fn default() -> Self {
        Self::new()
    }
}

impl<F: Fleet + Send> Channel for InProcess<F> {
    fn send(&mut self, frame: &[u8]) -> Result<(), Broken> {
        for &byte in frame {
            self.target.take(byte, &mut |bytes| self.answers.extend_from_slice(bytes));
        }
        Ok(())
    }

    fn receive(&mut self, into: &mut Vec<u8>, _: Duration) -> Result<(), Broken> {
        into.append(&mut self.answers);
        Ok(())
    }
}
