//! Aided navigation of a scene: what its aiding sensors measure, and the navigator that takes it.
//!
//! | file | what it has |
//! |---|---|
//! | [`measurements`] | what the sensors of a run deliver, in the order of arrival |
//! | [`columns`], [`told`] | the same as a file |
//! | [`fixes`] | what receivers wrote, on the time of a recording |
//! | [`settings`] | the filter for a scene |
//! | [`unit`](mod@unit) | what is known of a recording's sensors |
//! | [`navigator`] | the core's aided navigators behind one interface |
//! | [`seen`], [`smoother`] | its verdicts and steps, and what all measurements together say of them |
//! | [`vehicle`] | one run's navigator with its measurements |
//! | [`runs`] | many runs: their errors beside what their filters say |
//! | [`batches`] | so many of them, some at a time |
//! | [`budget`] | what each error term contributes to their errors |
//! | [`kept`] | what is kept of them, for parts of an ensemble |
//! | [`report`] | what became of measurements |
//! | [`estimates`] | what the filter estimates beside the motion |
//! | [`rows`] | states with their standard deviations, as files have them |

pub mod batches;
pub mod budget;
pub mod columns;
pub mod estimates;
pub mod fixes;
pub mod kept;
pub mod measurements;
pub mod navigator;
pub mod report;
pub mod rows;
pub mod runs;
pub mod seen;
pub mod settings;
pub mod smoother;
pub mod told;
pub mod unit;
pub mod vehicle;
