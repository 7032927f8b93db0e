//! The aided navigator: a mechanization with a filter beside it, and measurements that may come late, out of order,
//! twice or never.
//!
//! | file | what it has |
//! |---|---|
//! | [`navigator`] | samples and measurements in, navigation and its σ out |
//! | [`settings`] | what it rests on: states, noise, first uncertainties, gates |
//! | `settings_record` | the same as words |
//! | [`measured`] | measurements: position, velocity, height, speed, standing still, wheels |
//! | [`instant`] | a time counted in samples |
//! | [`queue`] | measurements that wait, sorted |
//! | [`ring`] | the last steps, from which a late measurement is taken to the present |
//! | `moment` | the vehicle at any time within them |
//! | `locality` | the Earth where the vehicle is |
//! | `expected` | what is expected of a measurement |
//! | `push` | samples in, blocks chained to steps |
//! | `step` | the filter's step, and the measurements that are due |
//! | `take` | a measurement taken: expectation, verdict, feedback |
//! | `heading` | a heading that is not known at the start |
//! | `anchor` | a velocity to compare the next one with |
//! | `path` | a measurement taken to the present |
//! | `spread` | the covariance in north, east and down |
//! | [`state`] | the state, and its record |
//! | [`tally`] | counts |
//! | [`fault`] | why something is refused before it is looked at |
//! | [`verdict`] | what becomes of measurements; what a smoother needs of a step |
//!
//! A measurement belongs to its own time: its innovation is that of the navigator then, and the way it depends on the
//! errors is carried through the steps and the corrections since. So it counts as if it had come in time, but for the
//! noise of the steps in between. With a horizon, measurements wait for each other and are taken in the order of
//! their times: then every bit is the same however they were transported, unless one comes later than the horizon.

mod anchor;
mod expected;
pub mod fault;
mod heading;
pub mod instant;
mod locality;
pub mod measured;
mod moment;
pub mod navigator;
mod path;
mod push;
pub mod queue;
pub mod ring;
pub mod settings;
mod settings_record;
mod spread;
pub mod state;
mod step;
mod take;
pub mod tally;
pub mod verdict;
