//! A channel: bytes to a device and back, over any kind of connection.

use schuler_simulator::input::Complaint;
use std::fmt;
use std::time::Duration;

/// The connection to a device has ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Broken(pub String);

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the connection to the device has ended: {}", self.0)
    }
}

impl std::error::Error for Broken {}

impl From<std::io::Error> for Broken {
    fn from(error: std::io::Error) -> Self {
        Self(error.to_string())
    }
}

impl From<Broken> for Complaint {
    fn from(broken: Broken) -> Self {
        Self::new(broken.to_string(), "")
    }
}

/// Bytes to a device and back.
pub trait Channel: Send {
    /// Sends a whole frame.
    fn send(&mut self, frame: &[u8]) -> Result<(), Broken>;
    /// Appends bytes that have come; waits for the first as long as `patience`, and appends nothing if none
    /// came.
    fn receive(&mut self, into: &mut Vec<u8>, patience: Duration) -> Result<(), Broken>;
    /// Faults put in on purpose so far; `None` on a channel that puts in none.
    fn injected(&self) -> Option<super::faults::Injected> {
        None
    }
    /// From here on no fault is put in any more.
    fn calm(&mut self) {}
}

impl<C: Channel + ?Sized> Channel for Box<C> {
    fn send(&mut self, frame: &[u8]) -> Result<(), Broken> {
        (**self).send(frame)
    }
    fn receive(&mut self, into: &mut Vec<u8>, patience: Duration) -> Result<(), Broken> {
        (**self).receive(into, patience)
    }
    fn injected(&self) -> Option<super::faults::Injected> {
        (**self).injected()
    }
    fn calm(&mut self) {
        (**self).calm();
    }
}
