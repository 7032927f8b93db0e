//! What a unit at rest reads, judged: faults are named, good readings pass, poor ones get their σ.

use schuler::alignment::judge::{Contradiction, Judgement, judge};
use schuler::alignment::place::Place;
use schuler::alignment::signs::Signs;
use schuler::alignment::still::Still;
use schuler::alignment::units::{ForceUnit, Kind, RateUnit};
use schuler::earth::{Geodetic, ROTATION_RATE, gravity, rotation_ned};
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::solution::Euler;
use schuler_tests::Numbers;

const INTERVAL_S: f64 = 0.01;
const ATTITUDE: Euler<f64> = Euler { roll: 0.05, pitch: -0.12, yaw: 0.7 };
const LATITUDE: f64 = 0.785;

/// Angular rate and specific force at rest.
fn at_rest() -> (Vector<f64>, Vector<f64>) {
    let (s, c) = f64::sin_cos(LATITUDE);
    let to_body = ATTITUDE.quaternion().conjugate().matrix(1.0);
    (to_body * rotation_ned(s, c), to_body * Vector::new(0.0, 0.0, -gravity(s, 100.0)))
}

fn place(latitude: f64) -> Place<f64> {
    Place::new(Geodetic { latitude, longitude: 0.3, altitude: 100.0 })
}

/// Sixty seconds of what a function makes of a time, judged at a latitude.
fn judged(
    latitude: f64,
    kind: Kind,
    read: impl Fn(f64) -> (Vector<f64>, Vector<f64>),
) -> Judgement<f64> {
    let mut still = Still::new(1.0);
    for n in 0..6000 {
        let (rate, force) = read(f64::from(n) * INTERVAL_S);
        let sample = Increment { angle_b: rate * INTERVAL_S, velocity_b: force * INTERVAL_S };
        still.add(&sample, INTERVAL_S);
    }
    judge(&still.readings().unwrap(), kind, &place(latitude))
}

fn contradiction(rate: Vector<f64>, force: Vector<f64>) -> Option<Contradiction<f64>> {
    judged(LATITUDE, Kind::Rates, |_| (rate, force)).contradiction
}

#[test]
fn what_is_right_passes() {
    let (rate, force) = at_rest();
    let Judgement { quality, contradiction } = judged(LATITUDE, Kind::Rates, |_| (rate, force));
    assert_eq!(contradiction, None);
    assert!(quality.heading_sigma < 1e-6 && quality.level_sigma < 1e-9, "{quality:?}");
    // A tactical gyro's bias of 3 °/h, 5 mg of accelerometer: poor, no contradiction.
    let bias = Vector::new(1.5e-5, 0.0, 0.0);
    let mut numbers = Numbers(7);
    let noise: Vec<f64> = (0..6000).map(|_| numbers.within(0.05)).collect();
    let Judgement { quality, contradiction } = judged(LATITUDE, Kind::Rates, |t| {
        let noise = noise[(t / INTERVAL_S).round() as usize];
        (rate + bias, force * 1.005 + Vector::new(noise, -noise, noise))
    });
    assert_eq!(contradiction, None);
    assert!(quality.heading_sigma > 0.1 && quality.heading_sigma < 1.0, "{quality:?}");
}

#[test]
fn units_are_named() {
    let (rate, force) = at_rest();
    for unit in ForceUnit::ALL.into_iter().skip(1) {
        let Some(Contradiction::Units { force, rate }) =
            contradiction(rate, force * (1.0 / unit.si()))
        else {
            panic!("{unit:?}")
        };
        let found: Vec<_> = force.iter().map(|e| (e.unit, e.kind)).collect();
        assert_eq!((found, rate.is_empty()), (vec![(unit, Kind::Rates)], true), "{unit:?}");
    }
    for unit in RateUnit::ALL.into_iter().skip(1) {
        let Some(Contradiction::Units { force, rate }) =
            contradiction(rate * (1.0 / unit.si()), force)
        else {
            panic!("{unit:?}")
        };
        let found: Vec<_> = rate.iter().map(|e| (e.unit, e.kind)).collect();
        assert_eq!((found, force.is_empty()), (vec![(unit, Kind::Rates)], true), "{unit:?}");
    }
}

