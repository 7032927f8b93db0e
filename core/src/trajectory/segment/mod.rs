//! Manoeuvres: a path by what a pilot or a driver does.
//!
//! Segments become controls, sums of smooth steps; controls drive a path over the ellipsoid; the path becomes
//! polynomials, whose joints are six times continuously differentiable in what drives them.
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::trajectory::segment::attitude::AttitudeRule;
//! use schuler::trajectory::segment::compile::segment::{Pace, Segment};
//! use schuler::trajectory::segment::compile::{Compiler, Start};
//!
//! let position = Geodetic { latitude: 0.8, longitude: 0.1, altitude: 100.0 };
//! let start = Start { position, course: 0.0, speed: 0.0 };
//! let segments = [
//!     Segment::Hold { duration_s: 60.0 },
//!     Segment::Accelerate { speed: 80.0, pace: Pace::Blend(40.0) },
//!     Segment::Climb { height: 500.0, rate: 8.0, blend_s: 6.0 },
//! ];
//! let mut compiler = Compiler::new(start, AttitudeRule::Coordinated, &segments)?;
//! let (mut pieces, mut altitude) = (0, 0.0);
//! while let Some(piece) = compiler.next_piece() {
//!     let piece = piece?;
//!     pieces += 1;
//!     altitude = piece.channel(3, piece.end_s);
//! }
//! assert_eq!(pieces, 26);
//! assert!((altitude - 600.0_f64).abs() < 1e-9);
//! # Ok::<(), schuler::trajectory::segment::compile::SegmentError>(())
//! ```
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
