//! Every complaint names the file, the line and the key, and says what would be accepted.

use super::scene;
use schuler_simulator::scene::{load, parse};

/// What a scene's error must be: its line, its key, and words of its text.
fn expect(text: &str, line: u64, key: &str, words: &[&str]) {
    let error = parse::scene("folder/bad.toml", text).expect_err(text);
    let message = error.to_string();
    let start = format!("folder/bad.toml:{line}: {key}: ");
    assert!(message.starts_with(&start), "{text}\ngives {message}\nnot    {start}");
    for word in words {
        assert!(message.contains(word), "{text}\ngives {message}\nwithout {word}");
    }
}

/// The same of what follows the two needed lines.
pub fn expect_more(more: &str, line: u64, key: &str, words: &[&str]) {
    expect(&format!("duration_s = 10\nrate_hz = 20\n{more}"), line, key, words);
}

#[test]
fn unknown_keys_name_the_nearest() {
    expect_more("durations_s = 1\n", 3, "durations_s", &["did you mean `duration_s`", "rate_hz"]);
    expect_more("[gyro]\nwobble_deg = 1\n", 4, "gyro.wobble_deg", &["[gyro]", "constant_deg_h"]);
    expect_more("[gyro]\nconstant = 1\n", 4, "gyro.constant", &["did you mean `constant_deg_h`"]);
    expect_more("[trajectory]\nroll = 1\n", 4, "trajectory.roll", &["`roll_deg`"]);
    expect_more(
        "[accelerometer]\ng_sensitivity_deg_h_g = 1\n",
        4,
        "accelerometer.g_sensitivity_deg_h_g",
        &[],
    );
    expect_more("[gyro]\n\nconstant_ug = 1\n", 5, "gyro.constant_ug", &["`constant_deg_h`"]);
    expect_more(
        "[trajectory]\nyaw_deg = { harmonics = [\n{ amplitude = 1, period = 2 }] }\n",
        5,
        "trajectory.yaw_deg.harmonics[0].period",
        &["`period_s`", "phase_deg"],
    );
    expect_more("[gyros]\n", 3, "gyros", &["the top level", "`gyro`"]);
    // The first of several, in the order of the file.
    expect_more("[gyro]\nzebra = 1\nant = 1\n", 4, "gyro.zebra", &[]);
}

#[test]
fn missing_keys() {
    expect("rate_hz = 20\n", 1, "duration_s", &["is missing", "above 0"]);
    expect("duration_s = 20\n", 1, "rate_hz", &["is missing", "from 1 to 1e6"]);
    expect_more(
        "[gyro]\ngauss_markov = { rms_deg_h = 1 }\n",
        4,
        "gyro.gauss_markov.correlation_s",
        &["is missing", "seconds, above 0"],
    );
    expect_more(
        "[accelerometer.gauss_markov]\ncorrelation_s = 1\n",
        3,
        "accelerometer.gauss_markov.rms_ug",
        &["is missing"],
    );
    expect_more(
        "[trajectory]\nroll_deg = { harmonics = [{ amplitude = 1 }] }\n",
        4,
        "trajectory.roll_deg.harmonics[0].period_s",
        &["is missing"],
    );
    expect_more(
        "[navigator]\nwindow = { block = 4 }\n",
        4,
        "navigator.window.history",
        &["missing"],
    );
}

#[test]
fn wrong_types() {
    expect_more("title = 3\n", 3, "title", &["is an integer", "text"]);
    expect_more("seed = 1.5\n", 3, "seed", &["is a float", "an integer from 0"]);
    expect_more("gyro = 3\n", 3, "gyro", &["is an integer", "a table"]);
    expect_more(
        "[gyro]\nconstant_deg_h = \"much\"\n",
        4,
        "gyro.constant_deg_h",
        &["is a string", "[x, y, z]"],
    );
    expect_more(
        "[gyro]\nconstant_deg_h = [1, 2]\n",
        4,
        "gyro.constant_deg_h",
        &["2 values", "[x, y, z]"],
    );
    expect_more(
        "[gyro]\nconstant_deg_h = [1, 2,\n true]\n",
        5,
        "gyro.constant_deg_h[2]",
        &["boolean"],
    );
    expect_more(
        "[trajectory]\nroll_deg = true\n",
        4,
        "trajectory.roll_deg",
        &["boolean", "harmonics"],
    );
    expect_more(
        "[trajectory]\nroll_deg = { harmonics = 3 }\n",
        4,
        "trajectory.roll_deg.harmonics",
        &["a list"],
    );
    expect_more(
        "[navigator]\nframe = 1\n",
        4,
        "navigator.frame",
        &["\"local-level\", \"earth-fixed\""],
    );
    expect_more("[navigator]\nwindow = 4\n", 4, "navigator.window", &["\"auto\"", "history"]);
}

