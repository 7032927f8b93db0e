//! Runs of a scene, flown together.
//!
//! | file | what it has |
//! |---|---|
//! | [`runs`] | what a group of runs does, and how one fails |
//! | `alone`, `pack` | one run by itself; runs abreast in lanes |
//! | [`group`] | the start of a group in whatever the machine has |
//! | [`fleet`] | all runs on all processors |
//! | [`instants`] | when they are read |
//! | [`held`] | the vertical where it is held |
//! | `saturated` | how often sensors were at their limit |
//! | [`kept`], [`batches`] | what is kept of runs, and runs in batches |
//! | [`budget`] | what each error term contributes |
//! | [`part`] | a file of kept runs, which goes on where it ended |

mod alone;
pub mod batches;
pub mod budget;
pub mod fleet;
pub mod group;
pub mod held;
pub mod instants;
pub mod kept;
mod pack;
pub mod part;
pub mod runs;
mod saturated;
