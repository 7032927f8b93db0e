//! Where the program runs: what starts it, prints its lines and ends it.

#[cfg(feature = "std")]
mod standard;
#[cfg(feature = "std")]
pub use standard::{main, print};

#[cfg(all(not(feature = "std"), target_arch = "arm"))]
mod semihosting;
#[cfg(all(not(feature = "std"), target_arch = "arm"))]
pub use semihosting::{exit, print};

#[cfg(all(not(feature = "std"), target_family = "wasm"))]
mod wasm;
#[cfg(all(not(feature = "std"), target_family = "wasm"))]
pub use wasm::{exit, print};

#[cfg(not(any(feature = "std", target_arch = "arm", target_family = "wasm")))]
mod linux;
#[cfg(not(any(feature = "std", target_arch = "arm", target_family = "wasm")))]
pub use linux::{exit, print};

/// Runs the program to its exit code.
#[cfg(not(feature = "std"))]
fn run() -> u8 {
    if crate::digests().is_ok() {
        return 0;
    }
    print(b"the core refuses a scene, a start or a sample\n");
    1
}

#[cfg(not(feature = "std"))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    print(b"the audit program panics\n");
    exit(2)
}
