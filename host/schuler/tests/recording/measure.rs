//! What the samples of a recording say about its motion, and the window for it.

use super::scattered;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler_simulator::recording::measure::{CANDIDATES, Measure, Motion};
use schuler_simulator::scene::WindowShape;
use std::f64::consts::TAU;

/// A cone of so many samples per cycle, with noise of a part of its size.
fn cone(samples_per_cycle: f64, noise: f64) -> Measure {
    let mut uniform = scattered(11);
    let mut noise = || noise * (uniform() + uniform() + uniform() - 1.5) * 2.0;
    let mut measure = Measure::default();
    for i in 0..2000 {
        let phase = TAU * f64::from(i) / samples_per_cycle;
        let angle_b = Vector::new(phase.cos() + noise(), phase.sin() + noise(), 1e-3);
        measure.add(&Increment { angle_b, velocity_b: Vector::new(0.0, 0.0, -0.098) });
        // As at a gap: what follows goes on elsewhere.
        if i == 1000 {
            measure.cut();
        }
    }
    measure.cut();
    measure
}

#[test]
fn a_cone_has_the_samples_per_cycle_that_it_has() {
    for samples in [3.6, 4.0, 6.0, 10.0, 20.0] {
        let Motion::Resolved(found) = cone(samples, 0.0).motion() else { panic!("{samples}") };
        assert!((found / samples - 1.0).abs() < 1e-3, "{found}, not {samples}");
    }
    for samples in [2.2, 2.5, 3.0] {
        let Motion::Unresolved(found) = cone(samples, 0.0).motion() else { panic!("{samples}") };
        assert!((found / samples - 1.0).abs() < 1e-3, "{found}, not {samples}");
    }
    let Motion::Resolved(found) = cone(10.0, 1e-6).motion() else { panic!("it stands out") };
    assert!((found / 10.0 - 1.0).abs() < 0.02, "{found}");
}

#[test]
fn what_does_not_move_or_only_trembles_is_told() {
    let mut still = Measure::default();
    for _ in 0..1000 {
        let velocity_b = Vector::new(0.0, 0.0, -0.098_1);
        still.add(&Increment { angle_b: Vector::new(5e-7, 0.0, -5e-7), velocity_b });
    }
    still.cut();
    assert_eq!((still.motion(), still.window()), (Motion::None, None));
    let mut uniform = scattered(5);
    let mut noise = Measure::default();
    for _ in 0..20_000 {
        let angle_b = Vector::new(uniform() - 0.5, uniform() - 0.5, uniform() - 0.5);
        noise.add(&Increment { angle_b, velocity_b: Vector::ZERO });
    }
    noise.cut();
    assert_eq!((noise.motion(), noise.window()), (Motion::Noise, Some(WindowShape::new(2, 4, 2))));
    assert_eq!(Measure::default().window(), None);
}

#[test]
fn resolved_motion_is_worth_a_long_window() {
    assert_eq!(cone(8.0, 0.0).window(), Some(WindowShape::new(4, 4, 4)));
    assert!(CANDIDATES.contains(&cone(2.5, 0.0).window().expect("there is one")));
}
