//! Summaries keep to `summary.schema.json`: what is written is in the schema, and what it asks for is written.

use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

fn schema() -> Value {
    let text = include_str!("../summary.schema.json");
    serde_json::from_str(text).expect("it is JSON")
}

/// What is wrong with a value by a schema: as much of JSON Schema as `summary.schema.json` is written in.
fn faults(schema: &Value, root: &Value, value: &Value, place: &str) -> Vec<String> {
    let known = [
        "$schema",
        "$defs",
        "$ref",
        "title",
        "description",
        "type",
        "const",
        "enum",
        "pattern",
        "minimum",
        "items",
        "properties",
        "required",
        "additionalProperties",
        "oneOf",
    ];
    let schema_keys = schema.as_object().expect("a schema is an object");
    for key in schema_keys.keys() {
        assert!(known.contains(&key.as_str()), "the test knows no {key}");
    }
    let fault = |what: String| vec![format!("{place}: {what}")];
    if let Some(reference) = schema["$ref"].as_str() {
        let name = reference.strip_prefix("#/$defs/").expect("a definition of its own");
        assert!(root["$defs"][name].is_object(), "{reference} leads nowhere");
        return faults(&root["$defs"][name], root, value, place);
    }
    if let Some(choices) = schema["oneOf"].as_array() {
        let all: Vec<_> = choices.iter().map(|one| faults(one, root, value, place)).collect();
        return match all.iter().filter(|faults| faults.is_empty()).count() {
            1 => Vec::new(),
            0 => all.into_iter().min_by_key(Vec::len).unwrap_or_default(),
            several => fault(format!("fits {several} of one")),
        };
    }
    let types = match &schema["type"] {
        Value::Array(types) => types.iter().filter_map(Value::as_str).collect(),
        one => one.as_str().into_iter().collect::<Vec<_>>(),
    };
    let is = |name: &&str| match *name {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "string" => value.is_string(),
        "number" => value.is_number(),
        "integer" => value.is_u64() || value.is_i64(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        other => panic!("the test knows no type {other}"),
    };
    if !types.is_empty() && !types.iter().any(is) {
        return fault(format!("{value} is not of {types:?}"));
    }
    if schema_keys.get("const").is_some_and(|only| only != value) {
        return fault(format!("{value} is not {}", schema["const"]));
    }
    if schema["enum"].as_array().is_some_and(|names| !names.contains(value)) {
        return fault(format!("{value} is not one of {}", schema["enum"]));
    }
    if let (Some(pattern), Some(text)) = (schema["pattern"].as_str(), value.as_str()) {
        let digits = pattern.strip_prefix("^[0-9a-f]{").and_then(|rest| rest.strip_suffix("}$"));
        let digits: usize = digits.and_then(|n| n.parse().ok()).expect("so many hex digits");
        if text.len() != digits || text.bytes().any(|b| !b"0123456789abcdef".contains(&b)) {
            return fault(format!("{text} is not {pattern}"));
        }
    }
    if let (Some(least), Some(number)) = (schema["minimum"].as_f64(), value.as_f64())
        && number < least
    {
        return fault(format!("{number} is below {least}"));
    }
    let mut found = Vec::new();
    if let (Some(items), true) = (schema_keys.get("items"), value.is_array()) {
        let items_of = value.as_array().into_iter().flatten().enumerate();
        found.extend(
            items_of.flat_map(|(i, item)| faults(items, root, item, &format!("{place}[{i}]"))),
        );
    }
    if let (Some(properties), Some(object)) = (schema["properties"].as_object(), value.as_object())
    {
        for (key, inner) in object {
            match properties.get(key) {
                Some(schema) => {
                    found.extend(faults(schema, root, inner, &format!("{place}.{key}")))
                }
                None => found.push(format!("{place}.{key}: is not in the schema")),
            }
        }
        for key in schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str) {
            assert!(properties.contains_key(key), "{key} is required, and not described");
            if !object.contains_key(key) {
                found.push(format!("{place}.{key}: is missing"));
            }
        }
        assert_eq!(schema["additionalProperties"], false, "{place} is open");
    }
    found
}

/// Runs the program; it must end as it should.
fn schuler(folder: &Path, line: &str, code: i32) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_schuler"));
    let done = command.current_dir(folder).args(line.split_whitespace()).output().unwrap();
    let said = String::from_utf8_lossy(&done.stderr);
    assert_eq!(done.status.code(), Some(code), "{line}: {said}");
}

#[track_caller]
fn summary(path: &Path, kind: &str) -> Value {
    let text = fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let summary: Value = serde_json::from_str(&text).expect("it is JSON");
    let found = faults(&schema(), &schema(), &summary, "");
    assert!(found.is_empty(), "{found:#?}");
    assert_eq!(summary["kind"], kind);
    summary
}

