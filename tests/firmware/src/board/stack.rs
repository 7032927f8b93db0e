//! How deep the stack grows: what lies below is painted, and later looked at.

use core::ptr;

/// What unused stack is painted with.
const PAINT: u32 = 0x5afe_57ac;

/// Bytes next to the stack pointer that stay as they are: the painter's own.
const OWN: usize = 128;

/// Bytes that are painted at most: more would take long on a board with much memory.
const MOST: usize = 64 * 1024;

unsafe extern "C" {
    #[cfg_attr(target_arch = "riscv32", link_name = "__estack")]
    static _stack_end: u32;
}

/// Stack below some place, painted.
pub struct Painted {
    top: usize,
    bottom: usize,
}

/// The stack pointer.
#[inline(always)]
fn stack_pointer() -> usize {
    let pointer: usize;
    // SAFETY: reads a register.
    unsafe {
        #[cfg(target_arch = "arm")]
        core::arch::asm!("mov {}, sp", out(reg) pointer, options(nomem, nostack, preserves_flags));
        #[cfg(target_arch = "riscv32")]
        core::arch::asm!("mv {}, sp", out(reg) pointer, options(nomem, nostack, preserves_flags));
    }
    pointer
}

impl Painted {
    /// Paints what lies below the caller.
    #[inline(always)]
    pub fn below() -> Self {
        Self::paint(stack_pointer())
    }

    #[inline(never)]
    fn paint(top: usize) -> Self {
        let end = (&raw const _stack_end) as usize;
        let bottom = end.max(top.saturating_sub(MOST)).next_multiple_of(4);
        for place in (bottom..top - OWN).step_by(4) {
            // SAFETY: between the end of the stack and the stack pointer nobody keeps anything.
            unsafe { ptr::write_volatile(place as *mut u32, PAINT) };
        }
        Self { top, bottom }
    }

    /// Bytes used since, at most.
    #[inline(never)]
    pub fn used(&self) -> usize {
        let mut places = (self.bottom..self.top).step_by(4);
        // SAFETY: the stack is readable memory, and aligned.
        let first =
            places.find(|&place| unsafe { ptr::read_volatile(place as *const u32) } != PAINT);
        self.top - first.unwrap_or(self.top)
    }
}
