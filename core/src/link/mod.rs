//! The link between a host and a target that navigates: frames, messages, and the target's application.
//!
//! Bytes → [`decoder`] → [`frame`] → [`message`] → [`target`], which owns a [`flight`] of one of the
//! mechanizations of its [`fleet`]. Every frame of a host that reaches its target whole is answered by
//! one frame. Everything is little-endian, and numbers cross as their bits.

pub mod bytes;
pub mod counters;
pub mod decoder;
pub mod fleet;
pub mod flight;
pub mod frame;
pub mod gap;
pub mod kind;
pub mod message;
pub mod refusal;
pub mod sequence;
pub mod target;
