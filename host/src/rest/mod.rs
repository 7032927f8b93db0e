//! What a recording says where the vehicle stands still: level, north, and whether it can be right.

pub mod align;
pub mod opening;
pub mod units;
mod words;

/// Says on the error stream what is poor, yet no reason to stop.
fn warn(text: &str) {
    eprintln!("schuler: warning: {text}");
}
