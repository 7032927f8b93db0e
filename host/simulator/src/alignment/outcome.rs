//! What an alignment was off by.

use super::aligner::Aligner;
use super::setup::Setup;
use crate::quadratic::quadratic;
use crate::source::Source;
use schuler::aiding::alignment::aligned::Aligned;
use schuler::aiding::alignment::verdict::AlignmentFault;
use schuler::drift::compare::drift;
use schuler::solution::Solution;

/// What came of a run's alignment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// What it found.
    pub aligned: Aligned<f64>,
    /// Where it left its navigator.
    pub solution: Solution<f64>,
    /// When that is, s.
    pub time_s: f64,
    /// Samples behind that.
    pub samples: u64,
    /// The rotation vector from the true to the computed attitude, north, east, down, rad.
    pub error: [f64; 3],
    /// What the filter says of it: standard deviations.
    pub sigma: [f64; 3],
    /// ε = eᵀP⁻¹e of the three; not a number where P is none.
    pub nees: f64,
}

/// Aligns a run of a scene, from a heading that is off by what the run draws or by an angle, rad.
pub fn of_run(
    setup: &Setup<'_>,
    source: &Source,
    run: u64,
    off: Option<f64>,
) -> Result<Outcome, (u64, AlignmentFault)> {
    let mut aligner = setup.start(run, off).map_err(|fault| (0, fault))?;
    let mut stream = source.start(run);
    for sample in 1..=setup.samples {
        // No sample is lost: a setup refuses a link that loses any.
        if let Some(increment) = stream.advance() {
            aligner.push(&increment).map_err(|fault| (sample, fault))?;
        }
    }
    let outcome = Outcome::of(&aligner, source).ok_or((setup.samples, AlignmentFault::Unseen))?;
    match outcome.aligned.moved_s {
        None => Ok(outcome),
        Some(moved_s) => Err(((moved_s * source.rate_hz()).round() as u64, AlignmentFault::Moved)),
    }
}

impl Outcome {
    /// Of an alignment that is done; `None` if it found no attitude.
    pub fn of(aligner: &Aligner<'_>, source: &Source) -> Option<Self> {
        let aligned = aligner.aligned()?;
        let (solution, samples) = (aligner.solution(), aligner.integrated());
        let error = drift(&solution, &source.truth(samples)).attitude_ned.into_array();
        let covariance = aligner.covariance();
        let sigma = std::array::from_fn(|i| covariance[i][i].max(0.0).sqrt());
        let nees = quadratic(&covariance, &error);
        let time_s = source.time_s(samples);
        Some(Self { aligned, solution, time_s, samples, error, sigma, nees })
    }
}
