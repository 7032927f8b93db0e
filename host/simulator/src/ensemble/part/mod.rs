//! A file of kept runs: a shard of an ensemble, or as much of it as was flown before it was stopped.
//!
//! A line of JSON says what was flown ([`header`]). Blocks of runs follow, each as a line of JSON (runs, instants,
//! failures), the numbers of its runs, and SHA-256 of all bytes before it. So a file that has lost its end is one with
//! fewer blocks, and no other damage goes unseen. The numbers are `f64` (little-endian) of each run that reached its end:
//! its drift at each instant (position in m, velocity in m/s, attitude in rad, north, east, down of each). Where runs are
//! aided, each drift is followed by nine variances and four NEES, and the last by the counts of the run's measurements.
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
