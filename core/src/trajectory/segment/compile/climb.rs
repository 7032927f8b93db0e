//! How a climb is divided: the path bends up, climbs steadily and bends back, exactly to the height.
//!
//! Climb angle g = g₁ S(t/T) and back; h' = V sin g. Either bend gains V T I(g₁), I(g) = ∫₀¹ sin(g S(x)) dx,
//! which is followed by Taylor series as the path itself is.

use crate::earth::EQUATORIAL_GRAVITY;
use crate::math::real::Real;
use crate::trajectory::segment::control::{Control, Controls};
use crate::trajectory::segment::fault::{Fault, LARGEST_CLIMB};
use crate::trajectory::segment::flow::FLOW_TERMS;
use crate::trajectory::segment::state::State;
use crate::trajectory::segment::step::{STEEPEST, Step};
use crate::trajectory::series::Series;

/// The part of gravity that pushing over may take away.
const LARGEST_PUSH: f64 = 0.9;

/// Climb angle g₁, rad, and how long it stays, s.
struct Plan {
    angle: f64,
    steady_s: f64,
}

/// At a speed, not 0, by a height with a rate, not more than the speed.
fn plan(speed: f64, height: f64, rate: f64, blend_s: f64) -> Plan {
    let sine = Real::abs(rate / speed);
    let slope = Real::atan2(sine, Real::sqrt(1.0 - sine * sine));
    // Backwards the nose points down to climb.
    let angle = if (height < 0.0) == (speed < 0.0) { slope } else { -slope };
    let bends = 2.0 * speed * blend_s;
    let left = height - bends * bend(angle).0;
    let steady_s = left / (speed * Real::sin_cos(angle).0);
    if steady_s >= 0.0 {
        return Plan { angle, steady_s };
    }
    // The bends alone climb further: V T 2I(g) = height by Newton's steps, from 2 sin(½g) near it.
    let wanted = height / bends;
    let mut angle = 2.0 * Real::atan2(wanted, Real::sqrt(1.0 - wanted * wanted));
    for _ in 0..8 {
        let (gain, slope) = bend(angle);
        angle += (wanted - gain) / slope;
    }
    Plan { angle, steady_s: 0.0 }
}

/// I(g) = ∫₀¹ sin(g S(x)) dx, and its slope ∫₀¹ S cos(g S) dx.
fn bend(angle: f64) -> (f64, f64) {
    const PARTS: u32 = 24;
    let step = Step { start_s: 0.0, duration_s: 1.0, change: 1.0 };
    let width = 1.0 / f64::from(PARTS);
    (0..PARTS).fold((0.0, 0.0), |(gain, slope), part| {
        let from = f64::from(part) * width;
        let step = step.series::<FLOW_TERMS>(from, from + 0.5 * width);
        let (sine, cosine) = step.scaled(angle).sin_cos();
        let grown = |series: Series<FLOW_TERMS>| series.integral().growth(width);
        (gain + grown(sine), slope + grown(step * cosine))
    })
}

/// See `Segment::controls`.
pub(super) fn controls(state: &State, height: f64, rate: f64, blend_s: f64) -> Controls {
    let Plan { angle, steady_s } = plan(state.speed, height, rate, blend_s);
    let up = Step { start_s: 0.0, duration_s: blend_s, change: angle };
    let back = Step { start_s: blend_s + steady_s, duration_s: blend_s, change: -angle };
    let climb = Control::stepping(state.climb, [up, back]);
    Controls { climb, ..state.steady(back.end_s()) }
}

/// Whether a climb is possible at a speed; `banks` if up is where specific force says.
pub(super) fn check(
    speed: f64,
    height: f64,
    rate: f64,
    blend_s: f64,
    banks: bool,
) -> Result<(), Fault> {
    if speed == 0.0 {
        return Err(Fault::AtRest);
    }
    let largest = Real::abs(speed) * Real::sin_cos(LARGEST_CLIMB).0;
    if rate > largest {
        return Err(Fault::TooSteep { largest });
    }
    let angle = plan(speed, height, rate, blend_s).angle;
    // V ġ ≤ 2.93 V g₁/T takes this much off γ cos g.
    let hold = LARGEST_PUSH * EQUATORIAL_GRAVITY * Real::sin_cos(angle).1;
    let least_blend_s = STEEPEST * Real::abs(speed * angle) / hold;
    if banks && blend_s < least_blend_s {
        return Err(Fault::PushesOver { least_blend_s });
    }
    Ok(())
}
