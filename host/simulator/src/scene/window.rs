//! A window in JSON: an object of its three counts, or null.

use super::WindowShape;
use serde::{Serialize, Serializer};

#[derive(Serialize)]
struct Counts {
    history: usize,
    block: usize,
    lookahead: usize,
}

/// For `#[serde(serialize_with)]`.
pub fn serialize<S: Serializer>(window: &Option<WindowShape>, to: S) -> Result<S::Ok, S::Error> {
    let counts = |&WindowShape { history, block, lookahead }| Counts { history, block, lookahead };
    window.as_ref().map(counts).serialize(to)
}
