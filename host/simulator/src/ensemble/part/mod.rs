//! A file of kept runs: a shard of an ensemble, or as much of it as was flown before it was stopped.
//!
//! A line of JSON says what was flown ([`header`]). Blocks of runs follow, each as a line of JSON (runs, instants,
//! failures), the drifts of its runs, and SHA-256 of all bytes before it. So a file that has lost its end is one with
//! fewer blocks, and no other damage goes unseen. Drifts are nine `f64` (little-endian; position in m, velocity in m/s,
//! attitude in rad, north, east, down of each) for each instant of each run that reached its end.
//!
//! | file | what it has |
//! |---|---|
//! | [`header`] | what was flown, and how two parts differ |
//! | [`block`] | a block in bytes |
//! | [`mod@write`], [`read`] | a part that grows, and one that is read back |

pub mod block;
pub mod header;
pub mod read;
pub mod write;
