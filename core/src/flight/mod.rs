//! Navigators by name: chosen at run time, flown, stored and digested.
//!
//! | file | what it has |
//! |---|---|
//! | [`configuration`] | one vocabulary: precision, axes, algorithm, window |
//! | [`catalogue`] | the one list of navigators, for whoever chooses one at run time |
//! | [`flight`] | a mechanization with its state and the digest of all states |
//! | [`from_double`] | the same, fed in double precision |
//! | [`carried`] | samples narrowed so that no rounding is lost |
//! | [`plan`] | the cheapest window for a motion |

pub mod carried;
#[macro_use]
pub mod catalogue;
pub mod configuration;
#[expect(clippy::module_inception, reason = "the flight itself, beside its catalogue")]
pub mod flight;
pub mod from_double;
pub mod plan;
