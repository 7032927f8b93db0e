//! The UART of the nRF51822 as the micro:bit wires it, to the debug probe's USB port.

use super::register::Register;
use core::sync::atomic::{AtomicBool, Ordering};

const BASE: usize = 0x4000_2000;

// SAFETY: the UART (nRF51 reference manual, chapter 29).
const START_RECEIVER: Register<u32> = unsafe { Register::at(BASE) };
const START_TRANSMITTER: Register<u32> = unsafe { Register::at(BASE + 0x008) };
const RECEIVED: Register<u32> = unsafe { Register::at(BASE + 0x108) };
const SENT: Register<u32> = unsafe { Register::at(BASE + 0x11c) };
const INTERRUPT_ENABLE: Register<u32> = unsafe { Register::at(BASE + 0x304) };
const ENABLE: Register<u32> = unsafe { Register::at(BASE + 0x500) };
const TRANSMIT_PIN: Register<u32> = unsafe { Register::at(BASE + 0x50c) };
const RECEIVE_PIN: Register<u32> = unsafe { Register::at(BASE + 0x514) };
const RECEIVE: Register<u32> = unsafe { Register::at(BASE + 0x518) };
const TRANSMIT: Register<u32> = unsafe { Register::at(BASE + 0x51c) };
const BAUD_RATE: Register<u32> = unsafe { Register::at(BASE + 0x524) };

/// In `INTERRUPT_ENABLE`: a byte has come.
const RECEIVED_BIT: u32 = 1 << 2;
const ENABLED: u32 = 4;
const BAUD_115200: u32 = 0x01d7_e000;
const INTERRUPT: u16 = 2;

/// Whether a byte was put that the transmitter has not reported as sent.
static SENDING: AtomicBool = AtomicBool::new(false);

pub fn open() {
    TRANSMIT_PIN.write(24);
    RECEIVE_PIN.write(25);
    BAUD_RATE.write(BAUD_115200);
    ENABLE.write(ENABLED);
    INTERRUPT_ENABLE.write(RECEIVED_BIT);
    START_RECEIVER.write(1);
    START_TRANSMITTER.write(1);
    super::unmask(INTERRUPT);
}

pub fn take() -> Option<u8> {
    let ready = RECEIVED.read() != 0;
    ready.then(|| {
        RECEIVED.write(0);
        RECEIVE.read() as u8
    })
}

pub fn has_room() -> bool {
    !SENDING.load(Ordering::Relaxed) || SENT.read() != 0
}

pub fn put(byte: u8) {
    SENT.write(0);
    SENDING.store(true, Ordering::Relaxed);
    TRANSMIT.write(byte.into());
}
