//! Blocks at an edge: as long a window as the samples support, and no longer.

use schuler::math::compensated::Pair;
use schuler::output::Output as _;
use schuler::sample::Increment;
use schuler::strapdown::block::newton::at_edge;
use schuler::strapdown::block::shape::WindowShape;
use schuler::strapdown::block::support::Differences;
use schuler::strapdown::block::window::*;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::navigator::{State, Strapdown};
use schuler::strapdown::reference::textbook::{LocalLevelTextbook, Textbook};
use schuler::trajectory::harmonic::Harmonic;
use schuler_simulator::scene::Channel;
use schuler_simulator::source::Source;
use schuler_tests::{Course, Numbers, at_rest, near};
use std::f64::consts::{FRAC_PI_2, TAU};

type Local = LocalLevel<Pair<f64>>;
type Earth = EarthFixed<Pair<f64>>;
const DEGREE: f64 = TAU / 360.0;
const RATE_HZ: f64 = 100.0;

/// Roll and pitch as cosines, pitch a quarter ahead, at rest.
fn cone(angle_deg: f64, samples_per_cycle: f64, duration_s: f64) -> Course {
    let mut scene = at_rest(duration_s);
    scene.rate_hz = RATE_HZ;
    let harmonic = |phase| Harmonic {
        amplitude: angle_deg * DEGREE,
        angular_rate: TAU * RATE_HZ / samples_per_cycle,
        phase,
    };
    let channel = |phase| Channel { harmonics: vec![harmonic(phase)], ..Channel::default() };
    (scene.trajectory.roll, scene.trajectory.pitch) = (channel(0.0), channel(FRAC_PI_2));
    let source = Source::new(&scene, false).unwrap();
    let sample = |n| source.perfect(source.time_s(n - 1), source.time_s(n));
    let samples = (1..=scene.samples()).map(sample).collect();
    Course { source, interval_s: Pair::new(RATE_HZ).reciprocal(), samples }
}

fn end_miss<M: Mechanization<Real = f64>>(mechanization: &M, course: &Course) -> f64 {
    let mut state = mechanization.start(&course.initial()).unwrap();
    for &sample in &course.samples {
        mechanization.push(&mut state, sample).unwrap();
    }
    mechanization.finish(&mut state);
    course.miss(course.samples.len() as u64, &mechanization.output(&state).wide())
}

/// What the sampling does not resolve costs no more than it costs the textbook; what it resolves, less.
#[test]
fn no_window_throws_a_cone() {
    for (angle_deg, samples_per_cycle, part) in [
        (0.1, 2.2, 1.5),
        (0.1, 2.5, 1.5),
        (0.1, 3.0, 1.5),
        (0.1, 10.0, 0.1),
        (1.0, 2.2, 1.5),
        (1.0, 2.5, 1.5),
        (1.0, 3.0, 1.5),
        (1.0, 10.0, 0.1),
    ] {
        let course = cone(angle_deg, samples_per_cycle, 60.0);
        let textbook = Textbook::<LocalLevelTextbook<f64>>::new(course.interval_s.hi).unwrap();
        let bound_m = (part * end_miss(&textbook, &course)).max(1e-8);
        let h = course.interval_s;
        let misses = [
            end_miss(&Strapdown::<Local, H2B2A2>::new(h).unwrap(), &course),
            end_miss(&Strapdown::<Local, H2B4A2>::new(h).unwrap(), &course),
            end_miss(&Strapdown::<Earth, H2B4A2>::new(h).unwrap(), &course),
            end_miss(&Strapdown::<Local, H4B4A4>::new(h).unwrap(), &course),
            end_miss(&Strapdown::<Earth, H4B4A4>::new(h).unwrap(), &course),
        ];
        for miss in misses {
            assert!(miss <= bound_m, "{angle_deg}° {samples_per_cycle}: {misses:?} {bound_m}");
        }
    }
}

/// Samples at rest with white noise, on all axes or on one of the gyros'.
fn noisy(angle: f64, one_axis: bool, seed: u64) -> Course {
    let mut course = cone(0.0, 10.0, 0.55);
    let mut numbers = Numbers(seed);
    for sample in &mut course.samples {
        let noise = numbers.vector(angle);
        sample.angle_b.x += noise.x;
        if !one_axis {
            sample.angle_b.y += noise.y;
            sample.angle_b.z += noise.z;
        }
    }
    course
}

fn state<W: Window>(course: &Course) -> State<Local, W> {
    let strapdown = Strapdown::<Local, W>::new(course.interval_s).unwrap();
    let mut state = strapdown.start(&course.initial()).unwrap();
    for &sample in &course.samples {
        strapdown.push(&mut state, sample).unwrap();
    }
    strapdown.finish(&mut state);
    state
}

