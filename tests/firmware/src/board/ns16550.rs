//! The 16550 UART of RISC-V's virt, and the interrupt controller in front of the core.

use super::register::Register;

const BASE: usize = 0x1000_0000;
const CONTROLLER: usize = 0x0c00_0000;

// SAFETY: UART 0 and the PLIC of QEMU's virt.
const DATA: Register<u8> = unsafe { Register::at(BASE) };
const INTERRUPT_ENABLE: Register<u8> = unsafe { Register::at(BASE + 1) };
const STATE: Register<u8> = unsafe { Register::at(BASE + 5) };
const PRIORITY: Register<u32> = unsafe { Register::at(CONTROLLER + 4 * INTERRUPT) };
const ENABLE: Register<u32> = unsafe { Register::at(CONTROLLER + 0x2000) };
const THRESHOLD: Register<u32> = unsafe { Register::at(CONTROLLER + 0x20_0000) };
const CLAIM: Register<u32> = unsafe { Register::at(CONTROLLER + 0x20_0004) };

/// The UART's number at the controller.
const INTERRUPT: usize = 10;
/// In `STATE`: a byte has come, the transmitter is empty.
const READY: u8 = 1;
const EMPTY: u8 = 1 << 5;

pub fn open() {
    INTERRUPT_ENABLE.write(1);
    PRIORITY.write(1);
    ENABLE.write(1 << INTERRUPT);
    THRESHOLD.write(0);
    super::unmask();
}

/// Claims what the controller reports, has it served, and says so.
pub fn served(serve: impl FnOnce()) {
    let claimed = CLAIM.read();
    serve();
    CLAIM.write(claimed);
}

pub fn take() -> Option<u8> {
    let ready = STATE.read() & READY != 0;
    ready.then(|| DATA.read())
}

pub fn has_room() -> bool {
    STATE.read() & EMPTY != 0
}

pub fn put(byte: u8) {
    DATA.write(byte);
}
