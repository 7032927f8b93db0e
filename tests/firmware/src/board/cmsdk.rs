//! The CMSDK UART of Arm's mps2 boards, and where its interrupt goes.

use super::register::Register;

const BASE: usize = if cfg!(feature = "mps2-an505") { 0x5020_0000 } else { 0x4000_4000 };

// SAFETY: UART 0 of the board (AN386, AN505: memory map).
const DATA: Register<u32> = unsafe { Register::at(BASE) };
const STATE: Register<u32> = unsafe { Register::at(BASE + 0x4) };
const CONTROL: Register<u32> = unsafe { Register::at(BASE + 0x8) };
const INTERRUPT_CLEAR: Register<u32> = unsafe { Register::at(BASE + 0xc) };
const BAUD_DIVIDER: Register<u32> = unsafe { Register::at(BASE + 0x10) };

/// In `STATE`: the transmitter, the receiver holds a byte.
const FULL: u32 = 1;
const READY: u32 = 1 << 1;
/// In `CONTROL`: transmitter, receiver, and its interrupt.
const ENABLED: u32 = 1 | 1 << 1 | 1 << 3;
/// In `INTERRUPT_CLEAR`: the receiver's.
const RECEIVED: u32 = 1 << 1;

/// The interrupts of UART 0: in some of these boards receive comes first, in some transmit.
const INTERRUPTS: [u16; 2] = if cfg!(feature = "mps2-an505") { [32, 33] } else { [0, 1] };

/// 115200 baud at 25 MHz; QEMU only asks that there be one.
const DIVIDER: u32 = 217;

pub fn open() {
    BAUD_DIVIDER.write(DIVIDER);
    CONTROL.write(ENABLED);
    INTERRUPTS.into_iter().for_each(super::unmask);
}

pub fn take() -> Option<u8> {
    INTERRUPT_CLEAR.write(RECEIVED);
    let ready = STATE.read() & READY != 0;
    ready.then(|| DATA.read() as u8)
}

pub fn has_room() -> bool {
    STATE.read() & FULL == 0
}

pub fn put(byte: u8) {
    DATA.write(byte.into());
}
