//! Defaults, and every key's unit against numbers computed apart from the program.

use super::scene;
use schuler_simulator::scene::*;
use std::f64::consts::{FRAC_PI_2, PI};

/// Equal but for the rounding of the conversion.
#[track_caller]
fn close(value: f64, expected: f64) {
    assert!((value - expected).abs() <= 1e-15 * expected.abs(), "{value:e} is not {expected:e}");
}

#[test]
fn what_is_left_out_has_its_default() {
    let scene = scene("").expect("it has all it needs");
    assert_eq!((scene.name.as_str(), scene.title.as_str()), ("bad", "bad"));
    assert_eq!((scene.duration_s, scene.rate_hz, scene.seed), (10.0, 20.0, 1));
    assert_eq!(scene.trajectory, Trajectory::default());
    assert_eq!(scene.gyro, SensorErrors::default());
    assert_eq!(scene.accelerometer, SensorErrors::default());
    assert_eq!(scene.initial_error, InitialError::default());
    assert_eq!(scene.link, Link::default());
    let navigator = Navigator {
        frame: Axes::LocalLevel,
        precision: Precision::F64,
        algorithm: Algorithm::Taylor,
        window: None,
        vertical: Vertical::Free,
        gap: Gap::Error,
    };
    assert_eq!(scene.navigator, navigator);
    assert_eq!(scene.samples(), 200);
}

#[test]
fn sensor_keys_in_si_units() {
    type Slot = fn(&Scene) -> Option<[f64; 3]>;
    // 2 of each unit; the figures are 2π/180/3600 and so on, to 17 digits.
    let cases: [(&str, &str, f64, Slot); 20] = [
        ("gyro", "constant_deg_h", 9.6962736221907197e-6, |s| s.gyro.constant),
        ("gyro", "turn_on_bias_deg_h", 9.6962736221907197e-6, |s| s.gyro.turn_on),
        ("gyro", "angle_random_walk_deg_sqrt_h", 5.8177641733144318e-4, |s| s.gyro.white),
        ("gyro", "rate_random_walk_deg_h_sqrt_h", 1.6160456036984533e-7, |s| s.gyro.random_walk),
        ("gyro", "bias_instability_deg_h", 9.6962736221907197e-6, |s| s.gyro.bias_instability),
        ("gyro", "scale_factor_ppm", 2e-6, |s| s.gyro.scale_factor),
        ("gyro", "misalignment_arcsec", 9.6962736221907197e-6, |s| s.gyro.misalignment),
        ("gyro", "g_sensitivity_deg_h_g", 9.8874474180180998e-7, |s| s.gyro.g_sensitivity),
        ("gyro", "quantization_arcsec", 9.6962736221907197e-6, |s| s.gyro.quantization),
        ("gyro", "saturation_deg_s", 3.4906585039886592e-2, |s| s.gyro.saturation),
        ("accelerometer", "constant_ug", 1.96133e-5, |s| s.accelerometer.constant),
        ("accelerometer", "turn_on_bias_ug", 1.96133e-5, |s| s.accelerometer.turn_on),
        ("accelerometer", "velocity_random_walk_m_s_sqrt_h", 1.0 / 30.0, |s| s.accelerometer.white),
        ("accelerometer", "acceleration_random_walk_ug_sqrt_h", 3.2688833333333333e-7, |s| {
            s.accelerometer.random_walk
        }),
        ("accelerometer", "bias_instability_ug", 1.96133e-5, |s| s.accelerometer.bias_instability),
        ("accelerometer", "scale_factor_ppm", 2e-6, |s| s.accelerometer.scale_factor),
        ("accelerometer", "misalignment_arcsec", 9.6962736221907197e-6, |s| {
            s.accelerometer.misalignment
        }),
        ("accelerometer", "quantization_m_s", 2.0, |s| s.accelerometer.quantization),
        ("accelerometer", "saturation_g", 19.6133, |s| s.accelerometer.saturation),
        ("gyro", "gauss_markov", 9.6962736221907197e-6, |s| s.gyro.gauss_markov.map(|p| p.rms)),
    ];
    for (table, key, expected, slot) in cases {
        let text = |value: &str| match key {
            "gauss_markov" => format!("[{table}.{key}]\nrms_deg_h = {value}\ncorrelation_s = 7\n"),
            _ => format!("[{table}]\n{key} = {value}\n"),
        };
        let parsed = |value| scene(&text(value)).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(
            slot(&parsed("2")),
            slot(&parsed("[2, 2.0, 2]")),
            "{key}: one value is all three"
        );
        let [x, y, z] = slot(&parsed("[2, 4, 6]")).unwrap_or_else(|| panic!("{key} is not set"));
        close(x, expected);
        close(y, 2.0 * expected);
        close(z, 3.0 * expected);
        // and nothing else is touched
        let mut other = parsed("2");
        other.gyro = SensorErrors::default();
        other.accelerometer = SensorErrors::default();
        let text_sha256 = other.text_sha256.clone();
        let without = scene("").expect("it has all it needs");
        assert_eq!(other, Scene { text_sha256, ..without }, "{key}");
    }
}

#[test]
fn gauss_markov_per_axis() {
    let text =
        "[accelerometer]\ngauss_markov = { rms_ug = [1, 2, 3], correlation_s = [4, 5, 6] }\n";
    let process = scene(text).expect("valid").accelerometer.gauss_markov.expect("given");
    close(process.rms[2], 2.941995e-5);
    assert_eq!(process.correlation_s, [4.0, 5.0, 6.0]);
}

