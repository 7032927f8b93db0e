//! A leg: what is flown from one point to the next, and which way.
//!
//! The first guess of the direction is the great ellipse, the section through the Earth's centre: a circle in
//! (x/a, y/a, z/b). It lies 0.5 m beside the geodesic over 96 km and 241 m over 1953 km. The leg is flown, and its miss at
//! the far point turns the first direction by miss/(R sin(s/R)), until it is met.
//! Source: Williams, *Geometry of Navigation* (1998), ch. 4 (great ellipse); Karney, Algorithms for geodesics,
//! *Journal of Geodesy* 87 (2013) 43–55 (reduced length).

use super::{FlyBy, WaypointError, lead};
use crate::earth::{FLATTENING, SEMI_MAJOR_AXIS};
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::trajectory::segment::attitude::AttitudeRule;
use crate::trajectory::segment::compile::check::Known;
use crate::trajectory::segment::compile::segment::{Length, Pace, Segment};
use crate::trajectory::segment::control::Line;
use crate::trajectory::segment::flow::Track;
use crate::trajectory::segment::state::State;
use crate::trajectory::spline::place::distance;

/// A leg meets its far point to this, m.
const MISS: f64 = 1e-7;
/// Tries at most; a geodesic takes three, a long rhumb line more.
const TRIES: usize = 30;
/// A smaller difference of height, m, is left to the next leg.
const LEAST_HEIGHT: f64 = 1e-6;
/// Part of a leg that a change of speed takes, and part of the rest that a climb takes.
const SHARE: f64 = 0.6;

/// What is flown from the point before to a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    /// The far point.
    pub index: usize,
    /// The far point's place.
    pub target: Track,
    line: Line,
    rule: AttitudeRule,
    accelerate: Option<Segment>,
    climb: Option<Segment>,
}

/// A leg that meets its far point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Aim {
    /// How it begins.
    pub state: State,
    /// Length of the straight rest up to the far point, m.
    pub distance: f64,
    /// How much it turns to the right from the state that was given, rad.
    pub turned: f64,
}

impl Leg {
    /// The leg to a point, from the height at which the path is.
    pub fn new(plan: &FlyBy<'_>, index: usize, altitude: f64) -> Result<Self, WaypointError> {
        let both = index
            .checked_sub(1)
            .and_then(|before| Some((plan.points.get(before..)?, plan.speeds_m_s.get(before..)?)));
        let Some(([from, to, ..], [slow, fast, ..])) = both else {
            return Err(WaypointError::TooFew);
        };
        let (from, to, slow, fast) = (*from, *to, *slow, *fast);
        let mut free =
            distance(from, to) - lead(plan, index - 1).length() - lead(plan, index).length();
        let mut accelerate = None;
        if fast != slow {
            let blend_s = SHARE * free / (0.5 * (fast + slow));
            accelerate = Some(Segment::Accelerate { speed: fast, pace: Pace::Blend(blend_s) });
            free *= 1.0 - SHARE;
        }
        let height = to.altitude - altitude;
        let mut climb = None;
        if !height.is_within(LEAST_HEIGHT) {
            // A third of the time to bend up, a third to bend back: the gentlest of its kind.
            let time_s = SHARE * free / fast;
            let blend_s = time_s / 3.0;
            let rate = Real::abs(height) / (time_s - blend_s);
            climb = Some(Segment::Climb { height, rate, blend_s });
        }
        let target = Track::new(to, 0.0);
        Ok(Self { index, target, line: plan.line, rule: plan.rule, accelerate, climb })
    }

    /// The changes of speed and height.
    pub fn changes(&self) -> [Option<Segment>; 2] {
        [self.accelerate, self.climb]
    }

    /// After the changes of speed and height.
    pub fn before(&self, first: &State) -> Result<State, WaypointError> {
        let changes = self.changes().into_iter().flatten();
        changes.into_iter().try_fold(*first, |state, segment| self.checked(&state, &segment))
    }

    /// After a segment, whose numbers must be possible.
    pub fn checked(&self, state: &State, segment: &Segment) -> Result<State, WaypointError> {
        let altitude = state.track.altitude.hi;
        let known = Known { speed: state.speed, altitude, rule: self.rule };
        let failed = |fault| WaypointError::Leg { index: self.index, fault };
        segment.check(known).map_err(failed)?;
        self.flown(state, segment)
    }

    /// After a segment.
    pub fn flown(&self, state: &State, segment: &Segment) -> Result<State, WaypointError> {
        let controls = segment.controls(state);
        let failed = |fault| WaypointError::Leg { index: self.index, fault };
        Ok(state.after(&controls.map_err(failed)?))
    }

    /// Which way and how far from a state's place.
    pub fn aim(&self, from: State) -> Result<Aim, WaypointError> {
        let mut state = from;
        state.track.along_e = heading_between(&from.track, &self.target);
        let normal = |track: &Track| track.normal_e.map(|n| n.hi);
        let radius = SEMI_MAJOR_AXIS + self.target.altitude.hi;
        let reach = radius * normal(&from.track).cross(normal(&self.target)).norm();
        let mut distance = reach;
        for _ in 0..TRIES {
            let before = self.before(&state)?;
            let straight =
                Segment::Straight { length: Length::Distance(distance), line: self.line };
            let end = self.flown(&before, &straight)?.track;
            let miss = self.target.normal_e - end.normal_e;
            let miss = miss.map(|n| n.hi) * radius;
            let (along, right) = (miss.dot(end.along_e), miss.dot(end.along_e.cross(normal(&end))));
            if along.is_within(MISS) && right.is_within(MISS) {
                let to = state.track.along_e;
                let turned = angle_between(&from.track, to);
                return Ok(Aim { state, distance, turned });
            }
            state.track = state.track.turned(right / reach);
            distance += along;
        }
        Err(WaypointError::Short { index: self.index })
    }
}

/// The angle to the right from a track's direction to another direction, rad.
pub(super) fn angle_between(track: &Track, to: Vector<f64>) -> f64 {
    let right = track.along_e.cross(track.normal_e.map(|n| n.hi));
    Real::atan2(to.dot(right), to.dot(track.along_e))
}

/// The direction at a place along the great ellipse to another.
pub(super) fn heading_between(from: &Track, to: &Track) -> Vector<f64> {
    // u ∝ (n̂_x, n̂_y, (1 − f) n̂_z) is the place in (x/a, y/a, z/b); the tangent is (t_x, t_y, (1 − f)t_z),
    // t = v − u(u·v)
    let squash = |v: Vector<f64>| Vector::new(v.x, v.y, (1.0 - FLATTENING) * v.z);
    let unit = |v: Vector<f64>| v * (1.0 / v.norm());
    let round = |track: &Track| unit(squash(track.normal_e.map(|n| n.hi)));
    let (u, v) = (round(from), round(to));
    let n = from.normal_e.map(|n| n.hi);
    // v − u by components does not lose near points.
    let apart = v - u;
    let tangent = squash(apart - u * u.dot(apart));
    unit(tangent - n * n.dot(tangent))
}
