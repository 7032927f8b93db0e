//! Fine alignment: a navigator that is told how little its vehicle moves finds level, north and the biases.
//!
//! | file | what it has |
//! |---|---|
//! | [`base`] | what is known of the vehicle's motion: it stands still, sways, or its velocity is measured |
//! | [`settings`] | what an alignment rests on |
//! | [`fine`] | the alignment: samples in, attitude and biases out |
//! | `step` | a step of the filter, and its measurement |
//! | [`search`] | a heading that is not known at the start |
//! | [`aligned`] | what came of it, with standard deviations |
//! | [`limit`] | what theory allows, and how long an alignment takes |
//! | [`verdict`] | what contradicts an alignment, or makes it too poor |
//!
//! The coarse methods, which need no first attitude, are in [`alignment`](crate::alignment).

pub mod aligned;
pub mod base;
pub mod fine;
pub mod limit;
pub mod search;
pub mod settings;
mod step;
pub mod verdict;
