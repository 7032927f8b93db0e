//! Fixes of receivers, on the time of a recording.

use super::{FROM, apart, at, ended, norm, rows, schuler};
use schuler_simulator::recording::instant::{GPS_EPOCH_S, Scale};
use std::fs;
use std::path::Path;

/// The fixes as RTKLIB writes them, at so much later a time, s since 1970 in GPS time.
fn pos(gnss: &Path, later_s: f64) -> String {
    let mut text = "%  GPST latitude(deg) longitude(deg) height(m) Q ns sdn(m) sde(m) sdu(m) sdne(m) sdeu(m) sdun(m) \
                    age(s) ratio vn(m/s) ve(m/s) vu(m/s) sdvn sdve sdvu sdvne sdveu sdvun\n"
        .to_owned();
    for row in rows(gnss) {
        let gps_s = row[0] + later_s - GPS_EPOCH_S as f64;
        let (week, seconds) = ((gps_s / 604_800.0).floor(), gps_s.rem_euclid(604_800.0));
        text += &format!(
            "{week} {seconds} {} {} {} 1 9 {} {} {} 0 0 0 0 0 {} {} {} {} {} {} 0 0 0\n",
            row[3],
            row[4],
            row[5],
            row[10],
            row[11],
            row[12],
            row[6],
            row[7],
            -row[8],
            row[13],
            row[14],
            row[15]
        );
    }
    text
}

#[test]
fn a_receivers_file_is_brought_to_the_recordings_time() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    schuler(folder, "emulate aided-drive --duration 30 --out imu.csv --gnss gnss.csv");
    schuler(folder, &format!("replay {FROM} --gnss gnss.csv --out nav.csv"));
    let later_s = 1_752_003_261.854;
    fs::write(folder.join("fixes.pos"), pos(&folder.join("gnss.csv"), later_s)).unwrap();
    // The same by a number.
    let lag_s = Scale::Gps.to(Scale::Utc, later_s - GPS_EPOCH_S as f64);
    schuler(folder, &format!("replay {FROM} --gnss fixes.pos --gnss-lag {lag_s} --out lag.csv"));
    // The same by tags of the stream as it was before it lost a byte in each line: one tag for each row.
    let imu = fs::read_to_string(folder.join("imu.csv")).unwrap();
    let mut tags = b"TIMETAG RTKLIB".to_vec();
    tags.resize(64, 0);
    tags.extend((later_s.floor() as u32).to_le_bytes());
    tags.extend(later_s.fract().to_le_bytes());
    let mut bytes = 0;
    for (n, line) in imu.lines().enumerate() {
        bytes += line.len() as u32 + 2;
        tags.extend((10 * n as u32).to_le_bytes());
        tags.extend(bytes.to_le_bytes());
    }
    fs::write(folder.join("imu.tag"), &tags).unwrap();
    let said = schuler(
        folder,
        &format!("replay {FROM} --gnss fixes.pos --time-tag imu.tag --out tag.csv"),
    );
    assert!(said.contains("by 3000 tags"), "{said}");
    let nav = rows(&folder.join("nav.csv"));
    for other in ["lag.csv", "tag.csv"] {
        let rows = rows(&folder.join(other));
        assert_eq!(rows.len(), nav.len());
        for (a, b) in nav.iter().zip(&rows) {
            // A microsecond of 46 m/s.
            assert!(norm(apart(a, b)) < 1e-4, "{other}: {a:?} {b:?}");
        }
    }
    // Without either it is another time.
    let (code, _, errors) = ended(folder, &format!("replay {FROM} --gnss fixes.pos --out no.csv"));
    assert!(code != Some(0) && errors.contains("--gnss-lag"), "{errors}");
}

#[test]
fn the_first_velocity_starts_it() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    schuler(
        folder,
        "emulate aided-drive --duration 120 --out imu.csv --gnss gnss.csv --truth truth.csv",
    );
    // Nothing is said of the sensors: those of a MEMS unit, as they are printed.
    let said = schuler(
        folder,
        "replay --imu imu.csv --gnss gnss.csv --lever-arm 0.5,-0.3,-1 --out nav.csv --every 1s",
    );
    assert!(said.contains("heading") && said.contains("by the velocity"), "{said}");
    assert!(said.contains("turn_on_bias_deg_h = 1000"), "{said}");
    let (nav, truth) = (rows(&folder.join("nav.csv")), rows(&folder.join("truth.csv")));
    let row = at(&nav, 100.0);
    let true_row = at(&truth, 100.0);
    let off = apart(true_row, row);
    for (error, sigma) in off.into_iter().zip(&row[10..13]) {
        assert!(error.abs() < 4.0 * sigma && *sigma < 2.0, "{off:?} {row:?}");
    }
    let heading = (row[9] - true_row[9] + 540.0).rem_euclid(360.0) - 180.0;
    assert!(heading.abs() * 3600.0 < 4.0 * row[18], "{heading}° {row:?}");
}

