//! The link between a host and a target that navigates: frames, messages, and the target's application.
//!
//! Bytes → [`decoder`] → [`frame`] → [`message`] → [`target`], which owns a [`flight`] of one of the
//! mechanizations of its [`fleet`]. Every frame of a host that reaches its target whole is answered by
//! one frame. Everything is little-endian, and numbers cross as their bits.
//!
//! ```
//! use schuler::link::fleet::Single;
//! use schuler::link::frame::{Header, MOST_ENCODED, encode};
//! use schuler::link::kind::Kind;
//! use schuler::link::target::Target;
//!
//! // A host asks a target to identify itself.
//! let mut target = Target::<Single>::new(0);
//! let mut line = [0; MOST_ENCODED];
//! let header = Header { kind: Kind::Greet, sequence: 1, time_ns: 0 };
//! let mut answers = 0;
//! for &byte in encode(&header, &mut line, |_| ())? {
//!     target.take(byte, &mut |_: &[u8]| answers += 1);
//! }
//! assert_eq!(answers, 1);
//! # Ok::<(), schuler::link::frame::TooLong>(())
//! ```

#[cfg(feature = "aiding")]
pub mod aided;
#[cfg(feature = "aiding")]
pub mod aided_fleet;
pub mod answer;
pub mod bytes;
#[macro_use]
pub mod compose;
mod count;
pub mod counters;
pub mod decoder;
pub mod fleet;
pub mod flight;
pub mod frame;
pub mod gap;
#[cfg(feature = "allan")]
pub mod identification;
pub mod kind;
pub mod message;
pub mod offer;
pub mod refusal;
pub mod sequence;
pub mod target;
