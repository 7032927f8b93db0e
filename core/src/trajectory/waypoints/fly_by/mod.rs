//! Around the corners: legs from point to point, joined by turns that are limited in bank.
//!
//! A leg is a geodesic or a rhumb line. At a corner the path turns before the way-point, so that it comes out on the
//! next leg; only the first and the last point are flown over. Height and speed change on the leg, before its
//! straight rest, and are those of the way-point in the turn. The result is a list of segments, as by hand: what
//! [`Compiler`](crate::trajectory::segment::compile::Compiler) makes of it is the path.
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::trajectory::segment::{attitude::AttitudeRule, compile::Compiler, control::Line};
//! use schuler::trajectory::waypoints::fly_by::{FlyBy, ROOM, fly_by};
//! use schuler::trajectory::segment::compile::segment::Segment;
//!
//! // Half a degree north, then half a degree east, at 150 m/s.
//! let at = |latitude: f64, longitude: f64| Geodetic {
//!     latitude: latitude.to_radians(),
//!     longitude: longitude.to_radians(),
//!     altitude: 1000.0,
//! };
//! let points = [at(45.0, 10.0), at(45.5, 10.0), at(45.5, 10.5)];
//! let plan = FlyBy {
//!     points: &points,
//!     speeds_m_s: &[150.0; 3],
//!     bank: 0.5,
//!     blend_s: 4.0,
//!     line: Line::Geodesic,
//!     rule: AttitudeRule::Coordinated,
//! };
//! let mut segments = [Segment::Hold { duration_s: 0.0 }; 2 * ROOM];
//! let (start, count) = fly_by(&plan, &mut segments)?;
//! let compiler = Compiler::new(start, AttitudeRule::Coordinated, &segments[..count]).unwrap();
//! let end = compiler.spans().last().unwrap().unwrap().state.track.position();
//! assert!((end.longitude - points[2].longitude).abs() < 1e-12);
//! # Ok::<(), schuler::trajectory::waypoints::fault::WaypointError>(())
//! ```
//!
//! | file | what it has |
//! |---|---|
//! | `leg` | what is flown from one point to the next, and which way |
//! | `corner` | where a turn begins, and by how much it turns |

mod corner;
mod leg;

use super::fault::WaypointError;
use super::place::check_places;
use crate::earth::{Geodetic, gravity};
use crate::math::real::Real;
use crate::trajectory::segment::attitude::AttitudeRule;
use crate::trajectory::segment::compile::Start;
use crate::trajectory::segment::compile::segment::{Length, Segment, Tightness};
use crate::trajectory::segment::control::Line;
use crate::trajectory::segment::fault::{LARGEST_BANK, LEAST_RHUMB_COSINE, LEAST_TIME_S};
use crate::trajectory::segment::flow::Track;
use crate::trajectory::segment::state::State;
use crate::trajectory::spline::place::{LARGEST_SPEED, distance};
use corner::Lead;
use leg::{Leg, heading_between};

/// Segments of a leg at most: a change of speed, a climb, a straight line, a turn.
pub const ROOM: usize = 4;

/// The part of a leg that its turns may take together.
const MOST_TURNS: f64 = 0.95;

/// Way-points and how they are flown.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FlyBy<'a> {
    /// Places: rad, rad, m.
    pub points: &'a [Geodetic<f64>],
    /// The speed at each of them, m/s; only the first may be 0.
    pub speeds_m_s: &'a [f64],
    /// The bank in turns, rad.
    pub bank: f64,
    /// How long it takes to roll in or out, s.
    pub blend_s: f64,
    /// What legs are. Changes of speed and of height follow a geodesic either way.
    pub line: Line,
    /// How body axes lie along the path; a coordinated flight must not push over into weightlessness.
    pub rule: AttitudeRule,
}

/// The start and the number of segments of a path around way-points; `segments` has room for [`ROOM`] per leg.
///
/// # Errors
///
/// [`WaypointError`] with the index of the point at fault.
pub fn fly_by(plan: &FlyBy<'_>, segments: &mut [Segment]) -> Result<(Start, usize), WaypointError> {
    check(plan)?;
    let needed = ROOM * (plan.points.len() - 1);
    if segments.len() < needed {
        return Err(WaypointError::NoRoom { needed });
    }
    let mut places = segments.iter_mut();
    let mut count = 0;
    let mut put = |segment: Segment| {
        if let Some(place) = places.next() {
            *place = segment;
            count += 1;
        }
    };
    let (mut state, mut start) = (at_start(plan), None);
    for index in 1..plan.points.len() {
        let leg = Leg::new(plan, index, state.track.altitude.hi)?;
        let aim = leg.aim(state)?;
        // The first leg begins with its course, the others with that of the turn before.
        if let (1, Some(&position)) = (index, plan.points.first()) {
            state = aim.state;
            start = Some(Start { position, course: state.track.course(), speed: state.speed });
        }
        leg.changes().into_iter().flatten().for_each(&mut put);
        let before = leg.before(&state)?;
        let turn = if index + 1 < plan.points.len() {
            let next = Leg::new(plan, index + 1, leg.target.altitude.hi)?;
            corner::turn(plan, &leg, &next, &before, aim.distance)?
        } else {
            None
        };
        let (straight, turn) = match turn {
            Some((straight, turn)) => (straight, Some(turn)),
            None => (aim.distance, None),
        };
        if straight / before.speed < LEAST_TIME_S {
            return Err(WaypointError::Short { index });
        }
        let straight = Segment::Straight { length: Length::Distance(straight), line: plan.line };
        put(straight);
        state = leg.checked(&before, &straight)?;
        if let Some(turn) = turn {
            put(turn);
            state = leg.checked(&state, &turn)?;
        }
    }
    start.map(|start| (start, count)).ok_or(WaypointError::TooFew)
}

