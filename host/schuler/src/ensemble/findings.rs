//! What is found out from the runs that were kept: all numbers, and nothing about how they are shown.

use super::accuracy::Accuracy;
use super::consistency::{Consistency, GROUPS};
use super::spread::{Matrix, Spread};
use super::statistics::{self, Comparison, Verdict};
use super::values::Values;
use super::{consistency, rounding};
use schuler_simulator::ensemble::batches::Means;
use schuler_simulator::ensemble::budget::{self, Contribution};
use schuler_simulator::ensemble::group::Ground;
use schuler_simulator::ensemble::kept::Kept;
use schuler_simulator::flight::Nine;
use schuler_simulator::simulate::{FlightError, nine};
use schuler_simulator::theory::{Covariance, Expected, Outside, Theory};
use schuler_simulator::units::ARCSECOND;

/// Instants at which theory is drawn.
const DRAWN: u64 = 120;

/// An instant at which the runs were read; m, m/s, arcsec.
#[derive(Clone, Debug)]
pub struct At {
    /// Seconds since the start.
    pub time_s: f64,
    /// What the runs do.
    pub spread: Spread,
    /// The covariance that theory expects; not numbers where that has ended.
    pub covariance_theory: Matrix,
    /// Circular and vertical error.
    pub accuracy: Accuracy,
    /// States together, as far as they can be tested.
    pub consistency: Vec<Consistency>,
}

/// What theory expects at a time; m, m/s, arcsec.
#[derive(Clone, Copy, Debug)]
pub struct Drawn {
    /// Seconds since the start.
    pub time_s: f64,
    /// Standard deviation of the nine.
    pub sigma: [f64; 9],
}

/// What an error term contributes.
#[derive(Clone, Debug)]
pub struct Share {
    /// Its name.
    pub name: String,
    /// By theory, at each instant.
    pub theory: Vec<Contribution>,
    /// By switching it off in runs, at each instant; none where that was not asked for.
    pub runs: Vec<Contribution>,
}

/// All that is found out.
#[derive(Clone, Debug)]
pub struct Findings {
    /// Runs that reached their end.
    pub ended: u64,
    /// Nine of each instant.
    pub comparisons: Vec<Comparison>,
    /// Comparisons without tests, because rounding matters.
    pub left_out: usize,
    /// Each instant; the last is the end.
    pub instants: Vec<At>,
    /// The runs at the end; none where there are fewer than two.
    pub end: Option<Values>,
    /// Theory's curves.
    pub drawn: Vec<Drawn>,
    /// The error terms.
    pub budget: Vec<Share>,
    /// What ends theory first, and when, s.
    pub outside: Option<(f64, Outside)>,
    /// Of mean and spread.
    pub verdict: Verdict,
    /// Of states together.
    pub together: Verdict,
}

impl Findings {
    /// Of runs; with `budget` so many of them are flown again without each error term.
    pub fn new(
        ground: &Ground,
        kept: &Kept,
        budget: Option<u64>,
        means: Means,
    ) -> Result<Self, FlightError> {
        let (scene, source) = (ground.scene, ground.source);
        let time_s = |sample: u64| source.time_s(sample);
        let numbers = kept.numbers();
        let ended = numbers.len() as u64;
        // Of a single run there is no spread.
        let readings = if ended > 1 { kept.flown.readings.as_slice() } else { &[] };
        let theory =
            Theory::new(scene).map_err(schuler_simulator::source::SourceError::Trajectory)?;
        let mut theory = theory.for_runs(ended.max(1));
        let mut comparisons = statistics::compare(readings, time_s, &mut theory);
        let rounding = rounding::rounding(ground, kept, means)?;
        let left_out = rounding::leave_out(&mut comparisons, &rounding, ended);
        let mut instants = Vec::new();
        let mut end = None;
        for (reading, compared) in readings.iter().zip(comparisons.chunks(Nine::NAMES.len())) {
            let values = Values::new(reading, &numbers);
            let tested = std::array::from_fn(|i| compared[i].tests.is_some());
            instants.push(At::new(time_s(reading.samples), &values, &tested, &mut theory));
            end = Some(values);
        }
        let outside = statistics::outside(readings, time_s, &mut theory);
        let consistency = instants.iter().flat_map(|at| &at.consistency);
        let probabilities: Vec<f64> = consistency.map(|c| c.test.probability).collect();
        let times: Vec<f64> = instants.iter().map(|at| at.time_s).collect();
        let budget = match ended {
            0 | 1 => Vec::new(),
            _ => shares(ground, kept, &times, budget, means)?,
        };
        Ok(Self {
            ended,
            verdict: Verdict::new(&comparisons),
            together: Verdict::of(probabilities.into_iter().enumerate().map(|(i, p)| (i, 0, p))),
            comparisons,
            left_out,
            instants,
            end,
            drawn: drawn(&mut theory, scene.duration_s),
            budget,
            outside,
        })
    }

    /// Every group of states at every instant, in the order of the verdict's places.
    pub fn consistency(&self) -> impl Iterator<Item = &Consistency> {
        self.instants.iter().flat_map(|at| &at.consistency)
    }
}

impl At {
    fn new(time_s: f64, values: &Values, tested: &[bool; 9], theory: &mut Theory) -> Self {
        let ended = theory.outside(time_s).is_some();
        let expected = if ended { Expected::UNKNOWN } else { theory.at(time_s) };
        let mean = nine(&expected.mean).numbers();
        let covariance_theory = match ended {
            true => [[f64::NAN; 9]; 9],
            false => in_units(&theory.covariance(time_s)),
        };
        let position = |i: usize| std::array::from_fn(|j| covariance_theory[i][j]);
        let accuracy = Accuracy::new(
            time_s,
            values,
            [mean[0], mean[1], mean[2]],
            [position(0), position(1), position(2)],
        );
        let group =
            |group| Consistency::new(time_s, group, values, &mean, &covariance_theory, tested);
        Self {
            time_s,
            spread: Spread::new(values),
            covariance_theory,
            accuracy,
            consistency: (0..consistency::GROUPS.len()).filter_map(group).collect(),
        }
    }
}

/// A covariance in m, m/s, arcsec.
fn in_units(covariance: &Covariance) -> Matrix {
    let unit = |i: usize| if i < 6 { 1.0 } else { ARCSECOND };
    std::array::from_fn(|i| std::array::from_fn(|j| covariance[i][j] / (unit(i) * unit(j))))
}

fn drawn(theory: &mut Theory, duration_s: f64) -> Vec<Drawn> {
    let times = (0..=DRAWN).map(|i| duration_s * i as f64 / DRAWN as f64);
    let known = times.map_while(|time_s| {
        let known = theory.outside(time_s).is_none();
        known.then(|| Drawn { time_s, sigma: nine(&theory.at(time_s).sigma).numbers() })
    });
    known.collect()
}

fn shares(
    ground: &Ground,
    kept: &Kept,
    times_s: &[f64],
    runs: Option<u64>,
    means: Means,
) -> Result<Vec<Share>, FlightError> {
    let share = |term: budget::Term| {
        let theory = budget::by_theory(&term, times_s)?;
        let runs = match runs {
            Some(runs) => {
                budget::by_switching_off::<FlightError>(ground, &term, kept, runs, means)?
            }
            None => Vec::new(),
        };
        Ok(Share { name: term.name, theory, runs })
    };
    budget::terms(ground.scene).into_iter().map(share).collect()
}

/// What the groups of states are called.
pub fn group_name(consistency: &Consistency) -> &'static str {
    GROUPS.get(consistency.group).map_or("", |(name, _)| name)
}
