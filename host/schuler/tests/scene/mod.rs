//! Scenes: what their files may say, what that means in SI units, and the built-in ones.

#![expect(clippy::excessive_precision, reason = "expected values keep their printed digits")]

mod attitude;
mod builtin;
mod errors;
mod keys;
mod navigators;
mod paths;
mod response;
mod sampling;
mod terms;
mod units;

use schuler_simulator::input::InputError;
use schuler_simulator::scene::{Scene, parse};

/// The keys that every scene needs.
const NEEDED: &str = "duration_s = 10\nrate_hz = 20\n";

/// A scene from the needed keys and some more, which start at line 3.
fn scene(more: &str) -> Result<Scene, InputError> {
    parse::scene("folder/bad.toml", &format!("{NEEDED}{more}"))
}
