//! Whole replays: files in, a file out, in little memory.

use super::{at_rest, even, near, scattered, scratch, text};
use clap::Parser;
use schuler_host::cli::{Cli, Command};
use schuler_host::{emulate, replay, run};
use schuler_simulator::recording::csv::{INCREMENTS, RATES};
use std::fs;
use std::path::Path;

const INITIAL: &str = "time_s = 0\nlatitude_deg = 45\nlongitude_deg = 10\naltitude_m = 100\n\
    north_m_s = 0\neast_m_s = 0\ndown_m_s = 0\nroll_deg = 0\npitch_deg = 0\nyaw_deg = 0\n";

/// Runs a command line; the message where it fails.
pub fn program(line: &[&str]) -> Result<(), String> {
    let arguments = ["schuler"].iter().chain(line);
    match Cli::try_parse_from(arguments).map_err(|e| e.to_string())?.command() {
        Command::Replay(args) => replay::replay(&args).map_err(|e| e.to_string()),
        Command::Emulate(args) => emulate::emulate(&args).map_err(|e| e.to_string()),
        Command::Run(args) => run::run(&args).map_err(|e| e.to_string()),
        _ => Err("another command".to_owned()),
    }
}

/// The rows of a table, as numbers.
pub fn rows(path: &Path) -> Vec<Vec<f64>> {
    let table = fs::read_to_string(path).unwrap_or_else(|e| panic!("{e}"));
    let number = |field: &str| field.parse().unwrap_or_else(|e| panic!("{e}"));
    table.lines().skip(1).map(|line| line.split(',').map(number).collect()).collect()
}

/// Replays a text from an initial state; the rows of nav.csv.
fn flown(imu: &str, initial: &str, more: &[&str]) -> Result<Vec<Vec<f64>>, String> {
    let folder = scratch();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("imu.csv"), imu).expect("the disk has room");
    fs::write(at("initial.toml"), initial).expect("the disk has room");
    let (imu, initial, out) = (at("imu.csv"), at("initial.toml"), at("nav.csv"));
    let line = ["replay", "--imu", text(&imu), "--initial", text(&initial), "--out", text(&out)];
    program(&[&line[..], more].concat())?;
    Ok(rows(&out))
}

/// Metres from one row of nav.csv to another.
pub fn apart(a: &[f64], b: &[f64]) -> f64 {
    let per_degree = 6.37e6_f64.to_radians();
    let east = (a[2] - b[2]) * per_degree * a[1].to_radians().cos();
    ((a[1] - b[1]) * per_degree).hypot(east).hypot(a[3] - b[3])
}

#[test]
fn rest_stays_at_rest_whatever_the_steps() {
    // At 45° N and 100 m: the Earth's rate and gravity.
    let rest = "5.156303965692141e-05,0.0,-5.1563039656921404e-05,0.0,0.0,-9.80588922170681";
    let times = (1..=20).map(|i| if i <= 10 { 10 * i } else { 100 + 11 * (i - 10) });
    let lines = times.map(|ms| format!("{},{rest}\n", f64::from(ms) / 1000.0));
    let imu = format!("{}\n{}", RATES.join(","), lines.collect::<String>());
    for frame in ["local-level", "earth-fixed"] {
        let nav = flown(&imu, INITIAL, &["--frame", frame]).unwrap_or_else(|e| panic!("{e}"));
        let last = nav.last().expect("rows");
        assert!(last[6].abs() < 1e-9, "v_down is {}", last[6]);
        near(last[0], 0.21, 1e-12);
    }
}

#[test]
fn a_manoeuvre_in_uneven_steps_is_the_same_manoeuvre() {
    let folder = scratch();
    let at = |name: &str| folder.path().join(name);
    for (name, more) in [("fine.csv", &[][..]), ("rates.csv", &["--rates"])] {
        let out = at(name);
        let line = ["emulate", "manoeuvre", "--perfect", "--rate", "10000", "--duration", "5"];
        program(&[&line[..], &["--out", text(&out)], more].concat())
            .unwrap_or_else(|e| panic!("{e}"));
    }
    let initial = "time_s = 0\nlatitude_deg = 45\nlongitude_deg = 100\naltitude_m = 3000\n\
        north_m_s = 281.7\neast_m_s = 342\ndown_m_s = -45\nroll_deg = 0\npitch_deg = 11.155\n\
        yaw_deg = 17.188733853924695\n";
    let read = |name: &str| fs::read_to_string(at(name)).expect("it is there");
    let fine = flown(&read("fine.csv"), initial, &[]).unwrap_or_else(|e| panic!("{e}"));
    // Steps of 8 to 12 ms: every fine sample belongs to one of the coarse.
    let mut uniform = scattered(1);
    let (increments, rates) = (rows(&at("fine.csv")), rows(&at("rates.csv")));
    let mut coarse = INCREMENTS.join(",") + "\n";
    let mut coarse_rates = RATES.join(",") + "\n";
    let mut from = 0;
    while from + 120 < increments.len() {
        let to = from + 80 + (41.0 * uniform()) as usize;
        let mut sums = vec![0.0; 6];
        for row in &increments[from..to] {
            sums.iter_mut().zip(&row[1..]).for_each(|(sum, value)| *sum += value);
        }
        let line = |values: &[f64]| {
            let values: Vec<_> = values.iter().map(f64::to_string).collect();
            format!("{},{}\n", increments[to - 1][0], values.join(","))
        };
        coarse += &line(&sums);
        coarse_rates += &line(&rates[to - 1][1..]);
        from = to;
    }
    let expected = &fine[from - 1];
    for (imu, bound) in [(&coarse, 1e-3), (&coarse_rates, 1e-3)] {
        let nav = flown(imu, initial, &[]).unwrap_or_else(|e| panic!("{e}"));
        let last = nav.last().expect("rows");
        assert_eq!(last[0], expected[0]);
        let off = apart(last, expected);
        assert!(off < bound, "{off} m");
    }
}

