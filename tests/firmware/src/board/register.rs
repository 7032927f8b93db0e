//! Registers of devices.

use core::ptr;

/// A register of `T` at an address.
#[derive(Clone, Copy)]
pub struct Register<T>(*mut T);

impl<T: Copy> Register<T> {
    /// The register at an address.
    ///
    /// # Safety
    /// A device of the board has one of this width there, and is touched through this file alone.
    pub const unsafe fn at(address: usize) -> Self {
        Self(address as *mut T)
    }

    /// What it holds.
    #[inline(always)]
    pub fn read(self) -> T {
        // SAFETY: promised in `at`.
        unsafe { ptr::read_volatile(self.0) }
    }

    /// Sets it.
    #[inline(always)]
    pub fn write(self, value: T) {
        // SAFETY: promised in `at`.
        unsafe { ptr::write_volatile(self.0, value) }
    }
}
