//! Samples late in a run: the motion a day on is that of another trajectory now, its phases and offsets
//! moved there by high precision.

use super::big::{Big, big};
use schuler::imu::{Quadrature, instant};
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::trajectory::harmonic::{Channel, Channels, Harmonic, HarmonicTrajectory};
use schuler::trajectory::{Motion, Trajectory};
use std::f64::consts::TAU;

type Course = HarmonicTrajectory<f64, 16>;

/// Offset, rate per second, and harmonics as amplitude, frequency in Hz, phase in rad.
type Described<'a> = (f64, f64, &'a [(f64, f64, f64)]);

/// Whole turns taken out.
fn reduced(angle: Big) -> f64 {
    let turn = big(2.0) * Big::pi();
    let turns = (angle / turn).rough().round();
    (angle - big(turns) * turn).rough()
}

/// A course as it is so much later: x(t₀ + t) as a function of t.
fn course(described: &[Described; 6], later: Big) -> Course {
    let harmonics: Vec<Vec<Harmonic<f64>>> = described
        .iter()
        .map(|(_, _, harmonics)| {
            let shifted = |&(amplitude, hz, phase): &(f64, f64, f64)| {
                let angular_rate = TAU * hz;
                let phase = reduced(big(phase) + big(angular_rate) * later);
                Harmonic { amplitude, angular_rate, phase }
            };
            harmonics.iter().map(shifted).collect()
        })
        .collect();
    let channel = |i: usize| {
        let (offset, rate, _) = described[i];
        let moved = big(offset) + big(rate) * later;
        let offset = if i < 5 { reduced(moved) } else { moved.rough() };
        Channel { offset, rate, harmonics: &harmonics[i] }
    };
    let [roll, pitch, yaw] = [0, 1, 2].map(channel);
    let [latitude, longitude, altitude] = [3, 4, 5].map(channel);
    Course::new(Channels { roll, pitch, yaw, latitude, longitude, altitude }).unwrap()
}

/// Vibration on a spin, waves, and a cruise round the Earth over both poles.
const FLIGHTS: [[Described; 6]; 3] = [
    [
        (0.3, 6.0, &[(0.01, 12.0, 0.4)]),
        (0.1, 0.0, &[(0.5, 1.3 / TAU, 1.0), (0.01, 12.0, 2.0)]),
        (1.0, -3.0, &[(0.8, 0.9 / TAU, 0.0)]),
        (0.7, 3e-5, &[(1.5e-7, 1.2 / TAU, 0.2)]),
        (1.7, 6e-5, &[(1e-10, 10.0, 0.3)]),
        (3000.0, 0.01, &[(50.0, 0.9 / TAU, 1.2)]),
    ],
    [
        (0.0, 0.0, &[(0.2, 1.0 / 7.3, 0.0)]),
        (0.0, 0.0, &[(0.07, 1.0 / 5.1, 0.0)]),
        (0.5, 0.0, &[]),
        (0.8, 0.0, &[]),
        (0.1, 0.0, &[]),
        (0.0, 0.0, &[(1.5, 1.0 / 6.1, 0.0)]),
    ],
    [
        (0.05, 0.0, &[]),
        (0.02, 0.0, &[]),
        (2.0, 1e-3, &[]),
        (0.5, 4e-5, &[]),
        (3.0, 1e-5, &[(1e-6, 1.0 / 40.0, 0.7)]),
        (9000.0, 0.0, &[]),
    ],
];

const RATES: [f64; 7] = [20.0, 50.0, 60.0, 100.0, 128.0, 299.7, 1000.0];

#[test]
fn a_day_on_the_increments_are_what_they_should_be() {
    for described in &FLIGHTS {
        let now = course(described, big(0.0));
        for rate_hz in RATES {
            let quadrature = Quadrature::plan(now.bound().bandwidth, 1.0 / rate_hz);
            for number in [1, 1000, 1_440_000, (86_400.0 * rate_hz) as u64, 864_123_457] {
                let centre = big(number as f64 - 0.5) / big(rate_hz);
                let interval = Pair::new(rate_hz).reciprocal();
                let there = course(described, centre);
                let expected = quadrature.increment_about(&there, Pair::default(), interval);
                let sample = quadrature.sample(&now, number, rate_hz);
                let off = |a: Vector<f64>, b: Vector<f64>| (a - b).norm() / b.norm();
                let angle = off(sample.angle_b, expected.angle_b);
                let velocity = off(sample.velocity_b, expected.velocity_b);
                assert!(
                    angle <= 1e-13 && velocity <= 1e-13,
                    "{rate_hz} {number} {angle:e} {velocity:e}"
                );
                // The truth at the sample's end belongs to the same time.
                let end = big(number as f64) / big(rate_hz);
                let truth = now.at_instant(instant(number as f64, rate_hz));
                let there = course(described, end).at(0.0);
                let angles = |m: &Motion<f64>| [m.roll, m.pitch, m.yaw, m.latitude, m.longitude];
                for (a, b) in angles(&truth).into_iter().zip(angles(&there)) {
                    let turn = (a.value - b.value) / TAU;
                    assert!((turn - turn.round()).abs() <= 2e-15, "{rate_hz} {number} {a:?} {b:?}");
                }
            }
        }
    }
}

/// Samples one after another make up the whole: nothing is lost between their ends.
#[test]
fn an_instant_has_twice_the_digits() {
    for rate_hz in RATES {
        for number in [0.0, 1.0, 86_399.0 * rate_hz, 123_456_789.5] {
            let Pair { hi, lo } = instant(number, rate_hz);
            let rest = (big(hi) + big(lo)) * big(rate_hz) - big(number);
            assert!(rest.rough().abs() <= 1e-30 * number, "{rate_hz} {number}");
            assert_eq!(hi, number / rate_hz);
        }
    }
}
