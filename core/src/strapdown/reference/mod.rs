//! Algorithms that the navigator is compared with.
//!
//! | file | what it has |
//! |---|---|
//! | [`textbook`] | the algorithm of the textbooks, with one sample per step and the one before it, in either frame |
//! | [`rk4`] | classical Runge-Kutta on instantaneous rates |

pub mod rk4;
pub mod textbook;
