//! Controls: what a pilot or a driver asks for, as sums of smooth steps over time.
//!
//! ```
//! use schuler::trajectory::segment::control::{Control, Controls};
//! use schuler::trajectory::segment::step::Step;
//!
//! // 20 s at 100 m/s; from 5 s to 9 s the course rate grows to 0.02 rad/s.
//! let turn = Step { start_s: 5.0, duration_s: 4.0, change: 0.02 };
//! let controls = Controls {
//!     course_rate: Control::stepping(0.0, [turn]),
//!     ..Controls::steady(20.0, 100.0)
//! };
//! assert_eq!(controls.joint_after(0.0), 5.0);
//! assert_eq!(controls.joint_after(9.0), 20.0);
//! assert_eq!(controls.course_rate.after(), 0.02);
//! ```

use super::step::{STEEPEST, Step};
use crate::earth::{EQUATORIAL_GRAVITY, SEMI_MAJOR_AXIS};
use crate::trajectory::series::Series;

/// The most steps of one control.
pub const STEPS: usize = 4;

/// Joints closer than this are one, s. A step is flat at its ends to the seventh order.
pub const LEAST_SPAN_S: f64 = 1e-6;

/// The largest angle, rad, by which anything turns within one piece.
const LARGEST_TURN: f64 = 0.5;
/// The largest arc, rad, along which a piece travels over the ellipsoid.
const LARGEST_ARC: f64 = 0.25;
/// The least and the largest number of pieces in a step. So many follow a step of 10¹⁵ m.
const PIECES_PER_STEP: [u32; 2] = [6, 96];
/// How far a piece may lie from the path between its ends, m: about as far as places round.
const FIDELITY: f64 = 2e-9;
/// The largest S⁽¹¹⁾/12! of the smooth step S, that at its ends: of its integral.
const ONCE: f64 = 12012.0 * 15.0 / (11.0 * 12.0);
/// The largest S⁽¹⁰⁾/12!: of the integral of its integral.
const TWICE: f64 = 12012.0 * 20.0 / (10.0 * 11.0 * 12.0);

/// A value that changes by steps.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Control {
    /// What it begins with.
    pub value: f64,
    /// Its changes, in any order.
    pub steps: [Step; STEPS],
}

impl Control {
    /// A value that stays.
    pub const fn steady(value: f64) -> Self {
        Self { value, steps: [Step::NONE; STEPS] }
    }

    /// A value that changes by up to [`STEPS`] steps, in any order.
    ///
    /// ```
    /// use schuler::trajectory::segment::{control::Control, step::Step};
    ///
    /// let up = Step { start_s: 0.0, duration_s: 4.0, change: 0.1 };
    /// let down = Step { start_s: 9.0, change: -0.1, ..up };
    /// assert_eq!(Control::stepping(0.0, [up, down]).after(), 0.0);
    /// ```
    pub fn stepping<const M: usize>(value: f64, steps: [Step; M]) -> Self {
        const { assert!(M <= STEPS, "a control has room for fewer steps") };
        let mut this = Self::steady(value);
        for (to, from) in this.steps.iter_mut().zip(steps) {
            *to = from;
        }
        this
    }

    /// The value after all of its steps.
    pub fn after(&self) -> f64 {
        self.steps.iter().fold(self.value, |sum, step| sum + step.change)
    }

    /// Its Taylor coefficients about a time, s, as they hold at the time `inside_s`.
    pub fn series<const N: usize>(&self, time_s: f64, inside_s: f64) -> Series<N> {
        let steps = self.steps.iter().filter(|step| step.change != 0.0);
        steps.fold(Series::constant(self.value), |sum, step| sum + step.series(time_s, inside_s))
    }

    /// Whether it stays at one value.
    pub fn is_steady(&self) -> bool {
        self.steps.iter().all(|step| step.change == 0.0)
    }

    /// A bound of its size between the joints around a time, s.
    pub(super) fn largest(&self, inside_s: f64) -> f64 {
        let [mut least, mut most] = [self.value; 2];
        for step in &self.steps {
            if step.is_active(inside_s) {
                least += step.change.min(0.0);
                most += step.change.max(0.0);
            } else if step.end_s() <= inside_s {
                least += step.change;
                most += step.change;
            }
        }
        least.abs().max(most.abs())
    }

    /// A bound of its slope, per second, at a time.
    fn steepest(&self, inside_s: f64) -> f64 {
        let active = self.steps.iter().filter(|step| step.is_active(inside_s));
        active.fold(0.0, |sum, step| sum + STEEPEST * step.change.abs() / step.duration_s)
    }
}

/// What a line without course rate is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Line {
    /// The straightest way over the ellipsoid.
    #[default]
    Geodesic,
    /// The way of constant course; not at a pole.
    Rhumb,
}

/// All controls of a stretch of time, which begins at 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Controls {
    /// How long it lasts, s.
    pub duration_s: f64,
    /// Speed V along the path, m/s; below 0 backwards.
    pub speed: Control,
    /// Climb angle g of the path above the horizon, rad.
    pub climb: Control,
    /// Course rate χ̇, rad/s, to the right, beside what the line itself turns.
    pub course_rate: Control,
    /// Roll, pitch and yaw on top of the attitude that the rule gives, rad.
    pub rotation: [Control; 3],
    /// What is straight.
    pub line: Line,
}

impl Controls {
    /// Straight on, level, for a time in s at a speed in m/s.
    pub const fn steady(duration_s: f64, speed: f64) -> Self {
        const NONE: Control = Control::steady(0.0);
        Self {
            duration_s,
            speed: Control::steady(speed),
            climb: NONE,
            course_rate: NONE,
            rotation: [NONE; 3],
            line: Line::Geodesic,
        }
    }

