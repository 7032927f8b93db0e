//! What a run leaves behind that is stopped, or cannot go on.

use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn schuler(folder: &Path, line: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
    command.current_dir(folder).args(line.split_whitespace()).output().unwrap()
}

/// Runs, and expects an exit code and words on the error stream; what it prints.
fn expect(folder: &Path, line: &str, code: i32, words: &[&str]) -> String {
    let done = schuler(folder, line);
    let said = String::from_utf8_lossy(&done.stderr);
    assert_eq!(done.status.code(), Some(code), "{line}: {said}");
    for word in words {
        assert!(said.contains(word), "{line} does not say {word}: {said}");
    }
    String::from_utf8(done.stdout).unwrap()
}

fn summary(folder: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(folder.join("summary.json")).unwrap()).unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name());
    let mut names: Vec<_> = names.map(|name| name.into_string().unwrap()).collect();
    names.sort();
    names
}

const SCENE: &str = "duration_s = 2\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\n";

#[cfg(target_os = "linux")]
mod signals {
    use super::{SCENE, names};
    use rustix::process::{Pid, Signal, kill_process};
    use std::fs;
    use std::os::unix::process::ExitStatusExt;
    use std::path::Path;
    use std::process::{Child, Command, Stdio};
    use std::thread;
    use std::time::Duration;

    fn id(child: &Child) -> Pid {
        Pid::from_raw(child.id() as i32).unwrap()
    }

    /// Waits until it has opened a file without a name, or ends.
    fn is_under_way(child: &mut Child) -> bool {
        let files = format!("/proc/{}/fd", child.id());
        for _ in 0..60_000 {
            if child.try_wait().unwrap().is_some() {
                return false;
            }
            let open = fs::read_dir(&files).into_iter().flatten().flatten();
            let mut open = open.filter_map(|entry| fs::read_link(entry.path()).ok());
            if open.any(|file| file.to_string_lossy().ends_with(" (deleted)")) {
                return true;
            }
            thread::sleep(Duration::from_millis(2));
        }
        false
    }

    fn start(folder: &Path, command: &mut Command) -> Child {
        let child = command.current_dir(folder).stdout(Stdio::null()).stderr(Stdio::piped());
        child.spawn().unwrap()
    }

    fn program(line: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
        command.args(line.split_whitespace());
        command
    }

    #[test]
    fn a_signal_leaves_nothing() {
        for (line, signal) in [
            ("run --rate 100000 --out deep/er/still", Signal::INT),
            ("run --rate 100000 --no-report", Signal::TERM),
            ("run --rate 100000", Signal::HUP),
            ("run --rate 100000", Signal::KILL),
            ("emulate --rate 100000 --out deep/imu.csv", Signal::INT),
            ("ensemble --rate 10000 --runs 1000", Signal::TERM),
            ("hil --rate 10000", Signal::INT),
            ("frontier --out deep", Signal::TERM),
            ("stress --full --out deep", Signal::INT),
        ] {
            let folder = tempfile::tempdir().unwrap();
            let mut child = start(folder.path(), &mut program(line));
            assert!(is_under_way(&mut child), "{line}");
            kill_process(id(&child), signal).unwrap();
            let done = child.wait_with_output().unwrap();
            // What a shell shows as 130 of SIGINT, 143 of SIGTERM.
            assert_eq!(done.status.signal(), Some(signal.as_raw()), "{line}: {done:?}");
            assert_eq!(names(folder.path()), [""; 0], "{line}");
            let said = String::from_utf8(done.stderr).unwrap();
            let is_said =
                said.contains("schuler: stopped by SIG") && said.contains("nothing was written");
            assert!(is_said || signal == Signal::KILL, "{line}: {said}");
        }
    }

