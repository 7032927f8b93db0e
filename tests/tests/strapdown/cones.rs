//! Cones of few samples per cycle, whose small errors blocks of four could repeat and add up.

use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::strapdown::block::alike::{Weights, lacking, weights_f32, weights_f64};
use schuler::strapdown::block::window::{H2B4A2, H4B4A4, Window};
use schuler::strapdown::frame::Frame;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::reference::textbook::{LocalLevelTextbook, Textbook};
use schuler::trajectory::harmonic::Harmonic;
use schuler_simulator::scene::Channel;
use schuler_tests::{Course, at_rest};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const RATE_HZ: f64 = 100.0;

/// Roll and pitch cosines, pitch 90° ahead, for a minute at 45°.
fn cone(degrees: f64, samples_per_cycle: f64) -> Course {
    let mut scene = at_rest(60.0);
    scene.rate_hz = RATE_HZ;
    let (amplitude, angular_rate) = (degrees * PI / 180.0, TAU * RATE_HZ / samples_per_cycle);
    let swing = |phase| Channel {
        harmonics: vec![Harmonic { amplitude, angular_rate, phase }],
        ..Channel::default()
    };
    scene.trajectory.roll = swing(0.0);
    scene.trajectory.pitch = swing(FRAC_PI_2);
    Course::of(&scene)
}

fn miss<F: Frame<Real = f64>, W: Window>(course: &Course) -> f64 {
    course.largest_miss(&Strapdown::<F, W>::new(course.interval_s).unwrap())
}

/// Of the textbook's error at most this share, or 10 nm.
fn assert_cone(degrees: f64, samples_per_cycle: f64, share: f64) {
    type Local = LocalLevel<Pair<f64>>;
    type Earth = EarthFixed<Pair<f64>>;
    let course = cone(degrees, samples_per_cycle);
    let textbook = Textbook::<LocalLevelTextbook<f64>>::new(course.interval_s.hi).unwrap();
    let bound = (share * course.largest_miss(&textbook)).max(1e-8);
    for (miss, what) in [
        (miss::<Local, H2B4A2>(&course), "2,4,2 local-level"),
        (miss::<Earth, H2B4A2>(&course), "2,4,2 Earth-fixed"),
        (miss::<Local, H4B4A4>(&course), "4,4,4 local-level"),
        (miss::<Earth, H4B4A4>(&course), "4,4,4 Earth-fixed"),
    ] {
        assert!(miss <= bound, "{degrees}° at {samples_per_cycle}: {what} {miss:e} over {bound:e}");
    }
}

#[test]
fn cones_that_are_not_resolved_are_as_good_as_the_textbook() {
    for degrees in [0.1, 1.0] {
        for samples_per_cycle in [2.2, 2.5, 3.0, 4.0] {
            assert_cone(degrees, samples_per_cycle, 1.5);
        }
    }
}

#[test]
fn cones_of_six_samples_per_cycle_are_ten_times_better() {
    for degrees in [0.1, 1.0] {
        for samples_per_cycle in [6.0, 10.0, 12.0] {
            assert_cone(degrees, samples_per_cycle, 0.1);
        }
    }
}

/// Motion by polynomials that the window's own fit follows lacks nothing.
fn nothing<const N: usize, const M: usize>(degree: i32) {
    let (single, double): (Weights<f32, M>, Weights<f64, M>) = (weights_f32(), weights_f64());
    // ∫tⁿ over a sample, t from −1 to 1 over all of them.
    let power = |k: usize, n: i32| {
        let edge = |k: usize| (k as f64 / M as f64 - 1.0).powi(n + 1) / f64::from(n + 1);
        edge(k + 1) - edge(k)
    };
    let samples = |n: i32| -> [Increment<f64>; N] {
        std::array::from_fn(|k| Increment {
            angle_b: Vector::new(power(k, n), power(k, 0), power(k, 1)),
            velocity_b: Vector::new(power(k, 1), power(k, n), power(k, 0)),
        })
    };
    let sizes = |n: i32| {
        let Increment { angle_b, velocity_b } = lacking(&samples(n), &single, &double);
        angle_b.norm().max(velocity_b.norm())
    };
    for n in 0..=degree {
        assert!(sizes(n) <= 1e-17, "{n}: {:e}", sizes(n));
    }
    assert!(sizes(degree + 1) > 1e-12 && sizes(degree + 2) > 1e-12);
}

#[test]
fn motion_that_the_fit_follows_lacks_nothing() {
    nothing::<12, 6>(7);
    nothing::<16, 8>(11);
}
