//! A target that flies, with a host that tells it frame after frame.

use super::session::{answers, frame, increments, initial, said, start};
use schuler::link::bytes::Bytes;
use schuler::link::counters::Counters;
use schuler::link::fleet::Every;
use schuler::link::gap::Policy;
use schuler::link::message::{Body, Request};
use schuler::link::target::Target;
use schuler::math::compensated::Pair;
use schuler::strapdown::block::window::H0B4A0;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::navigator::Strapdown;
use schuler_tests::Course;

/// What it flies.
pub type Flown = Strapdown<LocalLevel<Pair<f32>>, H0B4A0>;

/// A target that flies, and what it says to one frame after the other.
pub struct Line {
    pub target: Target<Every>,
    increments: Vec<Vec<u8>>,
}

impl Line {
    /// That has been started.
    pub fn new(gap: Policy) -> Self {
        let course = Course::new("manoeuvre", 1.0, 0.5);
        let mut line = Self { target: Target::new(0), increments: increments::<f32>(&course) };
        let initial = initial::<Flown>(&course);
        line.tell(&frame(&start::<Flown>(&initial, gap), 1));
        line
    }

    /// The frame of a sample.
    pub fn sample(&self, number: u32, sequence: u32) -> Vec<u8> {
        let increment = Bytes(&self.increments[number as usize - 1]);
        frame(&Request::Sample { number, increment }, sequence)
    }

    /// Everything that is answered to some bytes: what is answered, what was noticed, and a name.
    pub fn tell(&mut self, bytes: &[u8]) -> Vec<(u32, Counters, String)> {
        let mut heard = Vec::new();
        answers(&said(&mut self.target, bytes), |_, answer| {
            let name = match answer.body {
                Body::Hello { .. } => "hello".to_owned(),
                Body::Solution(at) => {
                    format!("at {} of {}: {:b}", at.integrated, at.taken, at.came)
                }
                Body::Restoring { words } => format!("{words} words"),
                Body::State { words, offset, .. } => format!("from {offset} of {words} words"),
                Body::Refused { refusal, taken } => format!("{refusal:?} at {taken}"),
            };
            heard.push((answer.answers, answer.counters, name));
        });
        heard
    }
}

/// No counts but some.
pub fn noticed(change: impl FnOnce(&mut Counters)) -> Counters {
    let mut counters = Counters::default();
    change(&mut counters);
    counters
}