/// Half a second of noise ends where four samples to a block end, with every window: all that may differ is
/// what noise makes of gravity within a block.
fn ends_alike<W: Window>() {
    for (one_axis, angle) in [(false, 1e-4), (true, 1e-4), (false, 5e-4)] {
        let (mut own, mut four) = (0.0, 0.0);
        for seed in 1..=32 {
            let course = noisy(angle, one_axis, seed);
            let h = course.interval_s;
            own += end_miss(&Strapdown::<Local, W>::new(h).unwrap(), &course).powi(2);
            four += end_miss(&Strapdown::<Local, H0B4A0>::new(h).unwrap(), &course).powi(2);
        }
        let (own, four, shape) = (own.sqrt(), four.sqrt(), W::SHAPE);
        assert!(own <= 1.5 * four, "{shape:?} {one_axis} {angle}: {own:e} {four:e}");
    }
}

#[test]
fn noise_is_not_blown_up_at_an_edge() {
    for_every_window!(ends_alike);
}

#[test]
fn what_was_chosen_is_told() {
    let smooth = Course::new("manoeuvre", 1.0, 1.0);
    let edges = state::<H2B4A2>(&smooth).edges();
    assert!(edges.first.gyro >= 8.0 && edges.last.gyro >= 7.0, "{edges:?}");
    // Noise of the gyros does not shorten what the accelerometers support.
    let edges = state::<H2B4A2>(&noisy(1e-4, true, 3)).edges();
    assert!(edges.first.gyro <= 7.0, "{edges:?}");
    let edges = state::<H4B4A0>(&noisy(1e-4, false, 3)).edges();
    assert!(edges.first.gyro <= 7.0 && edges.last.gyro <= 6.0, "{edges:?}");
    let edges = state::<H0B4A0>(&smooth).edges();
    assert_eq!(edges.first.gyro, 0.0);
}

/// A motion that is a polynomial is fitted by it, from either side.
#[test]
fn polynomials_are_fitted_exactly() {
    // ∫t⁴ dt over [j, j + 1]
    let sample = |j: i32| {
        let edge = |t: i32| f64::from(t).powi(5) / 5.0;
        let x = edge(j + 1) - edge(j);
        let mut sample = Increment::<f64>::ZERO;
        sample.angle_b.y = x;
        sample.velocity_b.z = -2.0 * x;
        sample
    };
    for (shape, begin) in [((0, 4, 6), 0), ((6, 4, 0), 4), ((2, 3, 5), 1), ((5, 2, 1), 3)] {
        let samples: Vec<_> = (0..14).map(|j| sample(j - 6)).collect();
        let (history, block, lookahead) = shape;
        let window = WindowShape { history, block, lookahead };
        let (fit, used) = at_edge(&samples, window, begin);
        assert!(used.gyro >= 5.0 && used.accelerometer >= 5.0, "{shape:?}: {used:?}");
        for sigma in [-1.0_f64, -0.3, 0.4, 1.0] {
            let start = (begin + history) as f64 - 6.0;
            let half = block as f64 / 2.0;
            let expected = half * (start + half * (sigma + 1.0)).powi(4);
            let at = |parts: Vec<f64>| parts.iter().rev().fold(0.0, |sum, c| sum * sigma + c);
            let rate = at(fit.rate.iter().map(|w| w.y).collect());
            let force = at(fit.force.iter().map(|f| f.z).collect());
            let scale = half * 8.0_f64.powi(4);
            assert!((rate - expected).abs() <= 1e-11 * scale, "{shape:?}: {rate} {expected}");
            assert!((force + 2.0 * expected).abs() <= 2e-11 * scale, "{shape:?}: {force}");
        }
    }
}

/// White noise has the same power in every difference, once its binomial is taken out.
#[test]
fn differences_of_noise_have_one_power() {
    let mut differences = Differences::<f64>::new();
    let mut numbers = Numbers(5);
    for _ in 0..200_000 {
        let (angle_b, velocity_b) = (numbers.vector(1.0), numbers.vector(2.0));
        differences.add(&Increment { angle_b, velocity_b });
    }
    // Three axes, each even within ±bound.
    for k in 0..=14 {
        let [gyro, accelerometer] = differences.power(k).unwrap();
        near(gyro, 1.0, 0.05, "gyros");
        near(accelerometer, 4.0, 0.05, "accelerometers");
    }
    assert_eq!(differences.power(15), None);
    assert_eq!(Differences::<f64>::new().power(0), None);
    assert_eq!(differences.count(), 200_000);
}
