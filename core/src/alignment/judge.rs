//! Whether what a still unit reads can be right.
//!
//! At rest on the Earth |f| = γ(φ, h), and ω has the components ω_ie sinφ along f and ω_ie cosφ across it.
//! Sensor errors move the readings a little; a wrong unit, sign or latitude moves them by a known amount.
//! Source: Groves, 2nd ed., §5.6 (levelling, gyrocompassing), §4.2 (sensor errors).
//!
//! ```
//! use schuler::alignment::judge::judge;
//! use schuler::alignment::place::Place;
//! use schuler::alignment::still::Still;
//! use schuler::alignment::units::Kind;
//! use schuler::earth::Geodetic;
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//!
//! // Velocity increments in units of gravity: 1 g · 0.01 s.
//! let mut still = Still::new(1.0_f64);
//! for _ in 0..3000 {
//!     let velocity_b = Vector::new(0.0, 0.0, -0.01);
//!     still.add(&Increment { angle_b: Vector::ZERO, velocity_b }, 0.01);
//! }
//! let place = Place::new(Geodetic { latitude: 0.8, longitude: 0.1, altitude: 100.0 });
//! let judgement = judge(&still.readings().unwrap(), Kind::Increments, &place);
//! assert!(judgement.contradiction.is_some());
//! ```

use super::place::Place;
use super::signs::{self, Signs};
use super::still::Readings;
use super::units::{Explanations, ForceUnit, Kind, RateUnit};
use crate::earth;
use crate::math::real::Scalar;

/// Specific force may differ from gravity by this fraction of it: a poor accelerometer's bias, 0.1 g.
const FORCE_LIMIT: f64 = 0.1;
/// Explanations are dropped if their misfit exceeds the best one's by this factor, plus 1 %.
const RIVAL: f64 = 10.0;
/// An angular rate above any bias, rad/s: 5 °/s.
const RATE_LIMIT: f64 = 0.0873;
/// A unit or a sign explains a rate if it leaves at most this fraction of the Earth's rate.
const RATE_FIT: f64 = 0.05;
/// A fraction of the Earth's rate that is taken for a bias without further tests.
const RATE_CLOSE: f64 = 0.1;
/// An error this many times the noise of one second is not a bias: ten times the largest ratio of bias to
/// noise of known sensors (consumer MEMS: 1 °/s and 0.003 °/s; pendulous accelerometers: 4 mg and 2 µg).
const STEADY: f64 = 3000.0;
/// Steady specific force that differs from gravity by this much is an acceleration.
const STEADY_FORCE: f64 = 0.005;
/// At rest, specific force varies by less than this fraction of itself from piece to piece.
const SPREAD_LIMIT: f64 = 0.03;

/// A contradiction in readings at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Contradiction<R> {
    /// Numbers in another unit or of another kind than stated.
    Units {
        /// Of the accelerometers; none if their readings are right.
        force: Explanations<ForceUnit, R>,
        /// Of the gyros; none if their readings are right, or do not decide it.
        rate: Explanations<RateUnit, R>,
    },
    /// Specific force varies: the vehicle is not still.
    Moving,
    /// Specific force is not gravity in any unit.
    Force,
    /// Specific force is not gravity, and is steadier than a sensor with such an error: an acceleration.
    Accelerating,
    /// The body turns: gyros and the direction of specific force agree.
    Turning,
    /// A rate that is too large for a bias and does not show in the accelerometers.
    Rate,
    /// Gyros and accelerometers contradict each other or the latitude.
    Directions(Signs<R>),
}

/// How good readings at rest are.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Quality<R> {
    /// |f| − γ, m/s².
    pub force_off: R,
    /// The smallest gyro error that explains the readings, rad/s.
    pub rate_off: R,
    /// Standard deviation of roll and pitch, from scatter and from the error of |f|, rad.
    pub level_sigma: R,
    /// Standard deviation of the heading, from scatter and from the error of ω, rad; above 1 there is no heading.
    pub heading_sigma: R,
}

/// The judgement of readings at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Judgement<R> {
    /// How good they are.
    pub quality: Quality<R>,
    /// Their contradictions, the strongest first.
    pub contradiction: Option<Contradiction<R>>,
}

/// Judges readings that are said to be of a kind, at rest at a place.
pub fn judge<R: Scalar>(readings: &Readings<R>, kind: Kind, place: &Place<R>) -> Judgement<R> {
    let Readings { rate_ib_b: rate, specific_force_b: force, .. } = *readings;
    let norm = force.norm();
    let up = if norm > R::ZERO { rate.dot(force) / norm } else { R::ZERO };
    let across = |up: R| {
        let square = rate.dot(rate) - up * up;
        if square > R::ZERO { square.sqrt() } else { R::ZERO }
    };
    let rate_off = place.least_bias(up, across(up));
    let quality = quality(readings, place, norm - place.gravity, rate_off);
    let contradiction = units(readings, kind, place, norm, [up, across(up)])
        .or_else(|| motion(readings, place, &quality, across(up)))
        .or_else(|| {
            let worst = noticed(readings, rate_off);
            let contradicts =
                worst && readings.rate_ib_b.norm() < R::of(2.0 * earth::ROTATION_RATE);
            let fit = R::of(RATE_FIT * earth::ROTATION_RATE);
            let signs = contradicts.then(|| signs::of(rate, force, place, rate_off, fit));
            signs.flatten().map(Contradiction::Directions)
        });
    Judgement { quality, contradiction }
}

