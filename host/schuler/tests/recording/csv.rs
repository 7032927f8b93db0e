//! `imu.csv`: round trips, gaps, and errors that name line and column.

use super::{WHOLE, good, near, read, scratch, text};
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler_simulator::recording::csv::{INCREMENTS, RATES};
use schuler_simulator::recording::rows::Recording;
use schuler_simulator::recording::samples::{Sample, Samples};
use schuler_simulator::recording::survey::Survey;
use schuler_simulator::recording::writer::ImuWriter;

/// A file of increments at some times, after the header.
fn file(times: &[f64]) -> String {
    let rows = times.iter().map(|t| format!("{t},1e-3,2e-3,3e-3,0.1,0.2,0.3\n"));
    format!("{}\n{}", INCREMENTS.join(","), rows.collect::<String>())
}

#[test]
fn headers_are_the_agreed_ones() {
    assert_eq!(
        INCREMENTS.join(","),
        "time_s,dtheta_x_rad,dtheta_y_rad,dtheta_z_rad,dvel_x_m_s,dvel_y_m_s,dvel_z_m_s"
    );
    assert_eq!(
        RATES.join(","),
        "time_s,gyro_x_rad_s,gyro_y_rad_s,gyro_z_rad_s,accel_x_m_s2,accel_y_m_s2,accel_z_m_s2"
    );
}

#[test]
fn what_is_written_reads_back_bit_for_bit() {
    let folder = scratch();
    let path = folder.path().join("imu.csv");
    let increment = |i: u32| {
        // Awkward numbers: tiny, huge, negative, and every digit in use.
        let x = f64::from(i).sin();
        let angle_b = Vector::new(x * 1e-300, -x / 3.0, x * 1e-7);
        Increment { angle_b, velocity_b: Vector::new(f64::from(i), 0.1 + x, -x * 1e200) }
    };
    let mut writer = ImuWriter::increments(&path).expect("the folder is there");
    for i in 1..=100 {
        writer.increment(f64::from(i) / 30.0, &increment(i)).expect("the disk has room");
    }
    writer.finish().expect("the disk has room");
    let recording = Recording::open(text(&path)).unwrap_or_else(|e| panic!("{e}"));
    let survey = Survey::of(&recording, None, WHOLE).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((survey.rows, survey.clock.interval_s()), (100, 1.0 / 30.0));
    assert_eq!(recording.initial, None);
    near(survey.start_s, 0.0, 1e-9);
    let mut samples = Samples::new(&recording, &survey, None).expect("it is there");
    for i in 1..=100 {
        let sample = samples.advance().expect("it is there").expect("one for each");
        assert_eq!(sample.time_s, f64::from(i) / 30.0);
        assert_eq!(sample.line, u64::from(i) + 1);
        assert_eq!(sample.increment, increment(i));
        assert!(!sample.filled);
    }
    assert_eq!(samples.advance(), Ok(None));
}

#[test]
fn gaps_are_told_from_jitter() {
    // 20 Hz with jitter of a fifth, two samples lost after the fourth.
    let times = [0.05, 0.1, 0.16, 0.2, 0.35, 0.4, 0.45, 0.49, 0.55, 0.6, 0.65, 0.7];
    let (survey, samples) = good(&file(&times), None);
    near(survey.clock.interval_s(), 0.05, 1e-3);
    let filled: Vec<_> = samples.iter().filter(|sample| sample.filled).collect();
    let [first, second] = filled[..] else { panic!("{filled:?}") };
    near(first.time_s, 0.25, 1e-12);
    near(second.time_s, 0.30, 1e-12);
    assert_eq!((first.line, first.missing), (6, 2));
    near(first.interval_s, 0.05, 1e-12);
}

#[test]
fn the_interval_is_exact_far_from_zero() {
    // 100 Hz, where a step of time has lost four digits.
    let times: Vec<_> = (0..500).map(|i| 432_000.0 + f64::from(i) / 100.0).collect();
    assert_eq!(good(&file(&times), None).0.clock.interval_s(), 0.01);
}

