//! Data sheets' units are those of scenes, times what the books say.

use schuler_simulator::allan::TRIADS;
use schuler_simulator::datasheet::{entries, keys, sections};
use schuler_simulator::scene::parse;

/// The number of a key in a text.
fn number(text: &str, key: &str) -> f64 {
    let line =
        text.lines().find(|line| line.starts_with(key)).unwrap_or_else(|| panic!("{key}: {text}"));
    line.split_once(" = ").unwrap().1.parse().unwrap()
}

#[test]
fn units_become_those_of_a_scene() {
    let text = sections(
        "sheet.toml",
        "sample_rate_hz = 100\n[gyro]\nnoise_density_mdps_sqrt_hz = 5\nin_run_bias_stability_deg_h = 6.642824703\n\
         scale_factor_percent = 0.1\nfull_scale_deg_s = 300\nresolution_mdps = 10\ncross_axis_percent = 0.1\n\
         g_sensitivity_deg_s_g = 0.01\nbandwidth_hz = 50\nlatency_ms = 5\noffset_percent_fs = 1\n\
         temperature_bias_mdps_k = 5\nnonlinearity_percent_fs = 0.1\n\
         [accelerometer]\nnoise_density_ug_sqrt_hz = 60\nbias_repeatability_mg = 2\nfull_scale_g = 8\n",
    )
    .unwrap();
    for (key, value) in [
        // 5e-3 °/s/√Hz × 60 √s/√h
        ("angle_random_walk_deg_sqrt_h", 0.3),
        // σ_min/√(2 ln 2/π)
        ("bias_instability_deg_h", 10.0),
        ("scale_factor_ppm", 1000.0),
        ("saturation_deg_s", 300.0),
        // 0.01 °/s × 0.01 s = 1e-4°
        ("quantization_arcsec", 0.36),
        ("bandwidth_hz", 50.0),
        ("latency_s", 0.005),
        // 3 °/s
        ("constant_deg_h", 10800.0),
        ("temperature_bias_deg_h_k", 18.0),
        ("g_sensitivity_deg_h_g", 36.0),
        // 60e-6 × 9.80665 m/s²/√Hz × 60
        ("velocity_random_walk_m_s_sqrt_h", 0.0353039),
        ("turn_on_bias_ug", 2000.0),
        ("saturation_g", 8.0),
    ] {
        let found = number(&text, key);
        assert!((found / value - 1.0).abs() < 1e-5, "{key}: {found}");
    }
    for note in [
        "B = σ_min/0.664",
        "nonlinearity_percent_fs: left out",
        "taken as rms",
        "so much of both other axes",
        // 1e-3 rad off the diagonal.
        "misalignment_matrix_arcsec = [[0, 206.265, 206.265], [206.265, 0, 206.265], [206.265, 206.265, 0]]",
        "[temperature]",
    ] {
        assert!(text.contains(note), "{note}: {text}");
    }
    // What is printed is a scene's.
    let scene = format!("duration_s = 1\nrate_hz = 100\n{text}");
    assert!(parse::scene("x.toml", &scene).is_ok(), "{text}");
}

#[test]
fn a_floor_may_be_that_of_a_random_walk() {
    // σ_min² = 2NK/√3: N = 1 °/√h = 1/60 °/√s, σ_min = 3 °/h = 1/1200 °/s.
    let text = sections(
        "sheet.toml",
        "bias_model = \"random-walk\"\n[gyro]\nangle_random_walk_deg_sqrt_h = 1\nin_run_bias_stability_deg_h = 3\n",
    )
    .unwrap();
    // K = √3/(2·1200²)·60 °/s/√s, × 3600 × 60 °/h/√h
    let expected = 3f64.sqrt() / 2.0 / 1200f64.powi(2) * 60.0 * 3600.0 * 60.0;
    let found = number(&text, "rate_random_walk_deg_h_sqrt_h");
    assert!((found / expected - 1.0).abs() < 1e-5, "{found} {expected}");
}