#[test]
fn numbers_that_are_not_finite() {
    expect("duration_s = inf\nrate_hz = 20\n", 1, "duration_s", &["inf is not a finite number"]);
    expect("duration_s = 1\nrate_hz = 1e999\n", 2, "rate_hz", &[]);
    expect_more(
        "[trajectory]\nroll_deg = nan\n",
        4,
        "trajectory.roll_deg",
        &["NaN", "a finite number"],
    );
    expect_more("[gyro]\nconstant_deg_h = [0, -inf, 0]\n", 4, "gyro.constant_deg_h[1]", &["-inf"]);
}

#[test]
fn values_out_of_range() {
    expect("duration_s = -1\nrate_hz = 20\n", 1, "duration_s", &["-1", "above 0"]);
    expect("duration_s = 0\nrate_hz = 20\n", 1, "duration_s", &["above 0"]);
    expect("duration_s = 1\nrate_hz = 0\n", 2, "rate_hz", &["from 1"]);
    expect("duration_s = 1\nrate_hz = 0.99\n", 2, "rate_hz", &["from 1"]);
    expect("rate_hz = 20\nduration_s = 0.01\n", 2, "duration_s", &["0 samples", "from 1 to"]);
    expect("duration_s = 1e9\nrate_hz = 1000\n", 1, "duration_s", &["4294967295"]);
    expect_more("seed = -1\n", 3, "seed", &["-1 is out of range", "18446744073709551615"]);
    for (table, rms) in [("gyro", "rms_deg_h"), ("accelerometer", "rms_ug")] {
        let process = format!("{table}.gauss_markov");
        let time = format!("[{process}]\n{rms} = 1\ncorrelation_s = ");
        expect_more(&format!("{time}-3\n"), 5, &format!("{process}.correlation_s"), &["above 0"]);
        expect_more(&format!("{time}0\n"), 5, &format!("{process}.correlation_s"), &["above 0"]);
        let spread = format!("[{process}]\n{rms} = -1\ncorrelation_s = 3\n");
        expect_more(&spread, 4, &format!("{process}.{rms}"), &["from 0 up"]);
    }
    let rms = [
        ("gyro", "turn_on_bias_deg_h"),
        ("gyro", "angle_random_walk_deg_sqrt_h"),
        ("gyro", "rate_random_walk_deg_h_sqrt_h"),
        ("gyro", "bias_instability_deg_h"),
        ("accelerometer", "turn_on_bias_ug"),
        ("accelerometer", "velocity_random_walk_m_s_sqrt_h"),
        ("accelerometer", "acceleration_random_walk_ug_sqrt_h"),
        ("accelerometer", "bias_instability_ug"),
    ];
    for (table, key) in rms {
        let text = format!("[{table}]\n{key} = -0.1\n");
        expect_more(&text, 4, &format!("{table}.{key}"), &["-0.1 is out of range", "from 0 up"]);
    }
    let steps = [
        ("gyro", "quantization_arcsec"),
        ("gyro", "saturation_deg_s"),
        ("accelerometer", "quantization_m_s"),
        ("accelerometer", "saturation_g"),
    ];
    for (table, key) in steps {
        expect_more(&format!("[{table}]\n{key} = 0\n"), 4, &format!("{table}.{key}"), &["above 0"]);
    }
    expect_more("[gyro]\nscale_factor_ppm = 2e6\n", 4, "gyro.scale_factor_ppm", &["ppm"]);
    expect_more(
        "[gyro]\nmisalignment_arcsec = 40000\n",
        4,
        "gyro.misalignment_arcsec",
        &["arcsec"],
    );
    expect_more("[link]\nloss = 1\n", 4, "link.loss", &["0 to below 1"]);
    expect_more("[link]\nloss = -0.1\n", 4, "link.loss", &["0 to below 1"]);
    expect_more("[link]\njitter_s = -1\n", 4, "link.jitter_s", &["from 0 up"]);
    expect_more("[link]\njitter_s = 0.0051\n", 4, "link.jitter_s", &["0 to 0.005"]);
}

