//! Alignment as a user meets it: runs of scenes against theory and themselves, and a recording of them.

use schuler_simulator::alignment::outcome::{self, Outcome};
use schuler_simulator::alignment::setup::Setup;
use schuler_simulator::alignment::spread::Spread;
use schuler_simulator::ensemble::fleet;
use schuler_simulator::ensemble::group::{Ground, Unit};
use schuler_simulator::scene::{Alignment, Base, Scene, builtin};
use schuler_simulator::simulate::Simulation;
use schuler_simulator::source::Source;
use schuler_simulator::units::DEGREE;
use std::fs;
use std::path::Path;
use std::process::Command;

fn schuler(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
    let done = command.current_dir(folder).args(arguments).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (done.status.code(), text(&done.stdout), text(&done.stderr))
}

/// Runs of a scene for a time, from a heading that is off by an angle if one is given, rad.
fn spread(scene: &Scene, seconds: f64, runs: u64, off: Option<f64>) -> Spread {
    let source = Source::new(scene, false).unwrap();
    let own = scene.alignment.unwrap_or(Alignment::new(seconds));
    let known = own.heading_sigma_rad.filter(|_| off.is_none());
    let alignment = Alignment { duration_s: seconds, heading_sigma_rad: known, ..own };
    let setup = Setup::new(scene, &source, alignment).unwrap();
    let one = |run| outcome::of_run(&setup, &source, run, off).unwrap();
    let outcomes: Vec<Outcome> = (0..runs).map(one).collect();
    Spread::new(&setup, &outcomes)
}

/// Errors are what the filter says, and what it says is what theory allows to within a share.
#[track_caller]
fn is_consistent(spread: &Spread, share: f64) {
    let claimed = spread.claimed.unwrap();
    // χ² of 3n degrees of freedom: its mean scatters by √(2/3n); four of them.
    let slack = 4.0 * (2.0 / (3.0 * spread.runs as f64)).sqrt();
    assert!((claimed.nees - 1.0).abs() < slack, "NEES {} ± {slack}", claimed.nees);
    for axis in &spread.axes {
        let Some(limit) = axis.limit else { continue };
        let ratio = axis.sigma.unwrap() / limit;
        assert!((0.99..1.0 + share).contains(&ratio), "{ratio} of theory");
    }
}

#[test]
fn a_standing_vehicle_reaches_theory_from_any_heading() {
    let scene = builtin::scene("align-still").unwrap();
    is_consistent(&spread(&scene, 120.0, 40, None), 0.08);
    is_consistent(&spread(&scene, 300.0, 40, Some(180.0 * DEGREE)), 0.10);
}

#[test]
fn a_turning_vehicle_and_a_swaying_one_find_north() {
    let turning = spread(&builtin::scene("align-turn").unwrap(), 300.0, 30, None);
    is_consistent(&turning, 0.08);
    // Its biases show: level is known twenty times better than at rest.
    assert!(turning.axes[0].sigma.unwrap() < 0.012 / 60.0 * DEGREE);
    let swaying = spread(&builtin::scene("align-sway").unwrap(), 120.0, 16, None);
    is_consistent(&swaying, 0.0);
    assert!(swaying.axes[2].sigma.unwrap() < 7.0 / 60.0 * DEGREE);
}

/// A vehicle that drives in curves, of whose heading nothing is known.
const UNDER_WAY: &str = r#"
duration_s = 120
rate_hz = 50
[trajectory]
yaw_deg = { offset = 150, harmonics = [{ amplitude = 60, period_s = 80 }] }
latitude_deg = 45
north_m = { harmonics = [{ amplitude = 300, period_s = 90 }] }
east_m = { harmonics = [{ amplitude = 400, period_s = 120 }] }
[gyro]
turn_on_bias_deg_h = 0.01
angle_random_walk_deg_sqrt_h = 0.002
[accelerometer]
turn_on_bias_ug = 50
noise_density_ug_sqrt_hz = 10
[alignment]
duration_s = 60
base = "moving"
"#;

