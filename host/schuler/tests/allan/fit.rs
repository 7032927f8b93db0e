//! The fit finds what was planted, and its intervals hold what they say.

use schuler::allan::octaves::Octaves;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::sensor::Timing;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::random_walk::RandomWalk;
use schuler::sensor::white::White;
use schuler_simulator::allan::fit::Fitter;
use schuler_simulator::allan::least_squares::solve;
use schuler_simulator::allan::record;
use schuler_simulator::allan::shape::Shape;
use schuler_simulator::allan::verdict::{Verdict, compare, configured};
use schuler_simulator::scene::{Scene, parse};

#[test]
fn intervals_cover_what_was_planted() {
    const RUNS: u64 = 10;
    let (interval_s, samples) = (0.01, 1 << 15);
    let [white, walk] = [1.0, 0.3];
    let timing = Timing::new(interval_s, samples).unwrap();
    let axes = |x| Vector::new(x, x, x);
    let terms =
        (White::new(axes(white), timing).unwrap(), RandomWalk::new(axes(walk), timing).unwrap());
    let unit = Emulator::new(terms, (), timing);
    let shapes = [Shape::White, Shape::RandomWalk];
    let (mut covered, mut ratios) = ([0; 2], Vec::new());
    for run in 0..RUNS {
        let mut state = unit.start(4, run);
        let mut axes: [Octaves<f64>; 3] = [Octaves::new(interval_s).unwrap(); 3];
        for _ in 0..samples {
            let read = unit.emulate(&mut state, &Increment::ZERO).angle_b.into_array();
            axes.iter_mut().zip(read).for_each(|(axis, x)| axis.add(x).unwrap());
        }
        for axis in axes {
            let points: Vec<_> = axis.points().filter(|point| point.differences > 1).collect();
            let variances: Vec<_> = points.iter().map(|point| point.variance).collect();
            let fit = Fitter::new(&points).fit(&variances, &shapes);
            for ((found, covered), truth) in fit.terms.iter().zip(&mut covered).zip([white, walk]) {
                let [from, to] = found.interval();
                *covered += usize::from((from..=to).contains(&truth));
            }
            ratios.push(fit.terms[0].magnitude() / white);
        }
    }
    // Of 30 intervals that cover with 95 %, fewer than 24 do so once in 2000 times.
    assert!(covered.iter().all(|covered| *covered >= 24), "{covered:?}");
    // N² of n samples is known to √(2/n)·1.3 at best, N to half of that: the mean of 30 to 1e-3.
    let mean = ratios.iter().sum::<f64>() / ratios.len() as f64;
    assert!((mean - 1.0).abs() < 5e-3, "{mean}");
}

#[test]
fn unknowns_are_not_negative() {
    // Of two unknowns the best is at (2, −1); on the border it is where 2x = b − 0.
    let normal = vec![vec![2.0, 1.0], vec![1.0, 3.0]];
    let solution = solve(&normal, &[3.0, -1.0]);
    assert_eq!(solution.values[1], 0.0);
    assert!((solution.values[0] - 1.5).abs() < 1e-12, "{solution:?}");
    let inside = solve(&normal, &[3.0, 4.0]);
    assert!((inside.values[0] - 1.0).abs() < 1e-12 && (inside.values[1] - 1.0).abs() < 1e-12);
    // The inverse of the matrix has 3/5 and 2/5 on its diagonal.
    assert!((inside.sigmas[0] - 0.6f64.sqrt()).abs() < 1e-12);
    assert!((inside.sigmas[1] - 0.4f64.sqrt()).abs() < 1e-12);
}

fn scene(gyro: &str) -> Scene {
    let text = format!(
        "duration_s = 20000\nrate_hz = 5\n[trajectory]\nlatitude_deg = 45\n[gyro]\n{gyro}\n"
    );
    parse::scene("planted.toml", &text).unwrap()
}

/// The verdicts on the configured terms of one scene where another was measured.
fn verdicts(measured: &str, said: &str) -> Vec<Verdict> {
    let record = record::of_scene(&scene(measured)).unwrap();
    let said = scene(said);
    let points: Vec<_> =
        record.axes[0].iter().filter(|point| point.differences > 1).copied().collect();
    let variances: Vec<_> = points.iter().map(|point| point.variance).collect();
    let terms = configured(&said.gyro, 0, record.timing);
    let (terms, time, _) = compare(&mut Fitter::new(&points), &variances, &terms);
    let terms = terms.iter().map(|compared| compared.verdict);
    terms.chain(time.map(|time| time.verdict)).collect()
}

#[test]
fn planted_faults_are_caught() {
    let sensor = |white: f64, rms: f64, correlation_s: f64| {
        format!(
            "angle_random_walk_deg_sqrt_h = {white}\n\
             gauss_markov = {{ rms_deg_h = {rms}, correlation_s = {correlation_s} }}"
        )
    };
    let own = sensor(0.02, 2.0, 100.0);
    let found = verdicts(&own, &own);
    assert!(found.iter().all(|verdict| *verdict == Verdict::Agrees), "{found:?}");
    // White noise of ten percent more than it is said to have.
    let found = verdicts(&sensor(0.022, 2.0, 100.0), &own);
    assert_eq!(found[0], Verdict::Differs, "{found:?}");
    // The correlation time of the other sensor.
    let found = verdicts(&sensor(0.02, 2.0, 20.0), &own);
    assert_eq!(found[2], Verdict::Differs, "{found:?}");
}
