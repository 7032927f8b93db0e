//! The covariance core against dense covariances, the mechanization, and the limits of theory.

mod aided_bits;
mod aided_drive;
mod aided_faults;
mod aided_sensors;
mod alignment;
mod bases;
mod covariance;
mod dense;
mod drive;
mod emulators;
mod factors;
mod figures;
mod filter;
mod processes;
mod riccati;
mod rows;
mod smoother;
mod standstill;
mod transition;
mod transport;
