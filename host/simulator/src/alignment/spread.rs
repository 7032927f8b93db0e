//! What many alignments were off by, beside their standard deviations and theory.

use super::outcome::Outcome;
use super::setup::Setup;
use crate::quadratic::by_chance;
use crate::scene::Base;
use std::f64::consts::PI;

/// The axes of an attitude error.
pub const AXES: [&str; 3] = ["north", "east", "heading"];

/// One axis over all runs, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Root of the mean square of the error.
    pub rms: f64,
    /// Mean of the error.
    pub mean: f64,
    /// Root of the mean variance that the filters say, where there is one.
    pub sigma: Option<f64>,
    /// What theory allows; `None` where there is no closed form.
    pub limit: Option<f64>,
}

/// What many alignments were off by.
#[derive(Clone, Debug, PartialEq)]
pub struct Spread {
    /// How many.
    pub runs: usize,
    /// About north, about east, heading.
    pub axes: [Axis; 3],
    /// What the filters say of themselves.
    pub claimed: Option<Claimed>,
}

/// What filters say of themselves, against what they were off by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Claimed {
    /// The mean of ε by its three degrees of freedom: 1 is expected.
    pub nees: f64,
    /// Where 95 % of such means lie.
    pub expected: [f64; 2],
    /// The mean of the residuals, by what is expected of them.
    pub residual: f64,
}

impl Spread {
    /// Of errors alone, as a method without a filter leaves them.
    pub fn of_errors(setup: &Setup<'_>, errors: &[[f64; 3]]) -> Self {
        let n = errors.len().max(1) as f64;
        let mean = |value: &dyn Fn(f64) -> f64, axis: usize| {
            errors.iter().map(|error| value(error[axis])).sum::<f64>() / n
        };
        let limits = limits(setup, true);
        let axes = std::array::from_fn(|axis| Axis {
            rms: mean(&|x| x * x, axis).sqrt(),
            mean: mean(&|x| x, axis),
            sigma: None,
            limit: limits[axis],
        });
        Self { runs: errors.len(), axes, claimed: None }
    }

    /// Of the runs of a scene.
    pub fn new(setup: &Setup<'_>, outcomes: &[Outcome]) -> Self {
        let n = outcomes.len().max(1) as f64;
        let mean = |value: &dyn Fn(&Outcome) -> f64| outcomes.iter().map(value).sum::<f64>() / n;
        let errors: Vec<_> = outcomes.iter().map(|one| one.error).collect();
        let mut spread = Self::of_errors(setup, &errors);
        let limits = limits(setup, false);
        for (i, axis) in spread.axes.iter_mut().enumerate() {
            axis.sigma = Some(mean(&|one| one.sigma[i].powi(2)).sqrt());
            axis.limit = limits[i];
        }
        let claimed = Claimed {
            nees: mean(&|one| one.nees) / 3.0,
            expected: by_chance(3.0 * n),
            residual: mean(&|one| one.aligned.residual),
        };
        Self { claimed: Some(claimed), ..spread }
    }
}

/// What theory allows about north, about east, and of the heading, rad; of a method that takes the vehicle for one
/// that does not turn, or of a filter that finds out.
fn limits(setup: &Setup<'_>, unturned: bool) -> [Option<f64>; 3] {
    let (here, seconds) = (setup.surroundings(), setup.alignment().duration_s);
    if setup.alignment().base != Base::Still {
        return [None; 3];
    }
    // Half a turn shows the biases.
    if setup.turned() >= PI {
        return [None, None, Some(setup.sensors.heading_turning(&here, seconds))];
    }
    let level = setup.sensors.level(&here);
    let heading = match unturned {
        true => setup.sensors.heading_unturned(&here, seconds),
        false => setup.sensors.heading(&here, seconds),
    };
    [Some(level), Some(level), Some(heading)]
}
