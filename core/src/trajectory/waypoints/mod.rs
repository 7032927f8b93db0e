//! Paths by way-points: through them, or around the corners between them.
//!
//! | file | what it has |
//! |---|---|
//! | [`place`] | whether neighbours can be joined |
//! | [`mod@through`] | a spline through every point, by times or by speeds |
//! | [`mod@fly_by`] | legs and turns with a bank, as segments |
//! | [`fault`] | what is wrong with way-points |
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::trajectory::spline::{BAND, EXTRA, Ends};
//! use schuler::trajectory::waypoints::through::through;
//!
//! // A hundredth of a degree of latitude in 10 s each, at 500 m.
//! let at = |degrees: f64| Geodetic { latitude: degrees.to_radians(), longitude: 0.1, altitude: 500.0 };
//! let points = [at(45.0), at(45.01), at(45.02), at(45.03)];
//! let times_s = [0.0, 10.0, 20.0, 30.0];
//! let (mut band, mut control) = ([[0.0; BAND]; 4 + EXTRA], [[0.0; 4]; 4 + EXTRA]);
//! let path = through(&points, &times_s, Ends::Natural, &mut band, &mut control)?;
//! let piece = path.piece(1).unwrap();
//! assert!((piece.channel(2, 15.0) - 45.015_f64.to_radians().sin()).abs() < 1e-13);
//! # Ok::<(), schuler::trajectory::waypoints::fault::WaypointError>(())
//! ```

pub mod fault;
pub mod fly_by;
pub mod place;
pub mod through;
