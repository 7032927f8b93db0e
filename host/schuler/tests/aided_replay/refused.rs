//! What cannot be is told with its place.

use super::{FROM, ended, schuler};
use std::fs;

#[test]
fn what_cannot_be_is_told_with_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    schuler(folder, "emulate aided-drive --duration 12 --out imu.csv --gnss gnss.csv");
    let gnss = fs::read_to_string(folder.join("gnss.csv")).unwrap();
    let header = gnss.lines().next().unwrap();
    let first = gnss.lines().nth(1).unwrap();
    let cells: Vec<_> = first.split(',').collect();
    let with = |i: usize, cell: &str| {
        let mut cells = cells.clone();
        cells[i] = cell;
        format!("{header}\n{}\n", cells.join(","))
    };
    let cases = [
        (
            with(3, "95"),
            "wrong.csv:2: latitude_deg: 95 is out of range; accepted: degrees, from -90 to 90",
        ),
        (with(3, ""), "wrong.csv:2: latitude_deg: is missing"),
        (with(4, "east"), "wrong.csv:2: longitude_deg: \"east\" is not a number"),
        (with(10, "0"), "wrong.csv:2: north_m_sigma: 0 is out of range; accepted: metres above 0"),
        (with(13, "NaN"), "wrong.csv:2: north_m_s_sigma: NaN is not a finite number"),
        (with(1, "-5"), "wrong.csv:2: arrives_s: -5 is before its time_s"),
        (
            with(2, "place"),
            "wrong.csv:2: measures: \"place\" is nothing that is measured; accepted: position,",
        ),
        (with(9, "3"), "wrong.csv:2: forward_m_s: is not part of what the row measures"),
        (gnss.replace("altitude_m", "height"), "wrong.csv:1: height: is no column of measurements"),
        (format!("{header}\n1,2\n"), "wrong.csv:2: the row has 2 values; accepted: 17"),
        (format!("{header}\n"), "wrong.csv: has no measurement"),
        ("a,b\n1,2\n".to_owned(), "wrong.csv: is no file of measurements"),
    ];
    for (text, expected) in cases {
        fs::write(folder.join("wrong.csv"), &text).unwrap();
        let (code, _, errors) =
            ended(folder, &format!("replay {FROM} --gnss wrong.csv --out n.csv"));
        assert!(code != Some(0) && errors.contains(expected), "{expected}\n{errors}");
        assert!(!folder.join("n.csv").exists());
    }
    for (line, expected) in [
        ("--gnss gnss.csv --height 200", "--height: holds the vertical, which --gnss aids"),
        ("--gnss gnss.csv --algorithm textbook", "--algorithm: an aided navigator is taylor"),
        ("--gnss gnss.csv --precision f32x2", "--precision: an aided navigator has no two-float"),
        ("--gnss gnss.csv --lever-arm 1,2", "forward,right,down in metres"),
        ("--gnss gnss.csv --time-tag gnss.csv", "gnss.csv: is no file of time tags"),
        ("--withhold 1..2", "--gnss"),
        ("--gnss gnss.csv --smooth gnss.csv", "--smooth: is the file that --gnss reads"),
        ("--gnss gnss.csv --smooth imu.csv", "--smooth: is the file that --imu reads"),
        ("--gnss gnss.csv --smooth n.csv", "--smooth: is the file that --out writes"),
    ] {
        let (code, _, errors) = ended(folder, &format!("replay {FROM} {line} --out n.csv"));
        assert!(code != Some(0) && errors.contains(expected), "{expected}\n{errors}");
    }
    let (_, _, errors) = ended(folder, "emulate paper --out p.csv --gnss p-gnss.csv");
    assert!(errors.contains("--gnss: paper has no sensor that aids navigation"), "{errors}");
    let (_, _, errors) = ended(folder, "emulate aided-drive --out imu.csv --gnss imu.csv");
    assert!(errors.contains("is the file that"), "{errors}");
    // A vehicle that stands tells no heading.
    let still = gnss.lines().map(|line| {
        let mut cells: Vec<_> = line.split(',').collect();
        if cells[0] != "time_s" {
            (cells[6], cells[7]) = ("0.1", "0.1");
        }
        cells.join(",") + "\n"
    });
    fs::write(folder.join("still.csv"), still.collect::<String>()).unwrap();
    let (_, _, errors) = ended(folder, "replay --imu imu.csv --gnss still.csv --out n.csv");
    assert!(errors.contains("--initial: is missing, and no two fixes"), "{errors}");
}
