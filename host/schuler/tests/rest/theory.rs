//! Theory is not printed beside what it does not know.

use super::schuler;
use serde_json::Value;
use std::fs;

#[test]
fn theory_ends_where_its_model_does() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let run = |errors: &str| {
        let scene = format!(
            "duration_s = 60\nrate_hz = 20\n[trajectory]\nlatitude_deg = 45\nroll_deg = 3\n\
             [gyro]\nangle_random_walk_deg_sqrt_h = 0.01\n{errors}"
        );
        fs::write(folder.join("x.toml"), scene).unwrap();
        let (code, out, said) = schuler(folder, &["run", "x.toml", "--no-report", "--out", "o"]);
        assert_eq!(code, Some(0), "{said}");
        let summary = fs::read_to_string(folder.join("o/summary.json")).unwrap();
        let summary: Value = serde_json::from_str(&summary).unwrap();
        (out, summary["theory"]["final_sigma"]["north_m"].is_null())
    };
    let (out, is_null) = run("");
    assert!(!out.contains("not comparable") && !is_null, "{out}");
    for (errors, words) in [
        ("[initial_error]\nattitude_down_arcsec = 72000\n", "are no small rotations"),
        ("[initial_error]\nattitude_north_arcsec = 7200\n", "second-order terms of attitude"),
        ("turn_on_bias_deg_h = 10000\n", "linear model ends"),
        ("quantization_arcsec = 1000\n", "gyro steps of 1000″ are coarse"),
        ("[accelerometer]\nquantization_m_s = 2\n", "accelerometer steps of 2.000 m/s are coarse"),
    ] {
        let (out, is_null) = run(errors);
        let text = crate::on_one_line(&out);
        assert!(text.contains("Theory: not comparable") && text.contains(words), "{errors}: {out}");
        assert!(is_null, "{errors}");
        let last = out.lines().find(|line| line.trim_start().starts_with("60.00")).unwrap();
        assert!(!last.contains('±'), "{last}");
    }
}