#[test]
fn samples_at_times_of_their_own_are_cut() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    schuler(
        folder,
        "emulate aided-drive --duration 60 --out imu.csv --gnss gnss.csv --truth truth.csv",
    );
    // Every third sample lasts longer, and holds what falls into it.
    let imu = rows(&folder.join("imu.csv"));
    let mut text =
        fs::read_to_string(folder.join("imu.csv")).unwrap().lines().next().unwrap().to_owned()
            + "\n";
    for three in imu.chunks_exact(3) {
        let joined = (1..7).map(|i| three[0][i] + three[1][i]);
        let joined: Vec<_> = joined.map(|x| x.to_string()).collect();
        text += &format!("{},{}\n", three[1][0], joined.join(","));
        let last: Vec<_> = three[2].iter().map(f64::to_string).collect();
        text += &(last.join(",") + "\n");
    }
    fs::write(folder.join("uneven.csv"), text).unwrap();
    // Nothing tells where its first sample begins: a fix does for the start.
    let from = "--sensors aided-drive --gnss gnss.csv";
    let said = schuler(folder, &format!("replay --imu uneven.csv {from} --out nav.csv"));
    assert!(said.contains("samples at times of their own are cut to 67 Hz"), "{said}");
    assert!(said.contains(" 0 refused"), "{said}");
    let (cut, truth) = (rows(&folder.join("nav.csv")), rows(&folder.join("truth.csv")));
    let last = &cut[cut.len() - 2];
    let off = |row: &&Vec<f64>| (row[0] - last[0]).abs();
    let other = truth.iter().min_by(|a, b| off(a).total_cmp(&off(b))).unwrap();
    let time_s = last[0] - other[0];
    assert!(last[0] > 59.9 && time_s.abs() <= 0.0051, "{last:?} {other:?}");
    let apart = apart(other, last);
    for i in 0..3 {
        let moved = other[4 + i] * time_s;
        let (error, sigma) = (apart[i] - moved, last[10 + i]);
        assert!(error.abs() < 4.0 * sigma && sigma < 1.0, "{apart:?} {last:?} {other:?}");
        let (error, sigma) = (last[4 + i] - other[4 + i], last[13 + i]);
        assert!(error.abs() < 4.0 * sigma + 0.05 && sigma < 0.2, "{last:?} {other:?}");
    }
}

#[test]
fn late_velocities_are_taken_at_their_time_or_left_out() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    schuler(folder, "emulate aided-drive --duration 60 --out imu.csv --gnss gnss.csv");
    let nav = |options: &str| {
        let said = schuler(folder, &format!("replay {FROM} {options} --out nav.csv"));
        (said, rows(&folder.join("nav.csv")))
    };
    let (_, own) = nav("--gnss gnss.csv");
    // Velocities in rows of their own, with stamps that are half a second late.
    let gnss = fs::read_to_string(folder.join("gnss.csv")).unwrap();
    let mut lines: Vec<String> = gnss.lines().map(str::to_owned).collect();
    let header = lines.remove(0);
    let mut text = header + "\n";
    for line in &lines {
        let mut place: Vec<_> = line.split(',').collect();
        let mut moves = place.clone();
        let late = (place[0].parse::<f64>().unwrap() + 0.5).to_string();
        (moves[0], moves[1], moves[2]) = (&late, &late, "velocity");
        for i in [3, 4, 5, 10, 11, 12] {
            moves[i] = "";
        }
        place[2] = "position";
        for i in [6, 7, 8, 13, 14, 15] {
            place[i] = "";
        }
        text += &(place.join(",") + "\n" + &moves.join(",") + "\n");
    }
    fs::write(folder.join("late.csv"), text).unwrap();
    let (said, late) = nav("--gnss late.csv --velocity-lag 0.5");
    assert!(said.contains("gnss: 119 taken, 0 refused"), "{said}");
    let (ours, other) = (&own[own.len() - 2], at(&late, own[own.len() - 2][0]));
    // The same measurements, in two vectors for one; the last velocity comes after the end.
    assert!(norm(apart(ours, other)) < 1e-3, "{ours:?} {other:?}");
    let (said, without) = nav("--gnss gnss.csv --velocity-lag off");
    assert!(said.contains("gnss: 60 taken"), "{said}");
    let sigma = |rows: &[Vec<f64>]| rows[rows.len() - 2][13];
    assert!(sigma(&without) > 1.5 * sigma(&own), "velocities still count");
}