#[test]
fn what_is_wrong_in_a_data_sheet_is_told() {
    for (text, words) in [
        (
            "[gyro]\nnoise_densty_mdps_sqrt_hz = 5\n",
            &["sheet.toml:2", "noise_density_mdps_sqrt_hz"][..],
        ),
        ("[gyro]\nresolution_mdps = 5\n", &["sheet.toml:2", "sample_rate_hz"]),
        ("[gyro]\nnoise_density_mdps_sqrt_hz = -5\n", &["out of range", "from 0 up"]),
        (
            "[gyro]\nnoise_density_mdps_sqrt_hz = 5\nangle_random_walk_deg_sqrt_h = 1\n",
            &["sheet.toml:2", "another key gives, too"],
        ),
        ("[gyro]\noffset_percent_fs = 5\n", &["sheet.toml:2", "full scale, which is missing"]),
        (
            "[gyro]\nmisalignment_matrix_arcsec = [[0, 1], [1, 0]]\n",
            &["sheet.toml:2", "three rows [x, y, z]"],
        ),
        ("sample_rate_hz = 5\n", &["no table of a sensor"]),
        ("[gyro]\n\nbias_model = \"flicker\"\n", &["sheet.toml:3", "bias_model at the top"]),
        ("[gyro]\nsample_rate_hz = 5\n", &["sheet.toml:2", "sample_rate_hz at the top"]),
    ] {
        let error = sections("sheet.toml", text).unwrap_err().to_string();
        for word in words {
            assert!(error.contains(word), "{word}: {error}");
        }
    }
    assert!(keys().contains("noise_density_ug_sqrt_hz"));
}

#[test]
fn what_a_scene_refuses_is_not_written() {
    for (keys, words) in [
        // A scene takes 10° = 17.4533 %, and 100 %.
        ("cross_axis_percent = 17.46", "misalignment_matrix_arcsec: arcsec, from -36000 to 36000"),
        ("cross_axis_percent = [1, 500, 1]", "500 is out of range"),
        ("scale_factor_percent = 300", "scale_factor_ppm: ppm, from -1e6 to 1e6"),
        ("misalignment_deg = -11", "misalignment_arcsec: arcsec, from -36000 to 36000"),
        ("latency_ms = 1e6", "latency_s: seconds, from 0 to 8 samples"),
        (
            "noise_density_mdps_sqrt_hz = 1e300",
            "angle_random_walk_deg_sqrt_h: a number from 0 up to",
        ),
        ("angle_random_walk_deg_sqrt_h = 1e300", "a number from 0 up to 1e12"),
        ("full_scale_deg_s = 1e11\noffset_percent_fs = 1e9", "constant_deg_h: a number from"),
    ] {
        let sensor = format!("[gyro]\n{keys}\n");
        let error = sections("x.toml", &sensor).unwrap_err().to_string();
        let line = 1 + keys.lines().count();
        let start = format!("x.toml:{line}: gyro.");
        assert!(error.starts_with(&start) && error.contains(words), "{keys}: {error}");
        let scene = format!("duration_s = 1\nrate_hz = 1\n{sensor}");
        let refused = parse::scene("x.toml", &scene).unwrap_err().to_string();
        assert!(refused.contains(words), "{keys}: {refused}");
    }
    for taken in ["cross_axis_percent = 17.45", "scale_factor_percent = 100", "latency_ms = 8000"] {
        assert!(sections("x.toml", &format!("[gyro]\n{taken}\n")).is_ok(), "{taken}");
    }
    // Eight samples of 100 Hz.
    let latency = |key: &str| {
        sections("x.toml", &format!("sample_rate_hz = 100\n[gyro]\n{key}\n"))
            .map_err(|e| e.to_string())
    };
    assert!(latency("latency_ms = 80").is_ok());
    for key in ["latency_ms = 81", "latency_s = 0.081"] {
        let error = latency(key).unwrap_err();
        assert!(
            error.starts_with("x.toml:3: gyro.latency_") && error.contains("from 0 to 0.08"),
            "{error}"
        );
    }
}

