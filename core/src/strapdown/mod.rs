//! Strapdown mechanization: increments in, position, velocity and attitude out.
//!
//! | room or file | what it has |
//! |---|---|
//! | [`block`] | the body's motion over a block of samples: windows, fits, series |
//! | [`frame`] | the step over a block in local-level or Earth-fixed axes |
//! | [`navigator`] | samples in, blocks and rows out |
//! | [`reference`](mod@reference) | what it is measured against: the textbook's algorithm, Runge-Kutta |
//! | [`mechanization`] | what every mechanization has in common |
//! | [`correction`] | corrections of a running state |
//! | [`plan`] | the cheapest window for a motion |
//! | [`limits`], [`gate`], [`plausible`] | what is accepted of samples, starts and restored states |

pub mod block;
pub mod correction;
pub mod frame;
pub mod gate;
pub mod limits;
pub mod mechanization;
pub mod navigator;
mod place;
pub mod plan;
pub mod plausible;
pub mod reference;
