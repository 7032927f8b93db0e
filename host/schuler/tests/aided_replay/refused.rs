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

/// A sentence with its checksum.
fn sum(sentence: &str) -> String {
    let checksum = sentence.bytes().fold(0, |sum, byte| sum ^ byte);
    format!("${sentence}*{checksum:02X}\n")
}

#[test]
fn a_damaged_sentence_is_told_where_it_stands() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    schuler(folder, "emulate aided-drive --duration 12 --out imu.csv");
    let of = |second: u32| {
        let clock = format!("00000{second}.00");
        let gga = format!("GNGGA,{clock},4530.0000,N,10015.0000,E,4,12,0.8,320.125,M,-20.000,M,,");
        let rmc = format!("GNRMC,{clock},A,4530.0000,N,10015.0000,E,0.0,0.0,010120,,,A");
        [sum(&gga), sum(&rmc)]
    };
    let [[first, a], [second, b], [third, c]] = [1, 2, 3].map(of);
    let wrong = second.replace("320.125", "320.126");
    // One bit of the last digit, 5 = 0b101 and 6 = 0b110: the checksum is off by 0b011.
    let [told, due] = [&second, &wrong].map(|line| line.trim_end().rsplit('*').next().unwrap());
    assert_eq!(told, due);
    let found = u8::from_str_radix(told, 16).unwrap();
    let checksum = format!(
        "lines.nmea:3: the checksum is {found:02X}, that of what stands here {:02X}",
        found ^ 3
    );
    let cut = second[..40].to_owned() + "\n";
    for (bad, expected) in [
        (wrong.as_str(), checksum.as_str()),
        (cut.as_str(), "lines.nmea:3: the sentence is cut: it ends in"),
        ("$GNG\n", "lines.nmea:3: the sentence is cut: it ends in \"$GNG\""),
    ] {
        let text = [first.as_str(), &a, bad, &b, &third, &c].concat();
        fs::write(folder.join("lines.nmea"), text).unwrap();
        let line = format!("replay {FROM} --gnss lines.nmea --out n.csv");
        let (code, _, errors) = ended(folder, &line);
        assert!(code == Some(2) && errors.contains(expected), "{expected}\n{errors}");
    }
}

#[test]
fn deviations_that_a_file_has_not_are_those_of_the_option() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    schuler(folder, "emulate aided-drive --duration 12 --out imu.csv --gnss gnss.csv");
    let gnss = fs::read_to_string(folder.join("gnss.csv")).unwrap();
    let but = |without: &dyn Fn(&str) -> bool| {
        let header: Vec<_> = gnss.lines().next().unwrap().split(',').collect();
        let kept = |line: &str| {
            let cells = line.split(',').zip(&header).filter(|(_, name)| !without(name));
            cells.map(|(cell, _)| cell).collect::<Vec<_>>().join(",") + "\n"
        };
        gnss.lines().map(kept).collect::<String>()
    };
    // The same numbers in the file and as an option are the same flight.
    let told: String = gnss
        .lines()
        .enumerate()
        .map(|(i, line)| {
            let mut cells: Vec<_> = line.split(',').collect();
            if i > 0 && !cells[10].is_empty() {
                cells[10..13].copy_from_slice(&["2", "2", "4"]);
            }
            if i > 0 && !cells[13].is_empty() {
                cells[13..16].fill("0.5");
            }
            cells.join(",") + "\n"
        })
        .collect();
    fs::write(folder.join("told.csv"), told).unwrap();
    fs::write(folder.join("none.csv"), but(&|name| name.ends_with("_sigma"))).unwrap();
    schuler(folder, &format!("replay {FROM} --gnss told.csv --out told-nav.csv"));
    let line = format!("replay {FROM} --gnss none.csv --gnss-sigma 2,4,0.5 --out nav.csv");
    let said = schuler(folder, &line);
    let expected = "none.csv: no standard deviations: taken as good are positions to 2 m level and 4 m in height, velocities to 0.5 m/s";
    assert!(said.contains(expected), "{said}");
    let [told, none] = ["told-nav.csv", "nav.csv"].map(|name| fs::read(folder.join(name)).unwrap());
    assert!(told == none && !told.is_empty());
    // One of three that is missing is a fault of the file.
    fs::write(folder.join("some.csv"), but(&|name| name == "down_m_sigma")).unwrap();
    let (code, _, errors) = ended(folder, &format!("replay {FROM} --gnss some.csv --out n.csv"));
    assert!(code == Some(2) && errors.contains("some.csv:2: down_m_sigma: is missing"), "{errors}");
}
