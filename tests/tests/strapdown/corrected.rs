//! Running states corrected: what was asked for is what the drift shows, and the flight goes on from there.

use schuler::drift::compare::{Drift, drift};
use schuler::earth::Geodetic;
use schuler::flight::carried::Carried;
use schuler::math::compensated::{Pair, Plain, TwoFloat};
use schuler::math::real::Scalar;
use schuler::math::vector::Vector;
use schuler::record::Record;
use schuler::solution::{Euler, Output as _, Solution};
use schuler::strapdown::block::unequal::Unequal;
use schuler::strapdown::block::window::{H0B4A0, H2B4A2, H4B4A0, Parabola20, Window};
use schuler::strapdown::correction::{Correction, MOST_POSITION, MOST_VELOCITY};
use schuler::strapdown::frame::Frame;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::limits::Rejected;
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};
use schuler_tests::{Course, Numbers, bits, largest};
use std::f64::consts::PI;

type Local = LocalLevel<Pair<f64>>;
type Earth = EarthFixed<Pair<f64>>;
type LocalTextbook = Textbook<LocalLevelTextbook<f64>>;
type EarthTextbook = Textbook<EarthFixedTextbook<f64>>;

fn narrow<R: Scalar>(correction: &Correction<f64>) -> Correction<R> {
    let narrow = |v: Vector<f64>| v.map(R::narrow);
    Correction {
        position_ned: narrow(correction.position_ned),
        velocity_ned: narrow(correction.velocity_ned),
        attitude_ned: narrow(correction.attitude_ned),
    }
}

/// The largest differences of position, velocity and attitude: m, m/s, rad.
fn apart(a: &Solution<f64>, b: &Solution<f64>) -> [f64; 3] {
    let Drift { position_ned, velocity_ned, attitude_ned } = drift(a, b);
    [position_ned, velocity_ned, attitude_ned].map(Vector::norm)
}

fn somewhere(numbers: &mut Numbers, most_latitude: f64) -> Solution<f64> {
    Solution::new(
        Geodetic {
            latitude: numbers.within(most_latitude),
            longitude: numbers.within(PI),
            altitude: 5000.0 + numbers.within(5000.0),
        },
        numbers.vector(300.0),
        Euler { roll: numbers.within(PI), pitch: numbers.within(1.5), yaw: numbers.within(PI) },
    )
}

fn some_correction(numbers: &mut Numbers, size: f64) -> Correction<f64> {
    Correction {
        position_ned: numbers.vector(5000.0 * size),
        velocity_ned: numbers.vector(50.0 * size),
        attitude_ned: numbers.vector(1.5 * size),
    }
}

/// What is missing to the correction asked for, over many places: m, m/s, rad, at most.
fn missing<M: Mechanization<Real: Scalar>>(
    mechanization: &M,
    most_latitude: f64,
    size: f64,
) -> [f64; 3] {
    let mut numbers = Numbers(91);
    let mut most = [0.0; 3];
    for _ in 0..200 {
        let initial = Solution::narrow(&somewhere(&mut numbers, most_latitude));
        let correction = narrow(&some_correction(&mut numbers, size));
        let mut state = mechanization.start(&initial).unwrap();
        let before = mechanization.output(&state).wide();
        mechanization.correct(&mut state, &correction).unwrap();
        assert_eq!(mechanization.check(&state), Ok(()));
        let widen = |v: Vector<M::Real>| v.map(Scalar::widen);
        let asked = Drift {
            position_ned: widen(correction.position_ned),
            velocity_ned: widen(correction.velocity_ned),
            attitude_ned: widen(correction.attitude_ned),
        };
        // Both ways: the drift that shows, and the solution that has it.
        let after = mechanization.output(&state).wide();
        let shown = drift(&after, &before);
        let parts = [
            (shown.position_ned - asked.position_ned).norm(),
            (shown.velocity_ned - asked.velocity_ned).norm(),
            (shown.attitude_ned - asked.attitude_ned).norm(),
        ];
        let expected = apart(&after, &asked.added_to(&before));
        for (most, part) in most.iter_mut().zip(parts).chain([]) {
            *most = largest([*most, part]);
        }
        for (most, part) in most.iter_mut().zip(expected) {
            *most = largest([*most, part]);
        }
    }
    most
}

fn strapdown<F: Frame<Real: Scalar>, W: Window>() -> Strapdown<F, W> {
    Strapdown::from_rate_hz(100.0).unwrap()
}

#[test]
fn what_is_asked_is_what_the_drift_shows() {
    let check = |what: &str, got: [f64; 3], most: [f64; 3]| {
        println!("{what}: {got:?}");
        for (got, most) in got.into_iter().zip(most) {
            assert!(got <= most, "{what}: {got:e} {most:e}");
        }
    };
    let double = [4e-9, 2e-12, 2e-15];
    check("local", missing(&strapdown::<Local, H0B4A0>(), 1.2, 1.0), double);
}
