//! A recording of a vehicle at rest: level, north, and whether the readings are plausible.

pub mod align;
pub mod fine;
pub mod opening;
pub mod units;
mod words;

/// Says on the error stream what is poor, yet no reason to stop.
fn warn(text: &str) {
    eprintln!("schuler: warning: {text}");
}
