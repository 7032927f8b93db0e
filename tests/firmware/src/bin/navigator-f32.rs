//! Navigates what a host sends over the UART, and answers: what a board without f64 flies.

#![no_std]
#![no_main]

use schuler_firmware::application;
use schuler_firmware::board::entry;

/// The reference mechanization alone fits a micro:bit.
#[cfg(feature = "microbit")]
type Fleet = schuler::link::flight::LinkedFlight<
    schuler::strapdown::navigator::Strapdown<
        schuler::strapdown::frame::local_level::LocalLevel<schuler::math::compensated::Pair<f32>>,
        schuler::strapdown::block::window::H0B4A0,
    >,
>;
#[cfg(not(feature = "microbit"))]
use schuler::link::fleet::Single as Fleet;

#[entry]
fn main() -> ! {
    application::serve::<Fleet>()
}

#[panic_handler]
fn panicked(_: &core::panic::PanicInfo) -> ! {
    application::stop()
}
