//! WebAssembly: `run.mjs` brings the function that prints.

mod host {
    #[link(wasm_import_module = "audit")]
    unsafe extern "C" {
        /// Prints so many bytes.
        pub fn print(bytes: *const u8, length: usize);
    }
}

/// Prints a line.
pub fn print(line: &[u8]) {
    // SAFETY: the host reads the bytes of the slice.
    unsafe { host::print(line.as_ptr(), line.len()) }
}

/// Ends the program.
pub fn exit(_: u8) -> ! {
    core::arch::wasm32::unreachable()
}

/// What the host calls; returns the exit code.
#[unsafe(no_mangle)]
extern "C" fn audit() -> u32 {
    super::run().into()
}
