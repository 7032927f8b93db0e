//! Navigates what a host sends over the UART, and answers: everything that the link knows, in f32 and f64.

#![no_std]
#![no_main]

use schuler::link::fleet::Every;
use schuler_firmware::application;
use schuler_firmware::board::entry;

#[entry]
fn main() -> ! {
    application::serve::<Every>()
}

#[panic_handler]
fn panicked(_: &core::panic::PanicInfo) -> ! {
    application::stop()
}
