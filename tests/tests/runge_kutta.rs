//! Runge-Kutta on rates against the truth: its order in the step, and the figures it is known for.

use schuler::drift::compare::drift;
use schuler::math::vector::Vector;
use schuler::output::Output as _;
use schuler::strapdown::limits::Rejected;
use schuler::strapdown::reference::rk4::RungeKutta;
use schuler_tests::{Course, bits};

/// Largest distance from the truth at the ends of steps, m.
fn largest_miss(course: &Course) -> f64 {
    let rates = |sample| course.source.rates(sample);
    let navigator = RungeKutta::new(course.interval_s.hi).unwrap();
    let mut state = navigator.start(&course.initial()).unwrap();
    let mut largest = 0.0;
    for sample in (2..=course.samples.len() as u64).step_by(2) {
        navigator.step(&mut state, &[rates(sample - 2), rates(sample - 1), rates(sample)]).unwrap();
        let miss = course.miss(sample, &state.output().wide());
        assert!(miss.is_finite());
        largest = f64::max(largest, miss);
    }
    largest
}

#[test]
fn the_error_falls_with_the_fourth_power_of_the_step() {
    let [coarse, middle, fine] =
        [1.0, 2.0, 4.0].map(|faster| largest_miss(&Course::new("manoeuvre", faster, 100.0)));
    let order = |a: f64, b: f64| (a / b).log2();
    for order in [order(coarse, middle), order(middle, fine)] {
        assert!((3.8..4.5).contains(&order), "{order}: {coarse:.3e} {middle:.3e} {fine:.3e}");
    }
    assert!((2e-2..5e-2).contains(&coarse), "{coarse:.3e}");
}

#[test]
fn slow_motion_to_the_rounding_of_plain_sums() {
    let miss = largest_miss(&Course::new("paper-perfect", 1.0, 1800.0));
    assert!((1e-9..6e-7).contains(&miss), "{miss:.3e}");
}

#[test]
fn attitude_keeps_its_length() {
    let course = Course::new("manoeuvre", 0.5, 20.0);
    let rates = |sample| course.source.rates(sample);
    let navigator = RungeKutta::new(course.interval_s.hi).unwrap();
    let mut state = navigator.start(&course.initial()).unwrap();
    for sample in (2..=course.samples.len() as u64).step_by(2) {
        navigator.step(&mut state, &[rates(sample - 2), rates(sample - 1), rates(sample)]).unwrap();
        let q = state.output().attitude.map(|c| c.hi);
        assert!((q.dot(q) - 1.0).abs() < 1e-12);
    }
    let end = course.samples.len() as u64 / 2 * 2;
    let drift = drift(&state.output().wide(), &course.source.truth(end));
    assert!(drift.attitude_ned.norm() < 1e-4, "{:?}", drift.attitude_ned);
}

#[test]
fn what_is_refused_leaves_the_state_alone() {
    let course = Course::new("hard", 1.0, 1.0);
    let navigator = RungeKutta::new(course.interval_s.hi).unwrap();
    let mut state = navigator.start(&course.initial()).unwrap();
    let before = bits(&state);
    let good = course.source.rates(0);
    let mut bad = good;
    bad.rate_ib_b = Vector::new(f64::NAN, 0.0, 0.0);
    assert_eq!(navigator.step(&mut state, &[good, good, bad]), Err(Rejected::Angle));
    bad = good;
    bad.specific_force_b.z = 2e5;
    assert_eq!(navigator.step(&mut state, &[good, bad, good]), Err(Rejected::Velocity));
    assert_eq!(bits(&state), before);
    assert!(RungeKutta::new(0.0).is_err() && RungeKutta::new(1.5).is_err());
}
