//! From controls to pieces: the path is followed from joint to joint, and a polynomial of degree 11 joins them.
//!
//! Two pieces that meet have the same derivatives of order 0 to 5 there, the same doubles. What stands still
//! is one piece with constant coefficients.
//!
//! ```
//! use schuler::earth::Geodetic;
//! use schuler::trajectory::segment::{attitude::AttitudeRule, flow::Track, flyer::Flyer, state::State};
//!
//! // 100 s along the equator at 50 m/s, 1000 m high: one piece.
//! let at = Geodetic { latitude: 0.0, longitude: 0.0, altitude: 1000.0 };
//! let east = core::f64::consts::FRAC_PI_2;
//! let state = State { speed: 50.0, ..State::at_rest(Track::new(at, east)) };
//! let mut flyer = Flyer::new(state, 0.0, AttitudeRule::Upright);
//! flyer.begin(state.steady(100.0))?;
//! let piece = flyer.next_piece().expect("there is one")?;
//! assert_eq!((piece.start_s, piece.end_s), (0.0, 100.0));
//! let arc = 50.0_f64 * 100.0 / (6_378_137.0 + 1000.0);
//! assert!((piece.channel(1, 100.0) - arc.sin()).abs() < 1e-15);
//! assert!(flyer.next_piece().is_none());
//! # Ok::<(), schuler::trajectory::segment::fault::Fault>(())
//! ```

use super::attitude::{AttitudeRule, attitude, rotation};
use super::control::{Controls, LEAST_SPAN_S, Line};
use super::fault::{Fault, LEAST_RHUMB_COSINE};
use super::flow::{Flow, Track};
use super::state::State;
use crate::math::compensated::Pair;
use crate::math::quaternion::Quaternion;
use crate::trajectory::hermite::{ORDERS, TERMS, two_point};
use crate::trajectory::piecewise::piece::{CHANNELS, Piece};
use crate::trajectory::series::Series;

/// Taylor coefficients of all channels at a joint.
type Ends = [[Pair<f64>; ORDERS]; CHANNELS];

/// From when to when: in the controls' time, and in the path's, rounded.
#[derive(Clone, Copy, Debug)]
struct Part {
    from_s: f64,
    to_s: f64,
    start_s: f64,
    end_s: f64,
}

/// A path in flight.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Flyer {
    rule: AttitudeRule,
    state: State,
    controls: Controls,
    /// When the controls begin.
    start_s: Pair<f64>,
    /// Between two joints: where they lie in the controls' time, and which of so many pieces is next.
    from_s: f64,
    to_s: f64,
    count: f64,
    index: f64,
    track: Track,
    /// Of the joint that is reached; none before the first piece.
    ends: Option<Ends>,
}

impl Flyer {
    /// At a state at a time, s.
    pub fn new(state: State, start_s: f64, rule: AttitudeRule) -> Self {
        Self {
            rule,
            state,
            controls: state.steady(0.0),
            start_s: Pair::new(start_s),
            from_s: 0.0,
            to_s: 0.0,
            count: 0.0,
            index: 0.0,
            track: state.track,
            ends: None,
        }
    }

    /// The state between manoeuvres: where the last controls ended whose pieces are all made.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// The time of that state, s.
    pub fn time_s(&self) -> f64 {
        self.start_s.hi
    }

    /// Takes the next controls; pieces of those before it that are not made are left out.
    ///
    /// # Errors
    ///
    /// [`Fault::Jump`] if they do not begin as the state is, [`Fault::NotFinite`].
    pub fn begin(&mut self, controls: Controls) -> Result<(), Fault> {
        if !controls.is_finite() {
            return Err(Fault::NotFinite);
        }
        if !self.state.goes_on(&controls) {
            return Err(Fault::Jump);
        }
        self.controls = controls;
        (self.from_s, self.to_s, self.count, self.index) = (0.0, 0.0, 0.0, 0.0);
        self.track = self.state.track;
        Ok(())
    }

    /// The next piece of the controls; none when they end.
    pub fn next_piece(&mut self) -> Option<Result<Piece<TERMS>, Fault>> {
        let part = self.next_part()?;
        Some(self.piece(part))
    }

    /// Flies the rest of the controls without making pieces.
    pub fn finish(&mut self) {
        while let Some(part) = self.next_part() {
            if !self.controls.is_still() {
                self.track = self.reached(part);
            }
        }
    }

