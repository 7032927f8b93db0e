//! What the nav step leaves over blocks of some length: flown on true body motions in such blocks and in
//! blocks of half that, from the same start. Its turns are exact: position and velocity tell.

use super::growth::rise;
use super::reference::{Part, Stretch};
use schuler::earth::{EQUATORIAL_GRAVITY, SEMI_MAJOR_AXIS};
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::solution::{EarthFixedSolution, Solution};
use schuler::strapdown::block_time::BlockTime;
use schuler::strapdown::earth_fixed::EarthFixed;
use schuler::strapdown::frame::Frame;
use schuler::strapdown::local_level::LocalLevel;
use schuler::trajectory::Trajectory;

/// Blocks flown until gravity's history is the flight's own, and blocks measured.
const WARM: usize = 4;
const MEASURED: usize = 8;

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

/// States after the warm-up and at the end, in blocks of so many parts.
fn fly<F: Frame<Real = f64>>(
    initial: &Solution<f64>,
    parts: &[Part],
    block: usize,
    interval_s: Pair<f64>,
    marks: [usize; 2],
) -> [F::Output; 2] {
    let time = BlockTime::new(interval_s, block);
    let mut frame = F::start(initial);
    let mut seen = [frame.output(); 2];
    for (n, part) in Part::blocks(parts, block).iter().enumerate() {
        let body = part.body();
        if n == 0 {
            frame.seed(&time, &body);
        }
        frame.step(&time, &body);
        for (mark, seen) in marks.iter().zip(&mut seen) {
            if (n + 1) * block == *mark {
                *seen = frame.output();
            }
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
    let finer = if block.is_multiple_of(2) { block / 2 } else { 1 };
    let marks = [WARM * block, (WARM + MEASURED) * block];
    let coarse = fly::<F>(initial, &stretch.parts, block, interval_s, marks);
    let fine = fly::<F>(initial, &stretch.parts, finer, interval_s, marks);
    let [r0, v0] = coarse[0].apart(&fine[0]);
    let [r1, v1] = coarse[1].apart(&fine[1]);
    let span_s = (MEASURED * block) as f64 * interval_s.hi;
    let per_s = 1.0 / span_s;
    // Growth after the warm-up is steady; what stands then beyond it comes from the start.
    let acceleration = (v1 - v0) * per_s;
    let velocity = (r1 - r0) * per_s - (v0 + v1) * 0.5;
    let warm_s = (WARM * block) as f64 * interval_s.hi;
    let begun = (v0 - acceleration * warm_s).norm();
    let (up, risen) = rise(duration_s);
    let kappa_square = 2.0 * EQUATORIAL_GRAVITY / SEMI_MAJOR_AXIS;
    // Half an ulp of gravity either way is rounding, which no shorter block mends.
    let rounding = f64::EPSILON * EQUATORIAL_GRAVITY;
    (acceleration.norm() - rounding).max(0.0) * risen / kappa_square
        + velocity.norm() * up
        + (begun - rounding * warm_s).max(0.0) * up
}

/// Position that the nav step's truncation leads to at the end of a flight, m.
pub fn position_m(
    motion: &impl Trajectory<f64>,
    interval_s: f64,
    block: usize,
    duration_s: f64,
    earth_fixed: bool,
) -> f64 {
    let count = (WARM + MEASURED) * block;
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
