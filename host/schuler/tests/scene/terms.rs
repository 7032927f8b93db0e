//! The table of sensor error terms: every field is in it, and everyone who walks it knows every entry.

use schuler::drift::compare::Drift;
use schuler::sensor::Timing;
use schuler::sensor::temperature::Ramp;
use schuler::sensor::triad::Triad;
use schuler_host::report::parameters;
use schuler_simulator::emulator;
use schuler_simulator::scene::terms::{Conditions, Source, TERMS, Term};
use schuler_simulator::scene::values::Values;
use schuler_simulator::scene::{Scene, SensorErrors};
use schuler_simulator::theory::{Expected, Theory};

/// A scene that rocks with one key of a sensor's table.
fn with(table: &str, line: &str) -> Scene {
    let warm = if line.contains("temperature") { "[temperature]\noffset_k = 10\n" } else { "" };
    let roll = "roll_deg = { harmonics = [{ amplitude = 3, period_s = 7 }] }";
    let text = format!("[trajectory]\n{roll}\nlatitude_deg = 45\n{warm}[{table}]\n{line}\n");
    super::scene(&text).unwrap()
}

/// What each term is set to, in the unit of its file.
fn values(term: &Term) -> Values {
    match term.name {
        // Nine samples would be too many.
        "latency" => Values::Axes([0.125; 3]),
        _ if term.is_matrix => {
            Values::Rows([[2.0, 3.0, 5.0], [7.0, 11.0, 13.0], [17.0, 19.0, 23.0]])
        }
        _ => Values::Axes([2.0; 3]),
    }
}

#[test]
fn every_field_is_in_the_table() {
    let each = |n: f64| Some([n; 3]);
    let rows = |n: f64| Some([[n; 3]; 3]);
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
        misalignment_matrix: rows(11.0),
        g_sensitivity_matrix: rows(12.0),
        temperature_bias: each(13.0),
        temperature_scale: each(14.0),
        temperature: None,
        bandwidth: each(15.0),
        latency: each(16.0),
    };
    let mut listed: Vec<_> = TERMS.iter().map(|t| (t.values)(&errors).unwrap().axes()[0]).collect();
    listed.sort_by(f64::total_cmp);
    let numbered: Vec<_> = (1..=16).map(f64::from).collect();
    assert_eq!(listed, numbered);
    // What reads a field and what sets it are the same field.
    for term in TERMS {
        let mut errors = SensorErrors::default();
        (term.set)(&mut errors, Some(values(term)));
        assert_eq!((term.values)(&errors), Some(values(term)), "{}", term.name);
    }
}

#[test]
fn every_term_is_parsed_built_reported_and_known_to_theory() {
    for term in TERMS {
        let keys = [("gyro", term.gyro), ("accelerometer", term.accelerometer)];
        assert!(keys.iter().any(|(_, key)| key.is_some()), "{}", term.name);
        for (table, key) in keys {
            let Some(key) = key else { continue };
            let given = values(term);
            let text = given.written(|x| x.to_string());
            let scene = with(table, &format!("{} = {text}", key.key));
            let errors = if table == "gyro" { &scene.gyro } else { &scene.accelerometer };
            let si = given.map(|x| x * key.unit);
            assert_eq!((term.values)(errors), Some(si), "{}", key.key);

            // Built: the sensors are not perfect, and no two terms are the same one.
            assert!(emulator::build(&scene).is_ok(), "{}", key.key);
            let timing = Timing::new(0.05, 200).unwrap();
            let mut triad = Triad::PERFECT;
            let ramp = Ramp::new(1.0, 0.0, 1.0, timing).unwrap();
            (term.build)(&mut triad, si, &Conditions { timing, ramp }).unwrap();
            assert_ne!(triad, Triad::PERFECT, "{}", key.key);

            let rows = parameters::sensors(&scene);
            assert_eq!(rows.len(), 1, "{}", key.key);
            assert_eq!(rows[0][0], term.name);
            let shown = match given {
                Values::Axes([x, ..]) => format!("{x} {}", key.symbol),
                Values::Rows(_) => format!("2, 3, 5; 7, 11, 13; 17, 19, 23 {}", key.symbol),
            };
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
