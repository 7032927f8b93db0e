//! Shards put together are the whole, byte for byte, for any split; so is what was stopped and went on.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

pub(super) fn schuler(folder: &Path, line: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
    command.current_dir(folder).args(line.split_whitespace()).output().unwrap()
}

pub(super) fn done(folder: &Path, line: &str) -> String {
    let done = schuler(folder, line);
    let said = String::from_utf8_lossy(&done.stderr).into_owned();
    assert_eq!(done.status.code(), Some(0), "{line}: {said}");
    said
}

/// A short ensemble with a drawn start, a random sensor, one that is at its limit at times.
pub(super) const SCENE: &str = "duration_s = 4\nrate_hz = 20\nseed = 5\n[trajectory]\nlatitude_deg = 45\n\
    roll_deg = { harmonics = [{ amplitude = 20, period_s = 3 }] }\n\
    [gyro]\nangle_random_walk_deg_sqrt_h = 3\nsaturation_deg_s = 41.8\n\
    [initial_error]\nnorth_m_sigma = 2\nattitude_down_arcsec_sigma = 100\ndown_m_s = 0.1\n\
    [navigator]\nwindow = { history = 0, block = 4, lookahead = 0 }\n";

/// All files of a folder, by name.
pub(super) fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<_> = entries
        .map(|path| {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            (name, fs::read(&path).unwrap())
        })
        .collect();
    files.sort();
    files
}

pub(super) fn same(a: &Path, b: &Path, what: &str) {
    let (a, b) = (files(a), files(b));
    let names = |files: &[(String, Vec<u8>)]| -> Vec<String> {
        files.iter().map(|(name, _)| name.clone()).collect()
    };
    assert_eq!(names(&a), names(&b), "{what}");
    for ((name, a), (_, b)) in a.iter().zip(&b) {
        assert!(a == b, "{what}: {name} differs");
    }
}

#[test]
fn shards_merge_to_the_whole_byte_for_byte() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("scene.toml"), SCENE).unwrap();
    let whole = "ensemble scene.toml --runs 29 --at 1s,2.2s --rate 25";
    // Theory leaves out that sensors are limited, so the verdict is of no interest here.
    let fly = |line: &str| {
        let done = schuler(folder.path(), line);
        let code = done.status.code();
        assert!(code == Some(0) || code == Some(1), "{line}: {done:?}");
    };
    fly(&format!("{whole} --keep --budget 8 --out whole"));
    let names: Vec<_> = files(&at("whole")).into_iter().map(|(name, _)| name).collect();
    let expected = [
        "accuracy.csv",
        "budget.csv",
        "consistency.csv",
        "covariance.csv",
        "ensemble.csv",
        "ensemble.html",
        "ensemble.json",
        "runs.csv",
    ];
    assert_eq!(names, expected);
    let runs = fs::read_to_string(at("whole/runs.csv")).unwrap();
    assert_eq!(runs.lines().count(), 1 + 29 * 3, "{}", &runs[..200]);
    assert!(runs.starts_with("run,time_s,north_m,") && runs.contains("\n28,4.0,"));
    let json = fs::read_to_string(at("whole/ensemble.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert!(json["saturated"].as_u64().unwrap() > 0);

    fly(&format!("{whole} --keep --budget 8 --threads 1 --batch 5 --out again"));
    same(&at("whole"), &at("again"), "one thread, batches of five");
    // Lanes, alone, and what does not divide; the parts in disorder.
    for (shards, threads, batch) in [(1, 2, 100), (3, 1, 4), (7, 2, 100), (29, 1, 100)] {
        let out = format!("parts-{shards}");
        for k in 1..=shards {
            let line = format!(
                "{whole} --shard {k}/{shards} --threads {threads} --batch {batch} --out {out}"
            );
            done(folder.path(), &line);
        }
        let mut parts: Vec<_> = files(&at(&out)).into_iter().map(|(name, _)| name).collect();
        assert_eq!(parts.len(), shards);
        parts.rotate_left(shards / 2);
        let parts: Vec<_> = parts.iter().map(|name| format!("{out}/{name}")).collect();
        let merged = format!("merged-{shards}");
        fly(&format!("ensemble merge {} --keep --budget 8 --out {merged}", parts.join(" ")));
        same(&at("whole"), &at(&merged), &format!("{shards} shards"));
    }
}

#[test]
fn runs_that_fail_merge_too() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("turns.toml"), super::TURNS).unwrap();
    let fly = |line: &str| schuler(folder.path(), line).status.code();
    let whole = "ensemble turns.toml --runs 40";
    assert_eq!(fly(&format!("{whole} --keep --out whole")), Some(1));
    for k in 1..=6 {
        // A part is a part, whatever becomes of its runs.
        assert_eq!(fly(&format!("{whole} --shard {k}/6 --out parts")), Some(0));
    }
    let parts: Vec<_> = (1..=6).map(|k| format!("parts/shard-{k}-of-6.part")).collect();
    assert_eq!(fly(&format!("ensemble merge {} --keep --out merged", parts.join(" "))), Some(1));
    same(&folder.path().join("whole"), &folder.path().join("merged"), "with failures");
}

