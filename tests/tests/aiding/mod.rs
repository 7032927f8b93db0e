//! The covariance core against dense covariances, the mechanization, and the limits of theory.

mod alignment;
mod bases;
mod covariance;
mod dense;
mod factors;
mod filter;
mod transition;
