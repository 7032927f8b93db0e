//! One scene at one rate: every case flown against the truth, then all timed alternately.

use super::case::{Case, Craft};
use super::chunk::Chunk;
use super::pace;
use super::{LeftOut, Point};
use schuler::drift::compare::drift;
use schuler::solution::Solution;
use schuler::strapdown::limits::Rejected;
use schuler::trajectory::Trajectory as _;
use schuler_simulator::navigator::{Reader, Unavailable};
use schuler_simulator::scene::Scene;
use schuler_simulator::source::{Source, SourceError};
use schuler_simulator::units::ARCSECOND;
use std::sync::mpsc;
use std::thread;

/// Samples that are held at a time.
const CHUNK: u64 = 4096;
/// Samples that a row may lie behind the newest one, at most: a block with its look-ahead.
const LAG: usize = 64;

/// The largest position (m), velocity (m/s) and attitude (arcsec) error so far.
type Largest = [f64; 3];
/// What became of a flight.
type Outcome = Result<Largest, String>;

/// Measures every case; what cannot be flown is told with its reason. `flown` hears how many samples
/// went by, all cases counted.
pub fn measure(
    scene: &Scene,
    cases: &[Case],
    passes: usize,
    flown: &mut dyn FnMut(u64),
) -> Result<(Vec<Point>, Vec<LeftOut>), SourceError> {
    let source = Source::new(scene, false)?;
    let samples = scene.samples();
    let outcomes = fly_all(&source, samples, cases, flown);
    let (mut flying, mut points, mut left_out) = (Vec::new(), Vec::new(), Vec::new());
    for (&case, outcome) in cases.iter().zip(outcomes) {
        let largest = match outcome {
            Ok(largest) => largest,
            Err(why) => {
                let (scene, rate_hz) = (scene.name.clone(), scene.rate_hz);
                left_out.push(LeftOut { scene, rate_hz, case, why });
                continue;
            }
        };
        if let Ok(craft) = start(&source, &case) {
            flying.push(craft);
            points.push(Point {
                scene: scene.name.clone(),
                duration_s: scene.duration_s,
                rate_hz: scene.rate_hz,
                case,
                ns_per_sample: f64::NAN,
                ns_spread: f64::NAN,
                max_position_m: largest[0],
                max_velocity_m_s: largest[1],
                max_attitude_arcsec: largest[2],
                on_front: false,
            });
        }
    }
    let times = pace::time(&source, samples.min(pace::SAMPLES), &flying, passes, flown);
    for (point, (median, spread)) in points.iter_mut().zip(times) {
        (point.ns_per_sample, point.ns_spread) = (median, spread);
    }
    Ok((points, left_out))
}

fn start(source: &Source, case: &Case) -> Result<Craft, Unavailable> {
    let bound = source.course.bound();
    case.start(source.rate_hz(), bound, &source.initial(0))
}

