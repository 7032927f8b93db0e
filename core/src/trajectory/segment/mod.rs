//! Manoeuvres: a path by what a pilot or a driver does.
//!
//! | file | what it has |
//! |---|---|
//! | [`step`] | the smooth step |
//! | [`control`] | speed, climb angle, course rate and rotation as sums of steps |
//! | [`flow`] | the path that they drive, on the ellipsoid |
//! | [`attitude`] | body axes along it |
//! | [`state`] | where a path is between two manoeuvres |
//! | [`flyer`] | from controls to pieces |
//! | [`compile`] | from segments to pieces: [`Compiler`](compile::Compiler) |
//! | [`fault`] | what is wrong with a manoeuvre |

pub mod attitude;
pub mod compile;
pub mod control;
pub mod fault;
pub mod flow;
pub mod flyer;
pub mod state;
pub mod step;
