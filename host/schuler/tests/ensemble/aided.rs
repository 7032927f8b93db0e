//! Aided ensembles: shards, what was stopped, what is kept, what each error term contributes, and whether a filter that
//! is told less noise than there is gets caught.

use super::shards::{done, files, same, schuler};
use std::fs;
use std::path::Path;

/// A receiver on a vehicle at rest, a sensor with noise, a start with errors.
const SCENE: &str = "duration_s = 12\nrate_hz = 50\nseed = 3\n[trajectory]\nlatitude_deg = 45\n\
    [gyro]\nangle_random_walk_deg_sqrt_h = 0.3\n[accelerometer]\nvelocity_random_walk_m_s_sqrt_h = 0.1\n\
    [initial_error]\nnorth_m_sigma = 1\neast_m_sigma = 1\ndown_m_sigma = 1\nnorth_m_s_sigma = 0.1\neast_m_s_sigma = 0.1\n\
    down_m_s_sigma = 0.1\nattitude_north_arcsec_sigma = 700\nattitude_east_arcsec_sigma = 700\n\
    attitude_down_arcsec_sigma = 7000\n[gnss]\nposition_m = 1\nvelocity_m_s = 0.05\noutages_s = [[7.5, 12]]\n";

fn json(path: &Path) -> serde_json::Value {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

#[test]
fn aided_shards_merge_to_the_whole_byte_for_byte() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("scene.toml"), SCENE).unwrap();
    let whole = "ensemble scene.toml --runs 17 --at 4s,8s";
    done(folder.path(), &format!("{whole} --keep --svg --budget 5 --out whole"));
    let names: Vec<_> = files(&at("whole")).into_iter().map(|(name, _)| name).collect();
    let expected = [
        "accuracy.csv",
        "aided.csv",
        "budget.csv",
        "ensemble.html",
        "ensemble.json",
        "ensemble.svg",
        "runs.csv",
    ];
    assert_eq!(names, expected);
    let runs = fs::read_to_string(at("whole/runs.csv")).unwrap();
    assert_eq!(runs.lines().count(), 1 + 17 * 3);
    assert!(runs.starts_with("run,time_s,north_m,") && runs.contains("\n16,12.0,"));
    let summary = json(&at("whole/ensemble.json"));
    let gnss = &summary["measurements"]["sensors"][0];
    // An epoch a second, before the outage.
    assert_eq!(gnss["accepted"].as_u64().unwrap() + gnss["refused"].as_u64().unwrap(), 17 * 7);
    assert_eq!(summary["consistency_tests"], serde_json::json!({ "done": 12, "failed": 0 }));

    for (shards, threads, batch) in [(1, 1, 5), (4, 2, 2), (17, 1, 100)] {
        let out = format!("parts-{shards}");
        for k in 1..=shards {
            let line = format!(
                "{whole} --shard {k}/{shards} --threads {threads} --batch {batch} --out {out}"
            );
            done(folder.path(), &line);
        }
        let parts = files(&at(&out)).into_iter().map(|(name, _)| format!("{out}/{name}"));
        let parts: Vec<_> = parts.rev().collect();
        let merged = format!("merged-{shards}");
        let line =
            format!("ensemble merge {} --keep --svg --budget 5 --out {merged}", parts.join(" "));
        done(folder.path(), &line);
        same(&at("whole"), &at(&merged), &format!("{shards} shards"));
    }
    // A part of other runs is none of these.
    let plain = SCENE.split("[gnss]").next().unwrap();
    fs::write(at("plain.toml"), plain).unwrap();
    done(folder.path(), "ensemble plain.toml --runs 17 --shard 1/4 --out other");
    let line = "ensemble merge parts-4/shard-2-of-4.part other/shard-1-of-4.part --out mixed";
    let refused = schuler(folder.path(), line);
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert_eq!(refused.status.code(), Some(2), "{said}");
    assert!(said.contains("without aiding") && !at("mixed").exists(), "{said}");
}

#[test]
fn smoothed_runs_are_as_their_smoothers_say_and_merge_too() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let scene = SCENE.replace("[[7.5, 12]]", "[[3.5, 8.5]]") + "[filter]\nsmoother = true\n";
    fs::write(at("scene.toml"), scene).unwrap();
    let whole = "ensemble scene.toml --runs 60 --at 6s";
    done(folder.path(), &format!("{whole} --out whole"));
    for k in 1..=2 {
        done(folder.path(), &format!("{whole} --shard {k}/2 --out parts"));
    }
    let parts = "parts/shard-1-of-2.part parts/shard-2-of-2.part";
    done(folder.path(), &format!("ensemble merge {parts} --out merged"));
    same(&at("whole"), &at("merged"), "smoothed");
    // In the middle of the outage, at the end.
    let cell = |file: &str, row: usize, column: &str| -> f64 {
        let text = fs::read_to_string(at("whole").join(file)).unwrap();
        let place = text.lines().next().unwrap().split(',').position(|name| name == column);
        text.lines().nth(1 + row).unwrap().split(',').nth(place.unwrap()).unwrap().parse().unwrap()
    };
    let [filtered, smoothed] =
        ["aided.csv", "smoothed.csv"].map(|file| cell(file, 0, "north_m_sigma"));
    assert!(smoothed < 0.9 * filtered, "{smoothed} {filtered}");
    assert_eq!(cell("smoothed.csv", 1, "north_m_rms"), cell("aided.csv", 1, "north_m_rms"));
    for row in 0..2 {
        // χ² of 540 degrees of freedom by their number: four of √(2/540).
        let nees = cell("smoothed.csv", row, "nees_all");
        assert!((nees - 1.0).abs() < 4.0 * (2.0_f64 / 540.0).sqrt(), "{nees}");
    }
    done(folder.path(), "run scene.toml --out one");
    let page = fs::read_to_string(at("one/report.html")).unwrap();
    assert!(page.contains("<h2>Smoothed</h2>"));
    // Its rows are errors within what is claimed: 4σ, which one in 16,000 passes.
    let rows = fs::read_to_string(at("one/smoothed.csv")).unwrap();
    let far = rows.lines().skip(1).filter(|row| {
        let numbers: Vec<f64> = row.split(',').map(|number| number.parse().unwrap()).collect();
        (0..9).any(|i| numbers[1 + i].abs() > 4.0 * numbers[10 + i])
    });
    assert!(rows.lines().count() > 50 && far.count() == 0);
}

