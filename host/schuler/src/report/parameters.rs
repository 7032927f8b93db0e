//! The scene for people: every parameter in the unit of its file.

use schuler_simulator::course::Path;
use schuler_simulator::number;
use schuler_simulator::scene::route::{Origin, Route};
use schuler_simulator::scene::terms::{Key, TERMS, Term};
use schuler_simulator::scene::values::Values;
use schuler_simulator::scene::{Channel, GaussMarkov, Mounting, Scene, SensorErrors, Trajectory};
use schuler_simulator::units::{self, DEGREE};
use std::f64::consts::TAU;

fn parameter(value: f64) -> String {
    schuler_report::axis::printed(&number::parameter(value))
}

/// Names and what they are set to.
pub type Rows = Vec<Vec<String>>;

fn axes(values: &[f64; 3], unit: f64, name: &str) -> String {
    let shown = values.map(|value| parameter(value / unit));
    match shown.iter().all(|value| *value == shown[0]) {
        true => format!("{} {name}", shown[0]),
        false => format!("{} {name}", shown.join(", ")),
    }
}

/// The values of a term: for each axis, or row by row.
fn shown(values: Values, unit: f64, name: &str) -> String {
    match values {
        Values::Axes(values) => axes(&values, unit, name),
        Values::Rows(rows) => {
            let row = |row: [f64; 3]| row.map(|value| parameter(value / unit)).join(", ");
            format!("{} {name}", rows.map(row).join("; "))
        }
    }
}

/// A row per error term that either sensor has: its name, the gyro's value, the accelerometer's.
pub fn sensors(scene: &Scene) -> Rows {
    // Biases, whose unit is the constant one's, come before all else.
    let is_bias = |term: &Term| term.gyro.is_some_and(|key| key.symbol == "°/h");
    let (biases, others): (Vec<_>, Vec<_>) = TERMS.iter().partition(|term| is_bias(term));
    let both = |name: &str, cells: [Option<String>; 2]| {
        cells.iter().any(Option::is_some).then(|| {
            let [gyro, accelerometer] = cells.map(|cell| cell.unwrap_or_else(|| "—".to_owned()));
            vec![name.to_owned(), gyro, accelerometer]
        })
    };
    let markov = |sensor: &SensorErrors, unit: f64, name: &str| {
        sensor.gauss_markov.map(|GaussMarkov { rms, correlation_s }| {
            format!("{} rms, {}", axes(&rms, unit, name), axes(&correlation_s, 1.0, "s"))
        })
    };
    let (gyro, accelerometer) = (&scene.gyro, &scene.accelerometer);
    let mut rows: Rows = biases
        .into_iter()
        .chain(others)
        .filter_map(|term| {
            let cell = |sensor, key: Option<Key>| {
                let values = (term.values)(sensor)?;
                key.map(|Key { unit, symbol, .. }| shown(values, unit, symbol))
            };
            both(term.name, [cell(gyro, term.gyro), cell(accelerometer, term.accelerometer)])
        })
        .collect();
    let markovs =
        [markov(gyro, units::DEGREE_PER_HOUR, "°/h"), markov(accelerometer, units::MICRO_G, "µg")];
    rows.extend(both("Gauss-Markov bias", markovs));
    rows
}

/// A row per channel, its name and its formula, or what the path was made from; and what rides on it.
pub fn trajectory(scene: &Scene) -> Rows {
    let motion = &scene.trajectory;
    let mut rows = match (&motion.path, &motion.route) {
        (Some(path), Some(route)) => {
            let row = |name: &str, value: String| vec![name.to_owned(), value];
            vec![row("path", made_from(path, route)), row("attitude", route.attitude.to_owned())]
        }
        _ => channels(motion),
    };
    let Mounting { lever_arm_m, vibration } = &motion.mounting;
    if *lever_arm_m != [0.0; 3] {
        rows.push(vec!["lever arm".to_owned(), axes(lever_arm_m, 1.0, "m")]);
    }
    let shaken = [
        ("vibration, roll", &vibration.roll, DEGREE, "°"),
        ("vibration, pitch", &vibration.pitch, DEGREE, "°"),
        ("vibration, yaw", &vibration.yaw, DEGREE, "°"),
        ("vibration, forward", &vibration.forward, 1.0, " m"),
        ("vibration, right", &vibration.right, 1.0, " m"),
        ("vibration, down", &vibration.down, 1.0, " m"),
    ];
    let shaken = shaken.into_iter().filter(|(_, channel, ..)| **channel != Channel::default());
    rows.extend(shaken.map(|(name, channel, unit, symbol)| {
        vec![name.to_owned(), formula(channel, unit, symbol)]
    }));
    rows
}

/// What a path was made from, in words.
pub fn made_from(path: &Path, route: &Route) -> String {
    let (count, degree) = match path {
        Path::Spline(path) => (path.pieces().len(), 7),
        Path::Blend(path) => (path.pieces().len(), 11),
    };
    let from = match &route.from {
        Origin::Segments(flown) => format!("{} segments", flown.segments.len()),
        Origin::Waypoints { points, past: None } => format!("through {} way-points", points.len()),
        Origin::Waypoints { points, past: Some(_) } => format!("past {} way-points", points.len()),
        Origin::Log { file, rows, .. } => format!("{rows} rows of {file}"),
    };
    format!("{from}, {count} pieces of degree {degree}")
}

