//! Replays of what a run measured.

use super::{FROM, apart, at, norm, reversed, rows, schuler};
use std::fs;

#[test]
fn a_replay_drifts_as_the_run_did() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    schuler(folder, "emulate aided-drive --duration 60 --run 3 --out imu.csv --gnss gnss.csv");
    schuler(folder, "run aided-drive --duration 60 --run 3 --rows --no-report --out run");
    let said = schuler(folder, &format!("replay {FROM} --gnss gnss.csv --out nav.csv"));
    assert!(said.contains("gnss: 60 taken, 0 refused, NIS"), "{said}");
    let (run, replay) = (rows(&folder.join("run/nav.csv")), rows(&folder.join("nav.csv")));
    // Degrees round places to a nanometre, and seconds of arc of the start to some more.
    for row in &replay[..replay.len() - 1] {
        let other = at(&run, row[0]);
        let off = norm(apart(row, other));
        assert!(off < 1e-6, "{off} m at {} s", row[0]);
        for (a, b) in row[4..10].iter().zip(&other[4..10]) {
            assert!((a - b).abs() < 1e-7, "{row:?} {other:?}");
        }
    }
    // What the filter says of itself is there, and shrinks.
    let (first, last) = (&replay[0], &replay[replay.len() - 1]);
    assert!(last[10] > 0.05 && last[10] < first[10] && last.len() == 19, "{last:?}");
}

#[test]
fn the_order_of_rows_and_their_way_do_not_change_a_bit() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let scene = schuler(folder, "scenes aided-drive");
    let way = "latency_s = 0.2\njitter_s = 0.3\nrepetition = 0.2\n[filter]\nhorizon_s = 1\n";
    fs::write(folder.join("late.toml"), format!("{scene}{way}")).unwrap();
    schuler(folder, "emulate late.toml --duration 40 --out imu.csv --gnss gnss.csv");
    let gnss = fs::read_to_string(folder.join("gnss.csv")).unwrap();
    // The last fix comes after the end, unless it comes in time.
    let gnss: Vec<_> = gnss.lines().filter(|line| !line.starts_with("40.0,")).collect();
    let gnss = gnss.join("\n") + "\n";
    fs::write(folder.join("gnss.csv"), &gnss).unwrap();
    fs::write(folder.join("back.csv"), reversed(&gnss)).unwrap();
    // All of them at once when they are true.
    let in_time = gnss.lines().map(|line| {
        let mut cells: Vec<_> = line.split(',').collect();
        if cells[0] != "time_s" {
            cells[1] = cells[0];
        }
        cells.join(",") + "\n"
    });
    fs::write(folder.join("in_time.csv"), in_time.collect::<String>()).unwrap();
    let nav = |gnss: &str| {
        let from = "--imu imu.csv --sensors late.toml --initial initial.toml";
        schuler(folder, &format!("replay {from} --gnss {gnss} --out nav.csv"));
        fs::read(folder.join("nav.csv")).unwrap()
    };
    let own = nav("gnss.csv");
    assert!(own == nav("back.csv"), "the order of rows shows");
    assert!(own == nav("in_time.csv"), "the way shows");
    let lines: Vec<_> = gnss.lines().collect();
    fs::write(folder.join("fewer.csv"), lines[..20].join("\n")).unwrap();
    assert!(own != nav("fewer.csv"), "fixes do not count");
}

#[test]
fn what_is_withheld_is_compared_with_the_navigator() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    // Fixes to a millimetre, at the unit itself, are the truth.
    let scene = schuler(folder, "scenes aided-drive")
        .replace("\nposition_m = 1\n", "\nposition_m = 0.001\n")
        .replace("[0.5, -0.3, -1]", "[0, 0, 0]");
    fs::write(folder.join("true.toml"), scene).unwrap();
    let emulate =
        "emulate true.toml --duration 100 --out imu.csv --gnss gnss.csv --truth truth.csv";
    schuler(folder, emulate);
    let from = "--imu imu.csv --sensors true.toml --initial initial.toml --gnss gnss.csv";
    let said = schuler(
        folder,
        &format!("replay {from} --withhold 20..50.5 --withhold 60..90.5 --out nav.csv"),
    );
    let (nav, truth) = (rows(&folder.join("nav.csv")), rows(&folder.join("truth.csv")));
    for time_s in [50.0, 90.0] {
        // A block ends there.
        let off = apart(at(&truth, time_s), at(&nav, time_s));
        assert!(norm(off) > 0.05, "{off:?}");
        let line = said.lines().find(|line| line.contains(&format!("to {}", time_s + 0.5)));
        let told = line.and_then(|line| line.split('(').nth(1)).unwrap();
        let told: Vec<f64> = told.split([',', ' ']).flat_map(str::parse).take(3).collect();
        for (a, b) in off.iter().zip(&told) {
            assert!((a - b).abs() < 0.02 + 0.01 * b.abs(), "{off:?} {told:?}\n{said}");
        }
    }
    assert!(
        said.contains("20 to 50.5 s, 31 measurements") && said.contains("2 spans together"),
        "{said}"
    );
    assert!(said.contains("gnss: 38 taken, 0 refused"), "{said}");
}
