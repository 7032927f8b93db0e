//! Aided scenes as a user meets them: errors and what the filter says, faults of the measurements, refusals.

use schuler_simulator::aided::runs::{self, Run, Scenes, Together};
use schuler_simulator::scene::{Precision, Scene, builtin};
use schuler_simulator::simulate::Simulation;
use schuler_simulator::source::Source;
use std::fs;
use std::path::Path;
use std::process::Command;

fn schuler(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
    let done = command.current_dir(folder).args(arguments).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (done.status.code(), text(&done.stdout), text(&done.stderr))
}

fn drive(seconds: f64) -> Scene {
    Scene { duration_s: seconds, ..builtin::scene("aided-drive").unwrap() }
}

fn flown(scene: &Scene, count: u64, stops: &[u64]) -> Vec<Run> {
    let source = Source::new(scene, false).unwrap();
    (0..count).map(|run| runs::fly(Scenes::of(scene, &source), run, stops).unwrap()).collect()
}

fn together(runs: &[Run]) -> Vec<Together> {
    runs::together(runs, 100.0)
}

/// The root of the mean square error of the position.
fn position(one: &Together) -> f64 {
    one.rms[..3].iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[track_caller]
fn is_consistent(one: &Together, count: usize) {
    // χ² of 9n degrees of freedom: its mean scatters by √(2/9n); four of them.
    let slack = 4.0 * (2.0 / (9.0 * count as f64)).sqrt();
    assert!(
        (one.nees[0] - 1.0).abs() < slack,
        "NEES {} ± {slack} at {} s",
        one.nees[0],
        one.time_s
    );
}

#[test]
fn errors_are_what_the_filter_says_with_satellites_and_without() {
    let runs = flown(&drive(460.0), 16, &[20_000, 39_900, 46_000]);
    let together = together(&runs);
    together.iter().for_each(|one| is_consistent(one, 16));
    // The optimum is 0.363 m, and 5.4 m after a minute without satellites.
    assert!((0.25..0.48).contains(&position(&together[0])), "{}", position(&together[0]));
    assert!((3.0..8.5).contains(&position(&together[2])), "{}", position(&together[2]));
    let counts = runs::counts(&runs);
    assert_eq!((counts.len(), counts[0].sensor), (1, "gnss"));
    let (nis, [least, most]) = counts[0].consistency().unwrap();
    assert!((least - 0.05..most + 0.05).contains(&nis), "{nis}");
}

#[test]
fn late_measurements_cost_nothing_but_their_age_and_a_horizon_makes_transport_immaterial() {
    let mut late = drive(120.0);
    let at = [11_800];
    let prompt = together(&flown(&late, 12, &at))[0];
    let line = &mut late.aiding.gnss.as_mut().unwrap().line;
    (line.latency_s, line.jitter_s) = (1.0, 0.3);
    let delayed = together(&flown(&late, 12, &at))[0];
    is_consistent(&delayed, 12);
    let said = |one: &Together| one.sigma[..3].iter().map(|x| x * x).sum::<f64>().sqrt();
    assert!(said(&delayed) < 1.1 * said(&prompt), "{} {}", said(&delayed), said(&prompt));
    // Repetition and another jitter change the order of arrival, and with a horizon no bit.
    late.aiding.filter.horizon_s = Some(2.0);
    let waits = flown(&late, 2, &at);
    let line = &mut late.aiding.gnss.as_mut().unwrap().line;
    (line.jitter_s, line.repetition) = (0.0, 0.4);
    let other = flown(&late, 2, &at);
    for (one, two) in waits.iter().zip(&other) {
        assert_eq!(one.reads, two.reads);
        assert!(two.report.again > 10 && one.report.again == 0);
    }
}

#[test]
fn outliers_are_refused_and_a_forged_position_locks_the_receiver_out() {
    let mut scene = drive(300.0);
    let gnss = scene.aiding.gnss.as_mut().unwrap();
    let clean = together(&flown(&drive(300.0), 8, &[29_000]))[0];
    gnss.outliers =
        Some(schuler::sensor::aiding::fault::Outliers { probability: 0.01, size_m: 100.0 });
    let runs = flown(&scene, 8, &[29_000]);
    assert!(position(&together(&runs)[0]) < 1.05 * position(&clean));
    let refused = runs::counts(&runs)[0].refused;
    assert!((10..45).contains(&refused), "{refused} of some 24");
    // A jump of 200 m is refused until the filter doubts itself, and says so.
    let gnss = scene.aiding.gnss.as_mut().unwrap();
    gnss.outliers = None;
    gnss.spoofing = Some(schuler::sensor::aiding::fault::Spoofing {
        from_s: 150.0,
        until_s: 300.0,
        jump_ned: [200.0, 0.0, 0.0].into(),
        ramp_ned: [0.0; 3].into(),
    });
    let run = &flown(&scene, 1, &[29_000])[0];
    assert_eq!(run.report.lockouts_s.first(), Some(&154.0), "{:?}", run.report);
}

#[test]
fn every_sensor_aids() {
    let folder = tempfile::tempdir().unwrap();
    let text = builtin::text("aided-drive").unwrap();
    // Its port is not at the antenna.
    let barometer =
        text.to_owned() + "\n[barometer]\nnoise_m = 0.2\nbias_m = 2\nlever_arm_m = [2, 0, 10]\n";
    let standing = "duration_s = 60\nrate_hz = 100\n[trajectory]\nlatitude_deg = 45\n[gyro]\nturn_on_bias_deg_h = 10\n\
        angle_random_walk_deg_sqrt_h = 0.1\n[accelerometer]\nturn_on_bias_ug = 100\nvelocity_random_walk_m_s_sqrt_h = 0.05\n\
        [initial_error]\nnorth_m_sigma = 1\neast_m_sigma = 1\ndown_m_sigma = 1\nnorth_m_s_sigma = 0.1\neast_m_s_sigma = 0.1\n\
        down_m_s_sigma = 0.1\nattitude_north_arcsec_sigma = 700\nattitude_east_arcsec_sigma = 700\n\
        attitude_down_arcsec_sigma = 7000\n";
    let rolling =
        standing.replace("latitude_deg = 45", "latitude_deg = 45\nnorth_m = { rate = 15 }");
    let wheels = "[odometer]\nscale_percent = 0.5\n[non_holonomic]\n".to_owned();
    for (name, text, sensors) in [
        ("high", barometer, vec!["gnss", "barometer"]),
        ("stands", standing.to_owned() + "[zero_velocity]\n", vec!["zero velocity"]),
        ("rolls", rolling + &wheels, vec!["odometer", "non-holonomic"]),
    ] {
        let file = folder.path().join(format!("{name}.toml"));
        fs::write(&file, text).unwrap();
        let mut scene = schuler_simulator::scene::load(file.to_str().unwrap()).unwrap();
        scene.duration_s = 60.0;
        let runs = flown(&scene, 12, &[5900]);
        let one = together(&runs)[0];
        let slack = 4.0 * (2.0_f64 / (9.0 * 12.0)).sqrt();
        assert!((one.nees[0] - 1.0).abs() < slack, "{name}: NEES {} ± {slack}", one.nees[0]);
        let counts = runs::counts(&runs);
        let seen: Vec<_> = counts.iter().map(|count| count.sensor).collect();
        assert_eq!(seen, sensors, "{name}");
        for count in counts {
            let (nis, _) = count.consistency().unwrap();
            assert!(
                (0.8..1.2).contains(&nis) || count.sensor == "zero velocity" || name == "rolls",
                "{name}: {nis}"
            );
        }
    }
}

#[test]
fn a_run_alone_is_that_of_the_ensemble_and_single_precision_says_the_same() {
    let mut scene = drive(60.0);
    let run = &flown(&scene, 1, &[6000])[0];
    let flight = Simulation::new(&scene, false).unwrap().fly(&mut |_| Ok(()), &|_| {}).unwrap();
    assert_eq!(flight.last.drift.position_m.as_slice(), &run.reads[0].error[..3]);
    assert_eq!(flight.aided.as_ref().unwrap().sensors[0].accepted, 60);
    let double = run.reads[0];
    scene.navigator.precision = Precision::F32;
    let single = flown(&scene, 1, &[6000])[0].reads[0];
    for i in 0..9 {
        let sigma = double.variance[i].sqrt();
        assert!((single.variance[i].sqrt() / sigma - 1.0).abs() < 2e-3, "{i}");
        assert!((single.error[i] - double.error[i]).abs() < 0.05 * sigma, "{i}");
    }
}

#[test]
fn what_cannot_be_aided_says_why() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let scene = "duration_s = 20\nrate_hz = 50\n[trajectory]\nlatitude_deg = 45\n";
    let says = |text: &str, arguments: &[&str], words: &[&str]| {
        fs::write(folder.join("s.toml"), format!("{scene}{text}")).unwrap();
        let (ended, _, said) = schuler(folder, arguments);
        assert_eq!(ended, Some(2), "{text}: {said}");
        for word in words {
            assert!(said.contains(word), "{text} does not say {word}: {said}");
        }
    };
    let run = ["run", "s.toml"];
    says("[filter]\npatience = 3\n", &run, &["filter", "has nothing to filter", "[gnss]"]);
    says("[gnss]\nposition_m = 0\n", &run, &["gnss.claimed_position_m", "must be there"]);
    says("[gnss]\noutages_s = [[5, 3]]\n", &run, &["gnss.outages_s", "ends before it begins"]);
    says("[gnss]\nrate = 1\n", &run, &["gnss.rate", "did you mean"]);
    says("[gnss]\n[navigator]\nvertical = \"held\"\n", &run, &["navigator.vertical", "barometer"]);
    says("[gnss]\n[navigator]\nprecision = \"f32x2\"\n", &run, &["navigator.precision", "\"f32\""]);
    says("[gnss]\nrate_hz = 201\n", &run, &["gnss.rate_hz", "at most 200"]);
    says("[gnss]\n[filter]\nhorizon_s = 13\n", &run, &["s.toml", "horizon_s", "12.8"]);
    says("[gnss]\n", &["run", "s.toml", "--vertical", "held"], &["--vertical", "barometer"]);
    says("[gnss]\n[link]\nloss = 0.1\n", &run, &["link", "takes every one at its time"]);
    says(
        "[gnss]\n[alignment]\nduration_s = 5\n",
        &run,
        &["alignment", "heading_sigma_deg in [filter]"],
    );
    says("[gnss]\n", &["audit", "record", "s.toml", "--out", "a"], &["filter", "is aided"]);
    // The targets remember 64 steps of 0.1 s.
    let slow = "[gnss]\n[filter]\nhorizon_s = 10\n";
    says(slow, &["hil", "s.toml"], &["filter", "the horizon must be"]);
    let (code, out, said) = schuler(folder, &["ensemble", "s.toml", "--runs", "8", "--out", "e"]);
    assert_eq!(code, Some(0), "{said}");
    assert!(out.contains("NEES of all") && out.contains("gnss: "), "{out}");
    let csv = fs::read_to_string(folder.join("e/aided.csv")).unwrap();
    let columns = csv.lines().next().unwrap().split(',').count();
    assert!(
        csv.lines().all(|line| line.split(',').count() == columns) && columns == 31,
        "{columns}"
    );
    let (code, out, said) = schuler(folder, &run);
    assert_eq!(code, Some(0), "{said}");
    assert!(out.contains("The filter says: 1σ") && out.contains("gnss: 20 taken"), "{out}");
}
