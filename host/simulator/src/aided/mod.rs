//! Aided navigation of a scene: what its aiding sensors measure, and the navigator that takes it.
//!
//! | file | what it has |
//! |---|---|
//! | [`measurements`] | what the sensors of a run deliver, in the order of arrival |
//! | [`settings`] | the filter for a scene |
//! | [`navigator`] | the core's aided navigators behind one interface |
//! | [`vehicle`] | one run's navigator with its measurements |
//! | [`runs`] | many runs: their errors beside what their filters say |
//! | [`report`] | what became of them |

pub mod measurements;
pub mod navigator;
pub mod report;
pub mod runs;
pub mod settings;
pub mod vehicle;
