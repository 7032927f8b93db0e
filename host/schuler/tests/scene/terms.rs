//! The table of sensor error terms: every field is in it, and everyone who walks it knows every entry.

use schuler::drift::compare::Drift;
use schuler::sensor::Timing;
use schuler::sensor::triad::Triad;
use schuler_host::report::parameters;
use schuler_simulator::emulator;
use schuler_simulator::scene::terms::{Source, TERMS};
use schuler_simulator::scene::{Scene, SensorErrors};
use schuler_simulator::theory::{Expected, Theory};

/// A scene that stands still with one key of a sensor's table.
fn with(table: &str, line: &str) -> Scene {
    let text = format!("[trajectory]\nroll_deg = 3\nlatitude_deg = 45\n[{table}]\n{line}\n");
    super::scene(&text).unwrap()
}

#[test]
fn every_field_is_in_the_table() {
    let each = |n: f64| Some([n; 3]);
    // No `..`: a field that is added must be thought of here.
    let errors = SensorErrors {
        constant: each(1.0),
        turn_on: each(2.0),
        gauss_markov: None,
        white: each(3.0),
        random_walk: each(4.0),
        bias_instability: each(5.0),
        scale_factor: each(6.0),
        misalignment: each(7.0),
        g_sensitivity: each(8.0),
        quantization: each(9.0),
        saturation: each(10.0),
    };
    let mut listed: Vec<_> = TERMS.iter().map(|t| (t.values)(&errors).unwrap()[0]).collect();
    listed.sort_by(f64::total_cmp);
    assert_eq!(listed, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0]);
    // What reads a field and what sets it are the same field.
    for term in TERMS {
        let mut errors = SensorErrors::default();
        *(term.values_mut)(&mut errors) = each(1.0);
        assert_eq!((term.values)(&errors), each(1.0), "{}", term.name);
    }
}

#[test]
fn every_term_is_parsed_built_reported_and_known_to_theory() {
    for term in TERMS {
        let keys = [("gyro", term.gyro), ("accelerometer", term.accelerometer)];
        assert!(keys.iter().any(|(_, key)| key.is_some()), "{}", term.name);
        for (table, key) in keys {
            let Some(key) = key else { continue };
            let scene = with(table, &format!("{} = 2", key.key));
            let errors = if table == "gyro" { &scene.gyro } else { &scene.accelerometer };
            assert_eq!((term.values)(errors), Some([2.0 * key.unit; 3]), "{}", key.key);

            // Built: the sensors are not perfect, and no two terms are the same one.
            assert!(emulator::build(&scene).is_ok(), "{}", key.key);
            let timing = Timing::new(0.05, 200).unwrap();
            let mut triad = Triad::PERFECT;
            (term.build)(&mut triad, [2.0 * key.unit; 3].into(), timing).unwrap();
            assert_ne!(triad, Triad::PERFECT, "{}", key.key);

            let rows = parameters::sensors(&scene);
            assert_eq!(rows.len(), 1, "{}", key.key);
            assert_eq!(rows[0][0], term.name);
            let shown = format!("2 {}", key.symbol);
            assert!(rows[0][1..].contains(&shown), "{rows:?}");

            let Expected { mean, sigma } = Theory::new(&scene).unwrap().at(10.0);
            let zero = Drift::default();
            let moved = [mean != zero, sigma != zero];
            match term.source {
                Source::Systematic(_) => assert_eq!(moved, [true, false], "{}", key.key),
                Source::LeftOut => assert_eq!(moved, [false, false], "{}", key.key),
                _ => assert_eq!(moved, [false, true], "{}", key.key),
            }
        }
    }
}
