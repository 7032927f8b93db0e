//! One clock: a constant rate where stamps are only rounded, else the stamps' own steps.

use super::{at_rest, even, fall, good, near, read, scattered};
use schuler_simulator::recording::clock::Clock;

/// The interval of a constant rate.
#[track_caller]
fn interval_s(clock: &Clock) -> f64 {
    match clock {
        Clock::Even { interval_s, .. } => *interval_s,
        Clock::Stamps { .. } => panic!("{clock:?}"),
    }
}

#[test]
fn rounded_stamps_of_a_whole_rate_are_that_rate() {
    for rate_hz in [60.0, 100.0, 128.0, 400.0] {
        let times = even(0.0, rate_hz, 6000);
        let (survey, samples) = good(&at_rest(0.0, &times, |t| format!("{t:.3}")), Some(0.0));
        assert_eq!(interval_s(&survey.clock), 1.0 / rate_hz, "{}", survey.clock_said);
        assert!(
            survey.clock_said.starts_with(&format!("{rate_hz:.4} Hz by least squares over 6000"))
        );
        assert!(samples.iter().all(|sample| sample.interval_s == 1.0 / rate_hz && !sample.filled));
        assert!(fall(&samples) < 1e-9, "{rate_hz} Hz: {}", fall(&samples));
        // The first sample begins at 0, within what the stamps tell.
        near(samples[0].end_s, 1.0 / rate_hz, 1e-3 / 3.0);
    }
    let times = even(0.0, 60.0, 600);
    let said = good(&at_rest(0.0, &times, |t| format!("{t:.3}")), None).0.clock_said;
    assert_eq!(said, "60.0000 Hz by least squares over 600 stamps, rounded to 1 ms");
}

#[test]
fn a_rate_that_is_not_whole_is_found_to_the_rounding_of_all_stamps() {
    // Over half an hour 1 cm is 6e-10 of the rate.
    for rate_hz in [60_000.0 / 1001.0, 100.003, 99.9871] {
        let count = (1800.0 * rate_hz) as u32;
        let times = even(0.0, rate_hz, count);
        let (_, samples) = good(&at_rest(0.0, &times, |t| format!("{t:.3}")), Some(0.0));
        assert!(fall(&samples) < 1e-2, "{rate_hz} Hz: {}", fall(&samples));
    }
}

#[test]
fn stamps_of_single_precision_far_from_zero() {
    for rate_hz in [60.0, 100.0, 128.0, 400.0] {
        let times = even(1e5, rate_hz, 20_000);
        // Steps of 7.8 ms: at 400 Hz three samples or four share a stamp.
        for exact in [true, false] {
            let stamp = |t: f64| match exact {
                true => f64::from(t as f32).to_string(),
                false => (t as f32).to_string(),
            };
            let (survey, samples) = good(&at_rest(1e5, &times, stamp), Some(1e5));
            assert_eq!(interval_s(&survey.clock), 1.0 / rate_hz, "{}", survey.clock_said);
            assert_eq!(samples.len(), times.len());
            assert!(fall(&samples) < 1e-8, "{rate_hz} Hz: {}", fall(&samples));
        }
    }
}

#[test]
fn stamps_that_are_coarse_leave_out_what_is_missing() {
    // 400 Hz in whole milliseconds, steps of 2 and 3 ms by turns; then two samples are lost.
    let mut times = even(0.0, 400.0, 4000);
    times.drain(2000..2002);
    let stamp = |t: f64| format!("{t:.3}");
    let (survey, samples) = good(&at_rest(0.0, &times, stamp), Some(0.0));
    assert_eq!(interval_s(&survey.clock), 0.0025);
    assert_eq!(samples.len(), 4000);
    assert_eq!(samples.iter().filter(|sample| sample.filled).count(), 2);
}

#[test]
fn time_that_really_varies_is_taken_from_the_stamps() {
    let mut uniform = scattered(7);
    let mut jitter = vec![0.0];
    for i in 0..6000 {
        jitter.push(jitter[i] + 0.01 * (1.0 + 0.2 * (2.0 * uniform() - 1.0)));
    }
    let mut wander = vec![0.0];
    for i in 0..6000 {
        wander.push(wander[i] + 0.01 * (1.0 + 0.01 * (f64::from(i as u32) / 1600.0).sin()));
    }
    let mut change = even(0.0, 100.0, 3000);
    change.extend(even(30.0, 120.0, 3600));
    for times in [&jitter[1..], &wander[1..], &change[..]] {
        let full = |t: f64| t.to_string();
        let (survey, samples) = good(&at_rest(0.0, times, full), Some(0.0));
        assert!(matches!(survey.clock, Clock::Stamps { .. }), "{}", survey.clock_said);
        assert!(fall(&samples) < 1e-9, "{}", fall(&samples));
        assert!(samples.iter().all(|sample| !sample.filled));
        // In whole microseconds each stamp is half of one off.
        let (_, samples) = good(&at_rest(0.0, times, |t| format!("{t:.6}")), Some(0.0));
        assert!(fall(&samples) < 1e-4, "{}", fall(&samples));
    }
}

#[test]
fn ten_long_steps_after_ten_short_ones_are_no_rounding() {
    let times: Vec<_> = (1..=20)
        .map(|i| if i <= 10 { 0.01 * f64::from(i) } else { 0.011 * f64::from(i) - 0.01 })
        .collect();
    let (survey, samples) = good(&at_rest(0.0, &times, |t| format!("{t:.3}")), Some(0.0));
    assert!(matches!(survey.clock, Clock::Stamps { .. }));
    near(samples[4].interval_s, 0.010, 1e-12);
    near(samples[14].interval_s, 0.011, 1e-12);
}

#[test]
fn the_first_interval_is_that_from_the_start_if_it_can_be() {
    let times = [0.012, 0.021, 0.031, 0.0405, 0.051, 0.0602, 0.0711];
    let text = at_rest(0.0, &times, |t| t.to_string());
    for (origin_s, first_s) in [(Some(0.0), 0.012), (Some(-1.0), 0.009), (None, 0.009)] {
        near(good(&text, origin_s).1[0].interval_s, first_s, 1e-15);
    }
}

#[test]
fn a_stated_rate_is_taken_unless_the_stamps_deny_it() {
    let mut uniform = scattered(3);
    // Stamps of a computer that was busy: up to 2 ms late.
    let times: Vec<_> = even(0.0, 100.0, 3000);
    let late: Vec<_> = times.iter().map(|t| format!("{}", t + 2e-3 * uniform())).collect();
    let mut stamps = late.iter();
    let mut text = String::new();
    for line in at_rest(0.0, &times, |_| "0".to_owned()).lines() {
        let row =
            line.strip_prefix("0,").map(|rest| format!("{},{rest}", stamps.next().expect("each")));
        text += &(row.unwrap_or_else(|| line.to_owned()) + "\n");
    }
    let (survey, samples, _) = read("imu.csv", &text, Some(100.0), None).expect("it is right");
    assert_eq!(interval_s(&survey.clock), 0.01);
    assert!(fall(&samples) < 1e-9);
    let message = read("imu.csv", &text, Some(50.0), None).expect_err("it is wrong").to_string();
    assert!(message.starts_with("--rate: 50 Hz is not the rate of the stamps, "), "{message}");
}
