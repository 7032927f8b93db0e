//! Running states corrected: what was asked for is what the drift shows, and the flight goes on from there.

use schuler::drift::compare::{Drift, drift};
use schuler::earth::Geodetic;
use schuler::math::compensated::{Pair, Plain, TwoFloat};
use schuler::math::real::Scalar;
use schuler::math::vector::Vector;
use schuler::output::Output as _;
use schuler::record::Record;
use schuler::solution::{Euler, Solution};
use schuler::strapdown::block::window::{H0B4A0, H2B4A2, H4B4A0, Window};
use schuler::strapdown::correction::{Correction, CorrectionError, MOST_POSITION, MOST_VELOCITY};
use schuler::strapdown::frame::Frame;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};
use schuler_tests::{Course, Numbers, bits, largest};
use std::f64::consts::PI;

pub type Local = LocalLevel<Pair<f64>>;
pub type Earth = EarthFixed<Pair<f64>>;
pub type LocalTextbook = Textbook<LocalLevelTextbook<f64>>;
pub type EarthTextbook = Textbook<EarthFixedTextbook<f64>>;

pub fn narrow<R: Scalar>(correction: &Correction<f64>) -> Correction<R> {
    let narrow = |v: Vector<f64>| v.map(R::narrow);
    Correction {
        position_ned: narrow(correction.position_ned),
        velocity_ned: narrow(correction.velocity_ned),
        attitude_ned: narrow(correction.attitude_ned),
    }
}

/// The largest differences of position, velocity and attitude: m, m/s, rad.
pub fn apart(a: &Solution<f64>, b: &Solution<f64>) -> [f64; 3] {
    let Drift { position_ned, velocity_ned, attitude_ned } = drift(a, b);
    [position_ned, velocity_ned, attitude_ned].map(Vector::norm)
}

/// Anywhere between two latitudes, north or south.
pub fn somewhere(numbers: &mut Numbers, [from, to]: [f64; 2]) -> Solution<f64> {
    let latitude = 0.5 * (from + to) + numbers.within(0.5 * (to - from));
    Solution::new(
        Geodetic {
            latitude: latitude.copysign(numbers.within(1.0)),
            longitude: numbers.within(PI),
            altitude: 5000.0 + numbers.within(5000.0),
        },
        numbers.vector(300.0),
        Euler { roll: numbers.within(PI), pitch: numbers.within(1.5), yaw: numbers.within(PI) },
    )
}

/// Up to 8.7 km, 87 m/s and 2.6 rad, times a size.
pub fn some_correction(numbers: &mut Numbers, size: f64) -> Correction<f64> {
    Correction {
        position_ned: numbers.vector(5000.0 * size),
        velocity_ned: numbers.vector(50.0 * size),
        attitude_ned: numbers.vector(1.5 * size),
    }
}

/// What is missing to the correction asked for, over many places: m, m/s, rad, at most.
pub fn missing<M: Mechanization<Real: Scalar>>(
    mechanization: &M,
    latitudes: [f64; 2],
    size: f64,
) -> [f64; 3] {
    let mut numbers = Numbers(91);
    let mut most = [0.0; 3];
    for _ in 0..200 {
        let initial = Solution::narrow(&somewhere(&mut numbers, latitudes));
        let correction = narrow(&some_correction(&mut numbers, size));
        let mut state = mechanization.start(&initial).unwrap();
        let before = mechanization.output(&state).wide();
        mechanization.correct(&mut state, &correction).unwrap();
        assert_eq!(mechanization.check(&state), Ok(()));
        let after = mechanization.output(&state).wide();
        let widen = |v: Vector<M::Real>| v.map(Scalar::widen);
        let asked = Drift {
            position_ned: widen(correction.position_ned),
            velocity_ned: widen(correction.velocity_ned),
            attitude_ned: widen(correction.attitude_ned),
        };
        // Against the solution that has this drift from the one before.
        let parts = apart(&after, &asked.added_to(&before));
        for (most, part) in most.iter_mut().zip(parts) {
            *most = largest([*most, part]);
        }
    }
    most
}

pub fn strapdown<F: Frame<Real: Scalar>, W: Window>() -> Strapdown<F, W> {
    Strapdown::from_rate_hz(100.0).unwrap()
}

