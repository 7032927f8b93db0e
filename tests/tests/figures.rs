//! The figures that the README states, each with its bound: accuracy on perfect sensors.

use schuler_simulator::flight::Flight;
use schuler_simulator::scene::{Algorithm, Axes, Precision, Scene, WindowShape, builtin};
use schuler_simulator::simulate;

fn fly(name: &str, change: impl Fn(&mut Scene)) -> Flight {
    let mut scene = builtin::scene(name).unwrap();
    change(&mut scene);
    simulate::fly(&scene, false, &mut |_| Ok(()), &|_| {}).unwrap()
}

fn window(history: usize, block: usize, lookahead: usize) -> Option<WindowShape> {
    Some(WindowShape { history, block, lookahead })
}

/// Largest position error over every sample, m, which must not exceed a bound.
fn holds(name: &str, bound_m: f64, change: impl Fn(&mut Scene)) {
    let [position_m, ..] = fly(name, change).max.norms;
    assert!(position_m <= bound_m, "{name}: {position_m:.3e} m exceeds {bound_m:.3e} m");
}

/// A row of the README's table: how it begins, and its three cells.
fn row<'a>(readme: &'a str, begins: &str) -> [&'a str; 3] {
    let mut rows =
        readme.lines().filter(|line| line.trim_start_matches(['|', ' ', '*']).starts_with(begins));
    let line = rows.next().unwrap_or_else(|| panic!("no row {begins}"));
    assert_eq!(rows.next(), None, "{begins}");
    let cells: Vec<&str> = line.split('|').map(str::trim).collect();
    [cells[2], cells[3], cells[4]]
}

/// Whether a number has the digits that are printed of it: `8.5e-9 m`, `0.26 m`.
fn is_printed(number: f64, cell: &str) -> bool {
    let printed = cell.strip_suffix(" m").unwrap();
    let (digits, exponent) = printed.split_once('e').unwrap_or((printed, "0"));
    let places = digits.split_once('.').map_or(0, |(_, after)| after.len()) as i32;
    let last = 10.0_f64.powi(exponent.parse::<i32>().unwrap() - places);
    (number - printed.parse::<f64>().unwrap()).abs() <= 0.501 * last
}

/// Bits are the same everywhere, and so are these digits.
#[test]
fn every_cell_of_the_readme() {
    type Change = fn(&mut Scene);
    let rows: [(&str, Change); 11] = [
        ("taylor, window by the plan, Earth-fixed", |s| s.navigator.frame = Axes::EarthFixed),
        ("taylor, window by the plan, local-level", |_| {}),
        ("taylor, a parabola over 40", |s| {
            (s.navigator.frame, s.navigator.window) = (Axes::EarthFixed, window(0, 40, 0));
        }),
        ("taylor, 4 samples (`--window 0,4,0`), Earth-fixed", |s| {
            (s.navigator.frame, s.navigator.window) = (Axes::EarthFixed, window(0, 4, 0));
        }),
        ("taylor, 4 samples, local-level", |s| s.navigator.window = window(0, 4, 0)),
        ("taylor, 8 samples, no delay", |s| s.navigator.window = window(4, 4, 0)),
        ("taylor, 8 samples (`--window 2,4,2`)", |s| {
            (s.navigator.frame, s.navigator.window) = (Axes::EarthFixed, window(2, 4, 2));
        }),
        ("4 samples in `f32x2`", |s| {
            (s.navigator.precision, s.navigator.window) = (Precision::F32x2, window(0, 4, 0));
        }),
        ("window by the plan in `f32`", |s| s.navigator.precision = Precision::F32),
        ("4 samples in `f32`", |s| {
            (s.navigator.precision, s.navigator.window) = (Precision::F32, window(0, 4, 0));
        }),
        ("our textbook", |s| s.navigator.algorithm = Algorithm::Textbook),
    ];
    let readme = include_str!("../../README.md");
    let mut cells = 0;
    for (begins, change) in rows {
        for (name, cell) in
            ["paper-perfect", "hard", "manoeuvre"].into_iter().zip(row(readme, begins))
        {
            if !cell.is_empty() {
                let [position_m, ..] = fly(name, change).max.norms;
                assert!(
                    is_printed(position_m, cell),
                    "{begins}, {name}: {position_m:.3e} m, {cell}"
                );
                cells += 1;
            }
        }
    }
    assert_eq!(cells, 28);
}

