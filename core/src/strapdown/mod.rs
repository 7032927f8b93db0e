//! Strapdown mechanization: increments in, position, velocity and attitude out.
//!
//! | room or file | what it has |
//! |---|---|
//! | [`block`] | the body's motion over a block of samples: windows, fits, series |
//! | [`frame`] | the step over a block in local-level or Earth-fixed axes |
//! | [`navigator`] | samples in, blocks and rows out |
//! | [`reference`](mod@reference) | algorithms that it is compared with: the textbook's, Runge-Kutta |
//! | [`mechanization`] | the trait of all mechanizations |
//! | [`correction`] | corrections of a running state |
//! | [`limits`], [`gate`], [`plausible`] | what is accepted of samples, starts and restored states |
//!
//! [windows]: block::window
#![doc = include_str!("ALGORITHM.md")]

#[macro_use]
pub mod block;
pub mod correction;
pub mod frame;
pub mod gate;
pub mod limits;
pub mod mechanization;
pub mod navigator;
mod place;
pub mod plausible;
pub mod reference;