/// Whether the gyros' error exceeds what scatter and a good gyro's bias explain.
fn noticed<R: Scalar>(readings: &Readings<R>, rate_off: R) -> bool {
    rate_off > R::of(RATE_CLOSE * earth::ROTATION_RATE)
        && rate_off > R::of(6.0) * readings.rate_sigma
}

fn quality<R: Scalar>(
    readings: &Readings<R>,
    place: &Place<R>,
    force_off: R,
    rate_off: R,
) -> Quality<R> {
    let square = |x: R| x * x;
    // An error ∇ of an axis tilts by ∇/γ; |f| − γ shows the error of one axis of three.
    let level = (square(readings.force_sigma) + square(force_off)).sqrt() / place.gravity;
    // Heading: ε_E/(ω_ie cosφ) and tilt·tanφ; ω shows the errors of two axes of three.
    let gyro = (square(readings.rate_sigma) + R::HALF * square(rate_off)).sqrt();
    let heading = (square(gyro) + square(level * place.rate_up)).sqrt();
    let none = R::of(1e3);
    let heading = if heading < place.rate_north * none { heading / place.rate_north } else { none };
    // Where the Earth's rate has no horizontal component, even perfect readings do not show north.
    let pole = R::entry(1e-6, 1e-12) * R::of(earth::ROTATION_RATE);
    Quality {
        force_off,
        rate_off,
        level_sigma: level,
        heading_sigma: if place.rate_north > pole { heading } else { none },
    }
}

/// Units in which readings make sense that are wrong as they stand.
fn units<R: Scalar>(
    readings: &Readings<R>,
    kind: Kind,
    place: &Place<R>,
    norm: R,
    [up, across]: [R; 2],
) -> Option<Contradiction<R>> {
    let off = |factor: R| (norm / factor / place.gravity - R::ONE).abs();
    let limit = R::of(FORCE_LIMIT);
    let force_units = ForceUnit::ALL.map(|unit| (unit, unit.si()));
    let force_is_right = off(R::ONE) < limit;
    let mut force = Explanations::NONE;
    if !force_is_right {
        force = Explanations::from_units(&force_units, kind, readings.interval_s, limit, off);
        keep_rivals(&mut force);
    }
    let rotation = R::of(earth::ROTATION_RATE);
    // A wrong sign in addition is a separate fault.
    let off = |factor: R| {
        let [as_is, reversed] =
            [up, -up].map(|up| place.least_bias(up / factor, across / factor) / rotation);
        if reversed < as_is { reversed } else { as_is }
    };
    // Scatter is in the same wrong unit, and a misfit below it proves nothing.
    let blur = readings.rate_sigma * R::of(6.0) / rotation;
    let fits = |factor: R| off(factor) + blur / factor;
    let rate_is_right = off(R::ONE) < R::of(RATE_CLOSE) + blur;
    let mut rate = Explanations::NONE;
    if !rate_is_right {
        let rate_units = RateUnit::ALL.map(|unit| (unit, unit.si()));
        let limit = R::of(RATE_FIT);
        rate = Explanations::from_units(&rate_units, kind, readings.interval_s, limit, fits);
        keep_rivals(&mut rate);
    }
    // A header is wrong for both triads or for neither.
    let (one, other) = (force, rate);
    if force_is_right {
        rate.retain(|explanation| explanation.kind == kind);
    } else if one.iter().any(|f| other.iter().any(|r| r.kind == f.kind)) {
        rate.retain(|r| one.iter().any(|f| f.kind == r.kind));
    }
    if rate_is_right && blur < R::ONE {
        force.retain(|explanation| explanation.kind == kind);
    } else if one.iter().any(|f| other.iter().any(|r| r.kind == f.kind)) {
        force.retain(|f| other.iter().any(|r| r.kind == f.kind));
    }
    let explained = !force.is_empty() || !rate.is_empty();
    explained.then_some(Contradiction::Units { force, rate })
}

fn keep_rivals<U: Copy, R: Scalar>(explanations: &mut Explanations<U, R>) {
    let best = explanations.iter().next().map(|best| best.misfit);
    if let Some(best) = best {
        explanations.retain(|one| one.misfit < best * R::of(RIVAL) + R::of(0.01));
    }
}

/// Motion of a vehicle that should be at rest.
fn motion<R: Scalar>(
    readings: &Readings<R>,
    place: &Place<R>,
    quality: &Quality<R>,
    across: R,
) -> Option<Contradiction<R>> {
    let (gravity, off) = (place.gravity, quality.force_off.abs());
    let steady = R::of(STEADY);
    let rate = readings.rate_ib_b.norm();
    let turn = readings.turn_b;
    // Accelerometers do not show a turn about the vertical: compare the components across it.
    let force = readings.specific_force_b;
    let norm = force.norm();
    let level = if norm > R::ZERO {
        let direction = force * (R::ONE / norm);
        readings.rate_ib_b - direction * readings.rate_ib_b.dot(direction)
    } else {
        readings.rate_ib_b
    };
    let agree = (level - turn).norm() < R::of(0.3) * across;
    let turns = across > R::of(20.0 * earth::ROTATION_RATE) && agree;
    if turns {
        Some(Contradiction::Turning)
    } else if readings.force_spread > R::of(SPREAD_LIMIT) * (norm + R::of(FORCE_LIMIT) * gravity) {
        Some(Contradiction::Moving)
    } else if off > R::of(FORCE_LIMIT) * gravity {
        Some(Contradiction::Force)
    } else if off > R::of(STEADY_FORCE) * gravity && off > steady * readings.force_noise {
        Some(Contradiction::Accelerating)
    } else if rate > R::of(RATE_LIMIT) {
        Some(Contradiction::Rate)
    } else {
        None
    }
}