#[test]
fn trajectory_channels() {
    let text = "[trajectory]\n\
        roll_deg = 0x10\n\
        pitch_deg = { rate = -0.5 }\n\
        yaw_deg = { offset = 1_80, harmonics = [{ amplitude = 2, period_s = 4, phase_deg = -90 }] }\n\
        latitude_deg = { harmonics = [{ amplitude = 1, period_s = 7200 }, { amplitude = -1e-6, period_s = 0.5 }] }\n\
        longitude_deg = 100.5\n\
        [trajectory.altitude_m]\n\
        offset = 3500\nrate = 2\n[[trajectory.altitude_m.harmonics]]\namplitude = 50\nperiod_s = 8\n";
    let motion = scene(text).expect("valid").trajectory;
    close(motion.roll.offset, 0.27925268031909273);
    close(motion.pitch.rate, -8.7266462599716479e-3);
    assert_eq!(motion.pitch.offset, 0.0);
    close(motion.yaw.offset, PI);
    let [yaw] = motion.yaw.harmonics[..] else { panic!("one harmonic was given") };
    close(yaw.amplitude, 3.4906585039886592e-2);
    close(yaw.angular_rate, FRAC_PI_2);
    close(yaw.phase, -FRAC_PI_2);
    let [slow, fast] = motion.latitude.harmonics[..] else { panic!("two harmonics were given") };
    close(slow.angular_rate, 8.7266462599716479e-4);
    assert_eq!(slow.phase, 0.0);
    close(fast.amplitude, -1.7453292519943296e-8);
    close(fast.angular_rate, 12.566370614359173);
    close(motion.longitude.offset, 1.7540558982543012);
    assert_eq!((motion.altitude.offset, motion.altitude.rate), (3500.0, 2.0));
    assert_eq!(motion.altitude.harmonics[0].amplitude, 50.0);
}

#[test]
fn initial_error_in_north_east_down() {
    let text = "[initial_error]\nnorth_m = 1\neast_m = 2\ndown_m = 3\n\
        north_m_s = 4\neast_m_s = 5\ndown_m_s = 6\n\
        attitude_north_arcsec = 3600\nattitude_east_arcsec = -7200\nattitude_down_arcsec = 10800\n";
    let error = scene(text).expect("valid").initial_error;
    assert_eq!(error.position_m, [1.0, 2.0, 3.0]);
    assert_eq!(error.velocity_m_s, [4.0, 5.0, 6.0]);
    close(error.attitude_rad[0], 1.7453292519943296e-2);
    close(error.attitude_rad[1], -3.4906585039886592e-2);
    close(error.attitude_rad[2], 5.2359877559829887e-2);
    assert!(!error.is_random());
}

#[test]
fn sigma_of_the_initial_error_in_north_east_down() {
    let text = "[initial_error]\nnorth_m = 1\nnorth_m_sigma = 2\neast_m_sigma = 3\ndown_m_sigma = 4\n\
        north_m_s_sigma = 5\neast_m_s_sigma = 6\ndown_m_s_sigma = 7\n\
        attitude_north_arcsec_sigma = 3600\nattitude_down_arcsec_sigma = 10800\n";
    let error = scene(text).expect("valid").initial_error;
    assert!(error.is_random());
    assert_eq!((error.position_m, error.position_sigma_m), ([1.0, 0.0, 0.0], [2.0, 3.0, 4.0]));
    assert_eq!((error.velocity_m_s, error.velocity_sigma_m_s), ([0.0; 3], [5.0, 6.0, 7.0]));
    assert_eq!((error.attitude_rad, error.attitude_sigma_rad[1]), ([0.0; 3], 0.0));
    close(error.attitude_sigma_rad[0], 1.7453292519943296e-2);
    close(error.attitude_sigma_rad[2], 5.2359877559829887e-2);
    for (line, key) in [
        ("north_m_sigma = -1", "north_m_sigma"),
        ("down_m_s_sigma = 1001", "down_m_s_sigma"),
        ("attitude_east_arcsec_sigma = nan", "attitude_east_arcsec_sigma"),
        ("up_m_sigma = 1", "up_m_sigma"),
    ] {
        let refused = scene(&format!("[initial_error]\n{line}\n")).expect_err(line);
        assert!(refused.key.as_deref().is_some_and(|found| found.ends_with(key)), "{refused}");
        assert!(refused.line.is_some(), "{refused}");
    }
}

#[test]
fn navigator_and_link() {
    let text = "title = \"T\"\nseed = 7\n[navigator]\nframe = \"earth-fixed\"\nprecision = \"f32\"\n\
        algorithm = \"taylor\"\nwindow = { history = 2, block = 4, lookahead = 2 }\n\
        vertical = \"held\"\ngap = \"bridge\"\n[link]\nloss = 0.25\njitter_s = 1e-4\n";
    let scene = scene(text).expect("valid");
    let navigator = Navigator {
        frame: Axes::EarthFixed,
        precision: Precision::F32,
        algorithm: Algorithm::Taylor,
        window: Some(WindowShape { history: 2, block: 4, lookahead: 2 }),
        vertical: Vertical::Held,
        gap: Gap::Bridge,
    };
    assert_eq!(scene.navigator, navigator);
    assert_eq!(scene.link, Link { loss: 0.25, jitter_s: 1e-4 });
    assert_eq!((scene.title.as_str(), scene.seed), ("T", 7));
    let written = super::scene("[navigator]\nwindow = \"2, 4,2\"\n").expect("valid").navigator;
    assert_eq!(written.window, Some(WindowShape { history: 2, block: 4, lookahead: 2 }));
    let auto = "[navigator]\nalgorithm = \"textbook\"\nwindow = \"auto\"\n";
    let navigator = super::scene(auto).expect("valid").navigator;
    assert_eq!((navigator.algorithm, navigator.window), (Algorithm::Textbook, None));
}