#[test]
fn a_vehicle_under_way_finds_its_heading_by_its_velocity() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("way.toml");
    fs::write(&file, UNDER_WAY).unwrap();
    let scene = schuler_simulator::scene::load(file.to_str().unwrap()).unwrap();
    assert_eq!(scene.alignment.unwrap().base, Base::Moving);
    let found = spread(&scene, 60.0, 24, None);
    is_consistent(&found, 0.0);
    assert!(found.axes[2].rms < 0.15 * DEGREE, "{}", found.axes[2].rms / DEGREE);
    // At a constant velocity nothing shows it.
    let steady = UNDER_WAY.replace("harmonics = [{ amplitude = 300, period_s = 90 }]", "rate = 20");
    let steady = steady.replace("harmonics = [{ amplitude = 400, period_s = 120 }]", "rate = 5");
    fs::write(&file, steady).unwrap();
    let (code, _, said) = schuler(folder.path(), &["align", "way.toml"]);
    assert!(code == Some(1) && said.contains("no heading is seen"), "{said}");
    assert!(said.contains("accepted: a longer --for"), "{said}");
}

#[test]
fn a_run_begins_where_its_alignment_ends_alone_as_in_an_ensemble() {
    let mut scene = builtin::scene("align-still").unwrap();
    scene.duration_s = 90.0;
    scene.alignment = Some(Alignment { duration_s: 60.0, ..scene.alignment.unwrap() });
    let source = Source::new(&scene, false).unwrap();
    let ground = Ground::new(&scene, &source);
    let flown = fleet::fly(&ground, 3, Unit::Alone, 2, 3, &|_| {}).unwrap();
    let end = flown.readings.last().unwrap();
    for run in 0..3 {
        let mut first = None;
        let mut rows = 0;
        let simulation = Simulation::of_run(&scene, false, run).unwrap();
        let mut row = |instant: &schuler_simulator::flight::Instant| {
            first.get_or_insert(instant.time_s);
            rows += 1;
            Ok(())
        };
        let flight = simulation.fly(&mut row, &|_| {}).unwrap();
        assert_eq!((first, rows), (Some(60.0), 601), "a row for each sample from its end on");
        let outcome = flight.aligned.unwrap();
        assert_eq!(outcome.samples, 1200);
        let alone = flight.last.drift.position_m;
        let together = end.drifts[run as usize].position_ned.into_array();
        assert_eq!(alone, together, "run {run}");
        // A heading that is off by ε drifts little in half a minute at rest.
        assert!(alone.iter().all(|x| x.abs() < 1.0) && alone != [0.0; 3], "{alone:?}");
    }
}

#[test]
fn a_recording_of_the_scene_is_aligned_as_well_as_it_says() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let emulate = ["emulate", "align-still", "--duration", "400", "--out", "imu.csv"];
    assert_eq!(schuler(folder, &emulate).0, Some(0));
    let initial = "time_s = 0\nlatitude_deg = 45\nlongitude_deg = 100\naltitude_m = 1000\nnorth_m_s = 0\n\
        east_m_s = 0\ndown_m_s = 0\nroll_deg = 0\npitch_deg = 0\nyaw_deg = 0\n";
    fs::write(folder.join("place.toml"), initial).unwrap();
    let align = |method: &str| {
        let options = ["align", "--imu", "imu.csv", "--initial", "place.toml", "--for", "300"];
        let (code, out, said) =
            schuler(folder, &[&options[..], &["--method", method, "--out", "a.toml"]].concat());
        assert_eq!(code, Some(0), "{method}: {said}");
        let text = fs::read_to_string(folder.join("a.toml")).unwrap();
        let yaw = text.lines().find_map(|line| line.strip_prefix("yaw_deg = ")).unwrap();
        (yaw.parse::<f64>().unwrap(), out)
    };
    let (fine, out) = align("auto");
    assert!(out.contains("\nfine: roll "), "{out}");
    assert!((fine - 40.0).abs() < 0.25, "{fine}");
    for method in ["two-vector", "inertial"] {
        let (heading, out) = align(method);
        assert!((heading - 40.0).abs() < 0.4, "{method}: {heading}");
        assert!(!out.contains("\nfine: "), "{out}");
    }
}