fn channels(t: &Trajectory) -> Rows {
    [
        ("roll", &t.roll, DEGREE, "°"),
        ("pitch", &t.pitch, DEGREE, "°"),
        ("yaw", &t.yaw, DEGREE, "°"),
        ("latitude", &t.latitude, DEGREE, "°"),
        ("longitude", &t.longitude, DEGREE, "°"),
        ("altitude", &t.altitude, 1.0, " m"),
    ]
    .into_iter()
    .map(|(name, channel, unit, symbol)| vec![name.to_owned(), formula(channel, unit, symbol)])
    .collect()
}

/// offset + rate·t + Σ amplitude·cos(2πt/period + phase).
fn formula(channel: &Channel, unit: f64, symbol: &str) -> String {
    let mut terms = Vec::new();
    if channel.offset != 0.0 {
        terms.push(format!("{}{symbol}", parameter(channel.offset / unit)));
    }
    if channel.rate != 0.0 {
        terms.push(format!("{}{symbol}/s · t", parameter(channel.rate / unit)));
    }
    for harmonic in &channel.harmonics {
        let phase = match harmonic.phase {
            0.0 => String::new(),
            phase => format!(" + {}°", parameter(phase / DEGREE)),
        };
        let amplitude = parameter(harmonic.amplitude / unit);
        let period = parameter(TAU / harmonic.angular_rate);
        terms.push(format!("{amplitude}{symbol} cos(2πt/{period} s{phase})"));
    }
    if terms.is_empty() { format!("0{symbol}") } else { terms.join(" + ").replace("+ −", "− ") }
}

/// How the scene is navigated, what its start is off by, and what its link does.
pub fn navigation(scene: &Scene) -> Rows {
    let n = &scene.navigator;
    let row = |name: &str, value: String| vec![name.to_owned(), value];
    let mut rows = vec![
        row("frame", n.frame.name().to_owned()),
        row("precision", n.precision.name().to_owned()),
        row("algorithm", n.algorithm.name().to_owned()),
        row("vertical channel", n.vertical.name().to_owned()),
        row("missing sample", n.gap.name().to_owned()),
        row("samples lost", format!("{} %", parameter(100.0 * scene.link.loss))),
        row("sampling jitter, rms", format!("{} s", parameter(scene.link.jitter_s))),
    ];
    let start = &scene.initial_error;
    for (name, values, unit, symbol) in [
        ("start off by, position", &start.position_m, 1.0, "m"),
        ("start off by, velocity", &start.velocity_m_s, 1.0, "m/s"),
        (
            "start off by, attitude about north, east, down",
            &start.attitude_rad,
            units::ARCSECOND,
            "arcsec",
        ),
    ] {
        if *values != [0.0; 3] {
            rows.push(row(name, axes(values, unit, symbol)));
        }
    }
    for (name, values, unit, symbol) in [
        ("start drawn with σ, position", &start.position_sigma_m, 1.0, "m"),
        ("start drawn with σ, velocity", &start.velocity_sigma_m_s, 1.0, "m/s"),
        ("start drawn with σ, attitude", &start.attitude_sigma_rad, units::ARCSECOND, "arcsec"),
    ] {
        if *values != [0.0; 3] {
            rows.push(row(name, axes(values, unit, symbol)));
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::super::sample;
    use super::*;

    #[test]
    fn values_stand_in_their_files_units() {
        let mut scene = sample::flight().scene;
        scene.accelerometer.scale_factor = Some([1e-6, -2e-6, 3e-6]);
        let rows = sensors(&scene);
        let row = |name: &str| rows.iter().find(|row| row[0] == name).unwrap()[1..].to_vec();
        assert_eq!(row("constant bias"), ["0.1 °/h", "—"]);
        assert_eq!(row("angle, velocity random walk"), ["0.01 °/√h", "—"]);
        assert_eq!(row("scale factor"), ["—", "1, −2, 3 ppm"]);
        assert_eq!(row("Gauss-Markov bias"), ["0.1 °/h rms, 720 s", "100 µg rms, 720 s"]);
        assert!(sensors(&sample::perfect().scene).is_empty());
    }

    #[test]
    fn channels_read_as_formulas() {
        let scene = sample::flight().scene;
        let rows = trajectory(&scene);
        assert_eq!(rows[3], ["latitude", "45° + 5° cos(2πt/7200 s)"]);
        assert_eq!(rows[5], ["altitude", "3500 m + 2000 m cos(2πt/7200 s + 30°)"]);
        assert_eq!(formula(&Channel::default(), 1.0, " m"), "0 m");
        let channel = Channel { offset: 1.0, rate: -2.0, harmonics: Vec::new() };
        assert_eq!(formula(&channel, 1.0, " m"), "1 m − 2 m/s · t");
    }
}
