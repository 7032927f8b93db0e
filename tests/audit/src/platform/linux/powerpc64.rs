//! System calls of 64-bit PowerPC.

pub const WRITE: usize = 4;
pub const EXIT: usize = 1;

/// # Safety
/// As the call demands.
pub unsafe fn call(number: usize, first: usize, second: usize, third: usize) -> usize {
    let result;
    // SAFETY: what the kernel may change is listed. An error (a small positive number with cr0.SO set)
    // looks like a short write, and the rest is tried again.
    unsafe {
        core::arch::asm!("sc", inlateout("r0") number => _, inlateout("r3") first => result,
            inlateout("r4") second => _, inlateout("r5") third => _, lateout("r6") _, lateout("r7") _,
            lateout("r8") _, lateout("r9") _, lateout("r10") _, lateout("r11") _, lateout("r12") _,
            lateout("cr0") _, lateout("ctr") _, lateout("xer") _);
    }
    result
}