    #[test]
    fn a_run_that_is_stopped_leaves_an_earlier_one_as_it_was() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("paper.toml"), SCENE).unwrap();
        assert!(
            program("run paper.toml").current_dir(folder.path()).output().unwrap().status.success()
        );
        let out = folder.path().join("out/paper");
        let files = names(&out);
        let contents =
            || files.iter().map(|name| fs::read(out.join(name)).unwrap()).collect::<Vec<_>>();
        let before = contents();
        let mut child = start(folder.path(), &mut program("run --rate 100000"));
        assert!(is_under_way(&mut child));
        kill_process(id(&child), Signal::INT).unwrap();
        child.wait().unwrap();
        assert_eq!(names(&out), files);
        assert!(contents() == before);
    }

    #[test]
    fn a_signal_that_is_ignored_stays_ignored() {
        let folder = tempfile::tempdir().unwrap();
        let line = format!("trap '' HUP; exec {} run --rate 100000", env!("CARGO_BIN_EXE_schuler"));
        let mut child = start(folder.path(), Command::new("sh").args(["-c", &line]));
        assert!(is_under_way(&mut child));
        kill_process(id(&child), Signal::HUP).unwrap();
        kill_process(id(&child), Signal::TERM).unwrap();
        let done = child.wait_with_output().unwrap();
        assert_eq!(done.status.signal(), Some(Signal::TERM.as_raw()), "{done:?}");
    }

    #[test]
    fn a_full_disk_ends_a_run_and_is_told() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("still.toml"), SCENE).unwrap();
        let run = |line| program(line).current_dir(folder.path()).output().unwrap();
        assert!(run("run still.toml --out o").status.success());
        let before = fs::read(folder.path().join("o/summary.json")).unwrap();
        fs::remove_file(folder.path().join("o/drift.csv")).unwrap();
        std::os::unix::fs::symlink("/dev/full", folder.path().join("o/drift.csv")).unwrap();
        // Hours of flight that nobody needs to wait for.
        let done = run("run still.toml --out o --duration 1000000");
        let said = String::from_utf8(done.stderr).unwrap();
        assert_eq!(done.status.code(), Some(2), "{said}");
        assert!(said.contains("o/drift.csv: cannot be written: No space left"), "{said}");
        assert!(said.contains("the files in o are of an earlier run"), "{said}");
        assert!(fs::read(folder.path().join("o/summary.json")).unwrap() == before);
    }

    #[test]
    fn what_is_in_the_way_is_told_before_the_flight() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::write(at("file"), "").unwrap();
        fs::create_dir_all(at("o/summary.json")).unwrap();
        std::os::unix::fs::symlink("nowhere", at("link")).unwrap();
        let long = "x".repeat(300);
        for (out, words) in [
            ("file/a", "file is no folder"),
            ("link/a", "link is a link that leads nowhere"),
            ("o", "o/summary.json: cannot be written: it is a folder"),
            (long.as_str(), "name too long"),
            (&format!("new/{long}/a"), "name too long"),
        ] {
            // So long a flight would not end while the test lasts.
            let done = program(&format!("run --duration 200000000 --out {out}"))
                .current_dir(folder.path())
                .output()
                .unwrap();
            let said = String::from_utf8(done.stderr).unwrap();
            assert_eq!(done.status.code(), Some(2), "{said}");
            assert!(said.contains(words), "{out}: {said}");
        }
        assert_eq!(names(folder.path()), ["file", "link", "o"]);
    }
}

#[test]
fn what_was_flown_is_kept_in_place_of_an_earlier_flight() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("still.toml"), SCENE).unwrap();
    expect(folder.path(), "run still.toml --out o", 0, &[]);
    assert_eq!(summary(&folder.path().join("o")).get("ended"), None);

    let words = ["schuler: sample ", "pole", "earth-fixed"];
    let text = expect(folder.path(), "run polar --frame local-level --out o", 1, &words);
    assert!(text.contains("\nEnded early, after ") && text.contains("written to o"), "{text}");
    let out = folder.path().join("o");
    assert_eq!(names(&out), ["drift.csv", "drift.png", "report.html", "summary.json"]);
    let summary = summary(&out);
    assert_eq!(summary["scene"], "polar");
    let flown = summary["samples"].as_u64().unwrap();
    let ended = &summary["ended"];
    let sample = ended["sample"].as_u64().unwrap();
    // 640 m from the pole at 250 m/s, 50 Hz; the rows that a block or a window waits with are missing.
    assert!(flown < sample && sample < flown + 50, "{ended}");
    assert_eq!(ended["time_s"], sample as f64 / 50.0);
    assert_eq!(
        (&ended["planned_samples"], &ended["planned_duration_s"]),
        (&30_000.into(), &600.0.into())
    );
    assert!(ended["reason"].as_str().unwrap().contains("pole"), "{ended}");
    assert_eq!(summary["duration_s"], flown as f64 / 50.0);
    let rows = fs::read_to_string(out.join("drift.csv")).unwrap();
    assert_eq!(rows.lines().count() as u64, flown + 2);
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains("Ended early, after "), "the page does not say so");
}

