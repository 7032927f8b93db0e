//! Input that cannot be right: it is refused with the right error, and no bit of a state changes.

use super::case::{Case, Check, Outcome};
use super::floor;
use super::flown::built_in;
use super::numbers::{GROUP, SUBNORMAL, TILTED, at, fly, navigator, start};
use schuler::drift::compare::drift;
use schuler::flight::catalogue::{Catalogue as _, Every};
use schuler::flight::configuration::Configuration;
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::limits::MOST_TURN;
use schuler::strapdown::limits::{Rejected, StartError};
use schuler_simulator::navigator::{self, Unavailable};
use schuler_simulator::progress::CaseProgress;
use schuler_simulator::scene::{Axes, Navigator, WindowShape};
use schuler_simulator::simulate::largest;
use schuler_simulator::source::Source;
use schuler_simulator::units::DEGREE;

/// Its cases.
pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for frame in [Axes::LocalLevel, Axes::EarthFixed] {
        let name = frame.name();
        let mut add = |what: &str, run: fn(Axes) -> Outcome| {
            cases.push(Case::new(GROUP, format!("{what}, {name}"), move |_| run(frame)));
        };
        add("attitudes far from unit", attitudes);
        add("starts that cannot be right", starts);
    }
    cases.push(Case::new(GROUP, "samples that cannot be right, every navigator", refused));
    cases.push(Case::new(GROUP, "a block that turns too far", |_| too_far()));
    cases
}

/// To a thousandth an attitude is brought to unit length, beyond it is refused.
fn attitudes(frame: Axes) -> Outcome {
    let scaled = |factor: f64| {
        let mut initial = at(0.7, 1000.0, TILTED);
        initial.attitude = initial.attitude.map(|c| c * Pair::new(factor));
        initial
    };
    let mut wrong = 0;
    for factor in [0.0, SUBNORMAL, 0.5, 0.998, 1.002, 1.1, -3.0, 1e150, f64::MAX, f64::NAN] {
        let refused = matches!(
            start(frame, &scaled(factor)).map(|_| ()),
            Err(Unavailable::Start(StartError::Attitude))
        );
        wrong += u64::from(!refused);
    }
    let pull = Vector::new(0.0, 0.0, -0.098);
    let samples = |_| Increment { angle_b: Vector::new(1e-3, 0.0, 0.0), velocity_b: pull };
    let unit = fly(frame, &scaled(1.0), 1000, &samples)?;
    let mut most: f64 = 0.0;
    for factor in [0.9995, 1.0005, -1.0] {
        let end = fly(frame, &scaled(factor), 1000, &samples)?;
        most = largest(most, drift(&end, &unit).position_ned.norm());
    }
    let why = "within a thousandth a start is brought to unit length, else refused";
    Ok(vec![
        Check::never("not refused", wrong, why),
        // Three Newton steps reach the rounding of a two-float product.
        Check::at_most("position apart", floor::free_m(10.0), most, "m", why),
    ])
}

