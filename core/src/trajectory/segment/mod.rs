//! Manoeuvres: a path by what a pilot or a driver does.
//!
//! | file | what it has |
//! |---|---|
//! | [`step`] | the smooth step |
//! | [`control`] | speed, climb angle, course rate and rotation as sums of steps |
//! | [`flow`] | the path that they drive, on the ellipsoid |

pub mod control;
pub mod flow;
pub mod step;