#[test]
fn a_line_that_cannot_be_read_matters_where_it_is_flown() {
    let good = at_rest(0.0, &even(0.0, 100.0, 100), |t| format!("{t:.2}"));
    let lines: Vec<_> = good.lines().collect();
    let with = |line: usize, text: &str| {
        let mut lines = lines.clone();
        lines[line - 1] = text;
        lines.join("\n")
    };
    let broken = lines[60].replacen(",0,", ",x,", 1);
    for (bad, line) in
        [(with(61, "x,1,2"), 61), (with(61, &broken), 61), (with(61, "-1,0,0,0,0,0,0"), 61)]
    {
        let message = flown(&bad, INITIAL, &[]).expect_err("it is flown");
        assert!(message.contains(&format!("imu.csv:{line}: ")), "{message}");
        let until = ["--until", "0.59"];
        let nav = flown(&bad, INITIAL, &until).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(nav.len(), 59);
    }
    let last = with(101, "x,1,2,3,4,5,6");
    assert!(
        flown(&last, INITIAL, &[]).expect_err("it is flown").contains("imu.csv:101: time_s: \"x\"")
    );
    assert_eq!(flown(&last, INITIAL, &["--until", "0.99"]).expect("it is not").len(), 99);
}

#[test]
fn a_gap_is_refused_with_its_line_or_bridged() {
    let mut times = even(0.0, 100.0, 100);
    times.drain(50..53);
    let imu = at_rest(0.0, &times, |t| format!("{t:.2}"));
    let message = flown(&imu, INITIAL, &[]).expect_err("samples are missing");
    assert!(
        message.contains("imu.csv:52: 3 samples are missing before this one, 0.030000 s"),
        "{message}"
    );
    assert!(message.contains("--gap bridge"), "{message}");
    let nav = flown(&imu, INITIAL, &["--gap", "bridge"]).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(nav.len(), 100);
    // What is not flown may lack anything.
    assert_eq!(flown(&imu, INITIAL, &["--until", "0.5"]).expect("it is whole").len(), 50);
}

#[test]
fn every_so_many_rows_or_seconds() {
    let imu = at_rest(0.0, &even(0.0, 100.0, 1005), |t| format!("{t:.2}"));
    let times = |every: &str| -> Vec<f64> {
        let nav = flown(&imu, INITIAL, &["--every", every]).unwrap_or_else(|e| panic!("{e}"));
        nav.iter().map(|row| row[0]).collect()
    };
    assert_eq!(times("250"), [2.5, 5.0, 7.5, 10.0, 10.05]);
    assert_eq!(times("2s"), [2.0, 4.0, 6.0, 8.0, 10.0, 10.05]);
    assert_eq!(times("0.5s").len(), 21);
    assert_eq!(times("1").len(), 1005);
    for wrong in ["0", "-1", "0s", "s", "2.5", "nans", "1m"] {
        let every = format!("--every={wrong}");
        let message = flown(&imu, INITIAL, &[&every]).expect_err(wrong);
        assert!(message.contains("a number of rows, such as 10, or of seconds"), "{message}");
    }
}

#[test]
fn motion_that_is_not_resolved_does_not_throw_a_replay() {
    // A cone of 0.1° at 2.5 samples per cycle: a textbook is 0.075 m off after a minute.
    let folder = scratch();
    let at = |name: &str| folder.path().join(name);
    let scene = "title = \"cone\"\nduration_s = 60\nrate_hz = 100\n[trajectory]\n\
        roll_deg = { harmonics = [{ amplitude = 0.1, period_s = 0.025 }] }\n\
        pitch_deg = { harmonics = [{ amplitude = 0.1, period_s = 0.025, phase_deg = 90 }] }\n\
        latitude_deg = 45\n";
    fs::write(at("cone.toml"), scene).expect("the disk has room");
    let (cone, out) = (at("cone.toml"), at("imu.csv"));
    program(&["emulate", text(&cone), "--perfect", "--out", text(&out)]).expect("it is a scene");
    let initial = "time_s = 0\nlatitude_deg = 45\nlongitude_deg = 0\naltitude_m = 0\n\
        north_m_s = 0\neast_m_s = 0\ndown_m_s = 0\nroll_deg = 0.1\npitch_deg = 0\nyaw_deg = 0\n";
    let imu = fs::read_to_string(&out).expect("it is there");
    for frame in ["local-level", "earth-fixed"] {
        let nav = flown(&imu, initial, &["--frame", frame]).unwrap_or_else(|e| panic!("{e}"));
        let off = apart(nav.last().expect("rows"), &[0.0, 45.0, 0.0, 0.0]);
        assert!(off < 0.08, "{off} m");
    }
}
