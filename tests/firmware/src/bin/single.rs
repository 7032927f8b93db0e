//! An image that holds a navigator in f32 and nothing else: what it needs in flash and in RAM, and that
//! nothing of f64 is in it.

#![no_std]
#![no_main]

use core::hint::black_box;
use schuler::math::compensated::Pair;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::local_level::LocalLevel;
use schuler::strapdown::mechanization::{Rejected, StartError};
use schuler::strapdown::navigator::{State, Strapdown};
use schuler::strapdown::window::H0B4A0;
use schuler_firmware::application;
use schuler_firmware::board::entry;

type Frame = LocalLevel<Pair<f32>>;

/// The order of the series that slow motion is planned with, the paper's among it.
const ORDER: usize = 3;

/// What is done once.
#[inline(never)]
fn start(strapdown: &Strapdown<Frame, H0B4A0>) -> Result<State<Frame, H0B4A0>, StartError> {
    strapdown.start(&black_box(Solution::default()))
}

/// What is done for every sample: its size is that of a step.
#[inline(never)]
fn every_sample(
    strapdown: &Strapdown<Frame, H0B4A0>,
    state: &mut State<Frame, H0B4A0>,
    sample: Increment<f32>,
) -> Result<(), Rejected> {
    strapdown.with_order(ORDER).push(state, sample)
}

#[entry]
fn main() -> ! {
    if let Ok(strapdown) = Strapdown::new(black_box(Pair::new(0.05)))
        && let Ok(mut state) = start(&strapdown)
    {
        loop {
            let taken = every_sample(&strapdown, &mut state, black_box(Increment::default()));
            black_box(taken.is_ok());
            black_box(state.output());
        }
    }
    application::stop()
}

#[panic_handler]
fn panicked(_: &core::panic::PanicInfo) -> ! {
    application::stop()
}
