//! Mean and spread of the drift over the runs, and whether they agree with theory.
//!
//! For n runs with mean m and standard deviation s, and μ and σ by theory: n(m − μ)²/σ² is χ² with
//! one degree of freedom, (n − 1)s²/σ² is χ² with n − 1.

use schuler_simulator::ensemble::fleet::Reading;
use schuler_simulator::flight::Nine;
use schuler_simulator::simulate::nine;
use schuler_simulator::theory::{Expected, Outside, Theory};
use statrs::distribution::{ChiSquared, ContinuousCDF};

/// What theory says scatters less than this is left to rounding, m, m/s, arcsec.
const LEAST_SIGMA: [f64; 3] = [1e-6, 1e-8, 1e-5];

/// The probability that an ensemble which follows theory is found not to.
pub const RISK: f64 = 1e-3;

/// A statistic, and how often chance alone would lie that far out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Test {
    /// χ².
    pub chi_square: f64,
    /// Two-sided probability.
    pub probability: f64,
}

/// One component at one instant; m, m/s, arcsec.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Comparison {
    /// Seconds since the start.
    pub time_s: f64,
    /// Which of [`Nine::NAMES`].
    pub component: usize,
    /// Over the runs.
    pub mean: f64,
    /// What theory expects of it; not a number where that has ended.
    pub mean_theory: f64,
    /// Standard deviation over the runs, about their own mean.
    pub sigma: f64,
    /// What theory expects of it.
    pub sigma_theory: f64,
    /// Of mean and standard deviation; absent where theory sees nothing scatter or is not a number.
    pub tests: Option<[Test; 2]>,
}

impl Comparison {
    /// Of one component's values over the runs.
    fn new(time_s: f64, component: usize, values: &[f64], [mu, sigma_theory]: [f64; 2]) -> Self {
        let n = values.len() as f64;
        // About theory's mean first, so that a large mean costs no digits.
        let about = if mu.is_nan() { 0.0 } else { mu };
        let gain = values.iter().map(|x| x - about).sum::<f64>() / n;
        let squares: f64 = values.iter().map(|x| (x - about - gain) * (x - about - gain)).sum();
        let freedom = n - 1.0;
        let variance = sigma_theory * sigma_theory;
        let tests = (sigma_theory >= LEAST_SIGMA[component / 3]).then(|| {
            let of_mean = n * gain * gain / variance;
            let of_sigma = squares / variance;
            let (below, above) = tails(freedom, of_sigma);
            [
                Test { chi_square: of_mean, probability: tails(1.0, of_mean).1 },
                Test { chi_square: of_sigma, probability: (2.0 * below.min(above)).min(1.0) },
            ]
        });
        Self {
            time_s,
            component,
            mean: about + gain,
            mean_theory: mu,
            sigma: (squares / freedom).sqrt(),
            sigma_theory,
            tests,
        }
    }
}

/// How much of χ² lies below and above a value; NaN of what is no number.
pub(super) fn tails(freedom: f64, chi_square: f64) -> (f64, f64) {
    match ChiSquared::new(freedom) {
        Ok(law) if chi_square.is_finite() => (law.cdf(chi_square), law.sf(chi_square)),
        _ => (f64::NAN, f64::NAN),
    }
}

/// Every component of every reading.
pub fn compare(
    readings: &[Reading],
    time_s: impl Fn(u64) -> f64,
    theory: &mut Theory,
) -> Vec<Comparison> {
    let mut comparisons = Vec::new();
    for reading in readings {
        let time_s = time_s(reading.samples);
        let mut expected = theory.at(time_s);
        if theory.outside(time_s).is_some() {
            expected = Expected::UNKNOWN;
        }
        let shifted = theory.shifted(time_s);
        let (mean, sigma) = (nine(&expected.mean).numbers(), nine(&expected.sigma).numbers());
        let runs: Vec<_> = reading.drifts.iter().map(|drift| nine(drift).numbers()).collect();
        for component in 0..Nine::NAMES.len() {
            let values: Vec<_> = runs.iter().map(|run| run[component]).collect();
            let theory = [mean[component], sigma[component]];
            let mut comparison = Comparison::new(time_s, component, &values, theory);
            if shifted[component] {
                comparison.tests = None;
            }
            comparisons.push(comparison);
        }
    }
    comparisons
}

/// What first ends theory at a reading, and the reading's time, s.
pub fn outside(
    readings: &[Reading],
    time_s: impl Fn(u64) -> f64,
    theory: &mut Theory,
) -> Option<(f64, Outside)> {
    readings.iter().find_map(|reading| {
        let time_s = time_s(reading.samples);
        theory.outside(time_s).map(|outside| (time_s, outside))
    })
}

/// Whether an ensemble follows theory: each of its tests at the level that makes [`RISK`] of all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// How many tests there are.
    pub tests: usize,
    /// How many fail.
    pub failed: usize,
    /// The least probable: its place among the comparisons, and which of the two tests.
    pub worst: Option<(usize, usize, f64)>,
}

impl Verdict {
    /// Of all comparisons. What is no number fails.
    pub fn new(comparisons: &[Comparison]) -> Self {
        Self::of(comparisons.iter().enumerate().flat_map(|(place, comparison)| {
            let tests = comparison.tests.into_iter().flatten().enumerate();
            tests.map(move |(which, test)| (place, which, test.probability))
        }))
    }

    /// Of tests, each with its place, which of several it is there, and its probability.
    pub fn of(tests: impl Iterator<Item = (usize, usize, f64)>) -> Self {
        let all: Vec<_> = tests.collect();
        let rank = |probability: f64| if probability.is_nan() { -1.0 } else { probability };
        let mut verdict = Self { tests: all.len(), failed: 0, worst: None };
        verdict.failed = all.iter().filter(|(.., probability)| verdict.fails(*probability)).count();
        verdict.worst = all.iter().copied().min_by(|a, b| rank(a.2).total_cmp(&rank(b.2)));
        verdict
    }

    /// The probability below which one of the tests fails.
    pub fn level(&self) -> f64 {
        RISK / self.tests as f64
    }

    /// Whether a test of this probability fails. What is no number does.
    pub fn fails(&self, probability: f64) -> bool {
        probability.is_nan() || probability < self.level()
    }
}
