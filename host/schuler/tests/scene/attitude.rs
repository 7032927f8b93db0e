//! Errors of attitude are rotations about north, east and down, and are called so.

use super::errors::expect_more;
use schuler_simulator::scene::parse;

#[test]
fn the_former_names_of_attitude_errors_lead_to_those_of_today() {
    for (former, axis) in [("roll", "north"), ("pitch", "east"), ("yaw", "down")] {
        let key = format!("initial_error.{former}_arcsec");
        let text = format!("[initial_error]\n{former}_arcsec = 1\n");
        let name = format!("the rotation about {axis} is `attitude_{axis}_arcsec`");
        expect_more(&text, 4, &key, &[&name, "north_m", "attitude_down_arcsec"]);
    }
}

/// At a yaw of 90° the nose points east: a rotation about north is what a pilot calls an error of pitch.
#[test]
fn an_attitude_error_is_a_rotation_about_its_axis() {
    let text = "duration_s = 1\nrate_hz = 20\n[trajectory]\nyaw_deg = 90\n\
        [initial_error]\nattitude_north_arcsec = 100\n";
    let scene = parse::scene("s.toml", text).expect("valid");
    let truth = schuler::solution::Solution::new(
        Default::default(),
        Default::default(),
        schuler::solution::Euler { roll: 0.0, pitch: 0.0, yaw: std::f64::consts::FRAC_PI_2 },
    );
    let start = schuler_simulator::simulate::offset(&truth, &scene).euler();
    let arcsec = 1.0_f64.to_radians() / 3600.0;
    assert!((start.pitch / arcsec + 100.0).abs() < 1e-6, "{start:?}");
    assert!((start.roll / arcsec).abs() < 1e-6, "{start:?}");
}
