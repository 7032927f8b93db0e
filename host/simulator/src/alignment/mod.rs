//! Alignment on a scene's own samples: before a flight, and by itself to be compared with theory.
//!
//! | file | what it has |
//! |---|---|
//! | [`sensors`] | what a filter takes a scene's sensors for |
//! | [`setup`] | an alignment of a scene, ready to be started for each run |
//! | [`aligner`] | one run's alignment: samples in, attitude and biases out |
//! | [`under_way`] | a vehicle that moves, whose velocity is measured |
//! | [`coarse`] | the methods that need no filter |
//! | [`outcome`] | what it was off by |
//! | [`begin`] | a navigator that goes on where an alignment ends |
//! | [`spread`] | what many were off by, beside their standard deviations and theory |

pub mod aligner;
pub mod begin;
pub mod coarse;
pub mod outcome;
pub mod sensors;
pub mod setup;
pub mod spread;
pub mod under_way;
