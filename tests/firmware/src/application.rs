//! The link's target on a board: bytes from the UART in, answers out.

use crate::board::{self, uart::Uart};
use schuler::link::fleet::Fleet;
use schuler::link::target::Target;

/// Serves a host for ever.
pub fn serve<F: Fleet>() -> ! {
    let mut target = Target::<F>::new(board::boots());
    let Some(mut uart) = Uart::open() else { stop() };
    target.hello(&mut Uart::send);
    loop {
        target.take(uart.receive(), &mut Uart::send);
    }
}

/// Nothing more can be done.
pub fn stop() -> ! {
    loop {
        board::sleep();
    }
}