/// Numbers that no coordinate can be.
const IMPOSSIBLE: [f64; 5] = [f64::MAX, f64::MIN, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// A number of a start, and what is said where it cannot be.
fn slot(start: &mut Solution<f64>, field: usize) -> Option<(&mut Pair<f64>, StartError)> {
    let (p, v, q) = (&mut start.position, &mut start.velocity_ned, &mut start.attitude);
    let place =
        [&mut p.latitude, &mut p.longitude, &mut p.altitude].map(|x| (x, StartError::Position));
    let speed = v.each_mut().map(|x| (x, StartError::Velocity));
    let attitude = q.each_mut().map(|x| (x, StartError::Attitude));
    place.into_iter().chain(speed).chain(attitude).nth(field)
}

/// Every number of a start in turn.
fn starts(frame: Axes) -> Outcome {
    let mut wrong = 0;
    for x in IMPOSSIBLE {
        let good = at(0.7, 1000.0, TILTED);
        for field in 0..10 {
            let mut bad = good;
            let expected = match slot(&mut bad, field) {
                Some((slot, expected)) => {
                    *slot = Pair::new(x);
                    expected
                }
                None => break,
            };
            let refused = start(frame, &bad).map(|_| ());
            wrong += u64::from(refused != Err(Unavailable::Start(expected)));
        }
    }
    Ok(vec![Check::never("not refused", wrong, "a typed error for every number of a start")])
}

/// Every navigator there is, with its window.
fn every_navigator() -> Vec<(Navigator, WindowShape)> {
    let mut all = Vec::new();
    Every::each(&mut |Configuration { precision, axes, algorithm, window }| {
        all.push((Navigator { precision, algorithm, ..navigator(axes) }, window));
    });
    all
}

/// Impossible numbers on each input between good samples: each refused by its kind, and every state and
/// row afterwards that of a flight without them.
fn refused(progress: &CaseProgress) -> Outcome {
    let scene = built_in("manoeuvre", |scene| {
        (scene.duration_s, scene.rate_hz) = (1.0, 200.0);
    })?;
    let source = Source::new(&scene, false).map_err(|error| error.to_string())?;
    let initial = source.initial(0);
    let interval_s = Pair::new(scene.rate_hz).reciprocal();
    let (mut wrong, mut moved) = (0, 0);
    let all = every_navigator();
    for (n, (navigator, window)) in all.iter().enumerate() {
        progress.reach(n as u64, all.len() as u64);
        let start = || navigator::start(navigator, *window, 14, interval_s, &initial);
        let mut disturbed = start().map_err(|error| error.to_string())?;
        let mut undisturbed = start().map_err(|error| error.to_string())?;
        let (mut rows, mut undisturbed_rows) = (Vec::new(), Vec::new());
        for n in 1..=scene.samples() {
            let good = source.perfect_sample(n);
            let x = IMPOSSIBLE[n as usize % IMPOSSIBLE.len()];
            for input in 0..6 {
                let mut bad = good;
                let expected = if input < 3 { Rejected::Angle } else { Rejected::Velocity };
                let vector = if input < 3 { &mut bad.angle_b } else { &mut bad.velocity_b };
                for (axis, slot) in vector.each_mut().into_iter().enumerate() {
                    if axis == input % 3 {
                        *slot = x;
                    }
                }
                let taken = disturbed.push(&bad, &mut |_, _| ());
                wrong += u64::from(taken != Err(expected));
            }
            for (flying, rows) in
                [(&mut disturbed, &mut rows), (&mut undisturbed, &mut undisturbed_rows)]
            {
                let taken = flying.push(&good, &mut |n, row| rows.push((n, *row)));
                taken.map_err(|why| format!("sample {n}: {why}"))?;
            }
        }
        disturbed.finish(&mut |n, row| rows.push((n, *row)));
        undisturbed.finish(&mut |n, row| undisturbed_rows.push((n, *row)));
        let same = disturbed.digest() == undisturbed.digest() && rows == undisturbed_rows;
        moved += u64::from(!same);
    }
    let why = "what cannot be right is refused by its kind, and no bit of the state moves";
    Ok(vec![Check::never("not refused", wrong, why), Check::never("state moved", moved, why)])
}

/// 3600 °/s at 100 Hz are 2.5 rad in a block of four, which no series of a block's length is for.
fn too_far() -> Outcome {
    let turn = 3600.0 * DEGREE * 0.01;
    let sample = |angle: f64| Increment {
        angle_b: Vector::new(0.0, angle, 0.0),
        velocity_b: Vector::new(0.0, 0.0, -0.098),
    };
    let mut wrong = 0;
    for frame in [Axes::LocalLevel, Axes::EarthFixed] {
        let initial = at(0.7, 1000.0, TILTED);
        let mut flying = start(frame, &initial).map_err(|error| error.to_string())?;
        let limit = MOST_TURN / 4.0;
        for (angle, expected) in [
            (turn, Err(Rejected::Turn)),
            (-turn, Err(Rejected::Turn)),
            (limit.next_up(), Err(Rejected::Turn)),
            (limit, Ok(())),
        ] {
            wrong += u64::from(flying.push(&sample(angle), &mut |_, _| ()) != expected);
        }
    }
    Ok(vec![Check::never("not refused", wrong, "a block turns by at most 2 rad about an axis")])
}
