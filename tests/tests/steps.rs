//! What the nav steps leave out at low rates and high speeds, what single precision rounds, and what adds up
//! over many turns: each bound is missed by an order or more without the terms that it is for.

use schuler::earth::Geodetic;
use schuler::flight::carried::Carried;
use schuler::math::compensated::{Pair, TwoFloat};
use schuler::math::real::Scalar;
use schuler::math::vector::Vector;
use schuler::output::Output as _;
use schuler::sample::Increment;
use schuler::solution::{Euler, Solution};
use schuler::strapdown::block::window::{H0B2A0, H0B4A0, H2B4A2, H4B4A4};
use schuler::strapdown::frame::Frame;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};
use schuler::trajectory::harmonic::Harmonic;
use schuler_simulator::scene::{Channel, Scene};
use schuler_tests::{Course, Numbers, at_rest, largest};
use std::f64::consts::{PI, TAU};

type Local = LocalLevel<Pair<f64>>;
type Earth = EarthFixed<Pair<f64>>;

fn steady(offset: f64, rate: f64) -> Channel {
    Channel { offset, rate, ..Channel::default() }
}

/// A scene of perfect sensors: degrees, and degrees per second.
fn scene(rate_hz: f64, duration_s: f64, change: impl FnOnce(&mut Scene)) -> Course {
    let mut scene = at_rest(duration_s);
    scene.rate_hz = rate_hz;
    change(&mut scene);
    Course::of(&scene)
}

/// The largest misses of a flight with each of the windows that follow it, in one frame, m.
fn misses<F: Frame<Real = f64>>(course: &Course) -> [f64; 3] {
    [
        course.largest_miss(&Strapdown::<F, H0B4A0>::new(course.interval_s).unwrap()),
        course.largest_miss(&Strapdown::<F, H2B4A2>::new(course.interval_s).unwrap()),
        course.largest_miss(&Strapdown::<F, H4B4A4>::new(course.interval_s).unwrap()),
    ]
}

/// Level at 300 m/s, 5 Hz, half an hour: 2.3e-8 m without the third order of the Earth's turn.
#[test]
fn level_flight_at_five_hertz() {
    for (latitude, north, east) in
        [(40.0, 0.00135, 0.0033), (-60.0, 0.0, -0.0053), (79.0, 0.0, 0.012)]
    {
        let course = scene(5.0, 1800.0, |scene| {
            scene.trajectory.latitude = steady(f64::to_radians(latitude), f64::to_radians(north));
            scene.trajectory.longitude = steady(3.1, f64::to_radians(east));
            scene.trajectory.altitude = steady(10_000.0, 0.0);
        });
        for miss in misses::<Local>(&course).into_iter().chain(misses::<Earth>(&course)) {
            assert!(miss <= 1e-8, "{latitude}°: {miss:e}");
        }
        let two = Strapdown::<Local, H0B2A0>::new(course.interval_s).unwrap();
        assert!(course.largest_miss(&two) <= 1e-8);
    }
}

/// Turns of 60° of bank at 300 m/s: 2.8e-6 m at 5 Hz where ∇³ of gravity stands still in turning axes.
#[test]
fn banked_turns() {
    for (rate_hz, bound) in [(5.0, 3e-8), (10.0, 3e-8)] {
        let course = scene(rate_hz, 1800.0, |scene| {
            let turn = |amplitude: f64, phase: f64| {
                vec![Harmonic {
                    amplitude: f64::to_radians(amplitude),
                    angular_rate: TAU / 111.1,
                    phase,
                }]
            };
            scene.trajectory.roll = steady(PI / 3.0, 0.0);
            scene.trajectory.yaw = steady(0.0, TAU / 111.1);
            scene.trajectory.latitude.harmonics = turn(0.0478, -PI / 2.0);
            scene.trajectory.longitude.harmonics = turn(0.0624, PI);
            scene.trajectory.altitude = steady(10_000.0, 0.0);
        });
        for miss in misses::<Local>(&course).into_iter().chain(misses::<Earth>(&course)) {
            assert!(miss <= bound, "{rate_hz} Hz: {miss:e}");
        }
    }
}

/// Around the Earth over the meridian, the latitude accelerating: 7e-5 m Earth-fixed with Newton's divisor as
/// a short series, 2.9e-7 m local-level without the fourth order of the meridian's arc.
#[test]
fn orbits() {
    for (altitude, rate) in [(420_000.0, 0.0646), (999_000.0, 0.0571)] {
        let course = scene(10.0, 1000.0, |scene| {
            let harmonic = Harmonic {
                amplitude: f64::to_radians(60.0),
                angular_rate: f64::to_radians(rate),
                phase: -0.7,
            };
            scene.trajectory.latitude = Channel { harmonics: vec![harmonic], ..steady(0.0, 0.0) };
            scene.trajectory.altitude = steady(altitude, 0.0);
        });
        for miss in misses::<Local>(&course).into_iter().chain(misses::<Earth>(&course)) {
            assert!(miss <= 1e-7, "{altitude} m: {miss:e}");
        }
    }
}

