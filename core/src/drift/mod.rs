//! The difference of a solution from the truth, and the growth of small errors.
//!
//! | file | what it has |
//! |---|---|
//! | [`compare`] | a solution less the truth, in metres, m/s and rad |
//! | [`offset`] | the solution with a given drift |
//! | `linear` | the differential equation of small errors along a motion (feature `trajectory`) |
//! | `meridian` | from such errors to a drift, and back (feature `trajectory`) |

pub mod compare;
#[cfg(feature = "trajectory")]
pub mod linear;
#[cfg(feature = "trajectory")]
pub mod meridian;
pub mod offset;
