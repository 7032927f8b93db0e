#![doc = include_str!("../README.md")]
#![no_std]
#![forbid(unsafe_code)]
// No panic rests on the optimiser alone: where an index is used, its place says why it holds.
#![deny(
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic,
    clippy::unwrap_used,
    clippy::unreachable
)]

#[cfg(all(target_arch = "x86", not(target_feature = "sse2")))]
compile_error!("x87 rounds to other bits: build for a processor with SSE2");

// Its tables of windows are macros, which the flight reads.
#[macro_use]
pub mod strapdown;

#[cfg(feature = "aiding")]
pub mod aiding;
pub mod alignment;
#[cfg(feature = "allan")]
pub mod allan;
pub mod digest;
pub mod drift;
pub mod earth;
#[macro_use]
pub mod flight;
#[cfg(feature = "trajectory")]
pub mod imu;
#[cfg(feature = "link")]
pub mod link;
pub mod math;
pub mod navigators;
#[cfg(feature = "sensor")]
pub mod noise;
pub mod output;
pub mod prelude;
pub mod readout;
pub mod record;
pub mod sample;
#[cfg(feature = "sensor")]
pub mod sensor;
pub mod solution;
#[cfg(feature = "trajectory")]
pub mod trajectory;
pub mod units;

#[doc(inline)]
pub use prelude::*;