#[test]
fn aided_runs_that_were_stopped_go_on_to_the_same_end() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("scene.toml"), SCENE).unwrap();
    let line = "ensemble scene.toml --runs 12 --shard 2/2 --batch 2 --out part";
    done(folder.path(), line);
    let part = folder.path().join("part/shard-2-of-2.part");
    let bytes = fs::read(&part).unwrap();
    let first = bytes.iter().position(|&byte| byte == b'\n').unwrap() + 1;
    for cut in [first, bytes.len() / 2, bytes.len() - 1, bytes.len()] {
        fs::write(&part, &bytes[..cut]).unwrap();
        let said = done(folder.path(), &format!("{line} --resume"));
        assert!(fs::read(&part).unwrap() == bytes, "cut at {cut}: {said}");
    }
    let mut damaged = bytes.clone();
    damaged[bytes.len() / 2] ^= 1;
    fs::write(&part, &damaged).unwrap();
    let refused = schuler(folder.path(), &format!("{line} --resume"));
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("SHA-256"));
}

/// The contribution of a term to a component at the end, rms.
fn share(folder: &Path, term: &str, component: &str) -> f64 {
    let text = fs::read_to_string(folder.join("budget.csv")).unwrap();
    let row = text.lines().rev().find(|row| row.contains(&format!(",{term},{component},")));
    let numbers: Vec<f64> =
        row.unwrap().split(',').skip(3).map(|number| number.parse().unwrap()).collect();
    numbers[0].hypot(numbers[1])
}

#[test]
fn terms_add_up_to_the_error_of_a_filter_that_is_linear() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("scene.toml"), SCENE).unwrap();
    done(folder.path(), "ensemble scene.toml --runs 200 --at 7s --budget 200 --out o");
    let out = folder.path().join("o");
    let terms = [
        "gyro angle random walk",
        "accelerometer velocity random walk",
        "start position",
        "start velocity",
        "start attitude",
        "gnss position noise",
        "gnss velocity noise",
    ];
    let aided = fs::read_to_string(out.join("aided.csv")).unwrap();
    let (head, end) = (aided.lines().next().unwrap(), aided.lines().last().unwrap());
    for component in ["north_m", "east_m_s", "attitude_north_arcsec"] {
        let column = head.split(',').position(|name| name == format!("{component}_rms")).unwrap();
        let rms: f64 = end.split(',').nth(column).unwrap().parse().unwrap();
        let sum: f64 = terms.iter().map(|term| share(&out, term, component).powi(2)).sum();
        // Independent terms: the squares add up but for chance products, each of a share √(1/200).
        let ratio = sum.sqrt() / rms;
        assert!((ratio - 1.0).abs() < 0.15, "{component}: {ratio}");
    }
}

#[test]
fn a_filter_that_expects_more_noise_than_there_is_is_told_and_safe() {
    let folder = tempfile::tempdir().unwrap();
    let scene = SCENE.replace("position_m = 1\n", "position_m = 1\nclaimed_position_m = 3\n");
    fs::write(folder.path().join("scene.toml"), scene).unwrap();
    let flown = schuler(folder.path(), "ensemble scene.toml --runs 60 --out o");
    let said = String::from_utf8_lossy(&flown.stdout).into_owned();
    assert_eq!(flown.status.code(), Some(0), "{said}");
    assert!(said.contains("the errors of position are smaller than the filters say"), "{said}");
}

#[test]
fn a_filter_that_is_told_less_noise_than_there_is_fails() {
    let folder = tempfile::tempdir().unwrap();
    let scene = SCENE.replace("position_m = 1\n", "position_m = 2\nclaimed_position_m = 1\n");
    fs::write(folder.path().join("scene.toml"), scene).unwrap();
    let flown = schuler(folder.path(), "ensemble scene.toml --runs 60 --out o");
    let said = String::from_utf8_lossy(&flown.stdout).into_owned();
    assert_eq!(flown.status.code(), Some(1), "{said}");
    assert!(said.contains("the errors of position are larger than the filters say"), "{said}");
    let summary = json(&folder.path().join("o/ensemble.json"));
    assert!(summary["consistency_tests"]["failed"].as_u64().unwrap() > 0);
    let page = fs::read_to_string(folder.path().join("o/ensemble.html")).unwrap();
    assert!(page.contains("The errors are not as the filters say"));
}
