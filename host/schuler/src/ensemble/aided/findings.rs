//! What is found out from aided runs: their errors beside what their filters say, and whether both agree.
//!
//! With e a run's error and P its filter's covariance, eᵀP⁻¹e is χ² with as many degrees of freedom as e has components
//! (the normalized estimation error squared; Bar-Shalom, Li and Kirubarajan, Estimation with Applications to Tracking and
//! Navigation, 2001, section 5.4), and its sum over n runs χ² with n times as many.

use super::super::accuracy::Accuracy;
use super::super::findings::Share;
use super::super::statistics::{RISK, Test, Verdict, tails};
use super::super::values::Values;
use schuler_simulator::aided::kept::AidedRuns;
use schuler_simulator::aided::report::Report;
use schuler_simulator::aided::runs::{
    FREEDOM, GROUPS, Together, counts, smoothed_together, together,
};
use schuler_simulator::number::{parameter, rounded};
use schuler_simulator::units::ARCSECOND;

/// What is not known of the position: theory has no say in it.
const UNKNOWN: [f64; 3] = [f64::NAN; 3];

/// A group of the nine at one instant.
#[derive(Clone, Copy, Debug)]
pub struct Consistency {
    /// Seconds since the start.
    pub time_s: f64,
    /// Which of [`GROUPS`].
    pub group: usize,
    /// The mean of eᵀP⁻¹e by its degrees of freedom: 1 is expected.
    pub nees: f64,
    /// Where 95 % of such means lie.
    pub expected: [f64; 2],
    /// Of the sum.
    pub test: Test,
}

/// All that is found out.
#[derive(Clone, Debug)]
pub struct Findings {
    /// Runs that reached their end.
    pub ended: u64,
    /// Samples in which a sensor was at its limit.
    pub saturated: u64,
    /// Each instant; the last is the end.
    pub instants: Vec<Together>,
    /// What smoothers make of those instants that they reach; none without.
    pub smoothed: Vec<Together>,
    /// Circular and vertical error at each.
    pub accuracy: Vec<Accuracy>,
    /// The groups at each.
    pub consistency: Vec<Consistency>,
    /// Of all of them.
    pub verdict: Verdict,
    /// The runs at each instant; m, m/s, arcsec.
    pub values: Vec<Values>,
    /// What became of their measurements.
    pub report: Report,
    /// What each error term contributes; none where that was not asked for.
    pub budget: Vec<Share>,
}

impl Findings {
    /// Of runs whose samples come at a rate, with what each error term contributes.
    pub fn new(runs: &AidedRuns, rate_hz: f64, budget: Vec<Share>) -> Self {
        let ended = runs.ended.len() as u64;
        let instants = together(&runs.ended, rate_hz);
        let consistency: Vec<Consistency> =
            instants.iter().flat_map(|at| of_instant(at, ended as f64)).collect();
        let probabilities = consistency.iter().map(|one| one.test.probability);
        let values: Vec<Values> = (0..instants.len()).map(|at| values(runs, at)).collect();
        let accuracy = |(at, values): (&Together, &Values)| {
            Accuracy::new(at.time_s, values, UNKNOWN, [UNKNOWN; 3])
        };
        let sum = |value: fn(&Report) -> u64| runs.ended.iter().map(|run| value(&run.report)).sum();
        let report = Report {
            sensors: counts(&runs.ended),
            again: sum(|report| report.again),
            late: sum(|report| report.late),
            dropped: sum(|report| report.dropped),
            ..Report::default()
        };
        Self {
            ended,
            saturated: runs.ended.iter().map(|run| run.saturated).sum(),
            smoothed: smoothed_together(&runs.ended, rate_hz),
            accuracy: instants.iter().zip(&values).map(accuracy).collect(),
            verdict: Verdict::of(probabilities.enumerate().map(|(place, p)| (place, 0, p))),
            instants,
            consistency,
            values,
            report,
            budget,
        }
    }

    /// Tests that fail because errors are larger than the filters say: who relies on these filters is misled.
    pub fn too_sure(&self) -> usize {
        let failed = self.consistency.iter().filter(|one| self.verdict.fails(one.test.probability));
        failed.filter(|one| one.nees.is_nan() || one.nees > 1.0).count()
    }

    /// The same in sentences: for each group the worst that fails, or that none does.
    pub fn sentences(&self) -> Vec<String> {
        let confidence = parameter(100.0 * (1.0 - RISK));
        let tests = self.verdict.tests;
        if tests == 0 {
            return vec!["No run reached its end: there is nothing to compare.".to_owned()];
        }
        let worst = GROUPS.iter().enumerate().filter_map(|(group, name)| {
            let of_it = self.consistency.iter().filter(|one| one.group == group);
            let failed = of_it.filter(|one| self.verdict.fails(one.test.probability));
            let failed: Vec<&Consistency> = failed.collect();
            let worst = failed.iter().min_by(|a, b| rank(a).total_cmp(&rank(b)))?;
            let side = if worst.nees > 1.0 { "larger" } else { "smaller" };
            let [least, most] = worst.expected.map(|x| rounded(x, 3));
            let of = match *name {
                "all" => "all errors together",
                name => &format!("the errors of {name}"),
            };
            Some(format!(
                "At {} s {of} are {side} than the filters say: NEES {} where 1 is expected (95 %: {least} to {most}); \
                 it fails at {} of {} times.",
                parameter(worst.time_s),
                rounded(worst.nees, 3),
                failed.len(),
                self.instants.len()
            ))
        });
        let mut sentences: Vec<String> = worst.collect();
        if sentences.is_empty() {
            sentences.push(format!(
                "The errors are as the filters say: {tests} tests of NEES at {confidence} %, none fails."
            ));
        }
        sentences
    }
}

/// What is no number is the least probable.
fn rank(one: &Consistency) -> f64 {
    if one.test.probability.is_nan() { -1.0 } else { one.test.probability }
}

fn of_instant(at: &Together, runs: f64) -> impl Iterator<Item = Consistency> {
    FREEDOM.into_iter().enumerate().map(move |(group, freedom)| {
        let (nees, expected) = (at.nees[group], at.expected[group]);
        let chi_square = nees * freedom * runs;
        let (below, above) = tails(freedom * runs, chi_square);
        let test = Test { chi_square, probability: (2.0 * below.min(above)).min(1.0) };
        Consistency { time_s: at.time_s, group, nees, expected, test }
    })
}

fn values(runs: &AidedRuns, at: usize) -> Values {
    let numbers = runs.ended.iter().map(|run| {
        let error = run.reads.get(at).map_or([f64::NAN; 9], |read| read.error);
        std::array::from_fn(|i| if i < 6 { error[i] } else { error[i] / ARCSECOND })
    });
    Values { runs: runs.of_ended(), numbers: numbers.collect() }
}
