//! The smallest image with a navigator in it: what is not used must not be linked.

#![no_std]
#![no_main]

use core::hint::black_box;
use schuler::math::compensated::Pair;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::block::window::H0B4A0;

#[panic_handler]
fn stop(_: &core::panic::PanicInfo) -> ! {
    loop {}
}

/// Navigates whatever it is given.
#[unsafe(no_mangle)]
extern "C" fn _start() -> ! {
    let interval_s = black_box(Pair::new(0.01_f32));
    let navigator = Strapdown::<LocalLevel<Pair<f32>>, H0B4A0>::new(interval_s);
    if let Ok(navigator) = navigator
        && let Ok(mut state) = navigator.start(&black_box(Solution::default()))
    {
        loop {
            let sample = black_box(Increment::<f32>::default());
            #[cfg(feature = "emulator")]
            let sample = emulated(sample);
            black_box(navigator.push(&mut state, sample)).ok();
            black_box(&state);
        }
    }
    loop {}
}

#[cfg(feature = "emulator")]
#[inline(never)]
fn emulated(sample: Increment<f32>) -> Increment<f32> {
    use schuler::noise::Streams;
    use schuler::sensor::white::White;
    use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing};
    let white = Timing::new(0.01, 1).and_then(|timing| White::new(black_box(sample).angle_b, timing));
    let mut reading = Reading::new(sample.angle_b);
    if let Ok(white) = white {
        let mut state = white.start(Streams::new(1, 0));
        let stimulus = Stimulus { sensed: sample.angle_b, velocity_b: sample.velocity_b };
        white.apply(&mut state, &stimulus, &mut reading);
    }
    Increment { angle_b: reading.increment, ..sample }
}
