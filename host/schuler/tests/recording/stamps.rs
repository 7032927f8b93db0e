//! Stamps that repeat, start over, or stand in another unit.

use super::{at_rest, even, fall, good, near, read};
use schuler_simulator::recording::csv::RATES;

/// Ten seconds from a time on, stamped within a period and in a unit.
fn wrapped(from_s: f64, period_s: f64, unit_s: f64) -> String {
    at_rest(from_s, &even(from_s, 100.0, 1000), |t| {
        let stamp = t.rem_euclid(period_s);
        if unit_s == 1.0 { format!("{stamp:.6}") } else { format!("{:.0}", stamp / unit_s) }
    })
}

#[test]
fn counters_that_come_round_go_on() {
    for (from_s, period_s, unit_s, name) in [
        (604_795.0, 604_800.0, 1.0, "a GPS week"),
        (86_395.0, 86_400.0, 1.0, "a day"),
        (4290.0, 4_294.967_296, 1.0, "a 32-bit counter of microseconds"),
        (4290.0, 4_294.967_296, 1e-6, "a 32-bit counter of microseconds"),
        (4_294_960.0, 4_294_967.296, 1e-3, "a 32-bit counter of milliseconds"),
        (60.0, 65.536, 1e-3, "a 16-bit counter of milliseconds"),
    ] {
        let text = wrapped(from_s, period_s, unit_s);
        let (survey, samples, recording) =
            read("imu.csv", &text, None, Some(from_s)).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(survey.mends.rounds.len(), 1, "{name}");
        let said = survey.said(&recording).join("\n");
        assert!(said.contains(&format!("{name} came round")), "{said}");
        assert_eq!(samples.len(), 1000);
        near(samples[999].end_s, from_s + 10.0, 1e-6);
        assert!(fall(&samples) < 1e-6, "{name}: {}", fall(&samples));
    }
}

#[test]
fn a_counter_with_a_sign_comes_round_too() {
    let text = at_rest(2140.0, &even(2140.0, 100.0, 1000), |t| {
        let stamp = if t >= 2_147.483_648 { t - 4_294.967_296 } else { t };
        format!("{stamp:.6}")
    });
    let (survey, samples) = good(&text, Some(2140.0));
    assert_eq!(survey.mends.rounds.len(), 1);
    assert!(fall(&samples) < 1e-6);
}

#[test]
fn a_clock_that_was_set_back_is_refused_with_its_line() {
    let mut times = even(0.0, 100.0, 50);
    times.extend(even(0.0, 100.0, 20));
    let text = at_rest(0.0, &times, |t| format!("{t:.2}"));
    let (_, samples, recording) = read("imu.csv", &text, None, None).expect("it is read");
    assert_eq!(samples.len(), 50);
    let survey = schuler_simulator::recording::survey::Survey::of(&recording, None, super::WHOLE);
    let survey = survey.unwrap_or_else(|e| panic!("{e}"));
    let mut samples =
        schuler_simulator::recording::samples::Samples::new(&recording, &survey, None)
            .expect("again");
    while samples.advance().expect("the same").is_some() {}
    let message = samples.trailing()[0].error.to_string();
    assert!(message.starts_with("imu.csv:52: time_s: 0.01 is not after 0.5"), "{message}");
}

#[test]
fn rows_written_twice_are_left_out_and_said() {
    let text = at_rest(0.0, &even(0.0, 100.0, 100), |t| format!("{t:.2}"));
    let row = text.lines().nth(40).expect("a row");
    let twice = text.replace(row, &format!("{row}\n{row}"));
    let (survey, samples, recording) = read("imu.csv", &twice, None, None).expect("it is mended");
    assert_eq!((samples.len(), survey.mends.copies, survey.mends.first_copy), (100, 1, 42));
    let said = survey.said(&recording).join("\n");
    assert!(said.starts_with("imu.csv:42: rows that are there twice, left out: 1"), "{said}");
    // Another sample at the same time is not: which one is it?
    let other = row.replacen(",0,", ",1,", 1);
    let (_, samples) = good(&text.replace(row, &format!("{row}\n{other}")), None);
    let message =
        samples.iter().flat_map(|s| &s.unread).next().expect("it is told").error.to_string();
    assert!(message.starts_with("imu.csv:42: time_s: 0.4 is not after 0.4"), "{message}");
}

#[test]
fn a_stamp_that_stood_still_is_given_its_place() {
    let text = at_rest(0.0, &even(0.0, 100.0, 100), |t| {
        format!("{:.2}", if (t - 0.41).abs() < 1e-6 { 0.40 } else { t })
    });
    let (survey, samples) = good(&text, Some(0.0));
    assert_eq!((samples.len(), survey.mends.stuck, survey.mends.first_stuck), (100, 1, 42));
    near(samples[40].end_s, 0.41, 1e-12);
    assert!(fall(&samples) < 1e-9);
}

#[test]
fn units_with_one_reading_are_taken() {
    for (unit, unit_s, digits) in [
        ("milliseconds", 1e-3, 0),
        ("microseconds", 1e-6, 0),
        ("nanoseconds", 1e-9, 0),
        ("milliseconds", 1e-3, 3),
    ] {
        for rate_hz in [50.0, 100.0, 400.0] {
            let text =
                at_rest(0.0, &even(0.0, rate_hz, 400), |t| format!("{:.digits$}", t / unit_s));
            let (survey, samples, recording) =
                read("imu.csv", &text, None, Some(0.0)).unwrap_or_else(|e| panic!("{unit}: {e}"));
            let said = survey.said(&recording).join("\n");
            assert!(said.contains(&format!("stamps are in {unit}, taken as such")), "{said}");
            near(samples[399].end_s, 400.0 / rate_hz, 1e-3);
            assert!(fall(&samples) < 1e-6);
        }
    }
}

#[test]
fn units_with_two_readings_are_asked_for() {
    // Rates every 100: of milliseconds 10 Hz, of microseconds 10 kHz.
    let rows: String = (1..50).map(|i| format!("{},0,0,0,0,0,-9.8\n", i * 100)).collect();
    let text = format!("{}\n{rows}", RATES.join(","));
    let message = read("imu.csv", &text, None, None).expect_err("it is not clear").to_string();
    let expected =
        "imu.csv: has samples of 100 s; these look like milliseconds or microseconds; accepted: ";
    assert!(message.starts_with(expected), "{message}");
}
