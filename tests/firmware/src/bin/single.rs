//! An image that holds a navigator in f32 and nothing else: what it needs in flash and in RAM, and that
//! nothing of f64 is in it.

#![no_std]
#![no_main]

use core::hint::black_box;
use schuler::math::compensated::Pair;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::local_level::LocalLevel;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::window::H0B4A0;
use schuler_firmware::board::entry;

#[entry]
fn main() -> ! {
    let interval_s = black_box(Pair::new(0.05_f32));
    let strapdown = Strapdown::<LocalLevel<Pair<f32>>, H0B4A0>::new(interval_s);
    if let Ok(strapdown) = strapdown
        && let Ok(mut state) = strapdown.start(&black_box(Solution::default()))
    {
        loop {
            let sample = black_box(Increment::<f32>::default());
            black_box(strapdown.push(&mut state, sample)).ok();
            black_box(state.output());
        }
    }
    loop {}
}

#[panic_handler]
fn panicked(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
