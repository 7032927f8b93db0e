//! Navigates what a host sends over the UART, with measurements or without, and identifies a unit at rest: in single
//! precision, without an operation of f64.

#![no_std]
#![no_main]

use schuler::link::aided::Linked;
use schuler::link::fleet::Single;
use schuler::link::identification::Identification;
use schuler::navigators::Navigator4;
use schuler_firmware::application;
use schuler_firmware::board::entry;

schuler::fleet! {
    /// What this image can do.
    Aiding {
        Plain: Single,
        Aided: Linked<Navigator4<f32>>,
        Unit: Identification<f32>,
    }
}

#[entry]
fn main() -> ! {
    application::serve::<Aiding>()
}

#[panic_handler]
fn panicked(_: &core::panic::PanicInfo) -> ! {
    application::stop()
}
