//! The error of the navigation step over blocks of some length, flown on true body motions in such blocks and in
//! blocks of twice that length, from the same start. Its rotations are exact, so position and velocity show it.

use super::growth::rise;
use super::middle::taper;
use super::reference::{Part, Stretch};
use schuler::earth::{EQUATORIAL_GRAVITY, SEMI_MAJOR_AXIS};
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::solution::{EarthFixedSolution, Solution};
use schuler::strapdown::frame::Frame;
use schuler::strapdown::frame::block_time::BlockTime;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::trajectory::Trajectory;

/// Long blocks flown until gravity's history is the flight's own; those measured, and their samples, at
/// least.
const WARM: usize = 3;
const MEASURED: usize = 8;
const SAMPLES: usize = 120;
/// Blocks twice as long leave eight times as much, or more: what they differ by is seven times the rest.
const LONGER: f64 = 7.0;

/// A printed state that can be compared to all its digits.
trait Apart: Copy {
    /// Position, m, and velocity, m/s, in axes of its own.
    fn apart(&self, other: &Self) -> [Vector<f64>; 2];
}

fn less(a: Pair<f64>, b: Pair<f64>) -> f64 {
    (a.hi - b.hi) + (a.lo - b.lo)
}

impl Apart for Solution<f64> {
    fn apart(&self, other: &Self) -> [Vector<f64>; 2] {
        let (a, b) = (self.position, other.position);
        let (_, cosine) = schuler::math::real::Real::sin_cos(a.latitude.hi);
        let north = less(a.latitude, b.latitude) * SEMI_MAJOR_AXIS;
        let east = less(a.longitude, b.longitude) * SEMI_MAJOR_AXIS * cosine;
        let position = Vector::new(north, east, less(b.altitude, a.altitude));
        [position, self.velocity_ned.zip(other.velocity_ned, less)]
    }
}

impl Apart for EarthFixedSolution<f64> {
    fn apart(&self, other: &Self) -> [Vector<f64>; 2] {
        [self.position_e.zip(other.position_e, less), self.velocity_e.zip(other.velocity_e, less)]
    }
}

/// States at the ends of `long` blocks, flown in blocks of some length that divides theirs.
fn fly<F: Frame<Real = f64>>(
    initial: &Solution<f64>,
    parts: &[Part],
    block: usize,
    long: usize,
    interval_s: Pair<f64>,
) -> Vec<F::Output> {
    let time = BlockTime::new(interval_s, block);
    let mut frame = F::start(initial);
    let mut seen = Vec::new();
    for (n, part) in Part::blocks(parts, block).iter().enumerate() {
        let body = part.body();
        if n == 0 {
            frame.seed(&time, &body);
        }
        frame.step(&time, &body);
        if ((n + 1) * block).is_multiple_of(long) {
            seen.push(frame.output());
        }
    }
    seen
}

fn rest<F: Frame<Real = f64, Output: Apart>>(
    initial: &Solution<f64>,
    stretch: &Stretch,
    block: usize,
    interval_s: Pair<f64>,
    duration_s: f64,
) -> f64 {
    let long = 2 * block;
    let coarse = fly::<F>(initial, &stretch.parts, long, long, interval_s);
    let fine = fly::<F>(initial, &stretch.parts, block, long, interval_s);
    let apart: Vec<_> = coarse.iter().zip(&fine).skip(WARM).map(|(a, b)| a.apart(b)).collect();
    // The slope by least squares, weighed so that swings leave nothing.
    let count = apart.len() as f64;
    let weighed = || apart.iter().enumerate().map(|(n, a)| (taper((n as f64 + 0.5) / count), n, a));
    let middle = 0.5 * (count - 1.0);
    let (mut square, mut slopes, mut all, mut means) =
        (0.0, [Vector::ZERO; 2], 0.0, [Vector::ZERO; 2]);
    for (weight, n, apart) in weighed() {
        let x = n as f64 - middle;
        square += weight * x * x;
        all += weight;
        for ((slope, mean), off) in slopes.iter_mut().zip(&mut means).zip(apart) {
            *slope = *slope + *off * (weight * x);
            *mean = *mean + *off * weight;
        }
    }
    let per_s = 1.0 / (square * long as f64 * interval_s.hi);
    let acceleration = slopes[1] * per_s;
    let velocity = slopes[0] * per_s - means[1] * (1.0 / all);
    let (up, risen) = rise(duration_s);
    let kappa_square = 2.0 * EQUATORIAL_GRAVITY / SEMI_MAJOR_AXIS;
    let left_m = acceleration.norm() * risen / kappa_square + velocity.norm() * up;
    left_m / LONGER
}

/// Position that the nav step's truncation leads to at the end of a flight, m.
pub fn position_m(
    motion: &impl Trajectory<f64>,
    interval_s: f64,
    block: usize,
    duration_s: f64,
    earth_fixed: bool,
) -> f64 {
    let measured = MEASURED.max(SAMPLES.div_ceil(2 * block));
    let count = (WARM + measured) * 2 * block;
    let exact_s = Pair::new(interval_s);
    let samples = duration_s / interval_s;
    let at = |part: f64| {
        let first = (part * samples) as u64;
        let stretch = Stretch::new(motion, interval_s, first, count);
        let initial = motion.at(first as f64 * interval_s).initial();
        if earth_fixed {
            rest::<EarthFixed<Pair<f64>>>(&initial, &stretch, block, exact_s, duration_s)
        } else {
            rest::<LocalLevel<Pair<f64>>>(&initial, &stretch, block, exact_s, duration_s)
        }
    };
    [0.0, 0.6].map(at).into_iter().fold(0.0, f64::max)
}
