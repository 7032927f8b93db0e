//! Body axes along a path, as series: a rule, and rotations on top of it.
//!
//! From level axes, forward along ĥ, right along ĥ × n̂, down along −n̂, a rule pitches up by the climb angle g
//! and banks to the right by φ:
//!
//! ```text
//! s = s_level ⊗ s_pitch(g) ⊗ s_bank(φ) ⊗ s_z(yaw) ⊗ s_y(pitch) ⊗ s_x(roll)
//! x̂ = ĥ cos g + n̂ sin g,  v = Vx̂
//! f = V'x̂ + Vx̂' + 2Ω×v + γn̂,  f_y = f·(ĥ × n̂),  f_u = f·(n̂ cos g − ĥ sin g)
//! tanφ = f_y/f_u:  s_bank = (√(f_y² + f_u²) + f_u, f_y, 0, 0)/|…|
//! ```
//!
//! That bank leaves no lateral specific force. All of it is defined at rest.
//! Source: the coordinated turn, Stevens & Lewis, *Aircraft Control and Simulation*, §3.6.
//!
//! ```
//! use schuler::trajectory::segment::attitude::AttitudeRule;
//!
//! assert_eq!(AttitudeRule::default(), AttitudeRule::Coordinated);
//! ```

use super::control::{Controls, Drive};
use super::fault::Fault;
use super::flow::Flow;
use crate::earth::ROTATION_RATE;
use crate::math::quaternion::Quaternion;
use crate::math::vector::Vector;
use crate::trajectory::columns::quaternion;
use crate::trajectory::piecewise::place::Place;
use crate::trajectory::series::Series;

/// The least part of gravity, along the body's vertical, with which the direction of a bank is taken.
const LEAST_LOAD: f64 = 0.05;

/// How body axes lie along a path.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum AttitudeRule {
    /// Forward along the path, banked so that there is no lateral specific force: an aircraft.
    #[default]
    Coordinated,
    /// Forward along the path, no bank: a vehicle on its road.
    Upright,
    /// Forward along the course, no bank and no pitch: a ship, a levelled platform.
    Level,
}

/// s, from body to Earth-fixed axes, of unit length, with its first `M` coefficients; `N` is one more.
pub(super) fn attitude<const N: usize, const M: usize>(
    rule: AttitudeRule,
    flow: &Flow<N>,
    drive: &Drive<N>,
    rotation: &[Series<M>; 3],
) -> Result<Quaternion<Series<M>>, Fault> {
    let (n, h) = (flow.normal_e.map(|n| n.first()), flow.along_e.map(|h| h.first()));
    let right = h.cross(n);
    let mut s = quaternion(h, right, -n);
    if rule != AttitudeRule::Level {
        s = about(s, drive.climb.first(), |v| Vector::new(Series::ZERO, v, Series::ZERO));
    }
    if rule == AttitudeRule::Coordinated {
        s = product(&s, &bank(flow, drive, n, h, right)?);
    }
    let [roll, pitch, yaw] = *rotation;
    s = about(s, yaw, |v| Vector::new(Series::ZERO, Series::ZERO, v));
    s = about(s, pitch, |v| Vector::new(Series::ZERO, v, Series::ZERO));
    Ok(about(s, roll, |v| Vector::new(v, Series::ZERO, Series::ZERO)))
}

/// The rotations on top at a time, s, as they hold at the time `inside_s`.
pub(super) fn rotation<const M: usize>(
    controls: &Controls,
    time_s: f64,
    inside_s: f64,
) -> [Series<M>; 3] {
    controls.rotation.map(|angle| angle.series(time_s, inside_s))
}

/// s, then a turn by an angle about one of the body's axes.
fn about<const M: usize>(
    s: Quaternion<Series<M>>,
    angle: Series<M>,
    axis: impl Fn(Series<M>) -> Vector<Series<M>>,
) -> Quaternion<Series<M>> {
    if angle == Series::ZERO {
        return s;
    }
    let (sine, cosine) = angle.scaled(0.5).sin_cos();
    product(&s, &Quaternion::new(cosine, axis(sine)))
}

/// a ⊗ b, once in the code: its 336 products take seven kilobytes on a Cortex-M4F.
#[inline(never)]
fn product<const M: usize>(
    a: &Quaternion<Series<M>>,
    b: &Quaternion<Series<M>>,
) -> Quaternion<Series<M>> {
    *a * *b
}

/// The bank without lateral specific force.
fn bank<const N: usize, const M: usize>(
    flow: &Flow<N>,
    drive: &Drive<N>,
    n: Vector<Series<M>>,
    h: Vector<Series<M>>,
    right: Vector<Series<M>>,
) -> Result<Quaternion<Series<M>>, Fault> {
    let forward = flow.along_e * drive.climb_cosine + flow.normal_e * drive.climb_sine;
    let speed = drive.speed.first::<M>();
    let (sine, cosine) = (drive.climb_sine.first::<M>(), drive.climb_cosine.first::<M>());
    // Of f what is not along x̂: Vx̂' + 2Ω×v + γn̂, and γn̂ has no part to the right.
    let velocity = forward.map(|x| x.first::<M>()) * speed;
    let mut across = forward.map(|x| x.derivative().first::<M>()) * speed;
    across.x = across.x - velocity.y.scaled(2.0 * ROTATION_RATE);
    across.y = across.y + velocity.x.scaled(2.0 * ROTATION_RATE);
    let gravity = Place::new(n, flow.altitude.first::<M>()).gravity::<M>();
    let lateral = across.dot(right);
    let up = across.dot(n * cosine - h * sine) + gravity * cosine;
    if up.value() <= LEAST_LOAD * gravity.value() {
        return Err(Fault::Weightless);
    }
    let square = lateral * lateral + up * up;
    let w = square * square.reciprocal_root() + up;
    let length = (w * w + lateral * lateral).reciprocal_root();
    let none = Series::ZERO;
    Ok(Quaternion::new(w * length, Vector::new(lateral * length, none, none)))
}