/// The paper's course with a steady climb in place of its flight: no sample is like another.
#[test]
fn a_steady_climb() {
    for (rate, bound_m) in [(10.0, 1e-8), (-2.0, 1e-8)] {
        holds("stationary", bound_m, |scene| {
            scene.trajectory.altitude.rate = rate;
            scene.duration_s = 600.0;
        });
    }
}

#[test]
fn the_papers_flight_to_ten_nanometres_in_both_frames() {
    for frame in [Axes::LocalLevel, Axes::EarthFixed] {
        for window in [None, window(0, 4, 0), window(2, 4, 2), window(4, 4, 0)] {
            holds("paper-perfect", 1e-8, |scene| {
                (scene.navigator.frame, scene.navigator.window) = (frame, window);
            });
        }
    }
}

#[test]
fn the_papers_flight_by_the_textbook_to_a_millimetre() {
    for frame in [Axes::LocalLevel, Axes::EarthFixed] {
        holds("paper-perfect", 1e-3, |scene| {
            (scene.navigator.frame, scene.navigator.algorithm) = (frame, Algorithm::Textbook);
        });
    }
}

#[test]
fn the_papers_flight_in_single_precision() {
    holds("paper-perfect", 0.15, |scene| scene.navigator.precision = Precision::F32);
}

#[test]
fn two_float_products_bring_single_precision_to_millimetres() {
    for name in ["paper-perfect", "stationary"] {
        let flight = fly(name, |scene| {
            (scene.navigator.precision, scene.navigator.window) =
                (Precision::F32x2, window(0, 4, 0));
        });
        let [position_m, ..] = flight.max.norms;
        assert!(position_m <= 5e-3, "{name}: {:?}", flight.max.norms);
    }
}

#[test]
fn hard_motion() {
    holds("hard", 1e-6, |scene| scene.navigator.window = window(4, 4, 0));
    holds("hard", 5e-9, |scene| scene.navigator.window = window(2, 4, 2));
    holds("hard", 5e-9, |scene| {
        (scene.navigator.window, scene.navigator.frame) = (window(2, 4, 2), Axes::EarthFixed);
    });
    holds("hard", 0.02, |scene| scene.navigator.algorithm = Algorithm::Textbook);
}

#[test]
fn manoeuvres_of_ten_g() {
    holds("manoeuvre", 5e-9, |scene| scene.navigator.window = window(2, 4, 2));
    holds("manoeuvre", 5e-9, |scene| {
        (scene.navigator.window, scene.navigator.frame) = (window(2, 4, 2), Axes::EarthFixed);
    });
}

#[test]
fn across_the_pole_and_the_antimeridian() {
    holds("polar", 1e-8, |_| {});
    holds("cruise-180", 1e-8, |_| {});
    holds("cruise-180", 1e-8, |scene| scene.navigator.frame = Axes::EarthFixed);
}

#[test]
fn standing_still_and_coning() {
    holds("stationary", 1e-8, |_| {});
    holds("coning", 1e-6, |_| {});
}

#[test]
fn nothing_skipped_gives_the_same_answer() {
    for name in ["paper-perfect", "hard", "stationary", "polar", "coning"] {
        let scene = builtin::scene(name).unwrap();
        let planned = fly(name, |_| {});
        let forced = simulate::fly(&scene, true, &mut |_| Ok(()), &|_| {}).unwrap();
        assert!(!planned.skipped.is_empty() && forced.skipped.is_empty(), "{name}");
        let gap: f64 = (0..3)
            .map(|i| planned.last.drift.position_m[i] - forced.last.drift.position_m[i])
            .map(|d| d * d)
            .sum();
        assert!(gap.sqrt() <= 1.5e-8, "{name}: {:.2e} m apart", gap.sqrt());
    }
}
