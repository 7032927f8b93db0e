//! What a scene says of one manoeuvre.
//!
//! Every segment begins and ends straight, level and at a steady speed; its blends lie within it.
//!
//! | segment | how long it takes | how it ends |
//! |---|---|---|
//! | [`Hold`](Segment::Hold) | its duration | as it began |
//! | [`Straight`](Segment::Straight) | its duration, or distance/speed | that far along the path at its height |
//! | [`Accelerate`](Segment::Accelerate) | its blend | at the speed, along the same line |
//! | [`Climb`](Segment::Climb) | two blends and what is left of the height at the rate | exactly that much higher |
//! | [`Turn`](Segment::Turn) | two blends and what is left of the angle at the rate | turned by the angle, or on the course |
//! | [`Rotate`](Segment::Rotate) | its blend | with these angles more |
//!
//! A turn or a climb that is over before its blends are reaches a part of its bank or rate.
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::trajectory::segment::compile::segment::{Amount, Segment, Tightness};
//! use schuler::trajectory::segment::{flow::Track, state::State};
//!
//! // A right angle to the right at 100 m/s on a circle of 2 km; rolling in and out takes 4 s each.
//! let at = Geodetic { latitude: 0.8, longitude: 0.0, altitude: 500.0 };
//! let state = State { speed: 100.0, ..State::at_rest(Track::new(at, 0.0)) };
//! let turn = Segment::Turn {
//!     amount: Amount::By(core::f64::consts::FRAC_PI_2),
//!     tightness: Tightness::Radius(2000.0),
//!     blend_s: 4.0,
//! };
//! let controls = turn.controls(&state)?;
//! assert_eq!(controls.duration_s, core::f64::consts::FRAC_PI_2 * 20.0 + 4.0);
//! # Ok::<(), schuler::trajectory::segment::fault::Fault>(())
//! ```

pub use super::extent::{Amount, Length, Pace, Tightness, Way};
use super::{climb, turn};
use crate::trajectory::segment::control::{Control, Controls, Line};
use crate::trajectory::segment::fault::Fault;
use crate::trajectory::segment::state::State;
use crate::trajectory::segment::step::Step;

/// One manoeuvre.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Segment {
    /// As it is, for a time: at rest all stands still, to the last bit.
    Hold {
        /// s.
        duration_s: f64,
    },
    /// Straight on at the speed that it has.
    Straight {
        /// How long.
        length: Length,
        /// What is straight.
        line: Line,
    },
    /// Another speed on the same line.
    Accelerate {
        /// The speed in the end, m/s; below 0 backwards.
        speed: f64,
        /// How fast it changes.
        pace: Pace,
    },
    /// Another height on the same line.
    Climb {
        /// How much higher, m; below 0 lower.
        height: f64,
        /// The vertical speed at most, m/s, positive.
        rate: f64,
        /// How long the path bends up or down at either end, s.
        blend_s: f64,
    },
    /// Another course at the same speed and height.
    Turn {
        /// How far.
        amount: Amount,
        /// How tight.
        tightness: Tightness,
        /// How long it takes to roll in or out, s.
        blend_s: f64,
    },
    /// A rotation on top of the attitude that the rule gives: yaw, then pitch, then roll about the axes as they
    /// lie by then. It stays until another takes it back. A yaw at rest turns the course with it: a vehicle that
    /// stands turns its heading.
    Rotate {
        /// Roll, pitch and yaw more, rad.
        angles: [f64; 3],
        /// How long it takes, s.
        blend_s: f64,
    },
}

impl Segment {
    /// The controls that do it from a straight and level state.
    ///
    /// # Errors
    ///
    /// [`Fault`] where a turn to a course ends at a pole; numbers are checked by
    /// [`check`](Segment::check).
    pub fn controls(&self, state: &State) -> Result<Controls, Fault> {
        Ok(match *self {
            Self::Hold { duration_s } => state.steady(duration_s),
            Self::Straight { length, line } => {
                let duration_s = match length {
                    Length::Time(duration_s) => duration_s,
                    Length::Distance(distance) => distance / state.speed.abs(),
                };
                Controls { line, ..state.steady(duration_s) }
            }
            Self::Accelerate { speed, pace } => {
                let change = speed - state.speed;
                let duration_s = pace.blend_s(change);
                let step = Step { start_s: 0.0, duration_s, change };
                let speed = Control::stepping(state.speed, [step]);
                Controls { speed, ..state.steady(duration_s) }
            }
            Self::Climb { height, rate, blend_s } => climb::controls(state, height, rate, blend_s),
            Self::Turn { amount, tightness, blend_s } => {
                turn::controls(state, amount, tightness, blend_s)?
            }
            Self::Rotate { angles, blend_s } => {
                let mut controls = state.steady(blend_s);
                for (control, change) in controls.rotation.iter_mut().zip(angles) {
                    let step = Step { start_s: 0.0, duration_s: blend_s, change };
                    *control = Control::stepping(control.value, [step]);
                }
                controls
            }
        })
    }
}
