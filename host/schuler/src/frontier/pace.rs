//! The time of a case: nanoseconds per sample, with all cases measured alternately.

use super::case::Craft;
use schuler_simulator::quartile::quartile;
use schuler_simulator::source::Source;
use schuler_simulator::timing;
use std::time::Instant;

/// Samples that a case is timed over, at most.
pub const SAMPLES: u64 = 2000;

/// Median and spread of each case's time per sample, ns. A pass goes over all cases before the next
/// one begins, so that a slow moment of the machine does not fall on one case alone; each is flown
/// once unmeasured before, so that its samples and code are at hand as in a long flight.
pub fn time(
    source: &Source,
    samples: u64,
    crafts: &[Craft],
    passes: usize,
    flown: &mut dyn FnMut(u64),
) -> Vec<(f64, f64)> {
    let increments = timing::perfect(source, samples);
    let rates: Vec<_> = (0..=samples).map(|n| source.rates(n)).collect();
    let mut flights: Vec<Box<dyn FnMut() + '_>> = crafts
        .iter()
        .map(|craft| match craft {
            Craft::Increments(navigator) => navigator.fly_unread(&[], &increments),
            Craft::Rates(navigator) => navigator.fly_unread(&rates),
        })
        .collect();
    let mut times = vec![Vec::with_capacity(passes); crafts.len()];
    for _ in 0..passes {
        for (flight, times) in flights.iter_mut().zip(&mut times) {
            flight();
            let start = Instant::now();
            flight();
            times.push(1e9 * start.elapsed().as_secs_f64() / samples.max(1) as f64);
            flown(samples);
        }
    }
    times.into_iter().map(median_and_spread).collect()
}

/// The median, and the distance from the first to the third quartile.
fn median_and_spread(times: Vec<f64>) -> (f64, f64) {
    let [first, median, third] = [1, 2, 3].map(|n| quartile(&times, n));
    (median, third - first)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn median_and_spread_are_of_the_times() {
        assert_eq!(median_and_spread((1..=25).rev().map(f64::from).collect()), (13.0, 12.0));
        assert_eq!(median_and_spread(vec![7.0]), (7.0, 0.0));
    }
}
