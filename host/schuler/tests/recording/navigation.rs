//! `nav.csv` and `initial.toml`.

use super::{near, scratch, text};
use schuler_simulator::recording::navigation::{COLUMNS, NavigationRow, NavigationWriter};
use std::f64::consts::FRAC_PI_4;

const INITIAL: &str = "time_s = 12.5\nlatitude_deg = 45\nlongitude_deg = -100.25\naltitude_m = 3500\n\
    north_m_s = 1\neast_m_s = -2\ndown_m_s = 0.5\nroll_deg = 5\npitch_deg = -6\nyaw_deg = 170\n";

fn initial() -> NavigationRow {
    NavigationRow::parse("initial.toml", INITIAL).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn every_key_in_si_units() {
    let row = initial();
    assert_eq!(row.time_s, 12.5);
    near(row.position.latitude, FRAC_PI_4, 1e-16);
    near(row.position.longitude, -1.7496925751243154, 1e-15);
    assert_eq!(row.position.altitude, 3500.0);
    assert_eq!(row.velocity_ned.into_array(), [1.0, -2.0, 0.5]);
    near(row.attitude.roll, 8.7266462599716479e-2, 1e-16);
    near(row.attitude.pitch, -0.10471975511965977, 1e-16);
    near(row.attitude.yaw, 2.9670597283903602, 1e-15);
}

#[test]
fn a_solution_and_back() {
    let row = initial();
    let again = NavigationRow::new(12.5, &row.solution());
    assert_eq!(
        (again.time_s, again.position, again.velocity_ned),
        (12.5, row.position, row.velocity_ned)
    );
    near(again.attitude.roll, row.attitude.roll, 1e-15);
    near(again.attitude.pitch, row.attitude.pitch, 1e-15);
    near(again.attitude.yaw, row.attitude.yaw, 2e-15);
}

#[test]
fn a_row_written_is_an_initial_state() {
    let folder = scratch();
    let path = folder.path().join("nav.csv");
    let row = initial();
    let mut writer = NavigationWriter::create(&path).expect("the folder is there");
    writer.row(&row).expect("the disk has room");
    writer.finish().expect("the disk has room");
    let written = std::fs::read_to_string(&path).expect("it is there");
    let [header, values] = written.lines().collect::<Vec<_>>()[..] else { panic!("{written}") };
    assert_eq!(
        header,
        "time_s,latitude_deg,longitude_deg,altitude_m,north_m_s,east_m_s,down_m_s,roll_deg,pitch_deg,yaw_deg"
    );
    let toml: String = COLUMNS
        .iter()
        .zip(values.split(','))
        .map(|(key, value)| format!("{key} = {value}\n"))
        .collect();
    let again = NavigationRow::parse("again.toml", &toml).unwrap_or_else(|e| panic!("{e}\n{toml}"));
    near(again.position.longitude, row.position.longitude, 4e-16);
    assert_eq!(again.velocity_ned, row.velocity_ned);
    near(again.attitude.yaw, row.attitude.yaw, 5e-16);
}

#[test]
fn errors_name_file_line_and_key() {
    for (number, column) in (1..).zip(COLUMNS) {
        let line = INITIAL.lines().nth(number - 1).expect("a line for each");
        let without = INITIAL.replace(&format!("{line}\n"), "");
        let message = NavigationRow::parse("i.toml", &without).expect_err(column).to_string();
        assert!(
            message.starts_with(&format!("i.toml:1: {column}: is missing; accepted: ")),
            "{message}"
        );
        let broken = INITIAL.replace(line, &format!("{column} = nan"));
        let message = NavigationRow::parse("i.toml", &broken).expect_err(column).to_string();
        assert!(
            message.starts_with(&format!("i.toml:{number}: {column}: NaN is not")),
            "{message}"
        );
    }
    for (from, to, start) in [
        (
            "latitude_deg = 45",
            "latitude_deg = 90.5",
            "i.toml:2: latitude_deg: 90.5 is out of range",
        ),
        ("altitude_m = 3500", "altitude_m = 1e7", "i.toml:4: altitude_m: 10000000 is out of range"),
        ("yaw_deg = 170", "heading_deg = 170", "i.toml:10: heading_deg: is not a key"),
        ("roll_deg = 5", "roll_deg = \"5\"", "i.toml:8: roll_deg: is a string"),
    ] {
        let message =
            NavigationRow::parse("i.toml", &INITIAL.replace(from, to)).expect_err(to).to_string();
        assert!(message.starts_with(start), "{message}");
    }
    let folder = scratch();
    let message =
        NavigationRow::read(text(&folder.path().join("none.toml"))).expect_err("none").to_string();
    assert!(message.contains("none.toml: cannot be read"), "{message}");
}