#[test]
fn a_scene_takes_the_same_units() {
    let scene = |gyro: &str| {
        parse::scene("x.toml", &format!("duration_s = 1\nrate_hz = 20\n[gyro]\n{gyro}\n"))
    };
    let [own, sheet] = ["angle_random_walk_deg_sqrt_h = 0.3", "noise_density_mdps_sqrt_hz = 5"]
        .map(|gyro| scene(gyro).unwrap().gyro.white.unwrap()[0]);
    assert!((own / sheet - 1.0).abs() < 1e-14, "{own} {sheet}");
    let errors =
        scene("cross_axis_percent = [1, 2, 3]\nfull_scale_deg_s = 100\noffset_percent_fs = 2")
            .unwrap()
            .gyro;
    let expected = [[0.0, 0.01, 0.01], [0.02, 0.0, 0.02], [0.03, 0.03, 0.0]];
    assert_eq!(errors.misalignment_matrix, Some(expected));
    let offset = errors.constant.unwrap()[0];
    assert!((offset / 2f64.to_radians() - 1.0).abs() < 1e-14, "{offset}");
    let refused = scene("nonlinearity_percent_fs = 0.1").unwrap_err().to_string();
    assert!(refused.contains("x.toml:4") && refused.contains("are linear"), "{refused}");
    let both = "angle_random_walk_deg_sqrt_h = 0.3\nnoise_density_mdps_sqrt_hz = 5";
    assert!(scene(both).unwrap_err().to_string().contains("another key gives, too"));
}

/// Whatever the command takes a scene takes, too, and it becomes the same.
#[test]
fn a_scene_takes_every_key_of_a_data_sheet() {
    for (triad, table) in TRIADS.iter().enumerate() {
        let full_scale = ["full_scale_deg_s = 100\n", "full_scale_g = 8\n"][triad];
        for entry in entries::of(triad) {
            let key = entry.key;
            let full_scale = if key.ends_with("_fs") { full_scale } else { "" };
            let sensor = format!("[{table}]\n{full_scale}{key} = [0.002, 0.003, 0.004]\n");
            let warm =
                if key.starts_with("temperature_") { "[temperature]\noffset_k = 0\n" } else { "" };
            let top = "duration_s = 1\nrate_hz = 50\n";
            let scene = parse::scene("x.toml", &format!("{top}{sensor}{warm}"));
            let scene = scene.unwrap_or_else(|e| panic!("{e}"));
            let section = sections("x.toml", &format!("sample_rate_hz = 50\n{sensor}")).unwrap();
            let again = parse::scene("x.toml", &format!("{top}{section}")).unwrap();
            for (direct, pasted) in
                [(&scene.gyro, &again.gyro), (&scene.accelerometer, &again.accelerometer)]
            {
                for term in schuler_simulator::scene::terms::TERMS {
                    let [direct, pasted] = [direct, pasted].map(|errors| (term.values)(errors));
                    // What is printed has six digits.
                    let same = match (direct, pasted) {
                        (Some(direct), Some(pasted)) => direct
                            .rows()
                            .as_flattened()
                            .iter()
                            .zip(pasted.rows().as_flattened())
                            .all(|(a, b)| (a - b).abs() <= 1e-5 * a.abs()),
                        (direct, pasted) => direct.is_none() && pasted.is_none(),
                    };
                    assert!(same, "{key}, {}: {direct:?} {pasted:?}", term.name);
                }
            }
        }
    }
}

#[test]
fn temperatures_of_data_sheets_in_a_scene() {
    let text = "duration_s = 1\nrate_hz = 20\n[temperature]\nramp_k_min = 1\n\
        [gyro]\ntemperature_bias_mdps_k = 2\ntemperature_scale_factor_percent_k = 0.03\n\
        [accelerometer]\ntemperature_bias_mg_k = 0.5\n";
    let scene = parse::scene("x.toml", text).unwrap();
    let close = |found: Option<[f64; 3]>, expected: f64| {
        let found = found.expect("it is given")[2];
        assert!((found / expected - 1.0).abs() < 1e-14, "{found} {expected}");
    };
    close(scene.gyro.temperature_bias, 0.002 * std::f64::consts::PI / 180.0);
    close(scene.gyro.temperature_scale, 3e-4);
    close(scene.accelerometer.temperature_bias, 0.5e-3 * 9.80665);
}
