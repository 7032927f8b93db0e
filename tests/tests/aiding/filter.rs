//! Refusals leave every bit; a record restores a filter; a resonator left alone.

use schuler::aiding::filter::{Filter15, Filter21};
use schuler::aiding::gate::Rows;
use schuler::aiding::measurement;
use schuler::aiding::model::Model;
use schuler::aiding::states::{Extra, Process, resonator::Resonator};
use schuler::aiding::surroundings::Pose;
use schuler::aiding::transition::{Stretch, Transition};
use schuler::prelude::*;
use schuler::record::Record;

fn model() -> Model<f32> {
    Model::new(1e-6, 1e-4, Process::random_walk(1e-6, 1e-9), Process::gauss_markov(1e-3, 50.0))
}

fn pose() -> Pose<f32> {
    let attitude = Euler { roll: 0.1, pitch: 0.2, yaw: 1.0 }.quaternion();
    Pose { body_to_ned: attitude.matrix(1.0), velocity_ned: Vector::new(3.0, 1.0, 0.0) }
}

/// A filter that has seen a few steps.
fn flown<const N: usize, const P: usize, const E: usize>(
    model: &Model<f32>,
) -> schuler::aiding::filter::Filter<f32, N, P, E> {
    let mut filter = schuler::aiding::filter::Filter::new(model);
    let three = |x: f32| Vector::new(x, x, x);
    filter.add_uncertainty(0, three(1.0), &pose());
    filter.add_uncertainty(3, three(0.1), &pose());
    filter.add_uncertainty(6, Vector::new(0.01, 0.01, 0.5), &pose());
    let stretch = Stretch {
        time_s: 0.1,
        velocity: Vector::new(0.1, 0.0, -0.98),
        position: Vector::new(0.005, 0.0, -0.049),
        ..Stretch::NONE
    };
    for _ in 0..25 {
        filter.advance(model, &Transition::new(&stretch));
    }
    filter
}

fn words(state: &impl Record) -> Vec<u64> {
    let mut words = Vec::new();
    state.record("", &mut |_, bits| words.push(bits));
    words
}

#[test]
fn a_refused_vector_leaves_every_bit() {
    let mut filter: Filter15<f32> = flown(&model());
    let before = words(&filter);
    let lever = Vector::new(0.5, -0.3, -1.0);
    for innovation in [f32::NAN, f32::INFINITY, 300.0] {
        let rows: Rows<f32, 15, 3> =
            measurement::position(Vector::new(0.0, innovation, 0.0), lever, 1.0);
        let judged = filter.measure(&rows, 16.3);
        assert!(!judged.accepted && judged.errors == [0.0; 15], "{innovation}: {}", judged.nis);
        assert_eq!(words(&filter), before, "{innovation}");
    }
    let rows: Rows<f32, 15, 3> = measurement::position(Vector::new(0.0, 1.0, 0.0), lever, 1.0);
    assert!(filter.measure(&rows, 16.3).accepted);
    assert_ne!(words(&filter), before);
}

#[test]
fn a_record_restores_a_filter() {
    let sway = Resonator { rms_m: 0.3, rate: 0.9, damping: 0.05 };
    let model = model().with(Extra::Resonator(sway)).unwrap();
    let filter: Filter21<f32> = flown(&model);
    let kept = words(&filter);
    let mut back = Filter21::<f32>::new(&model);
    let mut next = kept.iter();
    back.restore("", &mut |_, _| *next.next().unwrap());
    assert!(next.next().is_none() && words(&back) == kept && back.check().is_ok());
    back.restore("", &mut |name, bits| if name == "ud" { f32::NAN.to_bits().into() } else { bits });
    assert!(back.check().is_err());
    // On a target it takes at most a kilobyte.
    assert!(size_of::<Filter21<f32>>() <= 1024 && size_of::<Filter15<f32>>() <= 1024);
}

#[test]
fn a_resonator_left_alone_keeps_its_spread() {
    let sway = Resonator { rms_m: 0.3_f64, rate: 0.9, damping: 0.05 };
    let none = Process::constant(0.0);
    let model = Model::new(0.0, 0.0, none, none).with(Extra::Resonator(sway)).unwrap();
    let mut filter = Filter21::<f64>::new(&model);
    let stretch = Stretch {
        time_s: 0.1,
        rotation: Quaternion::new(0.0, Vector::new(0.01, 0.02, -0.01)).normalised_less_one(),
        ..Stretch::NONE
    };
    for _ in 0..1000 {
        filter.advance(&model, &Transition::new(&stretch));
    }
    let ud = filter.covariance();
    for n in 15..21 {
        let expected = sway.sigma(n - 15);
        assert!((ud.sigma(n) / expected - 1.0).abs() < 1e-3, "{n}: {} for {expected}", ud.sigma(n));
    }
}
