//! The command as a user meets it.

use schuler_simulator::lanes::Registers;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn ensemble(folder: &Path, arguments: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
    command.current_dir(folder).arg("ensemble").args(arguments.split_whitespace());
    command.output().unwrap()
}

const COLUMNS: &str = "time_s,component,mean,mean_theory,sigma,sigma_theory,\
    mean_chi_square,mean_probability,sigma_chi_square,sigma_probability,\
    least,least_run,p2_5,p25,p50,p75,p97_5,greatest,greatest_run";

#[test]
fn a_small_ensemble_prints_its_table_and_writes_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let done = ensemble(folder.path(), "--runs 10 --duration 120 --seed 3 --window 0,4,0 --out o");
    assert_eq!(done.status.code(), Some(0), "{}", String::from_utf8_lossy(&done.stderr));
    let text = String::from_utf8(done.stdout).unwrap();
    let abreast = Registers::Avx2.are_there();
    for words in [
        "at 120 s ",
        "down_m_s ",
        "Standard deviation over theory's",
        "The ensemble agrees with theory at 99.9 %: 144 tests",
        "States together agree with it at 99.9 %: ",
        "With 10 runs, a standard deviation that is off by ",
        "Error about the truth, m, that half or 95 % of the runs keep",
        "What the error at 120 s is made of",
        "gyro Gauss-Markov bias",
        "10 runs in ",
        if abreast { " side by side on each of " } else { " one at a time on each of " },
        if abreast { "ns per sample and run abreast, " } else { "ns per sample and run\n" },
        "written to o\n",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    assert!(text.lines().all(|line| line.chars().count() <= 120), "{text}");
    let csv = fs::read_to_string(folder.path().join("o/ensemble.csv")).unwrap();
    assert_eq!(csv.lines().next(), Some(COLUMNS));
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 8 * 9);
    assert_eq!((&rows[71][0], &rows[71][1]), ("120.0", "attitude_down_arcsec"));
    for row in &rows {
        assert!(row.iter().enumerate().all(|(i, x)| i == 1 || x.parse::<f64>().is_ok()), "{row:?}");
    }
    // Runs are what the seed makes them: the same again, others with another.
    let again = |arguments: &str| {
        assert_eq!(ensemble(folder.path(), arguments).status.code(), Some(0));
        fs::read_to_string(folder.path().join("out/paper/ensemble.csv")).unwrap()
    };
    assert_eq!(again("paper --runs 10 --duration 120 --seed 3 --window 0,4,0"), csv);
    assert_ne!(again("paper --runs 10 --duration 120 --seed 4 --window 0,4,0"), csv);
}

#[test]
fn a_window_without_lanes_is_flown_one_at_a_time() {
    let folder = tempfile::tempdir().unwrap();
    let done =
        ensemble(folder.path(), "--runs 5 --duration 30 --frame earth-fixed --window 0,12,0");
    let text = String::from_utf8(done.stdout).unwrap();
    assert!(text.contains("one at a time on each of ") && !text.contains("abreast"), "{text}");
}

#[test]
fn what_cannot_be_is_told_before_the_work_begins() {
    let folder = tempfile::tempdir().unwrap();
    let noisy = "duration_s = 1\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\n\
        [gyro]\nangle_random_walk_deg_sqrt_h = 0.1\n";
    for (name, text) in
        [("lossy.toml", "[link]\nloss = 0.1\n"), ("late.toml", "[link]\njitter_s = 0.001\n")]
    {
        fs::write(folder.path().join(name), format!("{noisy}{text}")).unwrap();
    }
    let constant = "duration_s = 1\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\n\
        [gyro]\nconstant_deg_h = 0.1\nangle_random_walk_deg_sqrt_h = 0\n\
        [accelerometer]\nquantization_m_s = 0.001\n";
    fs::write(folder.path().join("constant.toml"), constant).unwrap();
    fs::write(folder.path().join("taken"), "").unwrap();
    for (arguments, words) in [
        ("paper-perfect", ["paper-perfect has no random errors", "gauss_markov"]),
        ("constant.toml", ["constant has no random errors", "turn_on_bias"]),
        ("lossy.toml", ["link: ", "loss = 0"]),
        ("late.toml", ["link: ", "jitter_s = 0"]),
        ("--algorithm textbook", ["algorithm", "accepted: taylor"]),
        ("--window 1,1,1", ["--window", "2,4,2"]),
        ("--runs 3", ["--runs", "an integer from 4 to 10000000"]),
        ("--runs 10000001", ["--runs", "is not a number of runs"]),
        ("--runs many", ["--runs", "is not a number of runs"]),
        ("nowhere", ["nowhere: there is no such scene", "paper"]),
        ("--out taken", ["taken", "cannot be written"]),
        ("--fast", ["--fast", "unexpected"]),
    ] {
        let done = ensemble(folder.path(), arguments);
        let said = String::from_utf8_lossy(&done.stderr);
        assert_eq!(done.status.code(), Some(2), "{arguments}: {said}");
        for word in words {
            assert!(said.contains(word), "{arguments} does not say {word}: {said}");
        }
        assert!(!folder.path().join("out").exists(), "{arguments}");
    }
}