#[test]
fn what_was_stopped_goes_on_to_the_same_end() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("scene.toml"), SCENE.replace("saturation_deg_s = 41.8\n", "")).unwrap();
    let whole = "ensemble scene.toml --runs 30";
    done(folder.path(), &format!("{whole} --keep --out whole"));
    done(folder.path(), &format!("{whole} --shard 2/2 --batch 4 --out part"));
    let part = at("part/shard-2-of-2.part");
    let bytes = fs::read(&part).unwrap();
    // Cut anywhere: behind the first line, at the end of a block, within one, by a byte.
    let first = bytes.iter().position(|&byte| byte == b'\n').unwrap() + 1;
    for cut in
        [first, first + 1, bytes.len() / 2, bytes.len() * 3 / 4, bytes.len() - 1, bytes.len()]
    {
        fs::write(&part, &bytes[..cut]).unwrap();
        let said = done(
            folder.path(),
            &format!("{whole} --shard 2/2 --batch 4 --resume --threads 1 --out part"),
        );
        assert!(fs::read(&part).unwrap() == bytes, "cut at {cut}: {said}");
    }
    // With other batches the bytes are others, and the runs the same.
    fs::write(&part, &bytes[..bytes.len() * 3 / 4]).unwrap();
    done(folder.path(), &format!("{whole} --shard 2/2 --batch 3 --resume --out part"));
    done(folder.path(), &format!("{whole} --shard 1/2 --resume --out part"));
    let parts = "part/shard-1-of-2.part part/shard-2-of-2.part";
    done(folder.path(), &format!("ensemble merge {parts} --keep --out merged"));
    same(&at("whole"), &at("merged"), "resumed");
}

#[cfg(target_os = "linux")]
#[test]
fn a_signal_leaves_a_part_and_resume_goes_on_with_it() {
    use rustix::process::{Pid, Signal, kill_process};
    use std::process::Stdio;
    use std::thread;
    use std::time::{Duration, Instant};
    for signal in [Signal::INT, Signal::KILL] {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::write(at("scene.toml"), SCENE.replace("saturation_deg_s = 41.8\n", "")).unwrap();
        // More runs than are flown before the signal comes.
        let whole = "ensemble scene.toml --runs 6000 --at 1";
        let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
        command.args(format!("{whole} --batch 8 --out o").split_whitespace());
        command.current_dir(folder.path()).stdout(Stdio::null()).stderr(Stdio::piped());
        let child = command.spawn().unwrap();
        let end = Instant::now() + Duration::from_secs(60);
        while !at("o/ensemble.part").exists() && Instant::now() < end {
            thread::sleep(Duration::from_millis(1));
        }
        let id = Pid::from_raw(i32::try_from(child.id()).unwrap()).unwrap();
        kill_process(id, signal).unwrap();
        let stopped = child.wait_with_output().unwrap();
        let said = String::from_utf8_lossy(&stopped.stderr);
        assert!(!stopped.status.success(), "it was done before: {said}");
        let left: Vec<_> = files(&at("o")).into_iter().map(|(name, _)| name).collect();
        assert_eq!(left, ["ensemble.part"]);
        if signal == Signal::INT {
            let words = "of 6000 runs; --resume goes on with it";
            assert!(said.contains("stopped by SIGINT: o/ensemble.part holds "), "{said}");
            assert!(said.contains(words), "{said}");
        }
        // Not without being told, so that nothing is lost.
        let refused = schuler(folder.path(), &format!("{whole} --out o"));
        let said = String::from_utf8_lossy(&refused.stderr);
        assert!(said.contains("is there from before; accepted: --resume"), "{said}");
        done(folder.path(), &format!("{whole} --resume --keep --out o"));
        done(folder.path(), &format!("{whole} --keep --out whole"));
        same(&at("whole"), &at("o"), "after a signal");
    }
}
