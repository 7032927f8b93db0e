//! The command itself, with the target in a process of its own.

use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

fn schuler(line: &str, out: &Path) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
    command.args(line.split_whitespace()).args(["--out".as_ref(), out.as_os_str()]);
    command.output().unwrap()
}

fn summary(out: &Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(out.join("summary.json")).unwrap()).unwrap()
}

/// Flies with a target and without one, and gives both summaries.
fn both(options: &str, link: &str) -> [Value; 2] {
    let folder = tempfile::tempdir().unwrap();
    let [target, alone] = ["target", "alone"].map(|name| folder.path().join(name));
    let run = schuler(&format!("run paper --no-report --window 0,4,0 {options}"), &alone);
    assert!(run.status.success(), "{run:?}");
    let hil = schuler(&format!("hil paper {options} {link}"), &target);
    let text = String::from_utf8_lossy(&hil.stdout).into_owned();
    assert!(hil.status.success(), "{text}{}", String::from_utf8_lossy(&hil.stderr));
    let [drift, alone_drift] = [&target, &alone].map(|out| std::fs::read(out.join("drift.csv")));
    assert_eq!(drift.unwrap(), alone_drift.unwrap());
    let summaries = [&target, &alone].map(|out| summary(out));
    let digest = summaries[0]["digest"].as_str().unwrap();
    assert!(text.contains(&format!("agree in every bit: digest {digest}")), "{text}");
    let page = std::fs::read_to_string(target.join("report.html")).unwrap();
    assert!(page.contains("The link to the target"));
    summaries
}

/// What no clock, no link and no command line has a say in.
fn results(summary: &Value) -> Value {
    let mut summary = summary.clone();
    let keys = summary.as_object_mut().unwrap();
    let others = ["time", "skipped", "link", "lockstep", "kind", "command", "files"];
    keys.retain(|key, _| !others.contains(&key.as_str()));
    summary
}

#[test]
fn a_target_in_a_process_of_its_own_flies_the_same_bits() {
    for precision in ["f32", "f64"] {
        let [hil, run] = both(&format!("--duration 60 --precision {precision}"), "");
        assert_eq!(results(&hil), results(&run));
        assert_eq!(hil["link"]["device"], "twin");
        assert_eq!(
            (&hil["lockstep"]["equal"], hil["lockstep"].get("latency")),
            (&true.into(), None)
        );
        assert_eq!(hil["link"]["worst_round_trips"], 1);
        assert!(run["link"].is_null());
    }
}

#[test]
fn faults_on_the_way_change_no_bit() {
    let link = "--faults all=0.2 --fault-seed 3 --retries 20";
    let [hil, run] = both("--duration 60 --precision f32", link);
    assert_eq!(results(&hil), results(&run));
    let spans = hil["lockstep"]["link_over_time"].as_array().unwrap();
    let count = |key: &str| spans.iter().map(|span| span[key].as_u64().unwrap()).sum::<u64>();
    assert!(spans.len() == 60 && count("faults") > 100, "{spans:?}");
    assert!(count("sent_again") <= hil["link"]["resent"].as_u64().unwrap());
    let link = &hil["link"];
    for fault in link["faults"].as_array().unwrap() {
        assert!(fault["to_target"].as_u64().unwrap() > 5, "{fault}");
    }
    assert_eq!(link["lost"], 0);
    assert!(link["recovered"].as_u64().unwrap() > 50, "{link}");
}

#[test]
fn in_real_time_latency_is_measured() {
    let folder = tempfile::tempdir().unwrap();
    let hil = schuler("hil paper --duration 1 --rate 50 --stream --no-report", folder.path());
    let text = String::from_utf8_lossy(&hil.stdout);
    assert!(hil.status.success() && text.contains("latency: median "), "{text}");
    assert!(text.contains(" of 50 answers took longer"), "{text}");
    assert!(summary(folder.path())["digest"].is_string());
}

#[test]
fn a_window_that_the_target_lacks_is_replaced_aloud() {
    let folder = tempfile::tempdir().unwrap();
    let hil = schuler("hil hard --duration 4 --rate 50 --no-report", folder.path());
    let text = String::from_utf8_lossy(&hil.stdout);
    assert!(hil.status.success(), "{hil:?}");
    assert!(text.contains("The target has no window 4,4,4: flown with 2,4,2.\n"), "{text}");
    let summary = summary(folder.path());
    let shape = |side| serde_json::json!({ "history": side, "block": 4, "lookahead": side });
    assert_eq!(summary["window"], shape(2));
    assert_eq!(summary["link"]["planned_window"], shape(4));
}

#[test]
fn what_is_not_to_be_had_is_named() {
    let folder = tempfile::tempdir().unwrap();
    for (line, code, part) in [
        (
            "hil paper --window 0,8,0",
            2,
            "navigator: the target does not fly f64 local-level taylor 0,8,0",
        ),
        ("hil paper --device qemu --image missing", 2, "missing: there is no such image; accepted"),
        ("hil paper --device tcp:127.0.0.1:1", 2, "--device: 127.0.0.1:1: "),
        ("hil paper --device serial:/nowhere", 2, "--device: /nowhere: "),
        ("hil paper --faults melt=1", 2, "melt is no fault"),
        ("hil paper --duration 30 --faults drop=0.3 --retries 1", 1, "lost on the link"),
    ] {
        let output = schuler(line, folder.path());
        let text = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{line}: {text}");
        assert!(text.contains(part), "{line}: {text}");
    }
}
