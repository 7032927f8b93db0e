//! A navigator in f32 and nothing else: what it needs in flash and in RAM, and that nothing of f64 is in it.

use crate::application;
use core::hint::black_box;
use schuler::math::compensated::Pair;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::limits::{Rejected, StartError};
use schuler::strapdown::navigator::{State, Strapdown};
use schuler::strapdown::block::window::H0B4A0;

type Frame = LocalLevel<Pair<f32>>;
type Navigator = Strapdown<Frame, H0B4A0>;

/// What is done once.
#[inline(never)]
fn start(navigator: &Navigator) -> Result<State<Frame, H0B4A0>, StartError> {
    navigator.start(&black_box(Solution::default()))
}

/// What is done for every sample: its size, with that of what it calls, is that of a step.
#[inline(never)]
fn every_sample<const ORDER: usize>(
    navigator: &Navigator,
    state: &mut State<Frame, H0B4A0>,
    sample: Increment<f32>,
) -> Result<(), Rejected> {
    if ORDER == 0 {
        navigator.push(state, sample)
    } else {
        navigator.with_order(ORDER).push(state, sample)
    }
}

/// Navigates for ever, with a series of this order; 0: of one that is known when it runs.
pub fn navigate<const ORDER: usize>() -> ! {
    if let Ok(navigator) = Navigator::new(black_box(Pair::new(0.05)))
        && let navigator = navigator.with_order(black_box(3))
        && let Ok(mut state) = start(&navigator)
    {
        loop {
            let sample = black_box(Increment::default());
            let taken = every_sample::<ORDER>(&navigator, &mut state, sample);
            black_box(taken.is_ok());
            black_box(state.output());
        }
    }
    application::stop()
}
