//! The target's application on this machine, whatever it can fly.

use schuler::link::aided::Linked;
use schuler::link::aided_fleet::EveryAided;
use schuler::link::fleet::{Every, Fleet, Single};
use schuler::link::identification::Identification;
use schuler::link::target::Target;
use schuler::navigators::Navigator4;

schuler::fleet! {
    /// Whatever the link has.
    Whole {
        Plain: Every,
        Aided: EveryAided,
        F64Unit: Identification<f64>,
        F32Unit: Identification<f32>,
    }

    /// The same without double precision.
    WholeSingle {
        Plain: Single,
        Aided: Linked<Navigator4<f32>>,
        Unit: Identification<f32>,
    }
}

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
    Box::new(Target::<Whole>::new(0))
}

/// One that has no double precision, as the smallest boards.
pub fn single() -> Box<dyn Application> {
    Box::new(Target::<WholeSingle>::new(0))
}
