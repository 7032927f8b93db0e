//! `core::allan` against a batch in the test, and its degrees of freedom against the scatter of many runs.

use schuler::allan::octaves::{Octaves, RINGS, Refused};
use schuler::allan::term::Term;
use schuler::noise::Streams;

const INTERVAL_S: f64 = 0.01;

/// Overlapped Allan variance at clusters of m samples: from the sums, a difference for each sample.
fn batch(increments: &[f64], m: usize) -> f64 {
    let mean = increments.iter().sum::<f64>() / increments.len() as f64;
    let mut sum = 0.0;
    let mut curve = vec![0.0];
    curve.extend(increments.iter().map(|x| {
        sum += x - mean;
        sum
    }));
    let tau_s = m as f64 * INTERVAL_S;
    let differences = curve.iter().zip(&curve[m..]).zip(&curve[2 * m..]);
    let squares: f64 = differences.map(|((a, b), c)| (c - 2.0 * b + a).powi(2)).sum();
    squares / (2.0 * tau_s * tau_s * (increments.len() + 1 - 2 * m) as f64)
}

/// White noise, a random walk of the rate, and a mean as of gravity.
fn noise(samples: usize, run: u64) -> Vec<f64> {
    let mut stream = Streams::new(15, run).open();
    let mut walk = 0.0;
    let mut next = || {
        walk += 1e-3 * stream.normal::<f64>();
        0.0980665 + 1e-4 * (stream.normal::<f64>() + walk)
    };
    (0..samples).map(|_| next()).collect()
}

#[test]
fn short_clusters_are_those_of_a_batch_and_long_ones_within_their_scatter() {
    let increments = noise(100_003, 0);
    let mut axis: Octaves<f64> = Octaves::new(INTERVAL_S).unwrap();
    increments.iter().for_each(|x| axis.add(*x).unwrap());
    let points: Vec<_> = axis.points().collect();
    assert_eq!(points.len(), 16);
    for (octave, point) in points.iter().enumerate() {
        let m = 1 << octave;
        assert_eq!(point.samples, m as u64);
        let ratio = point.variance / batch(&increments, m) - 1.0;
        // Both have the same samples. A stride of a quarter keeps 92 % of the degrees of freedom or more, so
        // the two differ by no more than √(1/0.92 − 1) = 0.29 of a standard deviation, √(2/edf); six of that.
        let edf = point.freedom(Term::White(1.0));
        let within = if m <= 4 { 1e-12 } else { 6.0 * 0.29 * (2.0 / edf).sqrt() };
        assert!(ratio.abs() < within, "{m}: {ratio:e} of {within:e}");
    }
}

#[test]
fn single_precision_keeps_the_digits_beside_a_large_mean() {
    let increments: Vec<f32> = noise(65_536, 1).iter().map(|x| *x as f32).collect();
    let mut single: Octaves<f32> = Octaves::new(INTERVAL_S as f32).unwrap();
    let mut double: Octaves<f64> = Octaves::new(f64::from(INTERVAL_S as f32)).unwrap();
    for &x in &increments {
        single.add(x).unwrap();
        double.add(f64::from(x)).unwrap();
    }
    for (a, b) in single.points().zip(double.points()) {
        let ratio = f64::from(a.variance) / b.variance - 1.0;
        assert!(ratio.abs() < 1e-6, "{}: {ratio:e}", a.samples);
    }
    assert_eq!(single.points().count(), double.points().count());
}

#[test]
fn it_is_small_and_refuses_what_is_no_number() {
    assert!(size_of::<Octaves<f64>>() <= 3000 && size_of::<Octaves<f32>>() <= 3000);
    assert_eq!(RINGS, 28);
    for interval_s in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(Octaves::<f64>::new(interval_s).unwrap_err(), Refused::Interval);
    }
    let mut axis: Octaves<f64, 2> = Octaves::new(1.0).unwrap();
    assert_eq!(axis.points().count(), 0);
    for x in [1.0, -1.0, 1.0] {
        axis.add(x).unwrap();
    }
    let before = axis;
    for x in [f64::NAN, f64::INFINITY, -1e16] {
        assert_eq!(axis.add(x), Err(Refused::Increment));
    }
    assert_eq!(axis, before);
    // No more octaves than it has room for.
    (0..1000).for_each(|_| axis.add(0.5).unwrap());
    assert_eq!(axis.points().map(|point| point.samples).collect::<Vec<_>>(), [1, 2, 4, 8]);
}

