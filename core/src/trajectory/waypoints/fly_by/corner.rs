//! A corner: where a turn begins, and by how much it turns.
//!
//! The turn is flown from the way-point on; what it leads ahead and aside, x and y, says how much before the point it has to begin
//! to come out on the next leg: l = x − y/tanθ. Then it is flown from there, its distance from the next leg corrected by
//! Newton's step, and its angle by what is missing to the point after the next.

use super::leg::{Leg, angle_between};
use super::{FlyBy, WaypointError};
use crate::earth::{ECCENTRICITY_SQUARED, Radii};
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::trajectory::segment::compile::segment::{Amount, Length, Segment, Tightness};
use crate::trajectory::segment::flow::Track;
use crate::trajectory::segment::state::State;

/// A turn by less is left out, rad: the next leg is aimed from where the path is.
const LEAST_ANGLE: f64 = 1e-9;
/// Newton's steps at most: the first leaves less than 1 mm, five or six what rounding leaves.
const STEPS: usize = 12;
/// A turn ends on its next leg to this, m.
const NEAR: f64 = 1e-6;
/// It ends in the direction of the next leg to this, rad.
const NEAR_ANGLE: f64 = 1e-12;

/// How much of a leg a turn takes, in a plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lead {
    /// tan ½θ.
    pub tangent: f64,
    /// Radius, m.
    pub radius: f64,
    /// What rolling in and out adds, m.
    pub blends: f64,
    /// Speed, m/s.
    pub speed: f64,
    /// Gravity, m/s².
    pub gravity: f64,
}

impl Lead {
    /// No turn.
    pub const NONE: Self =
        Self { tangent: 0.0, radius: 0.0, blends: 0.0, speed: 0.0, gravity: 1.0 };

    /// Of a turn by an angle, rad, at a speed, m/s, and a rate, rad/s.
    pub fn new(angle: f64, speed: f64, rate: f64, blend_s: f64, gravity: f64) -> Self {
        // R tan ½θ on a circle; half a blend more at either end. Where the blends meet, the turn is longer by a blend.
        let (s, c) = Real::sin_cos(0.5 * Real::abs(angle));
        let part = Real::abs(angle) / (rate * blend_s);
        let part = if part < 1.0 { part } else { 1.0 };
        let tangent = s / if c > 1e-9 { c } else { 1e-9 };
        let radius = speed / (rate * if part > 0.0 { part } else { 1.0 });
        Self { tangent, radius, blends: 0.5 * speed * blend_s, speed, gravity }
    }

    /// All of it, m.
    pub fn length(&self) -> f64 {
        self.radius * self.tangent + self.blends
    }
}

/// Length of the straight line before a turn, m, and the turn; none where the path goes straight on.
pub(super) fn turn(
    plan: &FlyBy<'_>,
    leg: &Leg,
    next: &Leg,
    before: &State,
    distance: f64,
) -> Result<Option<(f64, Segment)>, WaypointError> {
    let straight =
        |length: f64| Segment::Straight { length: Length::Distance(length), line: plan.line };
    let turn = |angle: f64| Segment::Turn {
        amount: Amount::By(angle),
        tightness: Tightness::Bank(plan.bank),
        blend_s: plan.blend_s,
    };
    let corner = leg.flown(before, &straight(distance))?;
    let offset = |state: &State| position_e(&state.track) - position_e(&corner.track);
    let right_of = |state: &State| state.track.along_e.cross(state.track.normal_e.map(|n| n.hi));

    let onward = next.aim(corner)?.state;
    let mut angle = angle_between(&corner.track, onward.track.along_e);
    if angle.is_within(LEAST_ANGLE) {
        return Ok(None);
    }
    let (ahead, aside) = (corner.track.along_e, right_of(&corner));
    let flown = offset(&leg.flown(&corner, &turn(angle))?);
    let (s, c) = Real::sin_cos(angle);
    let mut lead = flown.dot(ahead) - flown.dot(aside) * c / s;
    // How much a later begin moves the end away from the next leg.
    let next_right = right_of(&onward);
    let slope = ahead.dot(next_right);
    for _ in 0..STEPS {
        let length = distance - lead;
        if length <= 0.0 {
            return Err(WaypointError::Short { index: leg.index });
        }
        let end = leg.flown(before, &straight(length))?;
        let end = leg.flown(&end, &turn(angle))?;
        let (aside, missing) = (offset(&end).dot(next_right), next.aim(end)?.turned);
        lead += aside / slope;
        angle += missing;
        if aside.is_within(NEAR) && missing.is_within(NEAR_ANGLE) {
            break;
        }
    }
    Ok(Some((distance - lead, turn(angle))))
}

/// The Earth-fixed position, m.
fn position_e(track: &Track) -> Vector<f64> {
    // r = (N + h)n̂ − e²N(n̂·ẑ)ẑ
    let n = track.normal_e.map(|n| n.hi);
    let east = Radii::at(n.z, Real::sqrt(n.x * n.x + n.y * n.y)).prime_vertical;
    let below = Vector::new(0.0, 0.0, ECCENTRICITY_SQUARED * east * n.z);
    n * (east + track.altitude.hi) - below
}
