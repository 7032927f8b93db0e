//! Flights whose every operation rounds at random: how many digits of the end can be trusted.
//!
//! | file | what it has |
//! |---|---|
//! | [`stochastic`] | a scalar that rounds at random |
//! | [`split_mix`] | random words |

pub mod split_mix;
pub mod stochastic;

use crate::navigator::compared::Arithmetic;
use crate::scene::{Axes, Precision};
use schuler::flight::carried::Carried;
use schuler::math::compensated::{Pair, Plain};
use schuler::math::real::Scalar;
use schuler::output::Output as _;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::block::window::H2B4A2;
use schuler::strapdown::frame::Frame;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::navigator::Strapdown;
use stochastic::Stochastic;

/// The window of such flights.
pub type Window = H2B4A2;

/// A flight through samples, an interval in seconds apart, with roundings drawn from a seed; only its end is
/// read. `reach` hears the number of each sample.
pub fn fly(
    arithmetic: Arithmetic,
    axes: Axes,
    seed: u64,
    samples: &[Increment<f64>],
    initial: &Solution<f64>,
    interval_s: Pair<f64>,
    reach: &mut dyn FnMut(u64),
) -> Result<Solution<f64>, String> {
    type Double = Stochastic<f64>;
    type Single = Stochastic<f32>;
    let fly = match (arithmetic, axes) {
        (Arithmetic::Named(Precision::F64), Axes::LocalLevel) => flown::<LocalLevel<Pair<Double>>>,
        (Arithmetic::Named(Precision::F64), Axes::EarthFixed) => flown::<EarthFixed<Pair<Double>>>,
        (Arithmetic::PlainDouble, Axes::LocalLevel) => flown::<LocalLevel<Plain<Double>>>,
        (Arithmetic::PlainDouble, Axes::EarthFixed) => flown::<EarthFixed<Plain<Double>>>,
        (Arithmetic::Named(Precision::F32), Axes::LocalLevel) => flown::<LocalLevel<Pair<Single>>>,
        (Arithmetic::PlainSingle, Axes::LocalLevel) => flown::<LocalLevel<Plain<Single>>>,
        _ => return Err(format!("{} {axes} does not round at random", arithmetic.name())),
    };
    stochastic::seed(seed);
    fly(samples, initial, interval_s, reach)
}

fn flown<F: Frame<Real: Scalar>>(
    samples: &[Increment<f64>],
    initial: &Solution<f64>,
    interval_s: Pair<f64>,
    reach: &mut dyn FnMut(u64),
) -> Result<Solution<f64>, String> {
    let strapdown = Strapdown::<F, Window>::new(Pair::narrow(interval_s));
    let strapdown = strapdown.map_err(|error| error.to_string())?;
    let state = strapdown.start(&Solution::narrow(initial));
    let mut state = state.map_err(|error| error.to_string())?;
    let mut carried = Carried::default();
    for (sample, n) in samples.iter().zip(1..) {
        let taken = strapdown.push(&mut state, carried.narrow(sample));
        taken.map_err(|why| format!("sample {n}: {why}"))?;
        reach(n);
    }
    strapdown.finish(&mut state);
    Ok(state.output().wide())
}
