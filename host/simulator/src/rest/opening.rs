//! The first seconds of a flight without alignment. If the vehicle is at rest, its readings are known, and a
//! recording in other units is refused before the flight diverges.
//!
//! A vehicle may start in any motion. So only steady readings count as rest, only errors that a unit or a sign
//! explains are refused, and only readings that scatter like noise lead to a warning.

use super::align::{NOTICED_FORCE, down_b, faces_away};
use super::{warn, words};
use crate::input::InputError;
use crate::recording::navigation::NavigationRow;
use crate::units::DEGREE;
use schuler::alignment::judge::{Contradiction, Judgement, judge};
use schuler::alignment::place::Place;
use schuler::alignment::signs::Signs;
use schuler::alignment::still::{Readings, Still};
use schuler::alignment::units::Kind;
use schuler::sample::Increment;

/// Length of the pieces whose scatter is measured, s.
const PIECE_S: f64 = 0.2;
/// After these times it is judged, s; the last ends it.
const JUDGED_S: [f64; 4] = [1.0, 2.0, 5.0, 10.0];
/// Fewer pieces tell nothing.
const FEWEST_PIECES: u32 = 5;
/// Readings that stay vary less than this from piece to piece, of themselves.
const STEADY: f64 = 0.01;
/// A unit explains a specific force if it misfits gravity by less than this.
const UNIT_FIT: f64 = 0.03;
/// A vehicle at rest is no faster than this, m/s.
const AT_REST_M_S: f64 = 0.1;
/// An initial level further from the accelerometers' than this is worth a warning, rad: what they see
/// tilts by less where |f| shows no acceleration, √(2·0.002).
const LEVEL_LIMIT: f64 = 5.0 * DEGREE;

/// Watches the first seconds.
pub struct Opening<'a> {
    file: &'a str,
    said: Kind,
    initial: NavigationRow,
    place: Place<f64>,
    still: Still<f64>,
    /// How many of the times have been judged at.
    judged: usize,
}

impl<'a> Opening<'a> {
    /// Of a file whose samples are said to be of a kind, flown from an initial state.
    pub fn new(file: &'a str, said: Kind, initial: &NavigationRow) -> Self {
        let place = Place::new(initial.position);
        Self { file, said, initial: *initial, place, still: Still::new(PIECE_S), judged: 0 }
    }

    /// Takes the next sample of an interval, s. An error is a recording that contradicts itself.
    pub fn add(&mut self, sample: &Increment<f64>, interval_s: f64) -> Result<(), InputError> {
        let Some(until_s) = JUDGED_S.get(self.judged) else { return Ok(()) };
        self.still.add(sample, interval_s);
        if self.still.seconds() + 0.5 * interval_s > *until_s {
            self.judged += 1;
            self.judge()?;
            if self.judged == JUDGED_S.len() {
                self.warn();
            }
        }
        Ok(())
    }

    /// The recording ends.
    pub fn finish(&mut self) -> Result<(), InputError> {
        if self.judged < JUDGED_S.len() {
            self.judged = JUDGED_S.len();
            self.judge()?;
            self.warn();
        }
        Ok(())
    }

    /// What was read, if it stayed as it was.
    fn steady(&self) -> Option<Readings<f64>> {
        let readings = self.still.readings()?;
        let force = readings.specific_force_b.norm();
        let steady = readings.force_spread < STEADY * force;
        (self.still.pieces() >= FEWEST_PIECES && steady).then_some(readings)
    }

    fn at_rest(&self) -> bool {
        self.initial.velocity_ned.norm() < AT_REST_M_S
    }

    fn judge(&self) -> Result<(), InputError> {
        let Some(readings) = self.steady() else { return Ok(()) };
        let Judgement { quality, contradiction } = judge(&readings, self.said, &self.place);
        let refuse = |complaint| Err(InputError::file(self.file, complaint));
        let stands = self.at_rest() && quality.force_off.abs() < UNIT_FIT * self.place.gravity;
        let level = self.still.alignment().level(self.initial.attitude.yaw);
        let upside_down =
            stands && level.is_ok_and(|level| faces_away(&level, &self.initial.attitude));
        let told = match contradiction {
            Some(Contradiction::Units { mut force, mut rate }) => {
                force.retain(|explanation| explanation.misfit < UNIT_FIT);
                // In motion gyros read what they like.
                rate.retain(|_| self.at_rest());
                let explained = !force.is_empty() || !rate.is_empty();
                explained.then_some(Contradiction::Units { force, rate })
            }
            Some(Contradiction::Directions(signs)) if stands && is_explained(&signs) => {
                contradiction
            }
            _ => None,
        };
        if let Some(told) = told {
            let complaint = words::complaint(&told, &readings, self.said, &self.place, upside_down);
            return refuse(complaint);
        }
        match level {
            Ok(level) if upside_down => {
                refuse(words::upside_down(level.roll, self.initial.attitude.roll))
            }
            _ => Ok(()),
        }
    }

    /// Says what is poor where it stands still for all that is known.
    fn warn(&self) {
        let Some(readings) = self.steady().filter(|_| self.at_rest()) else { return };
        let Judgement { quality, contradiction } = judge(&readings, self.said, &self.place);
        let gravity = self.place.gravity;
        let off = quality.force_off.abs();
        // Motion changes slowly, noise does not: its pieces scatter alike from one to the next.
        let noise = 3f64.sqrt() * readings.force_noise;
        let is_noise = contradiction.is_none() && readings.force_spread < 2.0 * noise;
        if off > NOTICED_FORCE * gravity && off < UNIT_FIT * gravity && is_noise {
            warn(&words::force_is_off(quality.force_off, &self.place));
        }
        let Ok(level) = self.still.alignment().level(self.initial.attitude.yaw) else { return };
        let cross = down_b(&level).cross(down_b(&self.initial.attitude)).norm();
        let stands = off < NOTICED_FORCE * gravity || is_noise && off < UNIT_FIT * gravity;
        let limit = LEVEL_LIMIT.max(5.0 * quality.level_sigma);
        if stands && cross > limit.sin() {
            warn(&format!(
                "the initial state says roll {:.2}°, pitch {:.2}°, but at rest the accelerometers show \
                 roll {:.2}°, pitch {:.2}°",
                self.initial.attitude.roll / DEGREE,
                self.initial.attitude.pitch / DEGREE,
                level.roll / DEGREE,
                level.pitch / DEGREE
            ));
        }
        // Level axes that turn are seen by the accelerometers.
        let up = readings.specific_force_b;
        let along = up * (readings.rate_ib_b.dot(up) / up.dot(up));
        let unseen = (readings.rate_ib_b - along - readings.turn_b).norm();
        let seconds = self.still.seconds();
        let blur = noise / gravity / seconds * (12.0 * PIECE_S / seconds).sqrt();
        if is_noise && unseen > (5.0 * blur + words::EARTH).max(6.0 * readings.rate_sigma) {
            warn(&format!(
                "at rest the gyros read {}, which the accelerometers do not feel: the gyros are off by \
                 about that, and attitude drifts with it",
                words::rate(readings.rate_ib_b.norm())
            ));
        }
    }
}

/// Whether a fault is named; that the directions speak of another latitude is not enough in what may
/// be slow motion.
fn is_explained(signs: &Signs<f64>) -> bool {
    let Signs { reversed, axis, exchanged, longitude, radians, .. } = *signs;
    reversed || longitude || radians || axis.into_iter().chain(exchanged).any(|explains| explains)
}