pub const MIDDLE: [f64; 2] = [0.0, 1.2];

pub fn within(what: &str, got: [f64; 3], most: [f64; 3]) {
    println!("{what}: {got:?}");
    for (got, most) in got.into_iter().zip(most) {
        assert!(got <= most, "{what}: {got:e} is above {most:e}");
    }
}

#[test]
fn what_is_asked_is_what_the_drift_shows() {
    // To the rounding floor; over kilometres the local-level frame is cut short by its series.
    let local = strapdown::<Local, H0B4A0>();
    let earth = strapdown::<Earth, H0B4A0>();
    within("local", missing(&local, MIDDLE, 0.1), [5e-9, 2e-13, 2e-15]);
    within("local, 8 km", missing(&local, MIDDLE, 1.0), [4e-6, 2e-13, 2e-15]);
    within("earth", missing(&earth, MIDDLE, 0.1), [5e-9, 2e-13, 2e-15]);
    within("earth, 8 km", missing(&earth, MIDDLE, 1.0), [5e-9, 2e-13, 2e-15]);
    let local = LocalTextbook::from_rate_hz(100.0).unwrap();
    let earth = EarthTextbook::from_rate_hz(100.0).unwrap();
    within("local textbook", missing(&local, MIDDLE, 0.1), [5e-9, 3e-13, 2e-15]);
    within("earth textbook", missing(&earth, MIDDLE, 0.1), [5e-9, 3e-13, 2e-15]);
}

#[test]
fn close_to_the_poles() {
    // Beyond 84° north is carried along; over the pole it is in Earth-fixed axes alone.
    let local = strapdown::<Local, H0B4A0>();
    let earth = strapdown::<Earth, H0B4A0>();
    within("local", missing(&local, [1.44, 1.55], 0.1), [3e-9, 2e-12, 2e-15]);
    within("earth", missing(&earth, [1.44, 1.55], 0.1), [3e-9, 2e-12, 2e-15]);
    within("at the pole", missing(&earth, [1.5705, PI / 2.0], 1.0), [1e-8, 1e-11, 1e-13]);
    let textbook = EarthTextbook::from_rate_hz(100.0).unwrap();
    within("textbook", missing(&textbook, [1.5705, PI / 2.0], 1.0), [1e-8, 1e-11, 1e-13]);
}

#[test]
fn single_precision_loses_nothing_of_a_correction() {
    let local = strapdown::<LocalLevel<Pair<f32>>, H0B4A0>();
    within("local", missing(&local, MIDDLE, 0.01), [2e-5, 2e-7, 5e-9]);
    let local = strapdown::<LocalLevel<TwoFloat<f32>>, H0B4A0>();
    within("local, two-float", missing(&local, MIDDLE, 0.01), [2e-5, 2e-7, 5e-9]);
    let earth = strapdown::<EarthFixed<Pair<f32>>, H0B4A0>();
    within("earth", missing(&earth, MIDDLE, 0.01), [2e-5, 2e-6, 5e-9]);
    let earth = strapdown::<EarthFixed<TwoFloat<f32>>, H0B4A0>();
    within("earth, two-float", missing(&earth, MIDDLE, 0.01), [2e-5, 2e-6, 5e-9]);
    // Without compensation the state rounds, a metre in Earth-fixed axes.
    let plain = strapdown::<EarthFixed<Plain<f32>>, H0B4A0>();
    within("earth, plain", missing(&plain, MIDDLE, 0.01), [1.5, 1e-3, 1e-6]);
}

/// At any phase of a block, with samples that wait: no bit changes, before the first block either.
fn zero_leaves<M: Mechanization<Real = f64, State: Record>>(mechanization: &M) {
    let course = Course::new("manoeuvre", 1.0, 0.5);
    let mut state = mechanization.start(&course.initial()).unwrap();
    for &sample in &course.samples {
        let before = bits(&state);
        mechanization.correct(&mut state, &Correction::ZERO).unwrap();
        let negative = Vector::new(-0.0, -0.0, -0.0);
        let negative = Correction { velocity_ned: negative, ..Correction::ZERO };
        mechanization.correct(&mut state, &negative).unwrap();
        assert_eq!(bits(&state), before);
        mechanization.push(&mut state, sample).unwrap();
    }
}