#[test]
fn where_no_run_can_go_on_each_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let spin = "duration_s = 5\nrate_hz = 20\n[trajectory]\nroll_deg = { rate = 1e4 }\n\
        [gyro]\nangle_random_walk_deg_sqrt_h = 0.1\n";
    fs::write(folder.path().join("spin.toml"), spin).unwrap();
    let done = ensemble(folder.path(), "spin.toml");
    let said = String::from_utf8_lossy(&done.stderr);
    assert_eq!(done.status.code(), Some(1), "{said}");
    assert!(said.contains("64 of 64 runs did not reach their end"), "{said}");
    let text = String::from_utf8(done.stdout).unwrap();
    for words in [
        "run 0 of seed 1 ended at sample 1, 0.05 s: the angle increment ",
        "run 19 of seed 1 ended at sample 1",
        "and 44 more",
        "too few runs reached their end: nothing to compare",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let csv = fs::read_to_string(folder.path().join("out/spin/ensemble.csv")).unwrap();
    assert_eq!(csv.trim_end(), COLUMNS);
}

#[test]
fn a_run_that_fails_is_named_and_the_others_go_on() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("turns.toml"), super::TURNS).unwrap();
    let done = ensemble(folder.path(), "turns.toml --runs 40");
    let said = String::from_utf8_lossy(&done.stderr);
    let text = String::from_utf8(done.stdout).unwrap();
    assert_eq!(done.status.code(), Some(1), "{said}");
    assert!(said.contains(" of 40 runs did not reach their end"), "{said}");
    let failed = text.lines().filter(|line| line.contains(" of seed 1 ended at sample ")).count();
    assert!(failed > 0 && failed < 20, "{text}");
    assert!(text.contains(&format!("of the {} runs of 40 that reached their end", 40 - failed)));
    let csv = fs::read_to_string(folder.path().join("out/turns/ensemble.csv")).unwrap();
    assert_eq!(csv.lines().count(), 1 + 8 * 9);
}

#[test]
fn what_is_held_and_what_is_single_agrees_with_theory() {
    let folder = tempfile::tempdir().unwrap();
    for (line, tests) in [
        // Down and its velocity are held: they do not scatter.
        ("sea-state --duration 600 --runs 40", "112 tests"),
        ("sea-state --duration 300 --runs 24 --frame earth-fixed", "112 tests"),
        ("sea-state --duration 300 --runs 8 --precision f32", "112 tests"),
        ("paper --duration 300 --runs 16 --precision f32x2", "144 tests"),
    ] {
        let done = ensemble(folder.path(), line);
        let text = String::from_utf8(done.stdout).unwrap();
        assert_eq!(done.status.code(), Some(0), "{line}: {text}");
        assert!(text.contains("agrees with theory at 99.9 %: "), "{line}: {text}");
        assert!(text.contains(tests), "{line}: {text}");
    }
}

#[test]
fn where_rounding_matters_nothing_is_compared() {
    let folder = tempfile::tempdir().unwrap();
    // Noise that moves nothing by more than single precision's own rounding.
    let quiet = "duration_s = 300\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\n\
        roll_deg = { harmonics = [{ amplitude = 30, period_s = 7 }] }\n\
        [gyro]\nangle_random_walk_deg_sqrt_h = 1e-7\n";
    fs::write(folder.path().join("quiet.toml"), quiet).unwrap();
    let done = ensemble(folder.path(), "quiet.toml --runs 8 --precision f32");
    let text = String::from_utf8(done.stdout).unwrap();
    assert_eq!(done.status.code(), Some(0), "{text}");
    assert!(text.contains("where rounding in f32 is above a third"), "{text}");
}

#[test]
fn an_ensemble_that_does_not_follow_theory_fails() {
    let folder = tempfile::tempdir().unwrap();
    // Theory leaves out that a sensor is at its limit, here by the Earth's rate alone.
    let limited = "duration_s = 60\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\n\
        [gyro]\nangle_random_walk_deg_sqrt_h = 0.1\nsaturation_deg_s = 0.001\n";
    fs::write(folder.path().join("limited.toml"), limited).unwrap();
    let done = ensemble(folder.path(), "limited.toml --runs 8");
    let (text, said) = [&done.stdout, &done.stderr].map(|x| String::from_utf8_lossy(x)).into();
    assert_eq!(done.status.code(), Some(1), "{said}");
    assert!(text.contains("does not agree with theory") && text.contains("written to"), "{text}");
    // Of 144, less those of the vertical, which a level vehicle's tilt moves by its square alone; and four of states
    // together at each of eight times.
    assert!(said.contains(" of 152 checks failed"), "{said}");
    assert!(text.contains("States together do not agree with it at 99.9 %: "), "{text}");
    assert!(
        text.contains("\nThe standard deviation of ") || text.contains("\nThe mean of "),
        "{text}"
    );
    assert!(folder.path().join("out/limited/ensemble.csv").is_file());
}

