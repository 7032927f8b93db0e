//! Logs: positions and, if there are any, attitudes at increasing times, as a path.
//!
//! Noise decides how. Without noise the path passes through every row; with noise it is the smoothest one whose
//! residual is as large as noise leaves it ([`mod@crate::trajectory::spline::smooth`]), for the horizontal position, the height and the attitude
//! apart. A path through noisy rows accelerates: 2 cm at 10 Hz are 8 m/s², smoothed 0.04 m/s².
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::trajectory::log::{Log, Noise, compile, rows};
//! use schuler::trajectory::spline::{BAND, EXTRA, smooth::Workspace};
//!
//! // Northwards with 10 m/s for 3 s, by radii of 6371 km.
//! let times_s = [0.0, 1.0, 2.0, 3.0];
//! let places = times_s.map(|t| Geodetic { latitude: 0.7 + 10.0 * t / 6.371e6, longitude: 0.1, altitude: 50.0 });
//! let mut positions = [[0.0; 4]; 4];
//! rows::positions(&places, &mut positions)?;
//! let log = Log { times_s: &times_s, positions: &positions, attitudes: None, noise: Noise::NONE, max_gap_s: 2.0 };
//!
//! let (mut factors, mut right) = ([[0.0; BAND]; 4 + EXTRA], [[0.0; 4]; 4 + EXTRA]);
//! let workspace = Workspace { gram: &mut [], factors: &mut factors, right: &mut right };
//! let mut position = [[0.0; 4]; 4 + EXTRA];
//! let (path, _) = compile(&log, &times_s, workspace, &mut position, &mut [])?;
//! assert!((path.piece(1).unwrap().channel(2, 1.5) - (0.7_f64 + 15.0 / 6.371e6).sin()).abs() < 1e-15);
//! # Ok::<(), schuler::trajectory::log::LogError>(())
//! ```
//!
//! | file | what it has |
//! |---|---|
//! | [`rows`] | rows as normal, height and a quaternion of continuous sign |
//! | `fault` | what is wrong with a log |
//! | `compile` | from rows to splines |

mod compile;
mod fault;
pub mod rows;

pub use compile::{Log, Noise, Outcome, compile};
pub use fault::{LogError, Part};
