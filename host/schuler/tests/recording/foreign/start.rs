//! A replay that starts where a file of positions says.

use super::super::replay::{apart, program, rows};
use super::{scratch, text};
use std::fs;

#[test]
fn positions_say_where_an_alignment_is() {
    let folder = scratch();
    let at = |name: &str| folder.path().join(name);
    let [imu, pos, out] = ["imu.csv", "a.pos", "nav.csv"].map(at);
    let emulate =
        ["emulate", "stationary", "--duration", "20", "--rate", "50", "--out", text(&imu)];
    program(&emulate).unwrap_or_else(|e| panic!("{e}"));
    let header = "% GPST latitude(deg) longitude(deg) height(m) Q ns sdn(m) sde(m) sdu(m)\n";
    let row = "2329 0 45 100 1000 1 9 0.01 0.01 0.02 0 0 0\n";
    fs::write(&pos, format!("{header}{row}")).expect("the disk has room");
    let line = ["replay", "--imu", text(&imu), "--initial", text(&pos), "--out", text(&out)];
    let error = program(&line).expect_err("nothing tells the attitude");
    assert!(
        error.contains("--initial: holds positions and no attitude") && error.contains("--align"),
        "{error}"
    );
    program(&[&line[..], &["--align", "10"]].concat()).unwrap_or_else(|e| panic!("{e}"));
    let nav = rows(&out);
    assert!(nav.len() == 500 && apart(&nav[0], &[0.0, 45.0, 100.0, 1000.0]) < 1e-6);
    let [.., roll, pitch, yaw] = nav[0][..] else { panic!("{:?}", nav[0]) };
    assert!((roll - 3.0).hypot(pitch + 7.0).hypot(yaw - 40.0) < 1e-3, "{roll} {pitch} {yaw}");
    // Another place contradicts the Earth's rate.
    fs::write(&pos, format!("{header}{}", row.replace(" 45 ", " -45 ")))
        .expect("the disk has room");
    let error =
        program(&[&line[..], &["--align", "10"]].concat()).expect_err("it is the other hemisphere");
    assert!(error.contains("latitude"), "{error}");
}
