//! Motion against its samples: what is accepted is integrated exactly, what cannot be is refused.

use super::scene;
use schuler_simulator::source::Source;
use std::f64::consts::{FRAC_PI_2, TAU};

/// A roll of 0.01° about a body that heads east at the equator, where the Earth turns about no roll axis.
fn rolling(period_s: f64) -> String {
    format!(
        "[trajectory]\nyaw_deg = 90\nroll_deg = {{ harmonics = \
         [{{ amplitude = 0.01, period_s = {period_s:e}, phase_deg = -90 }}] }}\n"
    )
}

#[test]
fn the_shortest_period_that_is_named_is_accepted_and_integrated_exactly() {
    let error = scene(&rolling(3e-5)).expect_err("it is too fast").to_string();
    let words = "folder/bad.toml:5: trajectory.roll_deg: is too fast for 20 samples per second; \
        accepted: periods from ";
    let rest = error.strip_prefix(words).unwrap_or_else(|| panic!("{error}"));
    let period_s: f64 = rest.split(' ').next().expect("a number").parse().expect("a number");
    scene(&rolling(period_s / 1.1)).expect_err("a little faster");

    let scene = scene(&rolling(period_s)).unwrap_or_else(|e| panic!("{e}"));
    let source = Source::new(&scene, false).expect("one harmonic");
    let w = TAU / period_s;
    let roll = |n: u64| 0.01_f64.to_radians() * (w * source.time_s(n) - FRAC_PI_2).cos();
    for n in 1..10 {
        let increment = source.perfect_sample(n);
        let expected = roll(n) - roll(n - 1);
        // Each of 8192 evaluations rounds a rate of 3.5 rad/s at a phase of up to 10⁴ rad.
        assert!((increment.angle_b.x - expected).abs() < 1e-13, "{n}: {increment:?} {expected:e}");
    }
}

#[test]
fn what_is_shaken_or_spun_beyond_its_samples_is_refused() {
    let refused = |text: &str, key: &str, accepted: &str| {
        let error = scene(text).expect_err(text).to_string();
        for word in [key, "too fast for 20 samples per second", accepted] {
            assert!(error.contains(word), "{text}: {error}");
        }
    };
    let shaken = |key: &str, amplitude: f64, period_s: f64| {
        format!(
            "[trajectory]\nyaw_deg = {{ rate = 1 }}\n{key} = {{ harmonics = \
             [{{ amplitude = {amplitude:e}, period_s = {period_s:e} }}] }}\n"
        )
    };
    refused(&shaken("roll_deg", 1e-9, 1e-12), "5: trajectory.roll_deg", "periods from 3.");
    refused(&shaken("altitude_m", 1e-9, 1e-6), "5: trajectory.altitude_m", "periods from 3.");
    refused(&shaken("longitude_deg", 1e-15, 1e-6), "5: trajectory.longitude_deg", "periods from");
    let text = "duration_s = 5\nrate_hz = 1\n[trajectory]\nroll_deg = { rate = 9e4 }\n\
        pitch_deg = { rate = -1e5 }\n";
    let error =
        schuler_simulator::scene::parse::scene("spun.toml", text).expect_err(text).to_string();
    let words = "spun.toml:5: trajectory.pitch_deg: is too fast for 1 samples per second; \
        accepted: what turns slower by a factor of 1.658";
    assert!(error.starts_with(words), "{error}");
}
