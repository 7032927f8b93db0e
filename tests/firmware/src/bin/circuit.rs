//! Flies paths that are compiled piece by piece on the target, in f64: all of the scene `circuit`, its steepest
//! turn, and the first of `waypoints`. Reports `key = value` lines, and ends with 0 if all of it was flown.

#![no_std]
#![no_main]

use schuler_firmware::board::{self, entry, stack::Painted};
use schuler_scenes::stretch::{Flown, Refused};
use schuler_scenes::target::{POINTS, STEEP, WHOLE, points, segments};

#[entry]
fn main() -> ! {
    let stack = Painted::below();
    let passed = report("circuit", segments(WHOLE))
        & report("steep turn", segments(STEEP))
        & report("waypoints", points(POINTS));
    defmt::println!("stack_bytes = {=usize}", stack.used());
    board::exit(passed)
}

#[panic_handler]
fn panicked(_: &core::panic::PanicInfo) -> ! {
    defmt::println!("fault = panic");
    board::exit(false)
}

/// What a flight came to; whether it ended.
#[inline(never)]
fn report<E>(flight: &str, flown: Result<Flown, Refused<E>>) -> bool {
    match flown {
        Ok(Flown { pieces, path, increments, states, final_m }) => {
            defmt::println!("{=str}, pieces = {=u32}", flight, pieces);
            defmt::println!("{=str}, path = {=u64:016x}", flight, path);
            defmt::println!("{=str}, increments = {=u64:016x}", flight, increments);
            defmt::println!("{=str}, states = {=u64:016x}", flight, states);
            defmt::println!("{=str}, final, m = {=f64}", flight, final_m);
            true
        }
        Err(_) => {
            defmt::println!("fault = {=str} is refused", flight);
            false
        }
    }
}
