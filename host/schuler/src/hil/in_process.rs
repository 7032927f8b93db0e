//! The target's application in this process: no channel at all.

use super::channel::{Broken, Channel};
use schuler_simulator::twin::application::{self, Application};
use std::time::Duration;

/// A target that answers before `send` returns.
pub struct InProcess {
    target: Box<dyn Application>,
    answers: Vec<u8>,
}

impl InProcess {
    /// Switched on, with whatever the link can fly.
    pub fn every() -> Self {
        Self::new(application::every())
    }

    /// Switched on, without double precision.
    pub fn single() -> Self {
        Self::new(application::single())
    }

    /// Switched on.
    pub fn new(mut target: Box<dyn Application>) -> Self {
        let mut answers = Vec::new();
        target.hello(&mut |bytes| answers.extend_from_slice(bytes));
        Self { target, answers }
    }
}

impl Channel for InProcess {
    fn send(&mut self, frame: &[u8]) -> Result<(), Broken> {
        self.target.take(frame, &mut |bytes| self.answers.extend_from_slice(bytes));
        Ok(())
    }

    fn receive(&mut self, into: &mut Vec<u8>, _: Duration) -> Result<(), Broken> {
        into.append(&mut self.answers);
        Ok(())
    }
}
