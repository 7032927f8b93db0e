//! The drift and the motion of a flight for curves: what every row has, as an envelope.

use super::norm;
use schuler_report::envelope::Envelope;
use schuler_simulator::flight::Instant;
use schuler_simulator::units::ARCSECOND;
use std::f64::consts::{PI, TAU};

/// Series of a trace: the nine of drift, then these.
pub const EULER: usize = 9;
/// Horizontal distance from the truth, m.
pub const HORIZONTAL: usize = 12;
/// The same over the time flown, nmi/h.
pub const RATE: usize = 13;
/// True height, m.
pub const HEIGHT: usize = 14;
/// True roll, pitch, yaw, degrees, without the jumps of a full turn.
pub const ATTITUDE: usize = 15;
const SERIES: usize = 18;

/// Metres of a nautical mile.
pub const NAUTICAL_MILE: f64 = 1852.0;
/// Before this, a rate of drift means nothing, s.
pub const FLOWN_S: f64 = 60.0;

/// Series over time, s.
#[derive(Clone, Debug, Default)]
pub struct Traces {
    /// All of them.
    pub all: Envelope<SERIES>,
    /// The start, s.
    start_s: Option<f64>,
    before_deg: Option<[f64; 3]>,
    turns: [f64; 3],
}

impl Traces {
    /// Of rows in memory.
    pub fn of(instants: &[Instant]) -> Self {
        let mut traces = Self::default();
        instants.iter().for_each(|instant| traces.row(instant));
        traces
    }

    /// Takes the next row.
    pub fn row(&mut self, instant: &Instant) {
        let mut values = [f64::NAN; SERIES];
        let (nine, rest) = values.split_at_mut(EULER);
        nine.copy_from_slice(&instant.drift.numbers());
        let [north, east, _] = instant.drift.position_m;
        let start_s = *self.start_s.get_or_insert(instant.time_s);
        let flown_s = instant.time_s - start_s;
        let horizontal_m = north.hypot(east);
        let rate = horizontal_m / NAUTICAL_MILE / (flown_s / 3600.0);
        let rate = if flown_s >= FLOWN_S { rate } else { f64::NAN };
        let [e0, e1, e2] = euler_arcsec(instant);
        let [roll, pitch, yaw] = self.unwrapped(instant.attitude_deg);
        rest.copy_from_slice(&[
            e0,
            e1,
            e2,
            horizontal_m,
            rate,
            instant.position[2],
            roll,
            pitch,
            yaw,
        ]);
        self.all.push(instant.time_s, values);
    }

    fn unwrapped(&mut self, angles_deg: [f64; 3]) -> [f64; 3] {
        let before = self.before_deg.replace(angles_deg).unwrap_or(angles_deg);
        std::array::from_fn(|axis| {
            let step = ((angles_deg[axis] - before[axis]) / 360.0).round();
            self.turns[axis] -= if step.is_finite() { step } else { 0.0 };
            angles_deg[axis] + 360.0 * self.turns[axis]
        })
    }
}

/// A rotation below this changes the angles in proportion to twelve digits, rad.
const SMALL: f64 = 1e-6;

/// Errors of roll, pitch and yaw, arcsec; not numbers where the attitude is not known.
fn euler_arcsec(instant: &Instant) -> [f64; 3] {
    let turned = instant.drift.attitude_arcsec.map(|angle| angle * ARCSECOND);
    let truth = instant.truth.euler();
    let [north, east, down] = turned;
    let errors = if norm(turned) < SMALL {
        // δθ = ψ_E cosψ − ψ_N sinψ, δφ = (ψ_N cosψ + ψ_E sinψ)/cosθ, δψ = ψ_D + δφ sinθ
        let (sin, cos) = truth.yaw.sin_cos();
        let roll = (north * cos + east * sin) / truth.pitch.cos();
        [roll, east * cos - north * sin, down + roll * truth.pitch.sin()]
    } else {
        let computed = instant.computed.euler();
        let angles =
            [computed.roll - truth.roll, computed.pitch - truth.pitch, computed.yaw - truth.yaw];
        angles.map(|angle| (angle + PI).rem_euclid(TAU) - PI)
    };
    let is_known = instant.attitude_deg[0].is_finite();
    errors.map(|angle| if is_known { angle / ARCSECOND } else { f64::NAN })
}

#[cfg(test)]
mod tests {
    use super::*;
    use schuler::earth::Geodetic;
    use schuler::math::{compensated::Pair, quaternion::Quaternion, vector::Vector};
    use schuler::solution::{Euler, Solution};

    #[test]
    fn angles_run_through_full_turns() {
        let instants: Vec<Instant> = (0..100)
            .map(|k| {
                let wrapped = (f64::from(k) * 10.0 + 180.0).rem_euclid(360.0) - 180.0;
                let attitude_deg = [wrapped, 0.0, 0.0];
                Instant { time_s: f64::from(k), attitude_deg, ..Default::default() }
            })
            .collect();
        let traces = Traces::of(&instants);
        let edges: Vec<_> = traces.all.edges(ATTITUDE).collect();
        assert!(edges.iter().enumerate().all(|(k, e)| (e[1] - k as f64 * 10.0).abs() < 1e-9));
    }

    #[test]
    fn small_rotations_turn_the_angles_as_exact_ones_do() {
        let at = Geodetic { latitude: 0.8, longitude: 0.1, altitude: 100.0 };
        let angles = Euler { roll: 0.3, pitch: -0.7, yaw: 2.1 };
        let mut instant = Instant {
            truth: Solution::new(at, Vector::ZERO, angles),
            computed: Solution::new(at, Vector::ZERO, angles),
            ..Default::default()
        };
        for size in [3e-7, 3e-6] {
            let rotation = Vector::new(size, -0.5 * size, 0.8 * size);
            let attitude = instant.truth.attitude.map(|c| c.hi);
            let turned = Quaternion::new(1.0, rotation * 0.5).normalised() * attitude;
            let exact = Euler::from_quaternion(turned);
            let exact = [exact.roll - 0.3, exact.pitch + 0.7, exact.yaw - 2.1];
            instant.computed.attitude = turned.map(Pair::new);
            instant.drift.attitude_arcsec = rotation.into_array().map(|angle| angle / ARCSECOND);
            for (told, exact) in euler_arcsec(&instant).iter().zip(exact) {
                assert!((told * ARCSECOND - exact).abs() < 20.0 * size * size + 1e-15);
            }
        }
    }

    #[test]
    fn a_mile_in_an_hour_is_one() {
        let at = |time_s: f64| {
            let mut instant = Instant { time_s, ..Default::default() };
            instant.drift.position_m = [0.6 * time_s, 0.8 * time_s, 7.0];
            instant
        };
        let traces = Traces::of(&[at(0.0), at(59.0), at(1852.0)]);
        let [_, early, last] = [0, 1, 2].map(|k| traces.all.edges(RATE).nth(k).unwrap()[1]);
        assert!(early.is_nan() && (last - 3600.0 / 1852.0).abs() < 1e-12, "{last}");
        let [least, most] = traces.all.extremes(HORIZONTAL);
        assert!(least == 0.0 && (most - 1852.0).abs() < 1e-9, "{most}");
    }
}