#[test]
fn line_ends_spaces_and_blank_lines_are_no_matter() {
    let text = file(&[0.1, 0.2, 0.3]).replace('\n', "\r\n").replace(",0.1,", ", 0.1 ,");
    // As spreadsheets write it: with a byte order mark, and quotes.
    let text = format!("\u{feff}{text}\r\n").replace(",0.2,", ",\"0.2\",");
    let (_, samples) = good(&text, None);
    assert_eq!(samples.len(), 3);
    let velocity = samples[2].increment.velocity_b;
    assert_eq!((velocity.x, velocity.y), (0.1, 0.2));
}

#[test]
fn errors_name_file_line_and_column() {
    let good = file(&(1..=120).map(|i| f64::from(i) / 20.0).collect::<Vec<_>>());
    // Row 100, counted from 0 after the header, is line 102.
    type Change = dyn Fn(&mut Vec<&str>);
    let with = |change: &Change| {
        let mut lines: Vec<_> = good.lines().map(str::to_owned).collect();
        let line = lines[101].clone();
        let mut fields = line.split(',').collect();
        change(&mut fields);
        lines[101] = fields.join(",");
        lines.join("\n") + "\n"
    };
    let cases = [
        (with(&|row| row[1] = "nan"), "bad.csv:102: dtheta_x_rad: ", "finite number"),
        (with(&|row| row[6] = "inf"), "bad.csv:102: dvel_z_m_s: ", "finite number"),
        (with(&|row| row[3] = "1,5"), "bad.csv:102: the row has 8 values", "accepted: 7"),
        (with(&|row| row[2] = ""), "bad.csv:102: dtheta_y_rad: ", "\"\""),
        (with(&|row| row[2] = "fast"), "bad.csv:102: dtheta_y_rad: ", "\"fast\""),
        (with(&|row| row[0] = "-1"), "bad.csv:102: time_s: -1 is not after 5", "increase"),
        (with(&|row| row.truncate(6)), "bad.csv:102: the row has 6 values", "accepted: 7"),
        (good.replace("dtheta_x", "theta_x"), "bad.csv:1: the header", "gyro_x_rad_s"),
        (good.lines().skip(1).collect::<Vec<_>>().join("\n"), "bad.csv:1: the header", "time_s,dt"),
        (String::new(), "bad.csv: is empty", "time_s,dtheta_x_rad"),
        (file(&[]), "bad.csv: has 0 samples", "two samples or more"),
        (file(&[1.0]), "bad.csv: has 1 samples", "two samples or more"),
        (file(&[1.0, 2.5, 4.0]), "bad.csv: has samples of 1.5 s", "at most 1 s"),
    ];
    for (text, start, words) in cases {
        // What is wrong in a line is told with the samples, as it may not matter.
        let told = |samples: Vec<Sample>| samples.into_iter().flat_map(|s| s.unread).next();
        let error = match read("bad.csv", &text, None, None) {
            Ok((_, samples, _)) => told(samples).expect(start).error,
            Err(error) => error,
        };
        let message = error.to_string();
        assert!(message.starts_with(start), "{message}\nnot {start}");
        assert!(message.contains(words), "{message}\nwithout {words}");
    }
}

#[test]
fn errors_about_a_sample_name_its_line() {
    let text = file(&[0.1, 0.2, 0.3]).replace("0.2,1e-3", "\n\n0.2,1e-3");
    let (_, samples, recording) = read("imu.csv", &text, None, None).expect("it is right");
    let complaint = schuler_simulator::input::Complaint::new("is too much", "less");
    let message = recording.error(samples[1].line, complaint).to_string();
    assert_eq!(message, "imu.csv:5: is too much; accepted: less");
}

#[test]
fn a_file_without_lines_is_no_recording() {
    let text = file(&[0.1, 0.2]) + &"1".repeat(1 << 17);
    let message = read("imu.csv", &text, None, None).expect_err("it is too long").to_string();
    assert_eq!(message, "imu.csv:4: the line is longer than 65536 bytes");
}
