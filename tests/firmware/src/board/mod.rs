//! Everything that knows the hardware: a file per family of boards, one of them chosen by a feature.
//!
//! To bring an image to a board of your own, write such a file with the same functions.

#[cfg(target_arch = "arm")]
mod cortex_m;
#[cfg(target_arch = "arm")]
pub use self::cortex_m::*;

#[cfg(target_arch = "riscv32")]
mod virt;
#[cfg(target_arch = "riscv32")]
pub use self::virt::*;

pub mod stack;

#[cfg(feature = "semihosting")]
use defmt_semihosting as _;

#[cfg(feature = "rtt")]
use defmt_rtt as _;

/// Ends the program: QEMU, or the debugger, exits with 0 or 1.
pub fn exit(passed: bool) -> ! {
    defmt::flush();
    semihosting::process::exit(if passed { 0 } else { 1 })
}
