//! The command as a user meets it: its files, its table, its errors.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn frontier(folder: &Path, arguments: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
    command.current_dir(folder).arg("frontier").args(arguments.split_whitespace());
    command.output().unwrap()
}

const COLUMNS: &str = "scene,rate_hz,algorithm,window,frame,precision,math,ns_per_sample,ns_spread,\
    max_position_m,max_velocity_m_s,max_attitude_arcsec,on_front";

#[test]
fn a_frontier_has_its_columns_and_its_front() {
    let folder = tempfile::tempdir().unwrap();
    let done = frontier(folder.path(), "--quick --scene hard --rate 10 --rate 50 --out o");
    assert_eq!(done.status.code(), Some(0), "{}", String::from_utf8_lossy(&done.stderr));
    let text = String::from_utf8(done.stdout).unwrap();
    for words in [
        "hard, 60 s",
        "the cheapest is",
        "Left out:\n  hard at 10 Hz: taylor 0,20,0; taylor 0,40,0: ",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let png = fs::read(folder.path().join("o/frontier.png")).unwrap();
    assert!(png.starts_with(b"\x89PNG"));
    let csv = fs::read_to_string(folder.path().join("o/frontier.csv")).unwrap();
    assert_eq!(csv.lines().next(), Some(COLUMNS));
    let rows: Vec<csv::StringRecord> =
        csv::Reader::from_reader(csv.as_bytes()).records().map(Result::unwrap).collect();
    let number = |row: &csv::StringRecord, column: usize| row[column].parse::<f64>().unwrap();
    // All there is: textbook, rk4 and every window, in each frame, precision and source of functions.
    for (algorithm, window, frame, precision, math) in [
        ("textbook", "", "local-level", "f64", "libm"),
        ("textbook", "", "earth-fixed", "f32", "micromath"),
        ("rk4", "", "earth-fixed", "f64", "libm"),
        ("taylor", "0,8,0", "earth-fixed", "f32-plain", "libm"),
        ("taylor", "2,4,2", "local-level", "f32x2", "libm"),
        ("taylor", "4,4,4", "earth-fixed", "f64", "libm"),
        ("taylor", "0,4,0", "local-level", "f32", "micromath"),
    ] {
        let wanted = [algorithm, window, frame, precision, math];
        let found = rows.iter().filter(|row| (2..7).map(|n| &row[n]).eq(wanted));
        assert_eq!(found.count(), 2, "{wanted:?}");
    }
    // Dominance, by comparing every row with every other but micromath's, which are never on the front.
    assert!(rows.iter().all(|row| &row[6] == "libm" || &row[12] == "false"));
    let rows: Vec<_> = rows.into_iter().filter(|row| &row[6] == "libm").collect();
    let cost_and_error = |row| (number(row, 1) * number(row, 7), number(row, 9));
    for row in &rows {
        assert!(number(row, 7) > 0.0 && number(row, 8) >= 0.0);
        let (cost, error) = cost_and_error(row);
        let beaten = rows.iter().map(cost_and_error).any(|(other_cost, other_error)| {
            other_cost <= cost && other_error <= error && (other_cost, other_error) != (cost, error)
        });
        assert_eq!(&row[12], if beaten { "false" } else { "true" }, "{row:?}");
    }
}

#[test]
fn bad_input_is_told_before_the_work_begins() {
    let folder = tempfile::tempdir().unwrap();
    let still = "duration_s = 1\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\n";
    fs::write(folder.path().join("short.toml"), still).unwrap();
    fs::create_dir(folder.path().join("other")).unwrap();
    fs::write(folder.path().join("other/short.toml"), still).unwrap();
    fs::write(folder.path().join("bad.toml"), "duration_s = 1\nrate_hz = 0\n").unwrap();
    fs::write(folder.path().join("long.toml"), still.replace("= 1\n", "= 1e8\n")).unwrap();
    fs::write(folder.path().join("taken"), "").unwrap();
    for (arguments, words) in [
        ("--scene nowhere", ["nowhere: there is no such scene", "paper-perfect"]),
        ("--scene hard --rate 0", ["--rate", "from 1 to 1e6"]),
        ("--scene hard --rate fast", ["--rate", "is not a number"]),
        ("--scene short.toml --rate 1", ["--rate: 1 Hz leaves short", "a rate above 2"]),
        ("--scene long.toml --rate 100", ["--rate: with 100 Hz", "4294967295"]),
        ("--scene bad.toml", ["bad.toml:2:", "rate_hz"]),
        (
            "--scene short.toml --scene other/short.toml",
            ["--scene: two scenes are called short", "different file names"],
        ),
        ("--scene hard --out taken", ["taken", "cannot be written"]),
        ("hard", ["unexpected argument", "schuler frontier"]),
        ("--fast", ["--fast", "unexpected"]),
    ] {
        let done = frontier(folder.path(), arguments);
        let said = String::from_utf8_lossy(&done.stderr);
        assert_eq!(done.status.code(), Some(2), "{arguments}: {said}");
        for word in words {
            assert!(said.contains(word), "{arguments} does not say {word}: {said}");
        }
        assert!(!folder.path().join("out/frontier").exists(), "{arguments}");
    }
}