    /// The span of time that is next; none when the controls end.
    fn next_part(&mut self) -> Option<Part> {
        if self.index >= self.count {
            if self.controls.duration_s - self.to_s <= LEAST_SPAN_S {
                self.end();
                return None;
            }
            self.from_s = self.to_s;
            self.index = 0.0;
            if self.controls.is_still() {
                (self.to_s, self.count) = (self.controls.duration_s, 1.0);
            } else {
                self.to_s = self.controls.joint_after(self.from_s);
                let span_s = self.to_s - self.from_s;
                self.count = self.track.pieces(&self.controls, self.inside_s(), span_s);
            }
        }
        let end = |index: f64| {
            let end_s = self.from_s + (self.to_s - self.from_s) * (index / self.count);
            if index < self.count { end_s } else { self.to_s }
        };
        let moment = |time_s: f64| (self.start_s + Pair::new(time_s)).hi;
        let (from_s, to_s) = (end(self.index), end(self.index + 1.0));
        self.index += 1.0;
        Some(Part { from_s, to_s, start_s: moment(from_s), end_s: moment(to_s) })
    }

    /// A time at which the polynomials of the controls hold that hold between the joints.
    fn inside_s(&self) -> f64 {
        0.5 * (self.from_s + self.to_s)
    }

    /// Where a part ends. Its rounded times are the path's: what lies between them is flown.
    fn reached(&self, part: Part) -> Track {
        self.track.along(&self.controls, part.from_s, part.end_s - part.start_s, self.inside_s())
    }

    /// The controls have ended.
    fn end(&mut self) {
        self.state = self.state.ended(&self.controls, self.track);
        self.start_s = self.start_s + Pair::new(self.to_s);
        self.controls = self.state.steady(0.0);
        (self.from_s, self.to_s, self.count, self.index) = (0.0, 0.0, 0.0, 0.0);
        self.track = self.state.track;
    }

    fn piece(&mut self, part: Part) -> Result<Piece<TERMS>, Fault> {
        let mut piece = Piece::new(part.start_s, part.end_s);
        let start = match self.ends {
            Some(ends) => ends,
            None => self.ends(&self.track, part.from_s, None)?,
        };
        if self.controls.is_still() {
            for (coefficient, end) in piece.coefficients.iter_mut().flatten().zip(&start) {
                *coefficient = end.first().map_or(0.0, |value| value.hi);
            }
            self.ends = Some(start);
            return Ok(piece);
        }
        let track = self.reached(part);
        let end = self.ends(&track, part.to_s, Some(&start))?;
        join(&mut piece, &start, &end);
        (self.ends, self.track) = (Some(end), track);
        Ok(piece)
    }

    /// What the channels do at a time of the controls, s, with the quaternion's sign as at the joint before.
    fn ends(&self, track: &Track, time_s: f64, before: Option<&Ends>) -> Result<Ends, Fault> {
        if self.controls.line == Line::Rhumb && track.cosine() < LEAST_RHUMB_COSINE {
            return Err(Fault::Pole);
        }
        let inside_s = self.inside_s();
        let drive = self.controls.drive::<{ ORDERS + 1 }>(time_s, inside_s);
        let flow = Flow::new(track, &drive);
        let angles = rotation::<ORDERS>(&self.controls, time_s, inside_s);
        let Quaternion { w, v } = attitude(self.rule, &flow, &drive, &angles)?;
        let exact = |series: Series<{ ORDERS + 1 }>, value: Pair<f64>| {
            let mut pairs = series.first::<ORDERS>().0.map(Pair::new);
            if let Some(first) = pairs.first_mut() {
                *first = value;
            }
            pairs
        };
        let [x, y, z] = flow.normal_e.zip(track.normal_e, exact).into_array();
        let h = exact(flow.altitude, track.altitude);
        let mut s = [w, v.x, v.y, v.z];
        if let Some([.., a, b, c, d]) = before {
            let last = [a, b, c, d].map(|channel| channel.first().map_or(0.0, |value| value.hi));
            if last.iter().zip(&s).fold(0.0, |sum, (a, b)| sum + a * b.value()) < 0.0 {
                s = s.map(|series| -series);
            }
        }
        let [w, a, b, c] = s.map(|series| series.0.map(Pair::new));
        let ends = [x, y, z, h, w, a, b, c];
        let finite = ends.iter().flatten().all(|x| x.hi.is_finite());
        if finite { Ok(ends) } else { Err(Fault::NotFinite) }
    }
}

/// The polynomials between two joints.
fn join(piece: &mut Piece<TERMS>, start: &Ends, end: &Ends) {
    // The rounded middle is δ from the middle: f(u − δ) = Σ (c_k − δ(k+1)c_{k+1} + …)uᵏ.
    let half = Pair::sum(piece.end_s, -piece.start_s) * Pair::new(0.5);
    let offset = 0.5 * ((piece.start_s - piece.middle_s) + (piece.end_s - piece.middle_s));
    for (channel, (start, end)) in start.iter().zip(end).enumerate() {
        let coefficients = two_point(start, end, half);
        let above = coefficients.iter().skip(1).map(|c| c.hi).chain([0.0]);
        let mut power = 0.0;
        for ((row, c), above) in piece.coefficients.iter_mut().zip(&coefficients).zip(above) {
            power += 1.0;
            if let Some(place) = row.get_mut(channel) {
                *place = c.hi + (c.lo - offset * power * above);
            }
        }
    }
}
