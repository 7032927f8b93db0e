//! System calls of IBM's z.

pub const WRITE: usize = 4;
pub const EXIT: usize = 1;

/// # Safety
/// As the call demands.
pub unsafe fn call(number: usize, first: usize, second: usize, third: usize) -> usize {
    let result;
    // SAFETY: the kernel keeps every register but the result's.
    unsafe {
        core::arch::asm!("svc 0", in("r1") number, inlateout("r2") first => result,
            in("r3") second, in("r4") third);
    }
    result
}
