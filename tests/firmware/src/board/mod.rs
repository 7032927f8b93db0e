//! Everything that knows the hardware: a file per core and per UART, chosen by the board's feature.
//!
//! To bring the images to a board of your own, give it such a UART; see README.md.

#[cfg(target_arch = "arm")]
mod cortex_m;
#[cfg(target_arch = "arm")]
pub use self::cortex_m::*;

#[cfg(target_arch = "riscv32")]
mod riscv;
#[cfg(target_arch = "riscv32")]
pub use self::riscv::*;

#[cfg_attr(any(feature = "mps2", feature = "mps2-an505"), path = "cmsdk.rs")]
#[cfg_attr(feature = "microbit", path = "nrf51.rs")]
#[cfg_attr(feature = "virt", path = "ns16550.rs")]
mod line;
mod register;
pub mod stack;
pub mod uart;

use core::ptr;

#[cfg(feature = "semihosting")]
use defmt_semihosting as _;

#[cfg(feature = "rtt")]
use defmt_rtt as _;

/// Ends the program: QEMU, or the debugger, exits with 0 or 1.
pub fn exit(passed: bool) -> ! {
    defmt::flush();
    semihosting::process::exit(if passed { 0 } else { 1 })
}

/// How often the board was reset since it has had power, in memory that start-up leaves alone; after
/// power comes on, it counts from some number.
pub fn boots() -> u32 {
    #[unsafe(link_section = ".uninit.boots")]
    static mut BOOTS: u32 = 0;
    let boots = &raw mut BOOTS;
    // SAFETY: nothing else knows the word, and any bits are a u32.
    unsafe {
        let count = ptr::read_volatile(boots).wrapping_add(1);
        ptr::write_volatile(boots, count);
        count
    }
}