/// Largest miss of a flight in two-float single precision, m.
fn two_float<F: Frame<Real = f32>>(course: &Course) -> f64 {
    let strapdown = Strapdown::<F, H0B4A0>::new(Pair::narrow(course.interval_s)).unwrap();
    let mut state = strapdown.start(&Solution::narrow(&course.initial())).unwrap();
    let (mut carried, mut done, mut miss) = (Carried::default(), 0, 0.0_f64);
    for sample in &course.samples {
        strapdown.push(&mut state, carried.narrow(sample)).unwrap();
        if state.integrated() != done {
            done = state.integrated();
            miss = largest([miss, course.miss(done, &state.output().wide())]);
        }
    }
    miss
}

/// Standing in any pose: 32 mm at worst where the excess of gravity is rounded.
#[test]
fn two_float_poses() {
    let mut numbers = Numbers(20);
    for _ in 0..20 {
        let course = scene(20.0, 1800.0, |scene| {
            scene.trajectory.latitude = steady(numbers.within(1.4), 0.0);
            scene.trajectory.longitude = steady(numbers.within(3.1), 0.0);
            scene.trajectory.altitude = steady(5000.0 + numbers.within(5000.0), 0.0);
            scene.trajectory.roll = steady(numbers.within(3.1), 0.0);
            scene.trajectory.pitch = steady(numbers.within(1.4), 0.0);
            scene.trajectory.yaw = steady(numbers.within(3.1), 0.0);
        });
        let miss = two_float::<LocalLevel<TwoFloat<f32>>>(&course);
        assert!(miss <= 5e-3, "local-level: {miss}");
        let miss = two_float::<EarthFixed<TwoFloat<f32>>>(&course);
        assert!(miss <= 2e-2, "earth-fixed: {miss}");
    }
}

/// At a pole, next to one and over it: 0.35 m in single precision.
#[test]
fn two_float_at_a_pole() {
    for (latitude, rate) in [(90.0, 0.0), (-90.0, 0.0), (89.99, 0.0), (89.5, 250.0 / 6.4e6)] {
        let course = scene(50.0, 600.0, |scene| {
            scene.trajectory.latitude = steady(f64::to_radians(latitude), rate);
            scene.trajectory.altitude = steady(500.0, 0.0);
        });
        let miss = two_float::<EarthFixed<TwoFloat<f32>>>(&course);
        assert!(miss <= 2e-2, "{latitude}°: {miss}");
    }
}

/// A million samples at 360 °/s: |q|² stays one, and the longitude folds.
fn spins<M: Mechanization<Real: Scalar>>(mechanization: M, most: f64) {
    let of = <M::Real as schuler::math::real::Real>::of;
    let position = Geodetic { latitude: of(0.7), longitude: of(PI - 3e-6), altitude: of(100.0) };
    let attitude = Euler { roll: of(0.3), pitch: of(0.2), yaw: of(0.5) };
    // East, fast enough to cross the antimeridian.
    let velocity = Vector::new(of(0.0), of(300.0), of(0.0));
    let mut state = mechanization.start(&Solution::new(position, velocity, attitude)).unwrap();
    let turned = TAU / 100.0;
    let angle = Vector::new(0.6, 0.64, -0.48).map(|axis: f64| of(axis * turned));
    let sample = Increment { angle_b: angle, velocity_b: Vector::new(of(0.0), of(0.0), of(0.0)) };
    for n in 0..1_000_000 {
        mechanization.push(&mut state, sample).unwrap();
        mechanization.hold_vertical(&mut state, of(100.0), of(0.0)).unwrap();
        if n % 997 == 0 {
            let row = mechanization.output(&state).solution();
            let q = row.attitude.map(Pair::widen);
            assert!((q.dot(q) - 1.0).abs() <= most, "{n}: {:e}", q.dot(q) - 1.0);
            assert!(row.position.longitude.widen().abs() <= PI * (1.0 + 1e-15));
        }
    }
}

#[test]
fn attitudes_keep_their_length() {
    let single = Pair::new(100.0_f32).reciprocal();
    let double = Pair::new(100.0_f64).reciprocal();
    spins(Strapdown::<LocalLevel<Pair<f32>>, H0B4A0>::new(single).unwrap(), 1e-5);
    spins(Strapdown::<EarthFixed<Pair<f32>>, H0B4A0>::new(single).unwrap(), 1e-5);
    spins(Strapdown::<LocalLevel<TwoFloat<f32>>, H0B4A0>::new(single).unwrap(), 1e-5);
    spins(Strapdown::<EarthFixed<TwoFloat<f32>>, H0B4A0>::new(single).unwrap(), 1e-5);
    spins(Strapdown::<Local, H0B4A0>::new(double).unwrap(), 1e-14);
    spins(Strapdown::<Earth, H0B4A0>::new(double).unwrap(), 1e-14);
    spins(Textbook::<LocalLevelTextbook<f32>>::new(single.hi).unwrap(), 1e-5);
    spins(Textbook::<EarthFixedTextbook<f32>>::new(single.hi).unwrap(), 1e-5);
}
