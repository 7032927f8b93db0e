//! Recordings that are flown with fixes: `emulate --gnss` and `replay --gnss`.

use schuler_simulator::recording::instant::{GPS_EPOCH_S, Scale};
use std::fs;
use std::path::Path;
use std::process::Command;

/// What a command that succeeds prints.
#[track_caller]
fn schuler(folder: &Path, line: &str) -> String {
    let (code, out, errors) = ended(folder, line);
    assert_eq!(code, Some(0), "{line}\n{errors}");
    out
}

fn ended(folder: &Path, line: &str) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
    let done = command.current_dir(folder).args(line.split_ascii_whitespace()).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (done.status.code(), text(&done.stdout), text(&done.stderr))
}

/// The rows of a CSV file of numbers; what is none is not a number.
fn rows(path: &Path) -> Vec<Vec<f64>> {
    let text = fs::read_to_string(path).unwrap();
    let row = |line: &str| line.split(',').map(|x| x.parse().unwrap_or(f64::NAN)).collect();
    text.lines().skip(1).map(row).collect()
}

/// From the first place to the second, north, east, down, m.
fn apart(from: &[f64], to: &[f64]) -> [f64; 3] {
    let north = (to[1] - from[1]).to_radians() * 6.37e6;
    let east = (to[2] - from[2]).to_radians() * 6.39e6 * from[1].to_radians().cos();
    [north, east, from[3] - to[3]]
}

fn norm(v: [f64; 3]) -> f64 {
    v.into_iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The row of a time.
fn at(rows: &[Vec<f64>], time_s: f64) -> &[f64] {
    rows.iter().find(|row| (row[0] - time_s).abs() < 1e-6).unwrap()
}

/// The rows of a file in the opposite order.
fn reversed(text: &str) -> String {
    let mut lines: Vec<_> = text.lines().collect();
    lines[1..].reverse();
    lines.join("\n") + "\n"
}

const FROM: &str = "--imu imu.csv --sensors aided-drive --initial initial.toml";

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
