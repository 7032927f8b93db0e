//! Rates become increments: exactly for cubics, else with the stated error.

use super::near;
use schuler_host::recording::Recording;
use schuler_host::recording::csv::{RATES, parse};

/// A recording of rates: x of the gyro and z of the accelerometer are a function and its negative.
fn record(times: impl IntoIterator<Item = f64>, rate: impl Fn(f64) -> f64) -> Recording {
    let rows = times.into_iter().map(|t| format!("{t},{},0,0,0,0,{}\n", rate(t), -rate(t)));
    let text = format!("{}\n{}", RATES.join(","), rows.collect::<String>());
    parse("rates.csv", &text).unwrap_or_else(|e| panic!("{e}"))
}

/// Every sample's increment less the integral over the interval before it.
fn errors(recording: &Recording, integral: impl Fn(f64) -> f64) -> Vec<f64> {
    let exact = |t: f64| integral(t) - integral(t - recording.interval_s);
    let samples = recording.samples.iter();
    samples
        .map(|s| {
            assert_eq!(s.increment.angle_b.x, -s.increment.velocity_b.z);
            s.increment.angle_b.x - exact(s.time_s)
        })
        .collect()
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
fn no_rate_is_carried_over_a_gap() {
    // A constant 1, a gap of ten samples, a constant 5.
    let times = even(8, 0.5).chain((18..=25).map(|i| f64::from(i) * 0.5));
    let recording = record(times, |t| if t < 6.0 { 1.0 } else { 5.0 });
    let gaps: Vec<_> = recording.gaps().collect();
    assert_eq!((gaps.len(), gaps[0].index, gaps[0].missing), (1, 8, 9));
    for (i, sample) in recording.samples.iter().enumerate() {
        near(sample.increment.angle_b.x, if i < 8 { 0.5 } else { 2.5 }, 1e-14);
    }
}

#[test]
fn uneven_steps_are_integrated_as_they_are() {
    let times: Vec<f64> = (1..=9).map(|i| f64::from(i) * 0.1 + f64::from(i % 3) * 0.02).collect();
    let recording = record(times.clone(), |t| t * t);
    for (pair, sample) in times.windows(2).zip(&recording.samples[1..]) {
        let exact = (pair[1].powi(3) - pair[0].powi(3)) / 3.0;
        near(sample.increment.angle_b.x, exact, 1e-15);
    }
}