#[test]
fn what_cannot_be_aligned_says_why() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let says = |arguments: &[&str], code: i32, words: &[&str]| {
        let (ended, _, said) = schuler(folder, arguments);
        assert_eq!(ended, Some(code), "{arguments:?}: {said}");
        for word in words {
            assert!(said.contains(word), "{arguments:?} does not say {word}: {said}");
        }
    };
    says(&["align"], 2, &["nothing to align", "--imu FILE", "a scene"]);
    says(&["align", "polar"], 1, &["no heading within 6° of a pole", "below 84°"]);
    says(&["align", "align-still", "--from", "3"], 2, &["--from", "is of a recording"]);
    says(
        &["align", "align-still", "--for", "5000"],
        2,
        &["alignment.duration_s", "from 0.2 to 1200"],
    );
    says(&["align", "align-still", "--for", "60", "--sigma", "0.1"], 2, &["to 0.1", "--for "]);
    says(&["align", "align-still", "--for", "60", "--sigma", "0.01"], 2, &["no time would do"]);
    // What drives off is not still.
    says(&["align", "circuit"], 1, &["run 0", "it moves more than", "--base swaying or moving"]);
    says(&["hil", "align-still"], 2, &["alignment", "starts from what is known"]);
    let scene = |text: &str| fs::write(folder.join("s.toml"), text).unwrap();
    let still = "duration_s = 60\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\n";
    for (table, words) in [
        ("duration_s = 60", ["alignment.duration_s", "from 0.2 to 59.8"]),
        ("duration_s = 30\nbase = \"afloat\"", ["alignment.base", "swaying"]),
        ("duration_s = 30\nsway_rms_m = 1", ["alignment.sway_rms_m", "base = \"swaying\""]),
        ("duration_s = 30\nheading_sigma_deg = 90", ["alignment.heading_sigma_deg", "at most 60"]),
        ("base = \"still\"", ["alignment.duration_s", "is missing"]),
    ] {
        scene(&format!("{still}[alignment]\n{table}\n"));
        says(&["run", "s.toml"], 2, &words);
    }
    scene(&format!("{still}[alignment]\nduration_s = 30\n[link]\nloss = 0.1\n"));
    says(&["run", "s.toml"], 2, &["link.loss", "needs all of them"]);
}

#[test]
fn what_is_wrong_is_told_in_options_that_align_has() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let emulate = ["emulate", "align-still", "--duration", "310", "--out", "imu.csv"];
    assert_eq!(schuler(folder, &emulate).0, Some(0));
    let initial = "time_s = 0\nlatitude_deg = 45\nlongitude_deg = 100\naltitude_m = 1000\nnorth_m_s = 0\n\
        east_m_s = 0\ndown_m_s = 0\nroll_deg = 0\npitch_deg = 0\nyaw_deg = 0\n";
    fs::write(folder.join("place.toml"), initial).unwrap();
    // Gyros that are off by 80 °/h: 2e-5 rad a sample of 0.05 s.
    let imu = fs::read_to_string(folder.join("imu.csv")).unwrap();
    let biased = imu.lines().enumerate().map(|(i, line)| {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        if i > 0 {
            cells[1] = (cells[1].parse::<f64>().unwrap() + 2e-5).to_string();
        }
        cells.join(",") + "\n"
    });
    fs::write(folder.join("biased.csv"), biased.collect::<String>()).unwrap();
    let (_, help, _) = schuler(folder, &["align", "--help"]);
    let begin = ["align", "--imu"];
    for (arguments, told) in [
        (&["imu.csv"][..], "--initial: is missing"),
        (
            &["imu.csv", "--initial", "place.toml", "--from", "-5", "--for", "10"],
            "--from: alignment would begin at -5 s",
        ),
        (
            &["imu.csv", "--initial", "place.toml", "--from", "1840"],
            "--from: alignment would begin at 1840 s",
        ),
        (
            &["imu.csv", "--initial", "place.toml", "--for", "400"],
            "--for: alignment would end at 400 s",
        ),
        (&["imu.csv", "--sigma", "0"], "accepted: degrees, above 0"),
        (&["biased.csv", "--initial", "place.toml"], "accepted: gyros of smaller errors"),
    ] {
        let (code, _, said) = schuler(folder, &[&begin[..], arguments].concat());
        assert!(code == Some(2) && said.contains(told), "{told}: {said}");
        // Of options, `align` names its own; what it says of another command is said to be one.
        let own = said.split("`schuler replay`").next().unwrap();
        for option in own.split(|c: char| !c.is_ascii_lowercase() && c != '-') {
            let is_option = option.starts_with("--");
            assert!(!is_option || option == "--help" || help.contains(option), "{option}: {said}");
        }
    }
    // Line 50 is the sample before the one that is missed.
    let holed: Vec<_> =
        imu.lines().enumerate().filter(|(i, _)| *i != 50).map(|(_, line)| line).collect();
    fs::write(folder.join("holed.csv"), holed.join("\n")).unwrap();
    let (code, _, said) =
        schuler(folder, &["align", "--imu", "holed.csv", "--initial", "place.toml"]);
    let told = "holed.csv:51: 1 sample is missing before this one";
    assert!(code == Some(1) && said.contains(told), "{said}");
    let (code, _, said) = schuler(folder, &["align"]);
    assert!(code == Some(2) && said.contains("--imu FILE") && said.contains("a scene"), "{said}");
}
