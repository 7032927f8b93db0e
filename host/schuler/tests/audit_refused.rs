//! What `schuler audit` refuses.

use super::audit::{alone, schuler};

#[test]
fn bad_input_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let empty = folder.path().to_str().unwrap();
    let noise = alone("paper", "noise", str::to_owned);
    let increments = alone("paper", "increments", str::to_owned);
    let (noise, increments) = (noise.path().to_str().unwrap(), increments.path().to_str().unwrap());
    let file = format!("{noise}/noise.chain");
    for (arguments, words) in [
        (vec!["compare", noise, &file], "is a folder, unlike the other; accepted: two chains"),
        (vec!["compare", &file, noise], "is a folder, unlike the other; accepted: two chains"),
        (
            vec!["compare", noise, increments],
            "lacks the chain noise; accepted: a folder with the chains of the other, or a single chain",
        ),
        (vec!["verify", empty], "holds no chain"),
        (vec!["verify", "/nowhere"], "cannot be read"),
        (vec!["record", "paper", "--out", empty, "--configuration", "f16"], "there is no f16"),
        (vec!["sensitivity", "hard", "--after", "61"], "no sample at 61 s"),
        (vec!["record", "papper", "--out", empty], "did you mean"),
    ] {
        let output = schuler(&arguments);
        let error = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{error}");
        assert!(error.contains(words), "{error}");
    }
}
