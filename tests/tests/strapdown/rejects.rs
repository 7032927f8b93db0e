//! What cannot be right is refused with its reason, and leaves the state as it was, bit for bit.

use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::solution::{Euler, Solution};
use schuler::strapdown::earth_fixed::EarthFixed;
use schuler::strapdown::local_level::LocalLevel;
use schuler::strapdown::mechanization::{Limits, Mechanization, Rejected, StartError};
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};
use schuler::strapdown::window::{H0B4A0, H2B4A2};
use schuler_tests::{Course, bits};
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Debug;

type Local = LocalLevel<Pair<f64>>;
type Earth = EarthFixed<Pair<f64>>;

/// Samples that cannot be right at 100 Hz, each with its reason.
fn broken(good: Increment<f64>) -> Vec<(Increment<f64>, Rejected)> {
    let mut samples = Vec::new();
    // 1e5 °/s and 1e5 m/s² over 10 ms
    let (most_angle, most_velocity) = (1e3 * PI / 180.0, 1e3);
    for axis in 0..3 {
        let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN];
        let over = |most: f64| [1.000001 * most, -1.000001 * most];
        for x in bad.into_iter().chain(over(most_angle)) {
            let mut sample = good;
            *sample.angle_b.each_mut()[axis] = x;
            samples.push((sample, Rejected::Angle));
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
fn refuses<M: Mechanization<Real = f64>>(mechanization: &M)
where
    M::State: Debug,
    M::Frame: Record,
{
    let course = Course::new("manoeuvre", 1.0, 0.3);
    let mut state = mechanization.start(&course.initial()).unwrap();
    let mut undisturbed = state;
    for &sample in &course.samples {
        for (bad, why) in broken(sample) {
            let before = format!("{state:?}");
            assert_eq!(mechanization.push(&mut state, bad), Err(why), "{bad:?}");
            let read = |row, _| panic!("row {row} of a refused sample");
            assert_eq!(mechanization.push_rows(&mut state, bad, read), Err(why), "{bad:?}");
            assert_eq!(format!("{state:?}"), before);
        }
        mechanization.push(&mut state, sample).unwrap();
        mechanization.push(&mut undisturbed, sample).unwrap();
        assert_eq!(bits(M::frame(&state)), bits(M::frame(&undisturbed)));
    }
    mechanization.finish_rows(&mut state, |_, _| ());
    mechanization.finish_rows(&mut undisturbed, |_, _| ());
    assert_eq!(bits(M::frame(&state)), bits(M::frame(&undisturbed)));
    assert_eq!(format!("{state:?}"), format!("{undisturbed:?}"));
}

const INTERVAL: f64 = 0.01;

#[test]
fn samples_that_cannot_be_right() {
    refuses(&Strapdown::<Local, H2B4A2>::new(Pair::new(INTERVAL)).unwrap());
    refuses(&Strapdown::<Earth, H0B4A0>::new(Pair::new(INTERVAL)).unwrap());
    refuses(&Textbook::<LocalLevelTextbook<f64>>::new(INTERVAL).unwrap());
    refuses(&Textbook::<EarthFixedTextbook<f64>>::new(INTERVAL).unwrap());
}

#[test]
fn single_precision_refuses_the_same() {
    let strapdown = Strapdown::<LocalLevel<Pair<f32>>, H2B4A2>::new(Pair::new(0.01)).unwrap();
    let course = Course::new("manoeuvre", 1.0, 0.3);
    let mut state = strapdown.start(&Solution::narrow(&course.initial())).unwrap();
    let before = format!("{state:?}");
    let narrow = |s: Increment<f64>| Increment {
        angle_b: s.angle_b.map(|c| c as f32),
        velocity_b: s.velocity_b.map(|c| c as f32),
    };
    for (bad, why) in broken(course.samples[0]) {
        assert_eq!(strapdown.push(&mut state, narrow(bad)), Err(why), "{bad:?}");
        assert_eq!(format!("{state:?}"), before);
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

fn place(latitude: f64, longitude: f64, altitude: f64) -> Solution<f64> {
    let position = Geodetic { latitude, longitude, altitude };
    let attitude = Euler { roll: 0.1, pitch: 0.2, yaw: 0.3 };
    Solution::new(position, Vector::new(10.0, 20.0, 30.0), attitude)
}

/// What all four mechanizations say to a start.
fn starts(initial: &Solution<f64>) -> Option<StartError> {
    let strapdown = Strapdown::<Local, H0B4A0>::new(Pair::new(0.01)).unwrap().start(initial).err();
    let earth = Strapdown::<Earth, H2B4A2>::new(Pair::new(0.01)).unwrap().start(initial).err();
    let textbook = Textbook::<LocalLevelTextbook<f64>>::new(0.01).unwrap().start(initial).err();
    let earth_textbook =
        Textbook::<EarthFixedTextbook<f64>>::new(0.01).unwrap().start(initial).err();
    assert_eq!([earth, textbook, earth_textbook], [strapdown; 3], "{initial:?}");
    strapdown
}

#[test]
fn starts_that_cannot_be_right() {
    let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    assert_eq!(starts(&place(0.8, 2.0, 300.0)), None);
    assert_eq!(starts(&place(-1.57, PI, -100.0)), None);
    // At the pole itself only the Earth-fixed frames start.
    let pole = place(-FRAC_PI_2, PI, -100.0);
    let local = Strapdown::<Local, H0B4A0>::new(Pair::new(0.01)).unwrap();
    assert_eq!(local.start(&pole).err(), Some(StartError::Pole));
    let textbook = Textbook::<LocalLevelTextbook<f64>>::new(0.01).unwrap();
    assert_eq!(textbook.start(&pole).err(), Some(StartError::Pole));
    assert!(Strapdown::<Earth, H2B4A2>::new(Pair::new(0.01)).unwrap().start(&pole).is_ok());
    assert!(Textbook::<EarthFixedTextbook<f64>>::new(0.01).unwrap().start(&pole).is_ok());
    for x in bad.into_iter().chain([1.571, -1.571, 45.0]) {
        assert_eq!(starts(&place(x, 2.0, 300.0)), Some(StartError::Position), "latitude {x}");
    }
    for x in bad.into_iter().chain([6.3, -100.0]) {
        assert_eq!(starts(&place(0.8, x, 300.0)), Some(StartError::Position), "longitude {x}");
    }
    for x in bad.into_iter().chain([1.1e6, -1.1e6]) {
        assert_eq!(starts(&place(0.8, 2.0, x)), Some(StartError::Position), "altitude {x}");
    }
    for x in bad.into_iter().chain([1.1e5, -1.1e5]) {
        for axis in 0..3 {
            let mut initial = place(0.8, 2.0, 300.0);
            *initial.velocity_ned.each_mut()[axis] = Pair::new(x);
            assert_eq!(starts(&initial), Some(StartError::Velocity), "{x}");
        }
    }
    for x in bad {
        for part in 0..4 {
            let mut initial = place(0.8, 2.0, 300.0);
            *initial.attitude.each_mut()[part] = Pair::new(x);
            assert_eq!(starts(&initial), Some(StartError::Attitude), "{x}");
        }
    }
    for stretch in [0.0, 0.99, 1.01, 2.0, -1.5] {
        let mut initial = place(0.8, 2.0, 300.0);
        initial.attitude = initial.attitude.map(|c| c * Pair::new(stretch));
        assert_eq!(starts(&initial), Some(StartError::Attitude), "{stretch}");
    }
    let opposite = place(0.8, 2.0, 300.0).attitude.map(|c| -c);
    let initial = Solution { attitude: opposite, ..place(0.8, 2.0, 300.0) };
    assert_eq!(starts(&initial), None);
    let none = Quaternion { w: Pair::default(), v: opposite.v.map(|_| Pair::default()) };
    assert_eq!(starts(&Solution { attitude: none, ..initial }), Some(StartError::Attitude));
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
    ];
    let words = ["angle", "velocity", "interval", "limits", "position", "velocity", "attitude"];
    for (i, (text, word)) in texts.iter().zip(words).enumerate() {
        assert!(text.contains(word), "{text}");
        assert!(texts.iter().skip(i + 1).all(|other| other != text), "{text}");
    }
}
