//! RISC-V as QEMU's virt has it.

pub use riscv_rt::entry;

/// What the board is called in reports.
pub const NAME: &str = "virt";

/// What [`Counter`] counts.
pub const UNIT: &str = "instructions";

/// Counts retired instructions, of the core itself.
pub struct Counter(());

impl Counter {
    /// The counter, which runs from reset.
    pub fn start() -> Option<Self> {
        Some(Self(()))
    }

    /// The count now.
    #[inline(always)]
    pub fn now(&self) -> u32 {
        ::riscv::register::minstret::read() as u32
    }

    /// How much was counted between two readings, less than a turn apart.
    #[inline(always)]
    pub fn between(&self, from: u32, to: u32) -> u32 {
        to.wrapping_sub(from)
    }

    /// A sum of counts in the board's [`UNIT`].
    pub fn worth(&self, counts: u64) -> f64 {
        counts as f64
    }
}

/// Waits for an interrupt, which need not be let through.
pub fn sleep() {
    ::riscv::asm::wfi();
}

/// Lets interrupts through.
pub(super) fn unmask() {
    // SAFETY: nothing here relies on interrupts being off but critical sections.
    unsafe {
        ::riscv::register::mie::set_mext();
        ::riscv::interrupt::enable();
    }
}

#[riscv_rt::core_interrupt(::riscv::interrupt::Interrupt::MachineExternal)]
fn external() {
    super::line::served(super::uart::receive);
}
