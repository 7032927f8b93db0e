//! Starts that cannot be right, and what is made of those that can.

use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::output::Output as _;
use schuler::record::Record;
use schuler::solution::{Euler, Solution};
use schuler::strapdown::block::window::{H0B4A0, H2B4A2};
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::limits::{Rejected, StartError};
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};
use schuler_tests::{Course, bits};
use std::f64::consts::{FRAC_PI_2, PI};

type Local = LocalLevel<Pair<f64>>;
type Earth = EarthFixed<Pair<f64>>;

fn place(latitude: f64, longitude: f64, altitude: f64) -> Solution<f64> {
    let position = Geodetic { latitude, longitude, altitude };
    let attitude = Euler { roll: 0.1, pitch: 0.2, yaw: 0.3 };
    Solution::new(position, Vector::new(10.0, 20.0, 30.0), attitude)
}

/// What both mechanizations say to a start, in local-level and in Earth-fixed axes.
fn starts_in_either(initial: &Solution<f64>) -> [Option<StartError>; 2] {
    let local = Strapdown::<Local, H0B4A0>::new(Pair::new(0.01)).unwrap().start(initial).err();
    let earth = Strapdown::<Earth, H2B4A2>::new(Pair::new(0.01)).unwrap().start(initial).err();
    let textbook = Textbook::<LocalLevelTextbook<f64>>::new(0.01).unwrap().start(initial).err();
    let earth_textbook =
        Textbook::<EarthFixedTextbook<f64>>::new(0.01).unwrap().start(initial).err();
    assert_eq!([textbook, earth_textbook], [local, earth], "{initial:?}");
    [local, earth]
}

/// What all four say.
fn starts(initial: &Solution<f64>) -> Option<StartError> {
    let [local, earth] = starts_in_either(initial);
    assert_eq!(local, earth, "{initial:?}");
    local
}

#[test]
fn starts_that_cannot_be_right() {
    let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    assert_eq!(starts(&place(0.8, 2.0, 300.0)), None);
    assert_eq!(starts(&place(-1.57, PI, -100.0)), None);
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

/// The remainder that a number carries may not be broken either.
#[test]
fn remainders_that_cannot_be_right() {
    for lo in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let good = place(0.8, 2.0, 300.0);
        type Coordinate = fn(&mut Solution<f64>) -> &mut Pair<f64>;
        let coordinates: [Coordinate; 3] = [
            |s| &mut s.position.latitude,
            |s| &mut s.position.longitude,
            |s| &mut s.position.altitude,
        ];
        for coordinate in coordinates {
            let mut initial = good;
            coordinate(&mut initial).lo = lo;
            assert_eq!(starts(&initial), Some(StartError::Position), "{lo}");
        }
        for axis in 0..3 {
            let mut initial = good;
            initial.velocity_ned.each_mut()[axis].lo = lo;
            assert_eq!(starts(&initial), Some(StartError::Velocity), "{lo}");
        }
        for part in 0..4 {
            let mut initial = good;
            initial.attitude.each_mut()[part].lo = lo;
            assert_eq!(starts(&initial), Some(StartError::Attitude), "{lo}");
        }
    }
}

/// Up to a thousandth off, an attitude is brought to unit length.
#[test]
fn a_start_is_brought_to_unit_length() {
    let good = place(0.8, 2.0, 300.0);
    for stretch in [1.0, 0.9992, 1.0008, 1.0 + 1e-9] {
        let attitude = good.attitude.map(|c| c * Pair::new(stretch));
        let stretched = Solution { attitude, ..good };
        fn attitude_at<M: Mechanization<Real = f64>>(
            mechanization: &M,
            initial: &Solution<f64>,
        ) -> Quaternion<f64> {
            let state = mechanization.start(initial).unwrap();
            mechanization.output(&state).wide().attitude.map(Pair::widen)
        }
        let local = Strapdown::<Local, H0B4A0>::new(Pair::new(0.01)).unwrap();
        let earth = Strapdown::<Earth, H0B4A0>::new(Pair::new(0.01)).unwrap();
        let textbook = Textbook::<LocalLevelTextbook<f64>>::new(0.01).unwrap();
        let expected = good.attitude.map(Pair::widen);
        for attitude in [
            attitude_at(&local, &stretched),
            attitude_at(&earth, &stretched),
            attitude_at(&textbook, &stretched),
        ] {
            let rest = attitude - expected;
            assert!(rest.dot(rest).sqrt() <= 5e-16, "{stretch}: {rest:?}");
        }
    }
}

/// What a processor that takes subnormal numbers for zero would make of the bits is not promised: a
/// navigator does not start on it.
#[cfg(target_arch = "x86_64")]
#[test]
#[expect(deprecated, reason = "the control register has no other name in the standard library")]
fn a_processor_that_flushes_subnormal_numbers() {
    use std::arch::x86_64::{_mm_getcsr, _mm_setcsr};
    const FLUSH: u32 = 1 << 15;
    const DENORMALS_ARE_ZERO: u32 = 1 << 6;
    let local = Strapdown::<Local, H0B4A0>::new(Pair::new(0.01)).unwrap();
    let single = Textbook::<EarthFixedTextbook<f32>>::new(0.01).unwrap();
    let initial = place(0.8, 2.0, 300.0);
    let narrow = Solution::narrow(&initial);
    for mode in [0, FLUSH, DENORMALS_ARE_ZERO, FLUSH | DENORMALS_ARE_ZERO] {
        // SAFETY: the mode is this thread's own, and what runs until it is set back is named here.
        let starts = unsafe {
            let before = _mm_getcsr();
            _mm_setcsr(before | mode);
            let starts = (local.start(&initial).err(), single.start(&narrow).err());
            _mm_setcsr(before);
            starts
        };
        let expected = if mode == 0 { None } else { Some(StartError::FlushToZero) };
        assert_eq!(starts, (expected, expected), "{mode:x}");
    }
}

/// At a pole north is nowhere: there the Earth-fixed frame starts, and goes on.
#[test]
fn the_local_level_frame_ends_at_the_pole() {
    for latitude in [FRAC_PI_2, -FRAC_PI_2, FRAC_PI_2 - 1e-5] {
        let starts = starts_in_either(&place(latitude, 2.0, 300.0));
        assert_eq!(starts, [Some(StartError::Pole), None], "{latitude}");
    }
    assert_eq!(starts_in_either(&place(FRAC_PI_2 - 2e-4, 2.0, 300.0)), [None, None]);

    fn flies_into_it<M: Mechanization<Real = f64, State: Record>>(mechanization: &M) {
        let course = Course::new("polar", 1.0, 300.0);
        let mut state = mechanization.start(&course.initial()).unwrap();
        let taken = course
            .samples
            .iter()
            .position(|&sample| mechanization.push(&mut state, sample).is_err())
            .unwrap();
        // 640 m before the pole at 250 m/s and 50 Hz, give or take a block
        let expected = course.samples.len() - (640.0_f64 / 250.0 * 50.0) as usize;
        assert!(taken.abs_diff(expected) <= 5, "{taken} {expected}");
        let before = bits(&state);
        for &sample in &course.samples[taken..] {
            assert_eq!(mechanization.push(&mut state, sample), Err(Rejected::Pole));
            assert_eq!(bits(&state), before);
        }
        let last = mechanization.output(&state).wide();
        assert!(course.miss(M::integrated(&state), &last) < 1e-3, "{last:?}");
    }
    flies_into_it(&Strapdown::<Local, H0B4A0>::new(Pair::new(0.02)).unwrap());
    flies_into_it(&Textbook::<LocalLevelTextbook<f64>>::new(0.02).unwrap());
}
