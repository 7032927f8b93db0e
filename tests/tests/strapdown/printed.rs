//! Whatever a navigator prints, it starts from.

use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::solution::{Euler, Solution};
use schuler::strapdown::limits::Rejected;
use schuler_simulator::navigator;
use schuler_simulator::recording::navigation::{COLUMNS, NavigationRow};
use schuler_simulator::scene::{Algorithm, Axes, Navigator, Precision, WindowShape};
use schuler_tests::Numbers;
use std::f64::consts::{FRAC_PI_2, PI};

/// Twice the cosine of the latitude at which the local-level frame ends.
const NEAR_POLE: f64 = 2e-4;

/// A number within ±`bound`, every third time at an end of it or next to one.
fn within(numbers: &mut Numbers, bound: f64) -> f64 {
    let x = numbers.within(bound);
    match numbers.word() % 6 {
        0 => bound.copysign(x),
        1 => (bound - 1e-9 * x.abs()).copysign(x),
        _ => x,
    }
}

fn vector(numbers: &mut Numbers, bound: f64) -> Vector<f64> {
    Vector::new((), (), ()).map(|()| within(numbers, bound))
}

fn anywhere(numbers: &mut Numbers) -> Solution<f64> {
    let position = Geodetic {
        latitude: within(numbers, FRAC_PI_2),
        longitude: within(numbers, PI),
        altitude: within(numbers, 9e5),
    };
    let attitude = Euler {
        roll: within(numbers, PI),
        pitch: within(numbers, FRAC_PI_2),
        yaw: within(numbers, PI),
    };
    Solution::new(position, vector(numbers, 9e4), attitude)
}

/// A row as the `initial.toml` that its printed numbers make, read again.
fn read_again(row: &NavigationRow) -> NavigationRow {
    let lines = COLUMNS.iter().zip(row.columns()).map(|(key, x)| format!("{key} = {x:?}\n"));
    let text: String = lines.collect();
    NavigationRow::parse("initial.toml", &text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// The rows of a violent flight, up to where it may leave what the frame or the Earth's model covers.
fn rows(mut navigator: Box<dyn navigator::Navigate>, numbers: &mut Numbers) -> Vec<NavigationRow> {
    let mut rows = Vec::new();
    let mut read = |_, row: &Solution<f64>| rows.push(NavigationRow::new(0.0, row));
    for _ in 0..12 {
        let (angle_b, velocity_b) = (vector(numbers, 0.3), vector(numbers, 1e2));
        if let Err(reason) = navigator.push(&Increment { angle_b, velocity_b }, &mut read) {
            assert!(matches!(reason, Rejected::Place | Rejected::Pole), "{reason}");
            break;
        }
    }
    rows
}

#[test]
fn every_printed_state_is_a_start() {
    use Algorithm::{Taylor, Textbook};
    use Precision::{F32, F32x2, F64};
    let ways = [(Taylor, F64), (Taylor, F32), (Taylor, F32x2), (Textbook, F64), (Textbook, F32)];
    let (mut numbers, mut started, mut refused) = (Numbers(7), 0, 0);
    for (algorithm, precision) in ways {
        for frame in [Axes::LocalLevel, Axes::EarthFixed] {
            let navigator = Navigator { algorithm, precision, frame, ..Navigator::default() };
            let start = |initial: &Solution<f64>| {
                let interval_s = Pair::new(10.0).reciprocal();
                navigator::start(&navigator, WindowShape::new(0, 4, 0), 10, interval_s, initial)
            };
            // In local-level axes navigation ends near a pole, and nowhere else.
            let is_covered = |position: &Geodetic<f64>, velocity_ned: &Vector<f64>| {
                let is_off_pole = position.latitude.cos() > NEAR_POLE;
                let is_slow = velocity_ned.into_array().iter().all(|speed| speed.abs() <= 1e5);
                let is_near = position.altitude.abs() <= 1e6;
                is_slow && is_near && (is_off_pole || frame == Axes::EarthFixed)
            };
            for _ in 0..60 {
                let initial = anywhere(&mut numbers);
                let Ok(flying) = start(&initial) else {
                    let position = initial.position.map(|pair| pair.hi);
                    let velocity_ned = initial.velocity_ned.map(|pair| pair.hi);
                    let is_covered = is_covered(&position, &velocity_ned);
                    assert!(!is_covered, "{algorithm:?} {precision:?} {frame:?} {initial:?}");
                    refused += 1;
                    continue;
                };
                let flown = rows(flying, &mut numbers);
                let covered = |row: &&NavigationRow| is_covered(&row.position, &row.velocity_ned);
                for row in flown.iter().filter(covered) {
                    let again = start(&read_again(row).solution());
                    assert!(again.is_ok(), "{algorithm:?} {precision:?} {frame:?} {row:?}");
                    started += 1;
                }
            }
        }
    }
    assert!(started > 2000 && refused < 200, "{started} {refused}");
}
