//! What a target flies of `circuit` and `waypoints`, and its twin on the host with it.

use crate::stretch::{Flown, Refused, Stretch, fly};
use crate::{circuit, waypoints};
use schuler::math::compensated::Pair;
use schuler::strapdown::block::window::H4B4A4;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::navigator::Strapdown;
use schuler::trajectory::piecewise::Attitude;
use schuler::trajectory::segment::compile::SegmentError;
use schuler::trajectory::spline::EXTRA;
use schuler::trajectory::waypoints::fault::WaypointError;

/// All of `circuit`, as fast as double precision in software allows.
pub const WHOLE: Stretch = Stretch { from_s: 0, to_s: circuit::DURATION_S, rate_hz: 4, nodes: 4 };
/// Its steepest turn, into 60° of bank and out of it.
pub const STEEP: Stretch = Stretch { from_s: 1050, to_s: 1072, rate_hz: 50, nodes: 4 };
/// Through the first way-points.
pub const POINTS: Stretch = Stretch { from_s: 0, to_s: 200, rate_hz: 4, nodes: 4 };

type Navigator = Strapdown<EarthFixed<Pair<f64>>, H4B4A4>;

/// Flies a stretch of `circuit`.
///
/// # Errors
///
/// [`Refused`].
pub fn segments(stretch: Stretch) -> Result<Flown, Refused<SegmentError>> {
    let compiler = circuit::compiler().map_err(Refused::Source)?;
    fly::<Navigator, _, _>(compiler, Attitude::Stored, stretch)
}

/// Flies a stretch of `waypoints`.
///
/// # Errors
///
/// [`Refused`].
pub fn points(stretch: Stretch) -> Result<Flown, Refused<WaypointError>> {
    let mut control = [[0.0; 4]; waypoints::POINTS + EXTRA];
    let path = waypoints::path(&waypoints::TIMES_S, &mut control).map_err(Refused::Source)?;
    let pieces = (0..path.pieces()).filter_map(|index| path.piece(index)).map(Ok);
    fly::<Navigator, _, _>(pieces, waypoints::ATTITUDE, stretch)
}
