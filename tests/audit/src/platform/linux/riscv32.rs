//! System calls of 32-bit RISC-V.

pub const WRITE: usize = 64;
pub const EXIT: usize = 93;

/// # Safety
/// As the call demands.
pub unsafe fn call(number: usize, first: usize, second: usize, third: usize) -> usize {
    let result;
    // SAFETY: the kernel keeps every register but the result's.
    unsafe {
        core::arch::asm!("ecall", in("a7") number, inlateout("a0") first => result,
            in("a1") second, in("a2") third);
    }
    result
}
