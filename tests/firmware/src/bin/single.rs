//! A navigator in f32 whose series has the order that slow motion is planned with, the paper's among it.

#![no_std]
#![no_main]

use schuler_firmware::board::entry;
use schuler_firmware::{application, single};

#[entry]
fn main() -> ! {
    single::navigate::<3>()
}

#[panic_handler]
fn panicked(_: &core::panic::PanicInfo) -> ! {
    application::stop()
}
