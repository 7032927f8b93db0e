//! Runs of a scene, flown together.
//!
//! | file | what it has |
//! |---|---|
//! | [`runs`] | what a group of runs does, and how one fails |
//! | `alone`, `pack` | one run by itself; runs abreast in lanes |
//! | [`group`] | the start of a group in whatever the machine has |
//! | [`fleet`] | all runs on all processors |
//! | [`held`] | the vertical where it is held |

mod alone;
pub mod fleet;
pub mod group;
pub mod held;
mod pack;
pub mod runs;
