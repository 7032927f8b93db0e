//! What cannot be right is refused with its reason, and leaves the state as it was, bit for bit.

use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::output::Output as _;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::block::window::{H0B4A0, H2B4A2};
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::limits::{Limits, MOST_TURN};
use schuler::strapdown::limits::{Rejected, StartError};
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};
use schuler_tests::{Course, bits};

type Local = LocalLevel<Pair<f64>>;
type Earth = EarthFixed<Pair<f64>>;

/// Samples at 100 Hz that cannot be right in blocks of some, each with its reason.
fn broken(good: Increment<f64>, block: f64) -> Vec<(Increment<f64>, Rejected)> {
    let mut samples = Vec::new();
    // 2 rad over the block, which is less than 1e5 °/s over 10 ms; 1e5 m/s² over 10 ms
    let (most_angle, most_velocity) = (MOST_TURN / block, 1e3);
    for axis in 0..3 {
        let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN];
        let over = |most: f64| [1.000001 * most, -1.000001 * most];
        let turns = over(most_angle).map(|x| (x, Rejected::Turn));
        for (x, why) in bad.map(|x| (x, Rejected::Angle)).into_iter().chain(turns) {
            let mut sample = good;
            *sample.angle_b.each_mut()[axis] = x;
            samples.push((sample, why));
        }
        for x in bad.into_iter().chain(over(most_velocity)) {
            let mut sample = good;
            *sample.velocity_b.each_mut()[axis] = x;
            samples.push((sample, Rejected::Velocity));
        }
    }
    samples
}

/// Flies a stream with every broken sample offered between any two good ones.
fn refuses<M: Mechanization<Real = f64>>(mechanization: &M, block: f64)
where
    M::State: Record,
{
    let course = Course::new("manoeuvre", 1.0, 0.3);
    let mut state = mechanization.start(&course.initial()).unwrap();
    let mut undisturbed = state;
    for &sample in &course.samples {
        let before = bits(&state);
        for (bad, why) in broken(sample, block) {
            assert_eq!(mechanization.push(&mut state, bad), Err(why), "{bad:?}");
            let read = |row, _| panic!("row {row} of a refused sample");
            assert_eq!(mechanization.push_rows(&mut state, bad, read), Err(why), "{bad:?}");
            assert_eq!(bits(&state), before);
        }
        mechanization.push(&mut state, sample).unwrap();
        mechanization.push(&mut undisturbed, sample).unwrap();
        assert_eq!(bits(&state), bits(&undisturbed));
    }
    mechanization.finish_rows(&mut state, |_, _| ());
    mechanization.finish_rows(&mut undisturbed, |_, _| ());
    assert_eq!(bits(&state), bits(&undisturbed));
}

const INTERVAL: f64 = 0.01;

/// Flies a stream on and on; navigation may leave the Earth, but it ends there and stays a number.
fn leaves<M: Mechanization<Real = f64>>(mechanization: &M, sample: Increment<f64>)
where
    M::State: Record,
{
    let mut state = mechanization.start(&Course::new("stationary", 1.0, 1.0).initial()).unwrap();
    let refused = (0..40_000).find_map(|_| mechanization.push(&mut state, sample).err());
    assert_eq!(refused, Some(Rejected::Place));
    let before = bits(&state);
    for _ in 0..9 {
        assert_eq!(mechanization.push(&mut state, sample), Err(Rejected::Place));
        assert_eq!(bits(&state), before);
    }
    let altitude = mechanization.output(&state).wide().position.altitude.hi;
    assert!((0.9e6..1.3e6).contains(&altitude.abs()), "{altitude}");
}

/// Specific force where its increment belongs, and one with the wrong sign: the field's mistakes.
#[test]
fn navigation_that_leaves_the_earth() {
    const INTERVAL: f64 = 0.05;
    let good = Course::new("stationary", 1.0, 1.0).samples[0];
    for factor in [20.0, -1.0] {
        let wrong = Increment { velocity_b: good.velocity_b * factor, ..good };
        leaves(&Strapdown::<Local, H2B4A2>::new(Pair::new(INTERVAL)).unwrap(), wrong);
        leaves(&Strapdown::<Earth, H2B4A2>::new(Pair::new(INTERVAL)).unwrap(), wrong);
        leaves(&Strapdown::<Earth, H0B4A0>::new(Pair::new(INTERVAL)).unwrap(), wrong);
        leaves(&Textbook::<LocalLevelTextbook<f64>>::new(INTERVAL).unwrap(), wrong);
        leaves(&Textbook::<EarthFixedTextbook<f64>>::new(INTERVAL).unwrap(), wrong);
    }
}

/// A vertical to hold that cannot be right is refused, and changes nothing.
#[test]
fn verticals_that_cannot_be_held() {
    fn check<M: Mechanization<Real = f64>>(mechanization: &M)
    where
        M::State: Record,
    {
        let course = Course::new("paper-perfect", 1.0, 1.0);
        let mut state = mechanization.start(&course.initial()).unwrap();
        let before = bits(&state);
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300] {
            for (altitude, down) in [(x, 0.0), (0.0, x)] {
                let held = mechanization.hold_vertical(&mut state, altitude, down);
                assert_eq!(held, Err(Rejected::Held), "{altitude} {down}");
                assert_eq!(bits(&state), before);
            }
        }
        for (altitude, down) in [(1e6, -1e5), (-1e6, 1e5), (0.0, -0.0)] {
            assert_eq!(mechanization.hold_vertical(&mut state, altitude, down), Ok(()));
        }
    }
    check(&Strapdown::<Local, H0B4A0>::new(Pair::new(INTERVAL)).unwrap());
    check(&Strapdown::<Earth, H0B4A0>::new(Pair::new(INTERVAL)).unwrap());
    check(&Textbook::<LocalLevelTextbook<f64>>::new(INTERVAL).unwrap());
    check(&Textbook::<EarthFixedTextbook<f64>>::new(INTERVAL).unwrap());
}

