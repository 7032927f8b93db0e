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
//!
//! ```
//! use schuler::flight::catalogue::{Catalogue, Entry, Every, Visitor};
//! use schuler::flight::configuration::Configuration;
//!
//! /// The samples that its window has.
//! struct Samples;
//!
//! impl Visitor for Samples {
//!     type Result = usize;
//!     fn visit<M: Entry>(self) -> usize {
//!         M::CONFIGURATION.window.samples()
//!     }
//! }
//!
//! let asked: Configuration = "f32 local-level taylor 2,4,2".parse()?;
//! assert_eq!(Every::visit(&asked, Samples), Some(8));
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

pub mod carried;
#[macro_use]
pub mod catalogue;
pub mod configuration;
#[expect(clippy::module_inception, reason = "the flight itself, beside its catalogue")]
pub mod flight;
pub mod from_double;
pub mod plan;
