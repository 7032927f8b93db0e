//! Gaps: what is missing, and what stands in its place.

use super::{REST, at_rest, even, fall, good, near};
use schuler_simulator::recording::samples::MOST_BRIDGED;

#[test]
fn missing_increments_lie_between_their_neighbours() {
    let mut times = even(0.0, 100.0, 1000);
    times.drain(400..425);
    let text = at_rest(0.0, &times, |t| format!("{t:.2}"));
    // The sensor delivers what belongs to a sample, not what was lost.
    let long = format!("{}", REST * (4.26 - 4.00));
    let text = text
        .lines()
        .map(|line| match line.starts_with("4.26,") {
            true => format!("4.26,0,0,0,0,0,{}\n", REST * 0.01),
            false => format!("{line}\n"),
        })
        .collect::<String>();
    assert!(!text.contains(&long));
    let (_, samples) = good(&text, Some(0.0));
    assert_eq!(samples.len(), 1000);
    let filled: Vec<_> = samples.iter().filter(|sample| sample.filled).collect();
    assert_eq!(filled.len(), 25);
    assert!(filled.iter().all(|sample| sample.missing == 25 && sample.line == 402));
    near(filled[0].end_s, 4.01, 1e-12);
    near(filled[24].end_s, 4.25, 1e-12);
    assert!(fall(&samples) < 1e-9);
}

#[test]
fn a_gap_in_uneven_time_is_shared_out() {
    let mut times: Vec<f64> = vec![0.0];
    for i in 0..200 {
        let step = if i % 2 == 0 { 0.009 } else { 0.011 + 0.0005 * f64::from(i % 5) };
        times.push(times[i as usize] + step);
    }
    let lost = times[100]..=times[102];
    let span_s = times[103] - times[99];
    times.retain(|t| !lost.contains(t));
    let (_, samples) = good(&at_rest(0.0, &times[1..], |t| t.to_string()), Some(0.0));
    let filled: Vec<_> = samples.iter().filter(|sample| sample.filled).collect();
    assert_eq!(filled.len(), 3);
    for sample in filled {
        near(sample.interval_s, span_s / 4.0, 1e-12);
    }
    let total: f64 = samples.iter().map(|sample| sample.interval_s).sum();
    near(total, times[times.len() - 1], 1e-12);
}

#[test]
fn a_rate_that_falls_is_no_row_of_gaps() {
    let mut times = even(0.0, 100.0, 300);
    times.extend(even(3.0, 40.0, 200));
    let (_, samples) = good(&at_rest(0.0, &times, |t| t.to_string()), Some(0.0));
    assert_eq!(samples.len(), 500);
    assert!(samples.iter().all(|sample| !sample.filled));
    near(samples[299].interval_s, 0.01, 1e-12);
    near(samples[300].interval_s, 0.025, 1e-12);
    assert!(fall(&samples) < 1e-9);
}

#[test]
fn a_gap_too_long_to_be_filled_is_told() {
    let mut times = even(0.0, 100.0, 1000);
    let later_s = 20.0 + 0.01 * MOST_BRIDGED as f64;
    times.extend(even(later_s, 100.0, 1000));
    let (_, samples) = good(&at_rest(0.0, &times, |t| format!("{t:.2}")), Some(0.0));
    assert_eq!(samples.len(), 2000);
    assert!(samples[1000].missing > MOST_BRIDGED && !samples[1000].filled);
}