#[test]
fn whatever_writes_a_summary_keeps_to_the_schema() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let folder = folder.path();
    let mut seen = BTreeSet::new();
    let mut note = |summary: &Value, kind: &str| {
        let keys = summary.as_object().expect("an object").keys();
        seen.extend(keys.map(|key| format!("{kind}.{key}")));
    };
    let scene =
        "duration_s = 20\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\naltitude_m = 30000\n";
    fs::write(at("high.toml"), scene).unwrap();
    schuler(folder, "run high.toml --out high --rows --vertical held", 0);
    let high = summary(&at("high/summary.json"), "run");
    note(&high, "run");
    assert_eq!((&high["vertical"], &high["schema_version"]), (&json!("held"), &json!(1)));
    assert_eq!(high["version"], env!("CARGO_PKG_VERSION"));
    let command = "schuler run high.toml --out high --rows --vertical held";
    assert_eq!(high["command"], json!(command.split(' ').collect::<Vec<_>>()));
    let files = ["drift.csv", "drift.png", "report.html", "nav.csv", "truth.csv", "summary.json"];
    assert_eq!(high["files"], json!(files));
    assert!(files.iter().all(|name| at("high").join(name).is_file()));
    // SHA-256 by another program.
    let sum = Command::new("sha256sum").arg(at("high.toml")).output();
    if let Ok(sum) = sum {
        let sum = String::from_utf8(sum.stdout).unwrap();
        assert_eq!(high["scene_sha256"].as_str(), sum.split_whitespace().next());
    }

    schuler(folder, "run paper --duration 10 --algorithm textbook --no-report --out textbook", 0);
    let textbook = summary(&at("textbook/summary.json"), "run");
    assert!(textbook["window"].is_null() && textbook["gap"] == "error");
    let lossy = format!("{scene}[link]\nloss = 0.3\n");
    fs::write(at("lossy.toml"), lossy).unwrap();
    schuler(folder, "run lossy.toml --out lossy --no-report", 1);
    note(&summary(&at("lossy/summary.json"), "run"), "run");
    schuler(folder, "run lossy.toml --out lossy --no-report --gap bridge", 0);
    assert_eq!(summary(&at("lossy/summary.json"), "run")["gap"], "bridge");
    schuler(folder, "hil paper --duration 5 --no-report --faults drop=0.01 --out hil", 0);
    note(&summary(&at("hil/summary.json"), "hil"), "run");
    schuler(folder, "ensemble --runs 4 --duration 30 --vertical held --out many", 0);
    let many = summary(&at("many/ensemble.json"), "ensemble");
    assert_eq!((&many["runs"], &many["vertical"]), (&json!(4), &json!("held")));
    note(&many, "ensemble");
    schuler(folder, "ensemble aided-drive --runs 4 --duration 30 --out aided", 0);
    note(&summary(&at("aided/ensemble.json"), "ensemble"), "ensemble");
    schuler(folder, "run aided-drive --duration 30 --no-report --out drive", 0);
    let drive = summary(&at("drive/summary.json"), "run");
    assert_eq!(drive["measurements"]["sensors"][0]["accepted"], 30);
    note(&drive, "run");
    schuler(folder, "emulate high.toml --out imu.csv --truth truth.csv", 0);
    let line = "replay --imu imu.csv --initial initial.toml --reference truth.csv --out again/";
    schuler(folder, line, 0);
    note(&summary(&at("again/summary.json"), "replay"), "replay");
    let line =
        "emulate aided-drive --duration 30 --gnss gnss.csv --out road.csv --truth road-truth.csv";
    schuler(folder, line, 0);
    let line = "replay --imu road.csv --initial initial.toml --gnss gnss.csv --sensors aided-drive \
        --reference road-truth.csv --out road/";
    schuler(folder, line, 0);
    let road = summary(&at("road/summary.json"), "replay");
    assert!(road["claimed"]["position_m"].as_f64().unwrap() > 0.0, "{road}");
    note(&road, "replay");
    let page = std::fs::read_to_string(at("road/report.html")).unwrap();
    assert!(page.contains("The filter says: 1σ"));
    let head = std::fs::read_to_string(at("road/drift.csv")).unwrap();
    assert!(head.lines().next().unwrap().ends_with("attitude_down_arcsec_sigma"), "{head:.300}");

    // And every key of the schema has been written by one of them.
    let schema = schema();
    for kind in ["run", "replay", "ensemble"] {
        for key in schema["$defs"][kind]["properties"].as_object().expect("it has some").keys() {
            assert!(seen.contains(&format!("{kind}.{key}")), "nothing has written {kind}.{key}");
        }
    }
}

#[test]
fn the_schema_refuses_what_is_none() {
    let folder = tempfile::tempdir().unwrap();
    schuler(folder.path(), "run paper --duration 2 --no-report --out o", 0);
    let right = summary(&folder.path().join("o/summary.json"), "run");
    let refuses = |change: &dyn Fn(&mut Value), words: &str| {
        let mut wrong = right.clone();
        change(&mut wrong);
        let found = faults(&schema(), &schema(), &wrong, "").join("\n");
        assert!(found.contains(words), "{words}: {found}");
    };
    refuses(&|s| s["seed"] = json!("1"), ".seed: \"1\" is not of");
    refuses(&|s| s["wobble"] = json!(1), ".wobble: is not in the schema");
    refuses(&|s| s["error"]["max"]["wobble"] = json!(1), ".error.max.wobble: is not in the schema");
    refuses(&|s| drop(s.as_object_mut().unwrap().remove("digest")), ".digest: is missing");
    refuses(&|s| s["digest"] = json!("xyz"), "is not ^[0-9a-f]{16}$");
    refuses(&|s| s["frame"] = json!("sideways"), "is not one of");
    refuses(&|s| s["schema_version"] = json!(2), ".schema_version: 2 is not 1");
    refuses(&|s| s["samples"] = json!(-1), "is below 0");
}
