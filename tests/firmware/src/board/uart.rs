//! Bytes in through an interrupt and a queue, bytes out by waiting.

use super::line;
use core::cell::Cell;
use core::hint;
use core::sync::atomic::{AtomicBool, Ordering};
use critical_section::Mutex;
use heapless::spsc::{Consumer, Producer, Queue};

/// Room for what comes while an answer is made: several frames, less one byte.
const ROOM: usize = 2048;

/// The interrupt's end of the queue.
static INCOMING: Mutex<Cell<Option<Producer<'static, u8>>>> = Mutex::new(Cell::new(None));

/// The reading end of the UART.
pub struct Uart {
    received: Consumer<'static, u8>,
}

impl Uart {
    /// Opens it and lets its interrupts come; once in a program.
    pub fn open() -> Option<Self> {
        static OPEN: AtomicBool = AtomicBool::new(false);
        static mut QUEUE: Queue<u8, ROOM> = Queue::new();
        let first = critical_section::with(|_| {
            let first = !OPEN.load(Ordering::Relaxed);
            OPEN.store(true, Ordering::Relaxed);
            first
        });
        if !first {
            return None;
        }
        let queue = &raw mut QUEUE;
        // SAFETY: this line is passed once, and nothing else knows the queue.
        let (incoming, received) = unsafe { &mut *queue }.split();
        critical_section::with(|token| INCOMING.borrow(token).set(Some(incoming)));
        line::open();
        Some(Self { received })
    }

    /// The next byte; sleeps until there is one.
    pub fn receive(&mut self) -> u8 {
        loop {
            if let Some(byte) = self.received.dequeue() {
                return byte;
            }
            // An interrupt that comes after the look wakes the core, and is served on leaving.
            critical_section::with(|_| {
                if !self.received.ready() {
                    super::sleep();
                }
            });
        }
    }

    /// Sends bytes, waiting for room.
    pub fn send(bytes: &[u8]) {
        for &byte in bytes {
            while !line::has_room() {
                hint::spin_loop();
            }
            line::put(byte);
        }
    }
}

/// Takes in what has come: the interrupt's part. A byte beyond the room is lost, and the frame with it.
pub(super) fn receive() {
    critical_section::with(|token| {
        let incoming = INCOMING.borrow(token);
        let mut queue = incoming.take();
        while let Some(byte) = line::take() {
            if let Some(queue) = &mut queue {
                let _ = queue.enqueue(byte);
            }
        }
        incoming.set(queue);
    });
}