    fn each(&self) -> [&Control; 6] {
        let [roll, pitch, yaw] = &self.rotation;
        [&self.speed, &self.climb, &self.course_rate, roll, pitch, yaw]
    }

    /// The next time, s, after one at which a step begins or ends, or the end.
    pub fn joint_after(&self, time_s: f64) -> f64 {
        let steps = self.each().into_iter().flat_map(|control| &control.steps);
        let ends =
            steps.filter(|step| step.change != 0.0).flat_map(|step| [step.start_s, step.end_s()]);
        let (least, last) = (time_s + LEAST_SPAN_S, self.duration_s - LEAST_SPAN_S);
        let between = ends.filter(|end| least < *end && *end < last);
        between.fold(self.duration_s, f64::min)
    }

    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        let steps = self.each().into_iter().flat_map(|control| &control.steps);
        let numbers = steps.flat_map(|step| [step.start_s, step.duration_s, step.change]);
        let values = self.each().into_iter().map(|control| control.value);
        numbers.chain(values).chain([self.duration_s]).all(f64::is_finite)
    }

    /// Whether all stands still throughout.
    pub fn is_still(&self) -> bool {
        let moves = self.speed.value != 0.0 || self.course_rate.value != 0.0;
        !moves && self.each().iter().all(|control| control.is_steady())
    }

    /// Whether a step goes on at a time, s.
    pub(super) fn steps_at(&self, time_s: f64) -> bool {
        let mut steps = self.each().into_iter().flat_map(|control| &control.steps);
        steps.any(|step| step.is_active(time_s))
    }

    /// The longest span of a piece, s, about a time: so short that a polynomial of degree 11 follows the path
    /// to its rounding.
    pub(super) fn longest_span_s(&self, inside_s: f64) -> f64 {
        let mut longest = f64::INFINITY;
        let speed = self.speed.largest(inside_s);
        // Of f, the length of the way: f' = V; f' = V sin g; f'' = Vχ̇. Rotations move nothing.
        let [roll, pitch, yaw] = self.rotation.each_ref().map(|control| (control, 0.0, 0.0));
        let controls = [
            (&self.speed, ONCE, 0.0),
            (&self.climb, ONCE * speed, 0.0),
            (&self.course_rate, 0.0, TWICE * speed),
            roll,
            pitch,
            yaw,
        ];
        for (control, once, twice) in controls {
            for step in control.steps.iter().filter(|step| step.is_active(inside_s)) {
                let Step { duration_s, change, .. } = *step;
                let bend = change.abs() * duration_s * (once + twice * duration_s);
                longest = longest.min(duration_s / pieces_per_step(bend));
            }
        }
        let course_rate = self.course_rate.largest(inside_s);
        // The bank is atan(V χ̇/γ), whose series ends at ±i: the steeper the turn, the sooner.
        let bank = speed * course_rate / EQUATORIAL_GRAVITY;
        if bank > 1.0 && self.course_rate.steepest(inside_s) > 0.0 {
            longest = longest.min(longest / bank);
        }
        let mut turn = course_rate + self.climb.steepest(inside_s);
        for rotation in &self.rotation {
            turn += rotation.steepest(inside_s);
        }
        longest.min(LARGEST_TURN / turn).min(LARGEST_ARC * SEMI_MAJOR_AXIS / speed)
    }

    /// Taylor coefficients of what drives the path, about a time, s, as they hold at the time `inside_s`.
    pub(super) fn drive<const N: usize>(&self, time_s: f64, inside_s: f64) -> Drive<N> {
        let climb = self.climb.series(time_s, inside_s);
        let (climb_sine, climb_cosine) =
            if climb == Series::ZERO { (climb, Series::constant(1.0)) } else { climb.sin_cos() };
        Drive {
            speed: self.speed.series(time_s, inside_s),
            climb,
            climb_sine,
            climb_cosine,
            course_rate: self.course_rate.series(time_s, inside_s),
            line: self.line,
        }
    }
}

/// Into how many pieces a step of length T goes over which the twelfth derivative is at most `bend` 12!/T¹², m.
///
/// The polynomial with the derivatives 0 to 5 of both ends of a piece h is at most |f⁽¹²⁾|(h/2)¹²/12! off.
/// Source: the remainder of Hermite's interpolation (Stoer and Bulirsch, *Introduction to Numerical Analysis*, §2.1.5).
fn pieces_per_step(bend: f64) -> f64 {
    let [least, most] = PIECES_PER_STEP;
    let is_near = |count: &u32| {
        let halves = 2.0 * f64::from(*count);
        let cube = halves * halves * halves;
        bend <= FIDELITY * (cube * cube) * (cube * cube)
    };
    f64::from((least..most).find(is_near).unwrap_or(most))
}

/// What drives a path, about an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Drive<const N: usize> {
    /// V, m/s.
    pub speed: Series<N>,
    /// g, rad.
    pub climb: Series<N>,
    /// sin g.
    pub climb_sine: Series<N>,
    /// cos g.
    pub climb_cosine: Series<N>,
    /// χ̇, rad/s.
    pub course_rate: Series<N>,
    /// What is straight.
    pub line: Line,
}

impl<const N: usize> Drive<N> {
    /// Horizontal speed V cos g, m/s.
    pub fn level_speed(&self) -> Series<N> {
        self.speed * self.climb_cosine
    }

    /// Vertical speed V sin g, m/s.
    pub fn climb_speed(&self) -> Series<N> {
        self.speed * self.climb_sine
    }
}
