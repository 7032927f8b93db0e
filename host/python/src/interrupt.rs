//! Ctrl-C while the interpreter is released.

use pyo3::prelude::*;
use schuler_simulator::input::{Complaint, InputError};
use std::time::{Duration, Instant};

/// How often Python is asked.
const PATIENCE: Duration = Duration::from_millis(200);
/// Calls between two looks at the clock.
const CALLS: u32 = 1024;

/// Asks Python from time to time whether to go on.
pub struct Watch {
    calls: u32,
    asked: Instant,
    raised: Option<PyErr>,
}

impl Watch {
    /// From now on.
    pub fn new() -> Self {
        Self { calls: 0, asked: Instant::now(), raised: None }
    }

    /// To be called often, without the interpreter; an error ends whatever is done.
    pub fn look(&mut self) -> Result<(), InputError> {
        self.calls += 1;
        if self.calls < CALLS {
            return Ok(());
        }
        self.calls = 0;
        if self.asked.elapsed() < PATIENCE { Ok(()) } else { self.ask() }
    }

    /// The same, to be called now and then.
    pub fn ask(&mut self) -> Result<(), InputError> {
        self.asked = Instant::now();
        Python::attach(|py| py.check_signals()).map_err(|raised| {
            self.raised = Some(raised);
            InputError::option("interrupted", Complaint::new("by a signal", ""))
        })
    }

    /// What was raised, if it was.
    pub fn raised(self) -> Result<(), PyErr> {
        self.raised.map_or(Ok(()), Err)
    }
}