#[test]
fn a_ramp_is_its_closed_form() {
    // Rate R·t: every difference of clusters is Rτ², so nothing scatters.
    let ramp = 3e-4;
    let mut axis: Octaves<f64> = Octaves::new(INTERVAL_S).unwrap();
    for i in 0..5000 {
        axis.add(ramp * (f64::from(i) + 0.5) * INTERVAL_S * INTERVAL_S).unwrap();
    }
    for point in axis.points() {
        let ratio = point.variance / Term::Ramp(ramp).variance(point.tau_s);
        assert!((ratio - 1.0).abs() < 1e-9, "{}: {ratio}", point.samples);
    }
}

#[test]
fn gauss_markov_forms_meet_where_the_series_ends() {
    let term = |t: f64| Term::GaussMarkov { rms: 1.0, correlation_s: t };
    for at in [0.5, 1.0, 2.0_f64] {
        let [below, above] = [0.5 * (1.0 - 1e-9), 0.5 * (1.0 + 1e-9)].map(|x| at / x);
        let [a, b] = [term(below).variance(at), term(above).variance(at)];
        assert!((a / b - 1.0).abs() < 1e-8, "{a} {b}");
        let [a, b] = [term(below), term(above)].map(|term| term.covariance(at));
        assert!((a / b - 1.0).abs() < 1e-8, "{a} {b}");
    }
    // Allan variance is E[d²]/(2τ²), and E[d²] = 6s(0) − 8s(τ) + 2s(2τ).
    for term in [
        Term::White(0.7),
        Term::Flicker(0.7),
        Term::RandomWalk(0.7),
        Term::Quantization(0.7),
        term(3.0),
    ] {
        for tau_s in [0.01, 1.0, 30.0] {
            let s = |t: f64| term.covariance(t);
            let square = 6.0 * s(0.0) - 8.0 * s(tau_s) + 2.0 * s(2.0 * tau_s);
            let ratio = square / (2.0 * tau_s * tau_s) / term.variance(tau_s);
            assert!((ratio - 1.0).abs() < 1e-9, "{term:?} {tau_s}: {ratio}");
        }
    }
}

#[test]
fn degrees_of_freedom_are_those_of_the_scatter() {
    // The variance of σ² over runs is 2σ⁴/edf. From 400 runs of normal variates it is known to
    // √(2/400) = 7 % (somewhat more: χ² is no normal variate); four of these.
    let runs = 400;
    let mut sums = [[0.0; 2]; 4];
    let mut freedoms = [0.0; 4];
    let octaves = [0, 2, 4, 6];
    for run in 0..runs {
        let mut stream = Streams::new(3, run).open();
        let mut axis: Octaves<f64> = Octaves::new(1.0).unwrap();
        (0..2048).for_each(|_| axis.add(stream.normal()).unwrap());
        let points: Vec<_> = axis.points().collect();
        for ((sum, freedom), octave) in sums.iter_mut().zip(&mut freedoms).zip(octaves) {
            let point = points[octave];
            let ratio = point.variance * point.tau_s;
            *sum = [sum[0] + ratio, sum[1] + ratio * ratio];
            *freedom = point.freedom(Term::White(1.0));
        }
    }
    for (([sum, squares], edf), octave) in sums.into_iter().zip(freedoms).zip(octaves) {
        let mean = sum / runs as f64;
        let scatter = squares / runs as f64 - mean * mean;
        assert!((scatter * edf / 2.0 - 1.0).abs() < 0.3, "{octave}: {}", scatter * edf / 2.0);
    }
    // By Monte Carlo of the design: 178.
    let edf: f64 = schuler::allan::freedom::of(Term::White(1.0), 64.0, 8192 / 16 - 7, 4);
    assert!((edf - 175.0).abs() < 1.5, "{edf}");
}
