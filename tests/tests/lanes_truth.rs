//! Perfect increments of samples side by side, and the sines and cosines in them: the bits of each alone.

use schuler::math::real::Real;
use schuler::math::vector::Vector;
use schuler::noise::Stream;
use schuler::sample::Increment;
use schuler_simulator::course::{Course, Reference};
use schuler_simulator::lanes::pack::Lanes;
use schuler_simulator::lanes::truth::Truth;
use schuler_simulator::lanes::{InLanes, Registers, in_registers};
use schuler_simulator::scene::builtin;
use schuler_simulator::source::Source;
use std::array;
use std::f64::consts::FRAC_PI_4;

/// Harmonics alone, turns without end, a pole; pieces and a mount, which fly one by one.
const SCENES: [&str; 9] = [
    "paper",
    "hard",
    "manoeuvre",
    "vibration",
    "sea-state",
    "polar",
    "cruise-180",
    "circuit",
    "drive",
];

/// Neither a multiple of what a register holds nor of what a run asks for at once.
const SAMPLES: u64 = 1003;

fn bits(increment: &Increment<f64>) -> [[u64; 3]; 2] {
    [increment.angle_b, increment.velocity_b].map(|v| v.map(f64::to_bits).into_array())
}

#[test]
fn samples_at_once_have_the_bits_of_each_alone() {
    for name in SCENES {
        let source = Source::new(&builtin::scene(name).unwrap(), false).unwrap();
        let first = 700;
        let at_once = source.perfect_samples(first..first + SAMPLES);
        assert_eq!(at_once.len() as u64, SAMPLES);
        for (n, increment) in (first..).zip(&at_once) {
            assert_eq!(bits(increment), bits(&source.perfect_sample(n)), "{name} at {n}");
        }
        for registers in [Registers::Avx512, Registers::Avx2] {
            let Course::Plain(Reference::Harmonic(course)) = &source.course else { continue };
            let still = Increment { angle_b: Vector::ZERO, velocity_b: Vector::ZERO };
            let mut increments = vec![still; SAMPLES as usize];
            let (quadrature, rate_hz) = (source.quadrature, source.rate_hz());
            let increments = &mut increments[..];
            let truth = Truth { course, quadrature, rate_hz, first, increments: &mut *increments };
            if in_registers(registers, truth).is_some() {
                assert!(at_once.iter().map(bits).eq(increments.iter().map(bits)), "{name}");
            }
        }
    }
}

#[test]
fn a_run_meets_the_samples_in_order() {
    for name in ["paper", "circuit"] {
        let source = Source::new(&builtin::scene(name).unwrap(), false).unwrap();
        let mut run = source.start(0);
        for n in 1..=300 {
            let (perfect, _) = run.advance_seen();
            assert_eq!(bits(&perfect), bits(&source.perfect_sample(n)), "{name} at {n}");
        }
    }
}

/// An angle of some kind, from random bits.
fn angle(kind: usize, word: u64) -> f64 {
    let share = (word >> 11) as f64 / (1u64 << 52) as f64 - 1.0;
    let eighths = (word & 31) as f64;
    match kind % 8 {
        0 => 0.8 * share,
        1 => 8.0 * share,
        2 => 1e3 * share,
        3 => 2e6 * share,
        // Any number, even none.
        4 => f64::from_bits(word),
        // About the borders of the quadrants and their middles.
        5 => (eighths - 16.0) * FRAC_PI_4 + 1e-5 * share,
        6 => {
            let near = (eighths * FRAC_PI_4).to_bits().wrapping_add(word >> 40 & 0xff);
            f64::from_bits(near.wrapping_sub(128))
        }
        // Zeros of both signs, and next to nothing.
        _ => 1e-7 * share * (word & 1) as f64,
    }
}

struct Circle;

impl InLanes for Circle {
    type Output = ();
    fn run<P: Lanes<N>, const N: usize>(self) {
        let mut stream = Stream::new(1, 2, 3);
        for n in 0..200_000 {
            // One kind at a time: where one lane needs more work, all take it.
            let angles: [f64; N] = array::from_fn(|_| angle(n, stream.next_u64()));
            let (sines, cosines) = P::from_lanes(angles).sin_cos();
            let results = sines.lanes().into_iter().zip(cosines.lanes());
            for (angle, (sine, cosine)) in angles.into_iter().zip(results) {
                let expected = Real::sin_cos(angle);
                let same = |a: f64, b: f64| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
                assert!(same(sine, expected.0) && same(cosine, expected.1), "{angle:e}");
            }
        }
    }
}

#[test]
fn sines_and_cosines_have_the_bits_of_single_ones() {
    for registers in [Registers::Avx512, Registers::Avx2] {
        in_registers(registers, Circle);
    }
}
