//! A heading that is not known at the start.
//!
//! A linear filter finds a heading that is off by less than a right angle, and starts again from what it has found. One
//! that is farther off shows in velocities that do not fit. Feeding them to the filter would spoil level and biases.
//! Instead the change of the computed velocity from one measurement to the next is compared with that of the
//! measured one: the angle between both is the error of the heading. If they are too short to tell it, position and
//! velocity are set to what is measured, and the heading waits.

use super::anchor::Anchor;
use super::instant::Instant;
use super::measured::{Kind, Measured};
use super::moment::Moment;
use super::navigator::Aided;
use super::ring::{Entry, Ring};
use super::settings::Start;
use super::state::AidedState;
use super::verdict::Witness;
use crate::aiding::alignment::search::{Found, Search};
use crate::aiding::filter::Fading;
use crate::aiding::surroundings::Pose;
use crate::aiding::transition::Stretch;
use crate::math::real::{Real, Scalar};
use crate::math::vector::Vector;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::correction::Correction;
use crate::strapdown::mechanization::Mechanization;

/// A heading from two velocities is taken if it is good to this, rad.
const GOOD: f64 = 0.3;
/// What a tilt adds to a velocity, m/s² per rad.
const GRAVITY: f64 = 9.8;

/// The angle about down from a true change of velocity to the computed one, with its standard deviation, rad; nothing if
/// they are too short for their noise, or not of the same length.
fn angle<R: Scalar>(computed: Vector<R>, truth: Vector<R>, noise: R) -> Option<(R, R)> {
    let level = |v: Vector<R>| Vector { z: R::ZERO, ..v };
    let (a, b) = (level(truth), level(computed));
    let length = a.norm();
    let alike = (length - b.norm()).abs() < R::of(3.0) * noise;
    let tells = alike && noise < R::of(GOOD) * length;
    tells.then(|| (a.cross(b).z.atan2(a.dot(b)), R::TWO * noise / length))
}

/// Whether it is a velocity.
fn has_velocity(kind: Kind) -> bool {
    matches!(kind, Kind::Velocity | Kind::PositionVelocity)
}

impl<R, M, const N: usize, const P: usize, const E: usize, const L: usize, const Q: usize>
    Aided<M, N, P, E, L, Q>
where
    R: Scalar + Real<Mask = bool>,
    M: Mechanization<Real = R, Body = BodyMotion<R>>,
{
    /// Sets position, velocity and heading by two velocities that do not fit, and starts again from there. False if the
    /// measurement has no velocity, or is older than the last one.
    pub(super) fn turn(
        &self,
        state: &mut AidedState<M, N, P, E, L, Q>,
        moment: &Moment<R>,
        innovations_ned: &[Vector<R>; 2],
        measured: &Measured<R>,
        witness: &mut impl Witness<R, N, P, E>,
    ) -> bool {
        let Anchor { samples, velocity_ned: anchor, sigma } = state.anchor;
        if !has_velocity(measured.kind) || measured.at.samples < samples {
            return false;
        }
        let [beyond, faster] = *innovations_ned;
        let start = &self.settings.start;
        let time_s = measured.at.since(&Instant::of_sample(samples)) * self.interval.hi;
        let [_, _, tilted] = state.corrected;
        let noise = measured.velocity_sigma.norm()
            + sigma
            + (start.level_rad + tilted) * R::of(GRAVITY) * time_s;
        let computed = moment.pose.velocity_ned - anchor;
        let found = angle(computed, computed - faster, noise);
        let (turn, heading_rad) = found.unwrap_or((R::ZERO, start.heading_rad));
        let moves = measured.kind == Kind::PositionVelocity;
        // Since the time of a late one the vehicle went on with a wrong heading.
        let age_s = Instant::of_sample(state.integrated).since(&measured.at) * self.interval.hi;
        let now = self.solution(state).velocity_ned.map(|c| c.hi);
        let since = (now - moment.pose.velocity_ned).norm() * R::TWO;
        let correction = Correction {
            position_ned: if moves { -(beyond + faster * age_s) } else { Vector::ZERO },
            velocity_ned: -faster,
            attitude_ned: Vector::new(R::ZERO, R::ZERO, -turn),
        };
        if self.mechanization.correct(&mut state.navigator, &correction).is_err() {
            return false;
        }
        // The antenna swings about the unit in a direction that is not known.
        let lever = self.settings.lever_b;
        let [moved, gained, _] = &mut state.corrected;
        if moves {
            *moved = measured.position_sigma.norm() + lever.norm() * R::TWO + since * age_s;
        }
        let swing = moment.rate_ib_b.cross(lever).norm();
        let sigma = measured.velocity_sigma.norm() + swing * R::TWO + since;
        *gained = sigma;
        self.start_again(state, heading_rad, witness);
        let velocity_ned = self.solution(state).velocity_ned.map(|c| c.hi);
        state.anchor = Anchor { samples: state.integrated, velocity_ned, sigma };
        true
    }

    /// Starts again where a heading that was not known has turned too far for a linear filter, or where what was
    /// taken does not fit.
    pub(super) fn search(
        &self,
        state: &mut AidedState<M, N, P, E, L, Q>,
        measured: &Measured<R>,
        fits: bool,
        witness: &mut impl Witness<R, N, P, E>,
    ) {
        if !state.search.goes_on() {
            return;
        }
        let solution = self.solution(state);
        if has_velocity(measured.kind) {
            let velocity_ned = solution.velocity_ned.map(|c| c.hi);
            let sigma = measured.velocity_sigma.norm();
            state.anchor = Anchor { samples: state.integrated, velocity_ned, sigma };
        }
        let [_, _, down] = Pose::of(&solution).body_to_ned.rows;
        let found = if fits {
            let sigma = state.filter.sigma_about(down);
            let found = state.search.judge(sigma);
            // Poor gyros never know it five times better.
            if found == Found::Going {
                state.search.settle(sigma);
            }
            found
        } else {
            // Half a turn off, a linear filter sees no need to turn.
            Found::Again(self.settings.start.heading_rad)
        };
        if let Found::Again(heading_rad) = found {
            self.start_again(state, heading_rad, witness);
        }
    }

    /// The filter starts again, with a heading of this standard deviation, rad. What a wrong heading has put into
    /// position, velocity and level is doubted, too.
    fn start_again(
        &self,
        state: &mut AidedState<M, N, P, E, L, Q>,
        heading_rad: R,
        witness: &mut impl Witness<R, N, P, E>,
    ) {
        let [moved, gained, tilted] = core::mem::replace(&mut state.corrected, [R::ZERO; 3]);
        let Start { position_m, velocity_m_s, level_rad, .. } = self.settings.start;
        let start = Start {
            position_m: position_m + moved,
            velocity_m_s: velocity_m_s + gained,
            level_rad: level_rad + tilted,
            heading_rad,
        };
        let solution = self.solution(state);
        state.filter = self.filter(&Pose::of(&solution), &start);
        state.search = Search::new(heading_rad);
        state.stretch = Stretch::NONE;
        let [_, rate] = state.rates;
        let entry = Entry::new(state.integrated, &solution, rate, &Stretch::NONE, &Fading::NONE);
        state.ring = Ring::new(entry);
        witness.restarted(state.integrated);
    }
}
