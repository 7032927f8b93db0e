//! The Gauss-Markov bias against the closed forms of its process, and the paper's erratum in (7).

use schuler::math::vector::Vector;
use schuler::noise::{Deviate, Streams};
use schuler::sensor::gauss_markov::{GaussMarkov, Process};
use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing};

/// φ, ∂∫b/∂b₀, ∂b₁/∂z₁, ∂∫b/∂z₁, ∂∫b/∂z₂, found from what the process does with known deviates.
fn coefficients<R: Deviate>(rms: R, correlation_s: R, interval_s: R) -> [f64; 5] {
    let process = Process::new(rms, correlation_s, interval_s);
    let mut stream = Streams::new(3, 0).open();
    let mut sample = |start: R| {
        let mut peek = stream.clone();
        let deviates: [f64; 2] = [peek.normal::<R>().widen(), peek.normal::<R>().widen()];
        let mut value = start;
        let integral = process.advance(&mut value, &mut stream);
        assert_eq!(stream, peek, "two deviates per sample");
        (value.widen(), integral.widen(), deviates)
    };
    let (value, first, [a, b]) = sample(R::ZERO);
    let drive = value / a;
    let (_, second, [c, d]) = sample(R::ZERO);
    // first = a·coupled + b·independent, second = c·coupled + d·independent
    let determinant = a * d - b * c;
    let coupled = (first * d - second * b) / determinant;
    let independent = (second * a - first * c) / determinant;

    let silent = Process::new(R::ZERO, correlation_s, interval_s);
    let mut value = R::ONE;
    let integral = silent.advance(&mut value, &mut stream);
    [value.widen(), integral.widen(), drive, coupled, independent]
}

/// Σ c(k)(−x)ᵏ/k! from the k-th term on, until it no longer changes.
fn series(x: f64, from: i32, coefficient: impl Fn(i32) -> f64) -> f64 {
    let mut power = 1.0;
    let mut sum = 0.0;
    for k in 1..200 {
        power *= -x / f64::from(k);
        if k >= from {
            sum += coefficient(k) * power;
        }
    }
    sum
}

/// Compares the joint distribution of value and integral with the process' own integrals.
fn check_moments<R: Deviate>(x: f64, tolerance: f64) {
    let (rms, correlation_s) = (R::of(3.0), R::of(8.0));
    let interval_s = R::narrow(8.0 * x);
    let [decay, integral, drive, coupled, independent] =
        coefficients(rms, correlation_s, interval_s);
    let (s, t) = (3.0f64, 8.0f64);
    // As closed forms where x is large, as series where they cancel.
    let small = x < 1.0;
    let exp = f64::exp;
    // Var b₁ = σ²(1 − e⁻²ˣ),  Cov(b₁, ∫b) = σ²T(1 − e⁻ˣ)²,  Var ∫b = σ²T²(2x − 3 + 4e⁻ˣ − e⁻²ˣ)
    let decrement = if small { -series(x, 1, |_| 1.0) } else { 1.0 - exp(-x) };
    let double = if small { -series(2.0 * x, 1, |_| 1.0) } else { 1.0 - exp(-2.0 * x) };
    let variance = if small {
        series(x, 3, |k| 4.0 - 2f64.powi(k))
    } else {
        2.0 * x - 3.0 + 4.0 * exp(-x) - exp(-2.0 * x)
    };
    let near = |what: &str, found: f64, expected: f64, tolerance: f64| {
        let error = (found / expected - 1.0).abs();
        assert!(error < tolerance, "{what} at x = {x}: {found:e} for {expected:e}");
    };
    near("decay", 1.0 + decay, 1.0 + exp(-x), tolerance);
    near("integral", integral, t * decrement, tolerance);
    near("variance", drive * drive, s * s * double, tolerance);
    near("covariance", drive * coupled, s * s * t * decrement * decrement, tolerance * 10.0);
    let total = coupled * coupled + independent * independent;
    near("integral's variance", total, s * s * t * t * variance, tolerance * 10.0);
    let rest = variance - decrement.powi(4) / double;
    near("rest", independent * independent, s * s * t * t * rest, tolerance * 100.0);
}

#[test]
fn value_and_integral_have_their_joint_distribution_at_any_interval() {
    for x in [1e-6, 0.05 / 720.0, 1e-3, 0.0299, 0.0301, 0.1, 0.29, 0.31, 0.9, 1.0, 3.0, 20.0] {
        check_moments::<f64>(x, 1e-12);
        check_moments::<f32>(x, 3e-6);
    }
}

