//! Scenes in source, for programs that read no files: on targets, in audits, in measurements of speed.
//!
//! They are what the host makes of its own files, with the same conversions in the same order.

#![no_std]
#![forbid(unsafe_code)]

pub mod channel;
pub mod circuit;
pub mod paper;
pub mod segment;
pub mod stretch;
pub mod target;
pub mod units;
pub mod waypoints;
