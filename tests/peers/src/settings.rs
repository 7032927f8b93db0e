//! What the filters are told: the true numbers of a scene, each under a key that names its unit, one a line. Filters in
//! other languages read the same file.

use crate::{Failed, files};
use std::fmt::Write as _;
use std::path::Path;
use toml::{Table, Value};

/// A degree per root hour and per hour, an arc second, a micro-g, in SI units.
const DEGREE: f64 = std::f64::consts::PI / 180.0;
const ARCSEC: f64 = DEGREE / 3600.0;
const MICRO_G: f64 = 9.80665e-6;

/// A folder's `settings.toml` from its `scene.toml`.
pub fn write(folder: &Path) -> Result<(), Failed> {
    let scene: Table = files::text(&folder.join("scene.toml"))?.parse()?;
    // The root of an hour is 60 roots of a second, its inverse an hour's per second.
    let rows = [
        ("rate_hz", number(&scene, "", "rate_hz")?),
        (
            "gyro_noise_rad_root_s",
            number(&scene, "gyro", "angle_random_walk_deg_sqrt_h")? * DEGREE / 60.0,
        ),
        ("gyro_bias_rad_s", number(&scene, "gyro", "turn_on_bias_deg_h")? * ARCSEC),
        (
            "accelerometer_noise_m_s_root_s",
            number(&scene, "accelerometer", "velocity_random_walk_m_s_sqrt_h")? / 60.0,
        ),
        ("accelerometer_bias_m_s2", number(&scene, "accelerometer", "turn_on_bias_ug")? * MICRO_G),
        ("position_m", alike(&scene, &["north_m_sigma", "east_m_sigma", "down_m_sigma"])?),
        ("velocity_m_s", alike(&scene, &["north_m_s_sigma", "east_m_s_sigma", "down_m_s_sigma"])?),
        (
            "level_rad",
            alike(&scene, &["attitude_north_arcsec_sigma", "attitude_east_arcsec_sigma"])? * ARCSEC,
        ),
        ("heading_rad", alike(&scene, &["attitude_down_arcsec_sigma"])? * ARCSEC),
        ("fix_position_m", number(&scene, "gnss", "position_m")?),
        ("fix_velocity_m_s", number(&scene, "gnss", "velocity_m_s")?),
    ];
    let mut text = String::new();
    for (key, number) in rows {
        writeln!(text, "{key} = {number:?}")?;
    }
    let lever = numbers(&scene, &["gnss", "lever_arm_m"])?;
    let [outage] = lists(&scene, &["gnss", "outages_s"])?;
    for (keys, numbers) in [
        (&["lever_forward_m", "lever_right_m", "lever_down_m"][..], lever),
        (&["outage_from_s", "outage_until_s"], outage),
    ] {
        for (key, number) in keys.iter().zip(numbers) {
            writeln!(text, "{key} = {number:?}")?;
        }
    }
    files::write(&folder.join("settings.toml"), &text)
}

/// A number of a section, or of the scene itself.
fn number(scene: &Table, section: &str, key: &str) -> Result<f64, Failed> {
    let table =
        if section.is_empty() { Some(scene) } else { scene.get(section).and_then(Value::as_table) };
    let found = table.and_then(|table| table.get(key)).and_then(as_number);
    found.ok_or_else(|| format!("scene.toml: {section} {key} must be one number").into())
}

/// The one standard deviation of several axes of the initial error: filters are told one.
fn alike(scene: &Table, keys: &[&str]) -> Result<f64, Failed> {
    let all = keys
        .iter()
        .map(|key| number(scene, "initial_error", key))
        .collect::<Result<Vec<_>, _>>()?;
    match all.first() {
        Some(first) if all.iter().all(|one| one == first) => Ok(*first),
        _ => Err(format!("scene.toml: {} must be the same", keys.join(", ")).into()),
    }
}

fn numbers(scene: &Table, path: &[&str]) -> Result<Vec<f64>, Failed> {
    let all = array(scene, path)?.iter().map(as_number).collect::<Option<_>>();
    all.ok_or_else(|| format!("scene.toml: {} must be numbers", path.join(" ")).into())
}

fn lists<const N: usize>(scene: &Table, path: &[&str]) -> Result<[Vec<f64>; N], Failed> {
    let of = |one: &Value| one.as_array()?.iter().map(as_number).collect::<Option<Vec<_>>>();
    let all = array(scene, path)?.iter().map(of).collect::<Option<Vec<_>>>();
    let all = all.and_then(|all| all.try_into().ok());
    all.ok_or_else(|| format!("scene.toml: {} must be {N} lists of numbers", path.join(" ")).into())
}

fn array<'a>(scene: &'a Table, path: &[&str]) -> Result<&'a [Value], Failed> {
    let [section, key] = path else { return Err("a section and a key".into()) };
    let found = scene.get(*section).and_then(|table| table.get(*key)).and_then(Value::as_array);
    Ok(found.ok_or_else(|| format!("scene.toml: no list {section} {key}"))?)
}

fn as_number(value: &Value) -> Option<f64> {
    value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64))
}