#[test]
fn samples_that_cannot_be_right() {
    refuses(&Strapdown::<Local, H2B4A2>::new(Pair::new(INTERVAL)).unwrap(), 4.0);
    refuses(&Strapdown::<Earth, H0B4A0>::new(Pair::new(INTERVAL)).unwrap(), 4.0);
    refuses(&Textbook::<LocalLevelTextbook<f64>>::new(INTERVAL).unwrap(), 1.0);
    refuses(&Textbook::<EarthFixedTextbook<f64>>::new(INTERVAL).unwrap(), 1.0);
}

#[test]
fn single_precision_refuses_the_same() {
    let strapdown = Strapdown::<LocalLevel<Pair<f32>>, H2B4A2>::new(Pair::new(0.01)).unwrap();
    let course = Course::new("manoeuvre", 1.0, 0.3);
    let mut state = strapdown.start(&Solution::narrow(&course.initial())).unwrap();
    let before = bits(&state);
    let narrow = |s: Increment<f64>| Increment {
        angle_b: s.angle_b.map(|c| c as f32),
        velocity_b: s.velocity_b.map(|c| c as f32),
    };
    for (bad, why) in broken(course.samples[0], 4.0) {
        assert_eq!(strapdown.push(&mut state, narrow(bad)), Err(why), "{bad:?}");
        assert_eq!(bits(&state), before);
    }
    assert_eq!(strapdown.push(&mut state, narrow(course.samples[0])), Ok(()));
}

#[test]
fn limits_are_the_callers_and_belong_to_the_interval() {
    let limits = Limits { angular_rate: 0.8, specific_force: 30.0 };
    let strapdown = Strapdown::<Local, H0B4A0>::with_limits(Pair::new(0.5), limits).unwrap();
    let textbook = Textbook::<LocalLevelTextbook<f64>>::with_limits(0.5, limits).unwrap();
    let course = Course::new("stationary", 1.0, 1.0);
    let at = |angle: f64, velocity: f64| Increment {
        angle_b: Vector::new(0.0, angle, 0.0),
        velocity_b: Vector::new(0.0, 0.0, velocity),
    };
    for (sample, expected) in [
        (at(0.4, 15.0), Ok(())),
        (at(-0.4, -15.0), Ok(())),
        (at(0.4 + 1e-12, 0.0), Err(Rejected::Angle)),
        (at(0.0, -15.0 - 1e-12), Err(Rejected::Velocity)),
    ] {
        let mut state = strapdown.start(&course.initial()).unwrap();
        assert_eq!(strapdown.push(&mut state, sample), expected, "{sample:?}");
        let mut state = textbook.start(&course.initial()).unwrap();
        assert_eq!(textbook.push(&mut state, sample), expected, "{sample:?}");
    }
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        for limits in
            [Limits { angular_rate: bad, ..limits }, Limits { specific_force: bad, ..limits }]
        {
            let strapdown = Strapdown::<Local, H0B4A0>::with_limits(Pair::new(0.5), limits);
            assert_eq!(strapdown.err(), Some(StartError::Limits), "{limits:?}");
            let textbook = Textbook::<EarthFixedTextbook<f64>>::with_limits(0.5, limits);
            assert_eq!(textbook.err(), Some(StartError::Limits), "{limits:?}");
        }
    }
}

#[test]
fn intervals_that_cannot_be_right() {
    for bad in [0.0, -0.0, -0.01, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1.0000001, 1e300] {
        let strapdown = Strapdown::<Local, H0B4A0>::new(Pair::new(bad));
        assert_eq!(strapdown.err(), Some(StartError::Interval), "{bad}");
        let textbook = Textbook::<EarthFixedTextbook<f64>>::new(bad);
        assert_eq!(textbook.err(), Some(StartError::Interval), "{bad}");
        let single = Strapdown::<LocalLevel<Pair<f32>>, H0B4A0>::new(Pair::new(bad as f32));
        assert_eq!(single.err(), Some(StartError::Interval), "{bad}");
    }
    for good in [1.0, 0.001, 1e-6] {
        assert!(Strapdown::<Local, H0B4A0>::new(Pair::new(good)).is_ok());
        assert!(Textbook::<LocalLevelTextbook<f64>>::new(good).is_ok());
    }
}

#[test]
fn every_refusal_says_what_it_is() {
    let texts = [
        Rejected::Angle.to_string(),
        Rejected::Velocity.to_string(),
        StartError::Interval.to_string(),
        StartError::Limits.to_string(),
        StartError::Position.to_string(),
        StartError::Velocity.to_string(),
        StartError::Attitude.to_string(),
        Rejected::Pole.to_string(),
        StartError::Pole.to_string(),
        Rejected::Place.to_string(),
        Rejected::Held.to_string(),
        Rejected::Turn.to_string(),
        StartError::FlushToZero.to_string(),
    ];
    let words = [
        "angle",
        "velocity",
        "interval",
        "limits",
        "position",
        "velocity",
        "attitude",
        "pole",
        "pole",
        "ellipsoid",
        "hold",
        "turns",
        "subnormal",
    ];
    for (i, (text, word)) in texts.iter().zip(words).enumerate() {
        assert!(text.contains(word), "{text}");
        assert!(texts.iter().skip(i + 1).all(|other| other != text), "{text}");
    }
}
