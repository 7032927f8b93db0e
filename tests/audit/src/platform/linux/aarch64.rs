//! System calls of 64-bit Arm.

pub const WRITE: usize = 64;
pub const EXIT: usize = 93;

/// # Safety
/// As the call demands.
pub unsafe fn call(number: usize, first: usize, second: usize, third: usize) -> usize {
    let result;
    // SAFETY: the kernel keeps every register but the result's.
    unsafe {
        core::arch::asm!("svc 0", in("x8") number, inlateout("x0") first => result,
            in("x1") second, in("x2") third);
    }
    result
}