#[test]
fn a_wrong_header_is_named() {
    let (rate, force) = at_rest();
    for said in [Kind::Increments, Kind::Rates] {
        let mistaken = said.mistaken(INTERVAL_S);
        let read = (rate * mistaken, force * mistaken);
        let Some(Contradiction::Units { force, rate }) =
            judged(LATITUDE, said, |_| read).contradiction
        else {
            panic!("{said:?}")
        };
        assert!(force.iter().all(|e| e.kind == said.other()), "{force:?}");
        let best = (force.iter().next().unwrap().unit, rate.iter().next().unwrap().unit);
        assert_eq!(best, (ForceUnit::MetrePerSecondSquared, RateUnit::RadianPerSecond));
    }
}

#[test]
fn signs_axes_and_latitudes_are_named() {
    let (rate, force) = at_rest();
    let signs = |latitude: f64, rate: Vector<f64>, force: Vector<f64>| -> Signs<f64> {
        match judged(latitude, Kind::Rates, |_| (rate, force)).contradiction {
            Some(Contradiction::Directions(signs)) => signs,
            other => panic!("{other:?}"),
        }
    };
    assert!(signs(LATITUDE, rate, -force).reversed);
    assert!(signs(-LATITUDE, rate, force).reversed);
    assert!(signs(LATITUDE, Vector::new(rate.x, rate.y, -rate.z), force).axis[2]);
    assert!(signs(LATITUDE, Vector::new(rate.z, rate.y, rate.x), force).exchanged[2]);
    assert!(signs(LATITUDE.to_radians(), rate, force).radians);
    let elsewhere = signs(0.2, rate, force);
    assert!((elsewhere.latitude - LATITUDE).abs() < 1e-9, "{elsewhere:?}");
}

#[test]
fn motion_is_told() {
    let (rate, force) = at_rest();
    let told = |read: &dyn Fn(f64) -> (Vector<f64>, Vector<f64>)| {
        judged(LATITUDE, Kind::Rates, read).contradiction
    };
    // A steady roll of 0.1 °/s, which turns the force in body axes.
    let turn = 0.1f64.to_radians();
    let rolled = told(&|t| {
        let turned = Euler { roll: turn * t, pitch: 0.0, yaw: 0.0 };
        let to_body = turned.quaternion().conjugate().matrix(1.0);
        (rate + Vector::new(turn, 0.0, 0.0), to_body * force)
    });
    assert_eq!(rolled, Some(Contradiction::Turning));
    let rocked = told(&|t| (rate, force + Vector::new(2.0 * (0.3 * t).sin(), 0.0, 0.0)));
    assert_eq!(rocked, Some(Contradiction::Moving));
    let pushed = told(&|_| (rate, force + force * (1.0 / force.norm())));
    assert!(
        matches!(pushed, Some(Contradiction::Accelerating | Contradiction::Force)),
        "{pushed:?}"
    );
    assert_eq!(told(&|_| (rate, force * 1e-3 * 0.1)), Some(Contradiction::Force));
    assert_eq!(told(&|_| (rate + force * 0.02, force)), Some(Contradiction::Rate));
}

/// White noise: the mean's σ is N/√T, on average; a motion that comes back costs far less.
#[test]
fn the_mean_is_as_good_as_its_scatter_says() {
    let mut numbers = Numbers(11);
    let (mut said, mut found) = (0.0, 0.0);
    for _ in 0..100 {
        let mut still = Still::new(1.0);
        for _ in 0..1000 {
            let noise = numbers.within(1e-4);
            let angle_b = Vector::new(noise, 0.0, 0.0);
            still.add(&Increment { angle_b, velocity_b: Vector::ZERO }, 0.1);
        }
        let readings = still.readings().unwrap();
        // One axis of three is noisy.
        said += 3.0 * readings.rate_sigma.powi(2);
        found += readings.rate_ib_b.x.powi(2);
    }
    assert!((said / found - 1.0).abs() < 0.5, "{}", said / found);
    let mut still = Still::new(1.0);
    for n in 0..6000 {
        let rate = 1e-3 * (f64::from(n) * 0.05).sin();
        let angle_b = Vector::new(rate * INTERVAL_S, 0.0, 0.0);
        still.add(&Increment { angle_b, velocity_b: Vector::ZERO }, INTERVAL_S);
    }
    let readings = still.readings().unwrap();
    assert!(readings.rate_sigma < 0.1 * 1e-3 / 60f64.sqrt(), "{readings:?}");
    assert!(readings.rate_sigma < ROTATION_RATE, "{readings:?}");
}
