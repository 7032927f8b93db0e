//! What the navigator is measured against.
//!
//! | file | what it has |
//! |---|---|
//! | [`textbook`] | the two-sample algorithm of the textbooks, in either frame |
//! | [`rk4`] | classical Runge-Kutta on instantaneous rates |

pub mod rk4;
pub mod textbook;