#[test]
fn rows_up_to_a_lost_sample_are_kept() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("lossy.toml"), format!("{SCENE}[link]\nloss = 0.1\n")).unwrap();
    expect(folder.path(), "run lossy.toml --window 2,4,2", 1, &["was lost on the link"]);
    let summary = summary(&folder.path().join("out/lossy"));
    let flown = summary["samples"].as_u64().unwrap();
    assert_eq!(summary["ended"]["sample"], flown + 1);
    assert!(flown > 1, "{flown}");
}

#[test]
fn a_flight_that_does_not_begin_keeps_its_start() {
    let folder = tempfile::tempdir().unwrap();
    let spin = format!("{SCENE}roll_deg = {{ rate = 1e4 }}\n");
    fs::write(folder.path().join("spin.toml"), spin).unwrap();
    expect(folder.path(), "run spin.toml --window 2,4,2", 1, &["sample 1", "turns a block"]);
    let summary = summary(&folder.path().join("out/spin"));
    assert_eq!((&summary["samples"], &summary["ended"]["sample"]), (&0.into(), &1.into()));
}

#[test]
fn a_target_that_breaks_off_leaves_what_was_flown() {
    let folder = tempfile::tempdir().unwrap();
    let line = "paper --duration 30 --window 2,4,2 --out o";
    expect(folder.path(), &format!("run {line}"), 0, &[]);
    let lossy = format!("hil {line} --no-report --faults drop=0.3 --retries 1");
    let text = expect(folder.path(), &lossy, 1, &["lost on the link"]);
    assert!(text.contains("Ended early, after ") && !text.contains("agree in every bit"), "{text}");
    // The page of the flight before would not be of this one.
    assert_eq!(names(&folder.path().join("o")), ["drift.csv", "summary.json"]);
    let summary = summary(&folder.path().join("o"));
    assert!(summary["ended"]["sample"].as_u64().unwrap() < 600 && summary["link"].is_object());
}

#[test]
fn fewer_rows_are_written_where_fewer_are_wanted() {
    let folder = tempfile::tempdir().unwrap();
    let times_s = |options: &str| -> Vec<f64> {
        expect(folder.path(), &format!("run --duration 10 --no-report --out o {options}"), 0, &[]);
        let text = fs::read_to_string(folder.path().join("o/drift.csv")).unwrap();
        text.lines().skip(1).map(|row| row.split(',').next().unwrap().parse().unwrap()).collect()
    };
    let all = times_s("");
    assert_eq!(all.len(), 201);
    assert_eq!(times_s("--every 1"), all);
    assert_eq!(times_s("--every 80"), [0.0, 4.0, 8.0, 10.0]);
    assert_eq!(times_s("--every 4s"), [0.0, 4.0, 8.0, 10.0]);
    assert_eq!(times_s("--every 1000s"), [0.0, 10.0]);
    for wrong in ["0", "-1", "1.5", "0s", "nans", "infs", "s", "often"] {
        let line = format!("run --every {wrong}");
        expect(folder.path(), &line, 2, &["--every", "a number of rows, such as 10"]);
    }
}

#[test]
fn much_is_announced() {
    let folder = tempfile::tempdir().unwrap();
    // Nobody can fly it: the size is known before that.
    let spin = format!("{}roll_deg = {{ rate = 1e4 }}\n", SCENE.replace("= 2\n", "= 1e8\n"));
    fs::write(folder.path().join("spin.toml"), spin).unwrap();
    let line = "run spin.toml --window 2,4,2 --no-report";
    expect(folder.path(), line, 1, &["out/spin/drift.csv takes about", "GB", "--every N"]);
    let done = schuler(folder.path(), &format!("{line} --every 3600s"));
    assert!(!String::from_utf8_lossy(&done.stderr).contains("takes about"));
}
