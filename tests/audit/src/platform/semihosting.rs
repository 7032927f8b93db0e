//! A Cortex-M whose debugger, or QEMU in its place, takes what is printed: Arm's semihosting.
//!
//! The image is loaded whole, so nothing is copied or cleared before it starts.

use core::arch::asm;

const WRITE0: usize = 0x04;
const EXIT: usize = 0x18;
/// Reasons of an exit.
const APPLICATION_EXIT: usize = 0x2_0026;
const RUN_TIME_ERROR: usize = 0x2_0023;

/// Prints a line of at most 127 bytes.
pub fn print(line: &[u8]) {
    // The call ends at the first zero.
    let mut text = [0_u8; 128];
    for (place, &byte) in text.iter_mut().take(127).zip(line) {
        *place = byte;
    }
    call(WRITE0, text.as_ptr() as usize);
}

/// Ends the program.
pub fn exit(code: u8) -> ! {
    call(EXIT, if code == 0 { APPLICATION_EXIT } else { RUN_TIME_ERROR });
    loop {}
}

fn call(operation: usize, argument: usize) {
    // SAFETY: WRITE0 reads up to the zero that `text` ends with; EXIT reads no memory.
    unsafe { asm!("bkpt 0xab", inlateout("r0") operation => _, in("r1") argument) }
}

/// Where the processor starts: the linker script's vector table points here.
#[unsafe(no_mangle)]
extern "C" fn reset() -> ! {
    #[cfg(target_abi = "eabihf")]
    // SAFETY: CPACR.CP10 and CP11 give access to the floating-point unit; nothing used it before.
    unsafe {
        const CPACR: *mut u32 = 0xe000_ed88 as *mut u32;
        CPACR.write_volatile(CPACR.read_volatile() | 0xf << 20);
        asm!("dsb", "isb");
    }
    fly()
}

/// Apart from `reset`, so that no register of the floating-point unit is saved before it is on.
#[inline(never)]
fn fly() -> ! {
    exit(super::run())
}

/// Where every exception leads.
#[unsafe(no_mangle)]
extern "C" fn fault() -> ! {
    print(b"the processor reports a fault\n");
    exit(2)
}
