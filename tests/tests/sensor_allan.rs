//! Allan variance of every random term against its closed form.
//!
//! The overlapping estimate from N samples at a cluster of m has at least N/m − 2 degrees of freedom
//! for each of these noises (random walk has the fewest; Riley, NIST SP 1065, section 5.4), so its
//! relative standard deviation is at most √(2/(N/m − 2)). The tolerance is five of these.

use schuler::math::vector::Vector;
use schuler::noise::Streams;
use schuler::sensor::flicker::{self, Flicker};
use schuler::sensor::gauss_markov::GaussMarkov;
use schuler::sensor::quantization::Quantization;
use schuler::sensor::random_walk::RandomWalk;
use schuler::sensor::turn_on::TurnOn;
use schuler::sensor::white::White;
use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing};

const INTERVAL_S: f64 = 0.05;
const SAMPLES: usize = 1_000_000;

fn timing() -> Timing<f64> {
    Timing::new(INTERVAL_S, SAMPLES as u64).unwrap()
}

/// What a term makes of constant rates: the cumulative output of each axis, from 0 on.
fn output(term: &impl ErrorTerm<f64>, truth: Vector<f64>) -> [Vec<f64>; 3] {
    let mut state = term.start(Streams::new(20, 12));
    let stimulus = Stimulus { sensed: truth, velocity_b: Vector::ZERO };
    let mut sums = [0.0; 3];
    let mut curves = [vec![0.0], vec![0.0], vec![0.0]];
    for _ in 0..SAMPLES {
        let mut reading = Reading::new(truth);
        term.apply(&mut state, &stimulus, &mut reading);
        for ((curve, sum), x) in
            curves.iter_mut().zip(&mut sums).zip(reading.increment.into_array())
        {
            *sum += x;
            curve.push(*sum);
        }
    }
    curves
}

/// Overlapping Allan variance of a cumulative sum at clusters of m samples.
fn allan_variance(curve: &[f64], m: usize) -> f64 {
    let tau = m as f64 * INTERVAL_S;
    let differences = curve.iter().zip(&curve[m..]).zip(&curve[2 * m..]);
    let sum: f64 = differences.map(|((a, b), c)| (c - 2.0 * b + a).powi(2)).sum();
    sum / (2.0 * tau * tau * (curve.len() - 2 * m) as f64)
}

/// Compares the three axes with closed forms of the averaging time.
fn check(term: &impl ErrorTerm<f64>, truth: Vector<f64>, expected: impl Fn(usize, f64) -> f64) {
    let curves = output(term, truth);
    for (axis, curve) in curves.iter().enumerate() {
        for m in [1, 2, 5, 20, 100, 500, 2000, 10_000] {
            let ratio = allan_variance(curve, m) / expected(axis, m as f64 * INTERVAL_S);
            let tolerance = 5.0 * (2.0 / ((SAMPLES / m) as f64 - 2.0)).sqrt();
            assert!((ratio - 1.0).abs() < tolerance, "axis {axis}, {m} samples: {ratio}");
        }
    }
}

const SCALE: [f64; 3] = [1.0, 2e-6, 30.0];

fn scaled(unit: f64) -> Vector<f64> {
    Vector::from(SCALE) * unit
}

#[test]
fn white_noise() {
    // N²/τ
    let n = 0.3;
    let term = White::new(scaled(n), timing()).unwrap();
    check(&term, Vector::ZERO, |axis, tau| (SCALE[axis] * n).powi(2) / tau);
}

#[test]
fn random_walk_of_the_bias() {
    // K²τ/3, from the first sample on: the bias moves within a sample, too.
    let k = 0.02;
    let term = RandomWalk::new(scaled(k), timing()).unwrap();
    check(&term, Vector::ZERO, |axis, tau| (SCALE[axis] * k).powi(2) * tau / 3.0);
}

/// (2σ²T/τ)[1 − (T/2τ)(3 − 4e^{−τ/T} + e^{−2τ/T})], by its series where that cancels.
fn gauss_markov(s: f64, t: f64, tau: f64) -> f64 {
    let x = tau / t;
    if x < 1e-2 {
        // 1 − (3 − 4e⁻ˣ + e⁻²ˣ)/2x = x²/3 − x³/4 + 7x⁴/60 − …
        return 2.0 * s * s / x * x * x * (1.0 / 3.0 - x / 4.0 + 7.0 * x * x / 60.0);
    }
    2.0 * s * s / x * (1.0 - (3.0 - 4.0 * (-x).exp() + (-2.0 * x).exp()) / (2.0 * x))
}

