//! The core for C: opaque states that the caller allocates, results as numbers, and nothing else.
//!
//! | file | what it has |
//! |---|---|
//! | `results` | every result by its name |
//! | `pointer` | what comes through a pointer, checked |
//! | `held` | a state in the caller's memory, with the mark that tells whose it is |
//! | `values` | samples, solutions and corrections as C structs |
//! | `navigation` | what every navigator does, once for all |
//! | `stored` | a state as bytes that can be kept, and its check |
//! | `navigators` | the functions of each navigator of the core's catalogue |
//! | `sizes` | the size of each state |
//! | `carried`, `alignment`, `emulator`, `digest` | what goes beside a navigator |
//! | `frames`, `target` | the link: frames, and the application of a target |
//!
//! `unsafe` stands where a pointer of the caller's is followed, and nowhere else: in `pointer` and `held`, and in
//! the exported functions, which pass such pointers on to them.

#![cfg_attr(not(test), no_std)]
#![allow(non_camel_case_types, reason = "C's names")]
#![allow(clippy::too_many_arguments, reason = "C's functions have no builders")]
#![deny(unsafe_op_in_unsafe_fn, clippy::indexing_slicing, clippy::unwrap_used, clippy::panic)]

mod alignment;
mod carried;
mod digest;
mod emulator;
mod frames;
mod held;
mod navigation;
mod navigators;
mod pointer;
mod results;
#[macro_use]
mod sizes;
mod stored;
mod target;
mod values;

pub use alignment::*;
pub use carried::*;
pub use digest::*;
pub use emulator::*;
pub use frames::*;
pub use navigators::*;
pub use results::*;
pub use target::*;
pub use values::*;

/// The version of this interface: what a program was compiled with has to be what it is linked with.
pub const SCHULER_ABI: u32 = 1;

/// The version of the interface that the library was built with: SCHULER_ABI, if header and library fit.
#[unsafe(no_mangle)]
pub extern "C" fn schuler_abi() -> u32 {
    SCHULER_ABI
}

/// Nothing in the core panics, and the archive has no call of this: `tests/c.sh` looks at its symbols.
#[cfg(feature = "archive")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}

/// Every other state: its name, the bytes that its C type has, and those that it needs. It is for the tests.
#[cfg(not(feature = "archive"))]
#[doc(hidden)]
pub fn sizes_beside(see: &mut dyn FnMut(&str, usize, usize)) {
    alignment::needs(see);
    carried::needs(see);
    digest::needs(see);
    emulator::needs(see);
    frames::needs(see);
    target::needs(see);
}
