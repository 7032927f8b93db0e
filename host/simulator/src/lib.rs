//! The simulator: a scene is flown through the core, and its drift compared with theory.
//!
//! It knows no command line, prints nothing and times nothing unless asked.
//!
//! | room | what it has |
//! |---|---|
//! | [`units`], [`number`], [`mod@quartile`], [`mod@quadratic`], [`parallel`], [`input`], [`output`], [`progress`] | units, numbers for people, files in and out |
//! | [`scene`] | what flies, what the sensors get wrong, how it is navigated |
//! | [`course`], [`source`], [`emulator`] | motion, truth, perfect increments, sensors |
//! | [`navigator`], [`lanes`], [`ensemble`], [`twin`] | the core's navigators: one, many abreast, a target's copy |
//! | [`rounding`] | flights that round at random |
//! | [`plan`], [`lively`], [`timing`] | the window for a scene, and what a stage costs |
//! | [`alignment`], [`aided`] | what comes before navigation, and what aids it |
//! | [`simulate`], [`flight`], [`nine`], [`high`] | a flight from start to end, and what it leaves |
//! | [`theory`] | the drift that is expected |
//! | [`portrait`], [`formats`] | what a motion is like, and its path for other tools |
//! | [`recording`], [`rest`] | streams of samples from files, and what a unit at rest tells |
//! | [`mod@reference`] | positions of others: a reference, way-points |
//! | [`allan`], [`datasheet`] | sensors identified by their Allan deviation, or by their data sheet |

pub mod aided;
pub mod alignment;
pub mod allan;
pub mod course;
pub mod datasheet;
pub mod emulator;
pub mod ensemble;
pub mod flight;
pub mod formats;
pub mod high;
pub mod input;
pub mod lanes;
pub mod lively;
pub mod navigator;
pub mod nine;
pub mod number;
pub mod output;
pub mod parallel;
pub mod plan;
pub mod portrait;
pub mod progress;
pub mod quadratic;
pub mod quartile;
pub mod recording;
pub mod reference;
pub mod rest;
pub mod rounding;
pub mod scene;
pub mod simulate;
pub mod source;
pub mod theory;
pub mod timing;
pub mod twin;

pub use schuler::units;
