//! Rates become increments: exactly for cubics, else with the stated error.

use super::{good, near};
use schuler_simulator::recording::csv::RATES;
use schuler_simulator::recording::samples::Sample;

/// A recording of rates: x of the gyro and z of the accelerometer are a function and its negative.
fn record(times: impl IntoIterator<Item = f64>, rate: impl Fn(f64) -> f64) -> Vec<Sample> {
    let rows = times.into_iter().map(|t| format!("{t},{},0,0,0,0,{}\n", rate(t), -rate(t)));
    good(&format!("{}\n{}", RATES.join(","), rows.collect::<String>()), None).1
}

/// Every sample's increment less the integral over its interval.
fn errors(samples: &[Sample], integral: impl Fn(f64) -> f64) -> Vec<f64> {
    let error = |s: &Sample| {
        assert_eq!(s.increment.angle_b.x, -s.increment.velocity_b.z);
        s.increment.angle_b.x - (integral(s.time_s) - integral(s.time_s - s.interval_s))
    };
    samples.iter().map(error).collect()
}

fn even(count: u32, step: f64) -> impl Iterator<Item = f64> {
    (1..=count).map(move |i| f64::from(i) * step)
}

#[test]
fn a_polynomial_through_all_the_points_is_exact() {
    // t^(n−1) through n rates, n up to 4, and a cubic through more.
    for (count, power) in [(2, 1), (3, 2), (4, 3), (5, 3), (30, 3)] {
        let recording = record(even(count, 0.125), |t| 2.0 + t.powi(power));
        let integral = |t: f64| 2.0 * t + t.powi(power + 1) / f64::from(power + 1);
        for error in errors(&recording, integral) {
            near(error, 0.0, 1e-13);
        }
    }
}

#[test]
fn the_error_of_a_fourth_power_is_the_stated_one() {
    let h = 0.125;
    let errors = errors(&record(even(12, h), |t| t.powi(4)), |t| t.powi(5) / 5.0);
    // f⁗ = 24; the interpolation error changes sign from the inner to the outer intervals.
    let unit = 24.0 * h.powi(5) / 720.0;
    let expect = |i: usize| match i {
        0 => -251.0,
        1 | 11 => 19.0,
        _ => -11.0,
    };
    for (i, error) in errors.into_iter().enumerate() {
        near(error, expect(i) * unit, 1e-12);
    }
}

#[test]
fn uneven_steps_are_integrated_as_they_are() {
    let times: Vec<f64> = (1..=9).map(|i| f64::from(i) * 0.1 + f64::from(i % 3) * 0.02).collect();
    let samples = record(times.clone(), |t| t * t);
    for (pair, sample) in times.windows(2).zip(&samples[1..]) {
        near(sample.interval_s, pair[1] - pair[0], 1e-15);
        let exact = (pair[1].powi(3) - pair[0].powi(3)) / 3.0;
        near(sample.increment.angle_b.x, exact, 1e-15);
    }
}

#[test]
fn a_missing_rate_lies_between_its_neighbours() {
    // One reading of 1 in zeros, at most two rows from a gap: its integral is 1 step, whatever is missing.
    for (reading, missing) in [(8, 6), (9, 6), (7, 6), (5, 6), (4, 6), (8, 10)] {
        let times = (1..=20).filter(|i| *i != missing).map(|i| f64::from(i) * 0.01);
        let samples =
            record(times, |t| if (t - 0.01 * f64::from(reading)).abs() < 1e-9 { 1.0 } else { 0.0 });
        assert_eq!(samples.len(), 20);
        assert_eq!(samples.iter().filter(|sample| sample.filled && sample.missing == 1).count(), 1);
        let sum: f64 = samples.iter().map(|sample| sample.increment.angle_b.x).sum();
        // Beside the gap a straight line passes on half of the reading.
        let next = reading == missing + 1 || reading + 1 == missing;
        near(sum, if next { 0.015 } else { 0.010 }, 5e-4);
    }
    // Across a gap of ten a constant 1 goes over into a constant 5, never beyond.
    let times = (1..=8).chain(18..=25).map(|i| f64::from(i) * 0.5);
    let samples = record(times, |t| if t < 6.0 { 1.0 } else { 5.0 });
    assert_eq!(samples.len(), 25);
    for sample in &samples {
        let mean = sample.increment.angle_b.x / sample.interval_s;
        assert!((0.98..=5.02).contains(&mean), "{mean} at {} s", sample.time_s);
    }
    let sum: f64 = samples.iter().map(|sample| sample.increment.angle_b.x).sum();
    near(sum, 8.0 * 0.5 + 3.0 * 5.0 + 7.0 * 2.5, 0.1);
}

#[test]
fn the_first_sample_makes_no_more_of_noise_than_there_is() {
    // A cubic through the first four would weigh the second reading with −59/24.
    for reading in 2..=4 {
        let spike = |t: f64| if (t - 0.01 * f64::from(reading)).abs() < 1e-9 { 1.0 } else { 0.0 };
        let samples = record(even(40, 0.01), spike);
        let sum: f64 = samples.iter().map(|sample| sample.increment.angle_b.x).sum();
        assert!((0.008..0.014).contains(&sum), "{sum}");
    }
}
