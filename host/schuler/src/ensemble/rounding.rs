//! The effect of rounding in single precision on an ensemble, which theory leaves out.

use super::statistics::Comparison;
use schuler_simulator::ensemble::batches::Means;
use schuler_simulator::ensemble::fleet::{self, Reading};
use schuler_simulator::ensemble::group::{Ground, Unit};
use schuler_simulator::ensemble::kept::Kept;
use schuler_simulator::flight::Nine;
use schuler_simulator::scene::{Precision, Scene};
use schuler_simulator::simulate::{FlightError, nine};
use schuler_simulator::source::Source;

/// Runs that are flown in double precision too.
const RUNS: u64 = 4;
/// The largest share of a mean's standard error that rounding may have where theory is compared with.
const SHARE: f64 = 1.0 / 3.0;

/// How far rounding takes each component at each reading, as the root mean square over the first runs:
/// their difference from the same runs in double precision. Of double precision, and where these runs
/// do not reach their end, nothing.
pub fn rounding(ground: &Ground, kept: &Kept, means: Means) -> Result<Vec<[f64; 9]>, FlightError> {
    if ground.scene.navigator.precision == Precision::F64 {
        return Ok(Vec::new());
    }
    let mut double = Scene::clone(ground.scene);
    double.navigator.precision = Precision::F64;
    // The same blocks end at the same instants.
    double.navigator.window = Some(ground.plan.window);
    let source = Source::new(&double, false)?;
    let double = Ground::new(&double, &source);
    let runs = 0..RUNS.min(kept.runs.end);
    let Means { threads, stops, .. } = means;
    let flown = fleet::fly_range(&double, runs.clone(), Unit::Alone, threads, stops, &|_| {})?;
    let exact = Kept::new(runs, flown);
    let (mine, theirs) = (kept.numbers(), exact.numbers());
    let pairs: Vec<(usize, usize)> = theirs
        .iter()
        .enumerate()
        .filter_map(|(theirs, run)| Some((mine.binary_search(run).ok()?, theirs)))
        .collect();
    let readings = kept.flown.readings.iter().zip(&exact.flown.readings);
    Ok(readings.map(|(rounded, exact)| root_mean_square(rounded, exact, &pairs)).collect())
}

fn root_mean_square(rounded: &Reading, exact: &Reading, pairs: &[(usize, usize)]) -> [f64; 9] {
    std::array::from_fn(|component| {
        let squares = pairs.iter().map(|&(a, b)| {
            let [a, b] =
                [&rounded.drifts[a], &exact.drifts[b]].map(|x| nine(x).numbers()[component]);
            (a - b) * (a - b)
        });
        (squares.sum::<f64>() / pairs.len().max(1) as f64).sqrt()
    })
}

/// Takes the tests away where rounding matters; how many comparisons had some.
pub fn leave_out(comparisons: &mut [Comparison], rounding: &[[f64; 9]], runs: u64) -> usize {
    let mut left_out = 0;
    let instants = comparisons.chunks_mut(Nine::NAMES.len());
    for (instant, rounding) in instants.zip(rounding) {
        for (comparison, rounding) in instant.iter_mut().zip(rounding) {
            let standard_error = comparison.sigma_theory / (runs as f64).sqrt();
            if *rounding > SHARE * standard_error && comparison.tests.take().is_some() {
                left_out += 1;
            }
        }
    }
    left_out
}