/// Flies all cases against the truth, shared out among the processors.
fn fly_all(
    source: &Source,
    samples: u64,
    cases: &[Case],
    flown: &mut dyn FnMut(u64),
) -> Vec<Outcome> {
    let threads = thread::available_parallelism().map_or(1, usize::from).min(cases.len().max(1));
    let (tell, hear) = mpsc::channel();
    thread::scope(|scope| {
        let share = |first: usize| {
            let tell = tell.clone();
            scope.spawn(move || {
                let own: Vec<Case> = cases.iter().copied().skip(first).step_by(threads).collect();
                fly(source, samples, &own, &mut |n| {
                    // Nobody hears any more only where the whole has failed.
                    let _ = tell.send(n);
                })
            })
        };
        let shares: Vec<_> = (0..threads).map(share).collect();
        drop(tell);
        hear.into_iter().for_each(flown);
        let mut shares: Vec<_> = shares
            .into_iter()
            .map(|share| share.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
            .map(Vec::into_iter)
            .collect();
        (0..cases.len()).filter_map(|n| shares[n % threads].next()).collect()
    })
}

/// Flies some cases side by side, so that truth and samples are worked out once for all of them.
fn fly(source: &Source, samples: u64, cases: &[Case], flown: &mut dyn FnMut(u64)) -> Vec<Outcome> {
    let mut flights: Vec<Flight> = cases.iter().map(|case| Flight::new(source, case)).collect();
    let mut truth = vec![source.truth(0)];
    let first_rates = source.rates(0);
    for flight in &mut flights {
        flight.go_on(&truth, 0, |craft, read| craft.push_rates(&first_rates, read));
    }
    let mut done = 0;
    while done < samples {
        let end = samples.min(done + CHUNK);
        // What rows of this chunk can still ask for.
        truth.drain(..truth.len().saturating_sub(LAG));
        truth.extend((done + 1..=end).map(|n| source.truth(n)));
        let first = end + 1 - truth.len() as u64;
        let chunk = Chunk::new(source, done, end);
        for flight in &mut flights {
            flight.go_on(&truth, first, |craft, read| craft.advance(&chunk, read));
            if end == samples {
                flight.go_on(&truth, first, |craft, read| {
                    craft.finish(read);
                    Ok(())
                });
            }
            flown(end - done);
        }
        done = end;
    }
    flights.into_iter().map(Flight::outcome).collect()
}

/// A case on its way, or why it is not.
struct Flight {
    craft: Result<Craft, String>,
    largest: Largest,
}

impl Flight {
    fn new(source: &Source, case: &Case) -> Self {
        let craft = start(source, case).map_err(|refused| refused.to_string());
        Self { craft, largest: [0.0; 3] }
    }

    /// Flies a stretch, of which `truth[0]` is row `first`; what is refused ends the flight.
    fn go_on(
        &mut self,
        truth: &[Solution<f64>],
        first: u64,
        stretch: impl FnOnce(&mut Craft, &mut Reader) -> Result<(), Rejected>,
    ) {
        let Ok(craft) = &mut self.craft else { return };
        let stretched = stretch(craft, &mut against(truth, first, &mut self.largest));
        if let Err(refused) = stretched {
            self.craft = Err(refused.to_string());
        }
    }

    fn outcome(self) -> Outcome {
        self.craft?;
        finite(self.largest)
    }
}

fn finite(largest: Largest) -> Outcome {
    if largest.iter().all(|error| error.is_finite()) {
        Ok(largest)
    } else {
        Err("its numbers end in NaN or infinity".to_owned())
    }
}

/// A reader that compares each row with the truth, of which `truth[0]` belongs to row `first`.
fn against<'a>(
    truth: &'a [Solution<f64>],
    first: u64,
    largest: &'a mut Largest,
) -> impl FnMut(u64, &Solution<f64>) + 'a {
    move |row, computed| {
        let known = row.checked_sub(first).and_then(|n| truth.get(n as usize));
        let error = match known {
            Some(truth) => {
                let drift = drift(computed, truth);
                let attitude = drift.attitude_ned.map(|angle| angle / ARCSECOND).norm();
                [drift.position_ned.norm(), drift.velocity_ned.norm(), attitude]
            }
            // A row that nothing is known of must not pass for a good one.
            None => [f64::NAN; 3],
        };
        for (most, now) in largest.iter_mut().zip(error) {
            // A NaN stays.
            *most = if most.is_nan() || *most > now { *most } else { now };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_that_is_no_number_is_told() {
        let mut largest = [0.0; 3];
        let row = Solution::default();
        against(&[row], 5, &mut largest)(4, &row);
        against(&[row], 5, &mut largest)(5, &row);
        assert!(largest.iter().all(|error| error.is_nan()));
        assert!(finite(largest).expect_err("no number").contains("NaN"));
        assert_eq!(finite([1.0, 2.0, 0.0]), Ok([1.0, 2.0, 0.0]));
    }
}
