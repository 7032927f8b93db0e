//! Navigates what a host sends over the UART, and answers: what a board without f64 flies.

#![no_std]
#![no_main]

use schuler::link::fleet::Single;
use schuler_firmware::application;
use schuler_firmware::board::entry;

#[entry]
fn main() -> ! {
    application::serve::<Single>()
}

#[panic_handler]
fn panicked(_: &core::panic::PanicInfo) -> ! {
    application::stop()
}