/// Checks all that does not depend on the way.
fn check(plan: &FlyBy<'_>) -> Result<(), WaypointError> {
    let FlyBy { points, speeds_m_s, bank, blend_s, line, .. } = *plan;
    check_places(points)?;
    if speeds_m_s.len() != points.len() {
        return Err(WaypointError::Count { needed: points.len() });
    }
    if !(bank > 0.0 && bank <= LARGEST_BANK && blend_s.is_within(1e6) && blend_s >= LEAST_TIME_S) {
        return Err(WaypointError::Turn);
    }
    for (index, (at, &speed_m_s)) in points.iter().zip(speeds_m_s).enumerate() {
        if !speed_m_s.is_finite() {
            return Err(WaypointError::NotFinite { index });
        }
        if speed_m_s < 0.0 || (speed_m_s == 0.0 && index > 0) {
            return Err(WaypointError::Speed { index });
        }
        if speed_m_s > LARGEST_SPEED {
            return Err(WaypointError::TooFast { index, speed_m_s });
        }
        let (_, cosine) = Real::sin_cos(at.latitude);
        if line == Line::Rhumb && cosine.abs() < LEAST_RHUMB_COSINE {
            return Err(WaypointError::Pole { index });
        }
        let before = index.checked_sub(1).and_then(|before| points.get(before));
        if before.is_some_and(|before| {
            let level = |at: Geodetic<f64>| Geodetic { altitude: 0.0, ..at };
            distance(level(*before), level(*at)) < super::place::LEAST_DISTANCE
        }) {
            return Err(WaypointError::Coincident { index });
        }
    }
    check_turns(plan)
}

/// Checks that the turns at both ends of each leg fit on it, with a little left.
fn check_turns(plan: &FlyBy<'_>) -> Result<(), WaypointError> {
    let mut last = Lead::NONE;
    for index in 1..plan.points.len() {
        let next = lead(plan, index);
        let (Some(from), Some(to)) = (plan.points.get(index - 1), plan.points.get(index)) else {
            break;
        };
        let length = MOST_TURNS * distance(*from, *to);
        if last.length() + next.length() > length {
            // The turn that needs more of the leg is to change.
            let (index, lead) =
                if last.length() > next.length() { (index - 1, last) } else { (index, next) };
            // Σ tan ½θ v²/(g tan bank) = what rolling leaves of the leg
            let level = |lead: Lead| lead.tangent * lead.speed * lead.speed / lead.gravity;
            let bent = length - last.blends - next.blends;
            let bank = Real::atan2(level(last) + level(next), bent);
            let radius =
                lead.speed * lead.speed * bent / (lead.gravity * (level(last) + level(next)));
            // Not even the steepest turn fits, or the radius would be negative.
            if !(radius > 0.0 && bank <= LARGEST_BANK) {
                return Err(WaypointError::NoTurn { index });
            }
            return Err(WaypointError::TooTight { index, bank, radius_m: radius });
        }
        last = next;
    }
    Ok(())
}

/// How much of its legs the turn at a point takes, roughly.
fn lead(plan: &FlyBy<'_>, index: usize) -> Lead {
    let (Some(around), Some(&speed)) =
        (plan.points.get(index.wrapping_sub(1)..), plan.speeds_m_s.get(index))
    else {
        return Lead::NONE;
    };
    let [from, at, to, ..] = around else { return Lead::NONE };
    let here = Track::new(*at, 0.0);
    let (back, on) = (
        heading_between(&here, &Track::new(*from, 0.0)),
        heading_between(&here, &Track::new(*to, 0.0)),
    );
    let right = back.cross(here.normal_e.map(|n| n.hi));
    // The turn is what is missing to straight on: half a turn from the way back.
    let angle = Real::atan2(-on.dot(right), -on.dot(back));
    let gravity = gravity(here.normal_e.z.hi, at.altitude);
    let rate = Tightness::Bank(plan.bank).course_rate(speed, gravity);
    Lead::new(angle, speed, rate, plan.blend_s, gravity)
}

/// At a place without a course yet.
fn at_start(plan: &FlyBy<'_>) -> State {
    let at = plan.points.first().copied().unwrap_or_default();
    let speed = plan.speeds_m_s.first().copied().unwrap_or(0.0);
    State { speed, ..State::at_rest(Track::new(at, 0.0)) }
}
