//! `replay --gnss`: a recording flown by an aided navigator.
//!
//! | file | what it has |
//! |---|---|
//! | [`given`] | fixes on the recording's time, and what the sensors are taken for |
//! | [`grid`] | samples at times of their own, cut into even ones |
//! | [`start`] | where it starts, and how well that is known |
//! | [`fly`] | the flight |
//! | [`rows`] | nav.csv with standard deviations |
//! | [`kept`] | what it leaves beside that, in memory |
//! | [`withheld`] | fixes that are hidden, and how far off the navigator then is |

pub mod fly;
pub mod given;
pub mod grid;
pub mod kept;
pub mod rows;
pub mod start;
pub mod withheld;
