//! How a turn is divided: the course rate grows, stays and goes back.
//!
//! χ̇ = γ tan(bank)/|V| or |V|/R. Either blend T turns by ½χ̇T, so a turn by θ stays |θ|/χ̇ − T at its rate; if
//! that is below 0, χ̇ = |θ|/T turns it in two blends.

use super::extent::{Amount, Tightness, Way};
use crate::earth::{self, EQUATORIAL_GRAVITY};
use crate::math::real::Real;
use crate::trajectory::segment::control::{Control, Controls};
use crate::trajectory::segment::fault::{Fault, LARGEST_BANK, LEAST_RHUMB_COSINE};
use crate::trajectory::segment::state::State;
use crate::trajectory::segment::step::Step;
use crate::trajectory::wrap;
use core::f64::consts::TAU;

/// How near to a course a turn ends, rad.
const NEAR: f64 = 1e-12;
/// A course that is this near counts as reached, not as a whole turn away, rad.
const SAME: f64 = 1e-9;

impl Tightness {
    /// The course rate, rad/s, at a speed other than 0 under a gravity in m/s².
    pub fn course_rate(self, speed: f64, gravity: f64) -> f64 {
        let speed = Real::abs(speed);
        match self {
            Self::Bank(bank) => {
                let (s, c) = Real::sin_cos(bank);
                gravity * s / (c * speed)
            }
            Self::Radius(radius) => speed / radius,
        }
    }
}

/// By an angle to the right, at most with a rate.
fn by(state: &State, angle: f64, rate: f64, blend_s: f64) -> Controls {
    let size = Real::abs(angle);
    let steady_s = size / rate - blend_s;
    let (rate, steady_s) = if steady_s < 0.0 { (size / blend_s, 0.0) } else { (rate, steady_s) };
    let change = if angle < 0.0 { -rate } else { rate };
    let on = Step { start_s: 0.0, duration_s: blend_s, change };
    let off = Step { start_s: blend_s + steady_s, duration_s: blend_s, change: -change };
    let course_rate = Control::stepping(state.course_rate, [on, off]);
    Controls { course_rate, ..state.steady(off.end_s()) }
}

/// See `Segment::controls`.
pub(super) fn controls(
    state: &State,
    amount: Amount,
    tightness: Tightness,
    blend_s: f64,
) -> Result<Controls, Fault> {
    let track = &state.track;
    let gravity = earth::gravity(track.normal_e.z.hi, track.altitude.hi);
    let rate = tightness.course_rate(state.speed, gravity);
    let (course, way) = match amount {
        Amount::By(angle) => return Ok(by(state, angle, rate, blend_s)),
        Amount::To { course, way } => (course, way),
    };
    let mut angle: f64 = wrap(course - track.course());
    if way == Way::Right && angle < -SAME {
        angle += TAU;
    }
    if way == Way::Left && angle > SAME {
        angle -= TAU;
    }
    // The meridians converge along the turn: it is flown until its end has the course.
    for _ in 0..12 {
        let controls = by(state, angle, rate, blend_s);
        let end = track.after(&controls);
        if track.cosine() < LEAST_RHUMB_COSINE || end.cosine() < LEAST_RHUMB_COSINE {
            break;
        }
        let missing: f64 = wrap(course - end.course());
        if missing.abs() < NEAR {
            return Ok(controls);
        }
        angle += missing;
    }
    Err(Fault::Pole)
}

/// Whether a turn is possible at a speed.
pub(super) fn check(speed: f64, tightness: Tightness) -> Result<(), Fault> {
    if speed == 0.0 {
        return Err(Fault::AtRest);
    }
    let tightest = Tightness::Bank(LARGEST_BANK).course_rate(speed, EQUATORIAL_GRAVITY);
    let most = match tightness {
        Tightness::Bank(bank) => bank <= LARGEST_BANK,
        Tightness::Radius(_) => tightness.course_rate(speed, EQUATORIAL_GRAVITY) <= tightest,
    };
    if most { Ok(()) } else { Err(Fault::TooTight { least_radius: Real::abs(speed) / tightest }) }
}