#[test]
fn what_theory_does_not_know_is_not_comparable() {
    let folder = tempfile::tempdir().unwrap();
    for (errors, words) in [
        ("turn_on_bias_deg_h = 1e4\n", "are no small rotations"),
        ("angle_random_walk_deg_sqrt_h = 0.01\nquantization_arcsec = 1000\n", "gyro steps of 1000"),
    ] {
        let scene = format!(
            "duration_s = 60\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\nroll_deg = 3\n\
             [gyro]\n{errors}"
        );
        fs::write(folder.path().join("poor.toml"), scene).unwrap();
        let done = ensemble(folder.path(), "poor.toml --runs 8");
        let text = crate::on_one_line(&String::from_utf8_lossy(&done.stdout));
        assert_eq!(done.status.code(), Some(0), "{text}");
        assert!(text.contains("not comparable") && text.contains(words), "{text}");
    }
}

#[test]
fn a_run_of_an_ensemble_is_flown_again_by_its_number() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "duration_s = 30\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\nroll_deg = 3\n\
        [gyro]\nangle_random_walk_deg_sqrt_h = 0.1\n\
        [initial_error]\neast_m_sigma = 7\nattitude_north_arcsec_sigma = 60\n";
    fs::write(folder.path().join("drawn.toml"), scene).unwrap();
    let done = ensemble(folder.path(), "drawn.toml --runs 9 --keep --out o");
    assert_eq!(done.status.code(), Some(0), "{done:?}");
    let runs = fs::read_to_string(folder.path().join("o/runs.csv")).unwrap();
    for number in [0, 5, 8] {
        let mut run = Command::new(env!("CARGO_BIN_EXE_schuler"));
        let line = format!("run drawn.toml --run {number} --no-report --out r{number}");
        run.current_dir(folder.path()).args(line.split_whitespace());
        assert!(run.output().unwrap().status.success(), "{line}");
        let drift = fs::read_to_string(folder.path().join(format!("r{number}/drift.csv"))).unwrap();
        let last: Vec<_> = drift.lines().last().unwrap().split(',').take(10).collect();
        let kept = format!("{number},{}", last.join(","));
        assert!(runs.lines().any(|row| row == kept), "{kept}");
    }
    // Without a number it is the first.
    let mut run = Command::new(env!("CARGO_BIN_EXE_schuler"));
    let line = "run drawn.toml --no-report --out again";
    run.current_dir(folder.path()).args(line.split_whitespace());
    assert!(run.output().unwrap().status.success());
    let [first, again] = ["r0", "again"]
        .map(|name| fs::read_to_string(folder.path().join(name).join("drift.csv")).unwrap());
    assert_eq!(first, again);
    assert_ne!(first, fs::read_to_string(folder.path().join("r5/drift.csv")).unwrap());
}

#[test]
fn the_budget_fits_80_columns_and_its_columns_are_in_line() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "duration_s = 4\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\nlongitude_deg = 100\n\
        [temperature]\noffset_k = 5\n\
        [gyro]\nangle_random_walk_deg_sqrt_h = 0.01\ntemperature_scale_factor_ppm_k = 3\n\
        [accelerometer]\nvelocity_random_walk_m_s_sqrt_h = 0.01\nacceleration_random_walk_ug_sqrt_h = 20\n\
        temperature_scale_factor_ppm_k = 3\nmisalignment_matrix_arcsec = [[0, 9, 9], [9, 0, 9], [9, 9, 0]]\n";
    fs::write(folder.path().join("terms.toml"), scene).unwrap();
    let out = ensemble(folder.path(), "terms.toml --runs 4 --budget 4 --out out");
    let text = String::from_utf8(out.stdout).unwrap();
    let rows = text.lines().skip_while(|line| !line.starts_with("What the error"));
    let rows: Vec<_> = rows.skip(2).take_while(|line| !line.contains(" runs in ")).collect();
    for name in [
        "accelerometer velocity random walk",
        "accelerometer acceleration random walk",
        "accelerometer misalignment of each axis",
        "accelerometer scale factor by temperature",
    ] {
        assert!(rows.iter().any(|row| row.starts_with(name)), "{name}: {text}");
    }
    // Cells stand to the right in their columns, so every row ends where the line does.
    for row in rows {
        assert_eq!(row.chars().count(), 80, "{row}\n{text}");
    }
}
