//! Ports that cannot have the same bits: limits field by field, and heads that contradict each other.

use super::audit::{golden_folder, printed, schuler};

#[test]
fn a_port_keeps_its_limits_or_not() {
    let golden = golden_folder().join("paper").join("f64-local-level-textbook.chain");
    let text = std::fs::read_to_string(&golden).unwrap();
    let line = text.lines().find(|line| line.starts_with("nav 5 ")).unwrap();
    let mut words: Vec<String> = line.split(' ').map(str::to_owned).collect();
    // After stage and sample: three of position, sine, cosine, then the velocity to the north.
    let bits = u64::from_str_radix(&words[7], 16).unwrap() + 3;
    words[7] = format!("{bits:016x}");
    let folder = tempfile::tempdir().unwrap();
    let mine = folder.path().join("mine.chain");
    let head = text.replace("seed: 1\n", "seed: 2\n").replace("rate_hz: 20\n", "rate_hz: 20.0\n");
    std::fs::write(&mine, head.replace(line, &words.join(" "))).unwrap();
    let (golden, mine) = (golden.to_str().unwrap(), mine.to_str().unwrap());
    let out = folder.path().to_str().unwrap();
    for (limits, exit, said) in [
        (vec![], 1, "sample 5, stage nav, field velocity north: 3 ulp"),
        (vec!["--ulps", "3"], 0, "all of 24 words are within their limits"),
        (vec!["--ulps", "2"], 1, "1 of 24 words are beyond: first stage nav, field velocity north"),
        (vec!["--ulps", "0", "--within", "velocity=1e-9", "--out", out], 0, "within"),
        (vec!["--within", "1", "--ulps", "velocity=2"], 1, "BEYOND in 1 of"),
    ] {
        let output = schuler(&[vec!["compare", golden, mine], limits].concat());
        let text = crate::on_one_line(&printed(&output));
        assert_eq!(output.status.code(), Some(exit), "{text}");
        let first = "the heads contradict each other: seed is 1 in the one, 2 in the other ";
        assert!(text.starts_with(first) && text.contains(said), "{text}");
    }
    let json = std::fs::read_to_string(folder.path().join("audit.json")).unwrap();
    assert!(json.contains("\"limit\": \"1e-9\"") && json.contains("\"key\": \"seed\""), "{json}");
    for (limits, said) in [
        (["--ulps", "mass=1"], "has no field mass in common with the first chain"),
        (["--ulps", "some"], "N or FIELD=N"),
        (["--within", "velocity=-1"], "M or FIELD=M"),
    ] {
        let output = schuler(&[vec!["compare", golden, mine], limits.to_vec()].concat());
        let error = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(2) && error.contains(said), "{error}");
    }
}
