//! Cortex-M: the counter that every core has, or the cycle counter of the larger ones.

use ::cortex_m::Peripherals;
use ::cortex_m::interrupt::InterruptNumber;
#[cfg(feature = "dwt")]
use ::cortex_m::peripheral::DWT;
use ::cortex_m::peripheral::NVIC;
#[cfg(not(feature = "dwt"))]
use ::cortex_m::peripheral::{SYST, syst::SystClkSource};
pub use cortex_m_rt::entry;
use cortex_m_rt::exception;

#[cfg(all(feature = "dwt", feature = "microbit"))]
compile_error!("a Cortex-M0 has no cycle counter in its DWT");

/// What the board is called in reports.
pub const NAME: &str = if cfg!(feature = "microbit") {
    "microbit"
} else if cfg!(feature = "mps2-an505") {
    "mps2-an505"
} else {
    "mps2"
};

/// What [`Counter`] counts: in QEMU, which knows no cycles, instructions; on a board the core's clocks.
pub const UNIT: &str = if cfg!(feature = "dwt") {
    "cycles"
} else if cfg!(feature = "semihosting") {
    "instructions"
} else {
    "clocks"
};

/// Of that unit, how many make one count. Under QEMU's `-icount shift=0` an instruction takes 1 ns, and
/// SysTick counts at 25, 20 or 16 MHz.
const WORTH: f64 = if cfg!(any(feature = "dwt", not(feature = "semihosting"))) {
    1.0
} else if cfg!(feature = "microbit") {
    62.5
} else if cfg!(feature = "mps2-an505") {
    50.0
} else {
    40.0
};

/// Counts in [`UNIT`]s.
pub struct Counter(());

impl Counter {
    /// Takes the counter and starts it; once in a program.
    #[cfg(not(feature = "dwt"))]
    pub fn start() -> Option<Self> {
        let mut timer = Peripherals::take()?.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(MOST);
        timer.clear_current();
        timer.enable_counter();
        Some(Self(()))
    }

    /// Takes the counter and starts it, once in a program; none where the core has none, or where it
    /// stands still.
    #[cfg(feature = "dwt")]
    pub fn start() -> Option<Self> {
        let mut core = Peripherals::take()?;
        core.DCB.enable_trace();
        // Some of the larger cores lock it.
        DWT::unlock();
        if !DWT::has_cycle_counter() {
            return None;
        }
        core.DWT.enable_cycle_counter();
        let from = DWT::cycle_count();
        ::cortex_m::asm::delay(64);
        (DWT::cycle_count() != from).then_some(Self(()))
    }

    /// The count now.
    #[inline(always)]
    pub fn now(&self) -> u32 {
        #[cfg(not(feature = "dwt"))]
        return MOST - SYST::get_current();
        #[cfg(feature = "dwt")]
        return DWT::cycle_count();
    }

    /// How much was counted between two readings, less than a turn apart.
    #[inline(always)]
    pub fn between(&self, from: u32, to: u32) -> u32 {
        to.wrapping_sub(from) & MOST
    }

    /// A sum of counts in the board's [`UNIT`].
    pub fn worth(&self, counts: u64) -> f64 {
        counts as f64 * WORTH
    }
}

/// The largest count: SysTick has 24 bits.
const MOST: u32 = if cfg!(feature = "dwt") { u32::MAX } else { 0x00ff_ffff };

/// Waits for an interrupt, which need not be let through.
pub fn sleep() {
    ::cortex_m::asm::wfi();
}

#[derive(Clone, Copy)]
struct Interrupt(u16);

// SAFETY: the numbers are those of the board's UART.
unsafe impl InterruptNumber for Interrupt {
    fn number(self) -> u16 {
        self.0
    }
}

/// Lets an interrupt through.
pub(super) fn unmask(interrupt: u16) {
    // SAFETY: nothing here relies on interrupts being off but critical sections.
    unsafe { NVIC::unmask(Interrupt(interrupt)) }
}

/// Every interrupt: only the UART's are let through.
#[exception]
unsafe fn DefaultHandler(_: i16) {
    super::uart::receive();
}
