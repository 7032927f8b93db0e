//! What is planted in the sensors is found, and what is true is not refused.

use schuler_host::ensemble::findings::Findings;
use schuler_host::ensemble::sentences::sentences;
use schuler_simulator::ensemble::batches::Means;
use schuler_simulator::ensemble::fleet;
use schuler_simulator::ensemble::group::Ground;
use schuler_simulator::ensemble::kept::Kept;
use schuler_simulator::scene::{Scene, WindowShape, builtin};
use schuler_simulator::source::Source;

/// A unit at rest with white noise and a turn-on bias of its gyros, read four times in a minute.
fn resting() -> Scene {
    let mut scene = builtin::scene("stationary").unwrap();
    scene.duration_s = 60.0;
    scene.rate_hz = 5.0;
    scene.gyro.white = Some([3e-6; 3]);
    scene.gyro.turn_on = Some([1e-6, 2e-6, 1e-6]);
    scene.accelerometer.white = Some([1e-4; 3]);
    scene.navigator.window = Some(WindowShape { history: 0, block: 4, lookahead: 0 });
    scene
}

/// Runs of one scene beside the theory of another.
fn compared(flown: &Scene, believed: &Scene, runs: u64) -> Findings {
    let sources = [flown, believed].map(|scene| Source::new(scene, false).unwrap());
    let stops = [75, 150, 225, 300];
    let ground = Ground::new(flown, &sources[0]);
    let unit = ground.widest(runs);
    let flown = fleet::fly_range(&ground, 0..runs, unit, 2, &stops, &|_| {}).unwrap();
    let means = Means { unit, threads: 2, stops: &stops, batch: None };
    let believed = Ground::new(believed, &sources[1]);
    Findings::new(&believed, &Kept::new(0..runs, flown), None, means).unwrap()
}

#[test]
fn ten_percent_more_noise_is_found_and_said() {
    let believed = resting();
    let mut flown = believed.clone();
    flown.gyro.white = Some([3.3e-6; 3]);
    flown.gyro.turn_on = Some([1.1e-6, 2.2e-6, 1.1e-6]);
    let found = compared(&flown, &believed, 2000);
    assert!(found.verdict.failed > 0 && found.together.failed > 0, "{:?}", found.verdict);
    let said = sentences(&found);
    let spread = said.iter().find(|text| text.starts_with("The standard deviation of attitude_"));
    let text = spread.unwrap_or_else(|| panic!("{said:?}"));
    assert!(text.contains(" % above theory's ") && text.contains("(95 %: "), "{text}");
    assert!(text.contains(" s is "), "{text}");
    // By how much: ten percent, with the interval of 2000 runs.
    let percent = text.split(" s is ").nth(1).and_then(|rest| rest.split(' ').next());
    let percent: f64 = percent.and_then(|number| number.parse().ok()).expect("a number");
    assert!((percent - 10.0).abs() < 8.0, "{text}");
    assert!(said.iter().any(|text| text.contains("NEES ") && text.contains(" is expected")));
    // No state's mean is off.
    assert!(!said.iter().any(|text| text.starts_with("The mean of ")), "{said:?}");
}

#[test]
fn a_bias_is_found_in_the_mean_that_it_moves() {
    let believed = resting();
    let mut flown = believed.clone();
    flown.accelerometer.constant = Some([0.0, 0.0, 1e-4]);
    let found = compared(&flown, &believed, 200);
    let said = sentences(&found);
    let text = said.iter().find(|text| text.starts_with("The mean of down_m"));
    let text = text.unwrap_or_else(|| panic!("{said:?}"));
    // Accelerometers that read too much down: the position goes down.
    assert!(text.contains(" lies ") && text.contains(" above theory's "), "{text}");
    assert!(text.contains(" standard errors)"), "{text}");
}

#[test]
fn what_is_true_is_not_refused_over_many_seeds() {
    let mut scene = resting();
    let (mut refused, mut tests) = (0, 0);
    for seed in 1..=60 {
        scene.seed = seed;
        let found = compared(&scene, &scene, 40);
        refused += usize::from(found.verdict.failed > 0) + usize::from(found.together.failed > 0);
        tests += found.verdict.tests;
        if found.verdict.failed + found.together.failed == 0 {
            let said = sentences(&found);
            assert_eq!(said.len(), 1, "{said:?}");
            assert!(said[0].starts_with("With 40 runs, a standard deviation that is off by "));
        }
    }
    assert!(tests > 60 * 50, "{tests}");
    // 120 verdicts with a risk of a thousandth each: three have a probability of 3e-4.
    assert!(refused < 3, "{refused}");
}