/// The bias of a term after each of some samples, and the integral over it.
fn history(term: &GaussMarkov<f64>, seed: u64, samples: usize) -> Vec<(Vector<f64>, Vector<f64>)> {
    let mut state = term.start(Streams::new(seed, 0));
    let stimulus = Stimulus { sensed: Vector::ZERO, velocity_b: Vector::ZERO };
    (0..samples)
        .map(|_| {
            let mut reading = Reading::new(Vector::ZERO);
            term.apply(&mut state, &stimulus, &mut reading);
            (state.bias, reading.increment)
        })
        .collect()
}

fn timing(interval_s: f64) -> Timing<f64> {
    Timing::new(interval_s, 1).unwrap()
}

#[test]
fn the_bias_is_stationary_and_its_correlation_decays_exponentially() {
    let rms = Vector::new(1.0, 2.0, 1e-6);
    let correlation_s = Vector::new(2.0, 10.0, 0.2);
    let interval_s = 0.5;
    let term = GaussMarkov::new(rms, correlation_s, timing(interval_s)).unwrap();
    let n = 1_000_000;
    let history = history(&term, 11, n);
    for axis in 0..3 {
        let b: Vec<f64> = history.iter().map(|(b, _)| b.into_array()[axis]).collect();
        let (s, t) = (rms.into_array()[axis], correlation_s.into_array()[axis]);
        let phi = (-interval_s / t).exp();
        for lag in [0, 1, 3, 10] {
            let pairs = b.iter().zip(&b[lag..]);
            let found = pairs.map(|(x, y)| x * y).sum::<f64>() / (n - lag) as f64;
            let expected = s * s * phi.powi(lag as i32);
            // Var of a covariance estimate ≤ 2σ⁴/n · Σφ²ᵏ over all k (Bartlett)
            let sigma = s * s * (2.0 / n as f64 * (1.0 + phi * phi) / (1.0 - phi * phi)).sqrt();
            assert!((found - expected).abs() < 5.0 * sigma, "axis {axis}, lag {lag}: {found:e}");
        }
    }
}

#[test]
fn every_run_starts_from_the_stationary_distribution() {
    let one = Vector::new(1.0, 1.0, 1.0);
    let term = GaussMarkov::new(one, one * 720.0, timing(0.05)).unwrap();
    let runs = 100_000;
    let mut sum = 0.0;
    for run in 0..runs {
        let bias = term.start(Streams::new(1, run)).bias;
        sum += bias.dot(bias) / 3.0;
    }
    let (mean, sigma) = (sum / runs as f64, (2.0 / (3.0 * runs as f64)).sqrt());
    assert!((mean - 1.0).abs() < 5.0 * sigma, "{mean}");
}

#[test]
fn the_integral_over_many_samples_has_the_variance_of_the_process() {
    // Var ∫b over τ = 2σ²T²(τ/T − 1 + e^{−τ/T}), whatever the sample interval
    let one = Vector::new(1.0, 1.0, 1.0);
    for (interval_s, samples) in [(0.02, 50), (0.25, 4), (1.0, 1), (4.0, 12)] {
        let term = GaussMarkov::new(one, one, timing(interval_s)).unwrap();
        let span = interval_s * samples as f64;
        let expected = 2.0 * (span - 1.0 + (-span).exp());
        let runs = 20_000;
        let mut sum = 0.0;
        for run in 0..runs {
            let total = history(&term, run, samples).iter().fold(Vector::ZERO, |t, s| t + s.1);
            sum += total.dot(total) / 3.0;
        }
        let ratio = sum / runs as f64 / expected;
        let sigma = (2.0 / (3.0 * runs as f64)).sqrt();
        assert!((ratio - 1.0).abs() < 5.0 * sigma, "{samples} samples of {interval_s} s: {ratio}");
    }
}

#[test]
fn the_bias_decays_where_the_printed_sign_of_equation_7_lets_it_explode() {
    // ∇̇ = +∇/T + ω would grow by e²⁰⁰ here; −∇/T + ω stays within six of its rms.
    let rms = Vector::new(1.0, 1.0, 1.0);
    let term = GaussMarkov::new(rms, rms * 720.0, timing(72.0)).unwrap();
    let history = history(&term, 7, 2000);
    assert!(history.iter().all(|(bias, _)| bias.is_within(6.0)));

    // Undriven, the bias falls to 1/e in a correlation time, in small steps, too.
    assert!((undriven::<f64>() / (-1.0f64).exp() - 1.0).abs() < 1e-10);
    assert!((undriven::<f32>() / (-1.0f64).exp() - 1.0).abs() < 5e-5);
}

/// What is left of a bias of 1 after a correlation time.
fn undriven<R: Deviate>() -> f64 {
    let silent = Process::new(R::ZERO, R::of(720.0), R::of(0.05));
    let mut stream = Streams::new(1, 0).open();
    let mut value = R::ONE;
    for _ in 0..14_400 {
        silent.advance(&mut value, &mut stream);
    }
    value.widen()
}
