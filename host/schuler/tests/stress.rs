//! `schuler stress`: what it runs, prints and writes, and how it ends.

use schuler_host::stress::case::{Bound, Case, Check};
use schuler_host::stress::{cases, run};
use schuler_simulator::progress::CaseProgress;
use std::collections::HashSet;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn stress(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
    command.current_dir(folder).arg("stress").args(arguments).output().unwrap()
}

#[test]
fn cases_that_pass_are_printed_and_written() {
    let folder = tempfile::tempdir().unwrap();
    let done = stress(folder.path(), &["--case", "subnormal", "--out", "out"]);
    assert_eq!(done.status.code(), Some(0), "{done:?}");
    let said = String::from_utf8(done.stdout).unwrap();
    assert!(said.contains("±5e-324") && said.contains("pass"), "{said}");
    assert!(said.contains("checks, 0 failed"), "{said}");
    let written = fs::read_to_string(folder.path().join("out/stress.csv")).unwrap();
    let mut reader = csv::Reader::from_reader(written.as_bytes());
    let header = ["group", "case", "bound", "measured", "unit", "verdict", "why"];
    assert_eq!(reader.headers().unwrap(), &header[..]);
    let mut rows = 0;
    for record in reader.records() {
        let record = record.unwrap();
        assert_eq!((&record[0], &record[5]), ("numbers", "pass"));
        assert!(record[1].contains("subnormal"), "{record:?}");
        let [bound, measured] = [2, 3].map(|i| record[i].parse::<f64>().unwrap());
        assert!(measured <= bound && record[6].len() > 10, "{record:?}");
        rows += 1;
    }
    // Two frames with three kinds of zeros, and two with a start of subnormals and two checks each.
    assert_eq!(rows, 10, "{written}");
    assert!(said.contains("10 checks"), "{said}");
}

#[test]
fn a_name_that_no_case_has_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let done = stress(folder.path(), &["--case", "no-such-case", "--out", "out"]);
    assert_eq!(done.status.code(), Some(2), "{done:?}");
    let said = String::from_utf8(done.stderr).unwrap();
    for word in ["--case", "no-such-case", "accepted", "motion: coning, 5 samples per cycle"] {
        assert!(said.contains(word), "{said}");
    }
    assert!(!folder.path().join("out").exists());
    // Long cases are there with --full only.
    let done = stress(folder.path(), &["--case", "30 d at rest"]);
    assert_eq!(done.status.code(), Some(2), "{done:?}");
    assert!(String::from_utf8(done.stderr).unwrap().contains("--full"));
}

#[test]
fn what_cannot_be_written_is_told_before_the_work_begins() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("taken"), "").unwrap();
    let done = stress(folder.path(), &["--case", "subnormal", "--out", "taken"]);
    assert_eq!(done.status.code(), Some(2), "{done:?}");
    assert!(String::from_utf8(done.stderr).unwrap().contains("cannot be written"));
    assert!(done.stdout.is_empty());
}

#[test]
fn a_check_that_fails_fails_the_run() {
    let made = |measured: f64| {
        Case::new("group", format!("measures {measured}"), move |_: &CaseProgress| {
            Ok(vec![Check::at_most("it", 1.0, measured, "m", "made up")])
        })
    };
    let broken = Case::new("group", "breaks off", |_: &CaseProgress| Err("why".to_owned()));
    let rows = run(&[made(1.0), made(1.1), made(f64::NAN), broken]).unwrap();
    let verdicts: Vec<_> = rows.iter().map(|row| row.passes()).collect();
    assert_eq!(verdicts, [true, false, false, false]);
    let failed = schuler_host::stress::judge(&rows).unwrap_err();
    assert_eq!(failed.to_string(), "3 of 4 checks failed");
    assert!(schuler_host::stress::judge(&rows[..1]).is_ok());
    let csv = String::from_utf8(schuler_host::stress::csv(&rows)).unwrap();
    let lines: Vec<_> = csv.lines().skip(1).collect();
    assert_eq!(lines[2], "group,\"measures NaN, it\",1.0,NaN,m,fail,made up");
    assert_eq!(lines[3], "group,breaks off,,,,fail,why");
}

#[test]
fn bounds_hold_on_their_side() {
    assert!(Bound::AtMost(1.0).holds(1.0) && !Bound::AtMost(1.0).holds(1.0_f64.next_up()));
    assert!(Bound::AtLeast(1.0).holds(1.0) && !Bound::AtLeast(1.0).holds(1.0_f64.next_down()));
    assert!(!Bound::AtMost(f64::INFINITY).holds(f64::NAN));
    assert!(!Bound::AtLeast(f64::NEG_INFINITY).holds(f64::NAN));
}

#[test]
fn every_group_has_cases_and_no_two_are_called_alike() {
    let cases = cases();
    let names: HashSet<_> = cases.iter().map(Case::full_name).collect();
    assert_eq!(names.len(), cases.len());
    for group in ["time", "motion", "place", "numbers", "rounding", "aged"] {
        assert!(cases.iter().any(|case| case.group == group && !case.long), "{group}");
    }
    for group in ["time", "rounding", "aged"] {
        assert!(cases.iter().any(|case| case.group == group && case.long), "{group}");
    }
}
