//! Smoothed flights.

use super::{FROM, apart, at, ended, norm, rows, schuler};
use std::fs;

#[test]
fn a_smoothed_replay_is_what_the_smoothed_run_is() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let scene = schuler(folder, "scenes aided-drive") + "\n[filter]\nsmoother = true\n";
    fs::write(folder.join("smooth.toml"), scene).unwrap();
    let run = crate::on_one_line(&schuler(folder, "run smooth.toml --no-report --out run"));
    let line = &run[run.find("smoothed, ").unwrap()..];
    let numbers = line.split([' ', ',', ';']).filter_map(|word| word.parse::<f64>().ok());
    let numbers: Vec<f64> = numbers.take(8).collect();
    let [states, from_s, to_s, off_m, filtered_m, sigma_m, most_m, nees] = numbers[..] else {
        panic!("{line}")
    };
    assert!(states >= 5000.0 && from_s < 0.2 && to_s > 599.9, "{line}");
    // What theory says of all measurements: 0.42 m at most in the minute without fixes.
    assert!(off_m < filtered_m && sigma_m < 0.3, "{line}");
    assert!(most_m < 1.5 && (0.3..3.0).contains(&nees), "{line}");
    // The same files by replay.
    schuler(folder, "emulate aided-drive --out imu.csv --gnss gnss.csv --truth truth.csv");
    let said =
        schuler(folder, &format!("replay {FROM} --gnss gnss.csv --smooth s.csv --out nav.csv"));
    assert!(said.contains("smoothed ") && said.contains("s.csv"), "{said}");
    let (smoothed, truth) = (rows(&folder.join("s.csv")), rows(&folder.join("truth.csv")));
    let steady = |row: &&Vec<f64>| (120.0..=400.0).contains(&row[0]);
    let mean = |sum: f64| (sum / smoothed.iter().filter(steady).count() as f64).sqrt();
    let variance = |row: &Vec<f64>| row[10..13].iter().map(|x| x * x).sum::<f64>();
    let claimed = mean(smoothed.iter().filter(steady).map(variance).sum());
    let outage = smoothed.iter().filter(|row| (400.0..=460.0).contains(&row[0]));
    let worst = outage.map(|row| variance(row).sqrt()).fold(0.0, f64::max);
    assert!((claimed / 0.213 - 1.0).abs() < 0.05, "{claimed} m");
    assert!((worst / 0.42 - 1.0).abs() < 0.1, "{worst} m");
    let off =
        smoothed.iter().filter(steady).map(|row| norm(apart(at(&truth, row[0]), row)).powi(2));
    let off = mean(off.sum());
    assert!((0.5..1.6).contains(&(off / claimed)), "{off} m where {claimed} m is claimed");
    // More steps than memory holds are refused before the flight.
    let long = schuler(folder, "scenes aided-drive")
        .replace("duration_s = 600", "duration_s = 500000")
        + "\n[filter]\nsmoother = true\n";
    fs::write(folder.join("long.toml"), long).unwrap();
    let (code, _, errors) = ended(folder, "run long.toml --no-report --out long");
    assert!(code != Some(0) && errors.contains("GiB of memory"), "{errors}");
}
