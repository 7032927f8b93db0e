//! Images that measure, report and end.

use crate::board;
use crate::fault::Fault;

/// Reports what went wrong, if anything did, and ends.
pub fn end(measured: &Result<(), Fault>) -> ! {
    if let Err(fault) = measured {
        defmt::println!("fault = {}", fault);
    }
    board::exit(measured.is_ok())
}

/// Entry and panic handler of an image that does what a function does.
#[macro_export]
macro_rules! measuring {
    ($measure:ident) => {
        #[$crate::board::entry]
        fn main() -> ! {
            $crate::measuring::end(&$measure())
        }

        #[panic_handler]
        fn panicked(_: &core::panic::PanicInfo) -> ! {
            defmt::println!("fault = panic");
            $crate::board::exit(false)
        }
    };
}
