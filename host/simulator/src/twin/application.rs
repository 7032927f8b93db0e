//! The target's application on this machine, whatever it can fly.

use schuler::link::fleet::{Every, Fleet, Single};
use schuler::link::target::Target;

/// A target's application.
pub trait Application: Send {
    /// Announces the target: the first frame that it sends.
    fn hello(&mut self, send: &mut dyn FnMut(&[u8]));
    /// Takes received bytes, and answers the frames that they complete.
    fn take(&mut self, bytes: &[u8], send: &mut dyn FnMut(&[u8]));
}

impl<F: Fleet + Send> Application for Target<F> {
    fn hello(&mut self, mut send: &mut dyn FnMut(&[u8])) {
        Target::hello(self, &mut send);
    }

    fn take(&mut self, bytes: &[u8], mut send: &mut dyn FnMut(&[u8])) {
        for &byte in bytes {
            Target::take(self, byte, &mut send);
        }
    }
}

/// One that flies whatever the link has, switched on.
pub fn every() -> Box<dyn Application> {
    Box::new(Target::<Every>::new(0))
}

/// One that has no double precision, as the smallest boards.
pub fn single() -> Box<dyn Application> {
    Box::new(Target::<Single>::new(0))
}