#[test]
fn motion_out_of_range() {
    let channel = |key: &str, value: &str| format!("[trajectory]\n{key} = {value}\n");
    let altitude = |value, words| {
        expect_more(&channel("altitude_m", value), 4, "trajectory.altitude_m", words)
    };
    altitude("-20000", &["-10000 to 1000000"]);
    altitude("{ offset = 999000, rate = 101 }", &["1000010 m"]);
    altitude(
        "{ harmonics = [{ amplitude = 1e6, period_s = 1e5 }, { amplitude = 1, period_s = 9 }] }",
        &[],
    );
    altitude("{ harmonics = [{ amplitude = 100, period_s = 0.1 }] }", &["too fast"]);
    expect_more(
        &channel("roll_deg", "{ rate = 1.1e5 }"),
        4,
        "trajectory.roll_deg",
        &["1e5 degrees"],
    );
    let shaken = "{ harmonics = [{ amplitude = 1, period_s = 1e-200 }] }";
    expect_more(&channel("yaw_deg", shaken), 4, "trajectory.yaw_deg", &["too fast"]);
    expect_more(
        &channel("latitude_deg", "{ rate = 2 }"),
        4,
        "trajectory.latitude_deg",
        &["too fast"],
    );
    let period = "{ harmonics = [{ amplitude = 1, period_s = 0 }] }";
    expect_more(
        &channel("roll_deg", period),
        4,
        "trajectory.roll_deg.harmonics[0].period_s",
        &["above 0"],
    );
    let many = format!("{{ harmonics = [{}] }}", "{ amplitude = 1e-9, period_s = 9 },".repeat(65));
    expect_more(&channel("roll_deg", &many), 3, "trajectory", &["65 harmonics", "at most 64"]);
}

#[test]
fn angles_out_of_range() {
    let degrees = "-1e6 to 1e6";
    for channel in ["roll_deg", "pitch_deg", "yaw_deg", "latitude_deg", "longitude_deg"] {
        let key = format!("trajectory.{channel}");
        let text = format!("[trajectory]\n{channel} = 1.1e6\n");
        expect_more(&text, 4, &key, &["1100000 is out of range", degrees, "{ offset"]);
        let text = format!("[trajectory.{channel}]\noffset = -1e300\n");
        expect_more(&text, 4, &format!("{key}.offset"), &["out of range", degrees]);
        let text =
            format!("[[trajectory.{channel}.harmonics]]\namplitude = 1e12\nperiod_s = 1e12\n");
        expect_more(&text, 4, &format!("{key}.harmonics[0].amplitude"), &[degrees]);
    }
    let phase =
        "[[trajectory.altitude_m.harmonics]]\namplitude = 1\nperiod_s = 9\nphase_deg = 1e9\n";
    expect_more(phase, 6, "trajectory.altitude_m.harmonics[0].phase_deg", &[degrees]);
}

#[test]
fn names_and_windows() {
    for key in ["frame", "precision", "algorithm", "vertical", "gap"] {
        let text = format!("[navigator]\n{key} = \"sideways\"\n");
        expect_more(
            &text,
            4,
            &format!("navigator.{key}"),
            &["there is no \"sideways\"", "accepted: \""],
        );
    }
    let window = |shape: &str| format!("[navigator]\nwindow = {shape}\n");
    let text = window("\"2,4\"");
    expect_more(&text, 4, "navigator.window", &["\"2,4\" is not a window", "\"auto\"", "2,4,2"]);
    let unknown = window("\"2,0,2\"");
    expect_more(&unknown, 4, "navigator.window", &["there is no window 2,0,2", "2,4,2"]);
    let empty = window("{ history = 2, block = 0, lookahead = 2 }");
    expect_more(&empty, 4, "navigator.window", &["there is no window 2,0,2", "2,4,2"]);
    let long = window("{ history = 30, block = 30, lookahead = 30 }");
    expect_more(&long, 4, "navigator.window", &["there is no window 30,30,30", "2,4,2"]);
    let negative = window("{ history = -1, block = 4, lookahead = 2 }");
    expect_more(&negative, 4, "navigator.window.history", &["-1", "from 0 to 1000"]);
}

#[test]
fn broken_toml_names_the_line() {
    for (text, line) in
        [("title = \n", 1), ("a = 1\n\nb = [1,\n", 3), ("[gyro\n", 1), ("a = 1\na = 2\n", 2)]
    {
        let error = parse::scene("bad.toml", text).expect_err(text).to_string();
        assert!(error.starts_with(&format!("bad.toml:{line}: is not TOML: ")), "{text}: {error}");
    }
}

#[test]
fn scenes_that_are_not_there() {
    let error = load("no-such-scene").expect_err("there is none").to_string();
    for word in ["no-such-scene", "paper-perfect", "sea-state", "TOML"] {
        assert!(error.contains(word), "{error}");
    }
    assert!(load("papr").expect_err("there is none").to_string().contains("did you mean `paper`"));
    let error = load("no/such/file.toml").expect_err("there is none").to_string();
    assert!(error.starts_with("no/such/file.toml: cannot be read: "), "{error}");
}

#[test]
fn the_largest_values_are_still_taken() {
    let fine = "seed = 18446744073709551615\n[link]\nloss = 0.999999\njitter_s = 0.005\n\
        [trajectory]\ncrosses_pole = true\nlatitude_deg = 1000\naltitude_m = -10000\nroll_deg = { rate = 1e5 }\n";
    assert_eq!(scene(fine).expect("all in range").seed, u64::MAX);
}
