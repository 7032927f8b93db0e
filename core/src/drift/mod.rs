//! How far a solution lies from the truth, and how small errors grow.
//!
//! | file | what |
//! |---|---|
//! | `compare` | a solution less the truth, in metres, m/s and rad |
//! | `linear` | the differential equation of small errors along a motion |
//! | `meridian` | from such errors to a drift, and back |

pub mod compare;
#[cfg(feature = "trajectory")]
pub mod linear;
#[cfg(feature = "trajectory")]
pub mod meridian;
pub mod offset;