#[test]
fn gauss_markov_bias() {
    let correlation_s = [0.02, 5.0, 720.0];
    let term = GaussMarkov::new(scaled(0.1), correlation_s.into(), timing()).unwrap();
    check(&term, Vector::ZERO, |axis, tau| {
        gauss_markov(0.1 * SCALE[axis], correlation_s[axis], tau)
    });
}

#[test]
fn flicker() {
    // T_i = 10ⁱΔt up to the run's length, σ_i² = B² ln(10)/π
    let b = 0.5;
    let times = [0.05, 0.5, 5.0, 50.0, 500.0, 5000.0, 50_000.0];
    let variance = std::f64::consts::LN_10 / std::f64::consts::PI;
    let sum = |tau: f64| times.map(|t| gauss_markov(variance.sqrt(), t, tau)).iter().sum::<f64>();
    let term = Flicker::new(scaled(b), timing()).unwrap();
    check(&term, Vector::ZERO, |axis, tau| (SCALE[axis] * b).powi(2) * sum(tau));

    let poles: Vec<_> = flicker::poles(timing()).collect();
    assert_eq!(poles.len(), times.len());
    for ((time, rms), expected) in poles.iter().zip(times) {
        assert!(
            (time / expected - 1.0).abs() < 1e-14 && (rms * rms / variance - 1.0).abs() < 1e-14
        );
    }
    // Which is (2 ln2/π)B² from ten samples to a twentieth of the run, but for its ripple.
    let plateau = 2.0 * std::f64::consts::LN_2 / std::f64::consts::PI;
    let span = SAMPLES as f64 / 20.0 / 10.0;
    for step in 0..=100 {
        let tau = 10.0 * INTERVAL_S * span.powf(f64::from(step) / 100.0);
        let ratio = (sum(tau) / plateau).sqrt();
        assert!((ratio - 1.0).abs() < 0.04, "Allan deviation at {tau} s: {ratio}");
    }
}

#[test]
fn quantization() {
    // 3Q²/τ², Q = step/√12, under a dither that spreads the sum over the steps.
    let (step, dither) = (0.2, 1.5);
    let term = (White::new(scaled(dither), timing()).unwrap(), steps(step));
    check(&term, scaled(0.013), |axis, tau| {
        let white = (SCALE[axis] * dither).powi(2) / tau;
        white + 3.0 * (SCALE[axis] * step).powi(2) / 12.0 / (tau * tau)
    });
    // Without dither a rate of an irrational part of a step does: no white noise remains.
    let part = std::f64::consts::SQRT_2 - 1.0;
    let curves = output(&steps(step), scaled(step * part));
    for (axis, curve) in curves.iter().enumerate() {
        for m in [1usize, 7, 50, 1000] {
            let tau = m as f64 * INTERVAL_S;
            // The second difference of the rounding error of a uniform phase, averaged over it.
            let beyond = |x: f64| x - x.round();
            let mean = (0..100_000)
                .map(|i| {
                    let phase = (f64::from(i) + 0.5) * 1e-5;
                    let at = |k: f64| beyond(phase + k * m as f64 * part);
                    (at(2.0) - 2.0 * at(1.0) + at(0.0)).powi(2)
                })
                .sum::<f64>()
                / 1e5;
            let expected = (SCALE[axis] * step).powi(2) * mean / (2.0 * tau * tau);
            let ratio = allan_variance(curve, m) / expected;
            assert!((ratio - 1.0).abs() < 2e-3, "axis {axis}, {m} samples: {ratio}");
        }
    }
}

fn steps(step: f64) -> Quantization<f64> {
    Quantization::new(scaled(step)).unwrap()
}

#[test]
fn a_turn_on_bias_is_constant_within_a_run_and_normal_over_runs() {
    let term = TurnOn::new(scaled(1.0), timing()).unwrap();
    let stimulus = Stimulus { sensed: Vector::ZERO, velocity_b: Vector::ZERO };
    let runs = 50_000;
    let mut squares = [0.0; 3];
    for run in 0..runs {
        let mut state = term.start(Streams::new(1, run));
        let mut next = || {
            let mut reading = Reading::new(Vector::ZERO);
            term.apply(&mut state, &stimulus, &mut reading);
            reading.increment
        };
        let first = next();
        assert_eq!(first, next());
        for ((square, x), scale) in squares.iter_mut().zip(first.into_array()).zip(SCALE) {
            *square += (x / (INTERVAL_S * scale)).powi(2);
        }
    }
    for square in squares {
        let variance = square / runs as f64;
        assert!((variance - 1.0).abs() < 5.0 * (2.0 / runs as f64).sqrt(), "{variance}");
    }
}
