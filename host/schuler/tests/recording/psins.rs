//! The PSINS format on a small file made here.

use super::{at_rest, even, near, read, scratch, text};
use schuler_simulator::recording::rows::Recording;
use schuler_simulator::recording::samples::Sample;
use std::f64::consts::PI;

const HEAD: &str = "% a comment\n%another\n\n\
    1.5 -2.5 -90.6 3 4 5\n\
    34.25 108.5 380 10 10 9.78\n\
    0.1 0.2 0.4 125 250 500 \n";
const COUNTS: &str = "1 2 3 4 5 80\n-1 0 7 0 0 81\n0 0 0 0 0 79\n";

#[test]
fn settings_scales_and_axes() {
    let read = read("car.imu", &format!("{HEAD}{COUNTS}"), None, None);
    let (survey, samples, recording) = read.unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((recording.name.as_str(), samples.len()), ("car.imu", 3));
    assert_eq!(recording.interval_s, Some(0.01));
    assert_eq!(survey.clock.interval_s(), 0.01);
    let times: Vec<_> = samples.iter().map(|s| s.time_s).collect();
    assert_eq!(times, [10.01, 10.02, 10.03]);
    near(survey.start_s, 10.0, 1e-12);
    assert_eq!(samples[0].line, 7);

    let initial = recording.initial.expect("the file brings it");
    assert_eq!(initial.time_s, 10.0);
    near(initial.attitude.pitch.to_degrees(), 1.5, 1e-14);
    near(initial.attitude.roll.to_degrees(), -2.5, 1e-14);
    near(initial.attitude.yaw.to_degrees(), 90.6, 1e-13);
    assert_eq!(initial.velocity_ned.into_array(), [4.0, 3.0, -5.0]);
    near(initial.position.latitude.to_degrees(), 34.25, 1e-13);
    near(initial.position.longitude.to_degrees(), 108.5, 1e-13);
    assert_eq!(initial.position.altitude, 380.0);

    // Right, forward, up counts 1 2 3 and 4 5 80; the file's µg is 9.78e-6 m/s².
    let arcsec = PI / 648_000.0;
    let first = samples[0].increment;
    near(first.angle_b.x, 0.4 * arcsec, 1e-20);
    near(first.angle_b.y, 0.1 * arcsec, 1e-20);
    near(first.angle_b.z, -1.2 * arcsec, 1e-20);
    near(first.velocity_b.x, 5.0 * 250.0 * 9.78e-6, 1e-16);
    near(first.velocity_b.y, 4.0 * 125.0 * 9.78e-6, 1e-16);
    near(first.velocity_b.z, -80.0 * 500.0 * 9.78e-6, 1e-14);
}

#[test]
fn it_is_known_by_its_content() {
    let folder = scratch();
    let bare = HEAD.trim_start_matches(|c| c != '1');
    for name in ["car.imu", "car.txt"] {
        for head in [bare, HEAD] {
            let path = folder.path().join(name);
            std::fs::write(&path, format!("{head}{COUNTS}")).expect("the disk has room");
            let recording = Recording::open(text(&path)).unwrap_or_else(|e| panic!("{e}"));
            assert!(recording.initial.is_some(), "{name}");
        }
    }
    // Neither the name nor a comment makes it one.
    let other = format!("% a comment\n{}", at_rest(0.0, &even(0.0, 100.0, 50), |t| t.to_string()));
    let recording = Recording::of_text("car.imu", &other).unwrap_or_else(|e| panic!("{e}"));
    assert!(recording.initial.is_none() && recording.interval_s.is_none());
}

#[test]
fn errors_name_file_line_and_column() {
    let whole = format!("{HEAD}{COUNTS}");
    let cases = [
        (whole.replace("-1 0 7 0 0 81", "-1 0 x 0 0 81"), "car.imu:8: dtheta_up: \"x\"", "counts"),
        (whole.replace("-1 0 7 0 0 81", "-1 0 7 0 nan 81"), "car.imu:8: dvel_forward: ", "counts"),
        (
            whole.replace("-1 0 7 0 0 81", "-1 0 7 0 0"),
            "car.imu:8: the row has 5 values",
            "6: dtheta_right",
        ),
        (whole.replace("-1 0 7 0 0 81", "-1 0 7 0 0 81 4"), "car.imu:8: the row has 7 values", "6"),
        (whole.replace("34.25", "134.25"), "car.imu:5: latitude: 134.25", "-90 to 90"),
        (whole.replace("10 10 9.78", "10 0 9.78"), "car.imu:5: interval: 0 ", "milliseconds"),
        (whole.replace("10 10 9.78", "10 10 980"), "car.imu:5: g: 980 ", "m/s²"),
        (whole.replace("0.1 0.2 0.4", "0.1 0 0.4"), "car.imu:6: gyro_forward: 0 ", "above 0"),
        (
            HEAD.replace("0.1 0.2 0.4 125 250 500 \n", ""),
            "car.imu: ends within its settings",
            "gyro_right",
        ),
        (HEAD.to_owned(), "car.imu: has 0 samples", "two samples"),
        (String::new(), "car.imu: is empty", "time_s"),
    ];
    for (text, start, words) in cases {
        let told = |samples: Vec<Sample>| samples.into_iter().flat_map(|s| s.unread).next();
        let error = match read("car.imu", &text, None, None) {
            Ok((_, samples, _)) => told(samples).expect(start).error,
            Err(error) => error,
        };
        let message = error.to_string();
        assert!(message.starts_with(start), "{message}\nnot {start}");
        assert!(message.contains(words), "{message}\nwithout {words}");
    }
}