#[test]
fn a_zero_correction_leaves_every_bit() {
    zero_leaves(&strapdown::<Local, H2B4A2>());
    zero_leaves(&strapdown::<Earth, H4B4A0>());
    zero_leaves(&LocalTextbook::from_rate_hz(100.0).unwrap());
    zero_leaves(&EarthTextbook::from_rate_hz(100.0).unwrap());
}

/// Refused corrections change nothing.
fn refuses<M: Mechanization<Real = f64, State: Record>>(mechanization: &M) {
    let course = Course::new("manoeuvre", 1.0, 0.5);
    let mut state = mechanization.start(&course.initial()).unwrap();
    for &sample in &course.samples {
        mechanization.push(&mut state, sample).unwrap();
    }
    let before = bits(&state);
    let mut refused = |correction: Correction<f64>, why| {
        assert_eq!(mechanization.correct(&mut state, &correction), Err(why), "{correction:?}");
        assert_eq!(bits(&state), before, "{correction:?}");
    };
    let limits = [MOST_POSITION, MOST_VELOCITY, PI];
    for (part, limit) in limits.into_iter().enumerate() {
        for axis in 0..3 {
            for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1.001 * limit, -f64::MAX] {
                let mut correction = Correction::ZERO;
                let Correction { position_ned, velocity_ned, attitude_ned } = &mut correction;
                let parts = [position_ned, velocity_ned, attitude_ned];
                *parts.into_iter().nth(part).unwrap().each_mut()[axis] = wrong;
                refused(correction, CorrectionError::Size);
            }
        }
    }
    // Each component within its limit, but not all of them together.
    let long = Vector::new(0.7, 0.7, 0.7) * MOST_POSITION;
    refused(Correction { position_ned: long, ..Correction::ZERO }, CorrectionError::Size);
}

#[test]
fn refusals_leave_every_bit() {
    refuses(&strapdown::<Local, H2B4A2>());
    refuses(&strapdown::<Earth, H2B4A2>());
    refuses(&LocalTextbook::from_rate_hz(100.0).unwrap());
    refuses(&EarthTextbook::from_rate_hz(100.0).unwrap());
}

/// Too near a pole for local-level axes, and out of the shell that navigation goes on in.
#[test]
fn where_navigation_cannot_go() {
    let initial = |latitude, altitude| {
        let place = Geodetic { latitude, longitude: 1.0, altitude };
        Solution::new(place, Vector::ZERO, Euler { roll: 0.0, pitch: 0.0, yaw: 0.0 })
    };
    fn check<M: Mechanization<Real = f64, State: Record>>(
        mechanization: &M,
        initial: &Solution<f64>,
        position_ned: Vector<f64>,
        expected: Result<(), CorrectionError>,
    ) {
        let mut state = mechanization.start(initial).unwrap();
        let before = bits(&state);
        let correction = Correction { position_ned, ..Correction::ZERO };
        assert_eq!(mechanization.correct(&mut state, &correction), expected);
        assert_eq!(bits(&state) == before, expected.is_err());
        assert_eq!(mechanization.check(&state), Ok(()));
    }
    let local = strapdown::<Local, H0B4A0>();
    let earth = strapdown::<Earth, H0B4A0>();
    let textbook = LocalTextbook::from_rate_hz(100.0).unwrap();
    // 10 km from the pole, 200 m towards it.
    let (polar, north) = (initial(PI / 2.0 - 1e4 / 6.4e6, 0.0), Vector::new(200.0, 0.0, 0.0));
    check(&local, &polar, north, Err(CorrectionError::Pole));
    check(&textbook, &polar, north, Err(CorrectionError::Pole));
    check(&earth, &polar, north, Ok(()));
    check(&local, &polar, north * 0.1, Ok(()));
    let (high, up) = (initial(0.5, 999_000.0), Vector::new(0.0, 0.0, -2000.0));
    check(&local, &high, up, Err(CorrectionError::Place));
    check(&textbook, &high, up, Err(CorrectionError::Place));
    check(&earth, &initial(0.0, 999_000.0), up, Err(CorrectionError::Place));
    check(&local, &high, -up, Ok(()));
}
