//! Where a path in pieces is at its liveliest, and the quadrature that resolves it there.

use crate::course::{Course, Path};
use schuler::imu::Quadrature;
use schuler::math::compensated::Pair;
use schuler::sample::Increment;
use schuler::trajectory::Trajectory as _;

/// Samples over which a rule of quadrature is tried.
const TRIED: u64 = 2000;
/// Rules of so many nodes at most are tried, against those of two more.
const NODES: usize = 6;
/// Readings of a piece whose differences are looked at.
const LOOKS: usize = 5;
/// Gravity over the Earth's rate of turning at 1 rad/s: readings of either kind in one measure, m/s² per rad/s.
const FORCE: f64 = 9.8;

/// The pieces of a path by how lively they are, the liveliest first: beginning and end, s.
///
/// The measure is the fourth difference of what sensors read, over an interval's fourth power.
pub fn pieces(course: &Course, path: &Path) -> Vec<[f64; 2]> {
    let measure = |[from_s, to_s]: [f64; 2]| {
        let step_s = (to_s - from_s) / (LOOKS - 1) as f64;
        let readings: [[f64; 6]; LOOKS] = std::array::from_fn(|n| {
            // Within the piece, not at its joints.
            let part = (n as f64 + 0.5) / LOOKS as f64;
            let rates = course.rates_at(Pair::new(from_s + part * (to_s - from_s)));
            let [a, b, c] = rates.rate_ib_b.into_array();
            let [d, e, f] = (rates.specific_force_b * (1.0 / FORCE)).into_array();
            [a, b, c, d, e, f]
        });
        let fourth = |i: usize| {
            let [a, b, c, d, e] = readings.map(|six| six[i]);
            (a - 4.0 * b + 6.0 * c - 4.0 * d + e).abs()
        };
        (0..6).map(fourth).fold(0.0, f64::max) / step_s.powi(4)
    };
    let mut spans: Vec<_> = path.spans().into_iter().map(|span| (measure(span), span)).collect();
    spans.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1[0].total_cmp(&b.1[0])));
    spans.into_iter().map(|(_, span)| span).collect()
}

/// The fewest nodes whose increments two more change by no more than a rounding of the largest, over the
/// liveliest samples; `None` where no rule of one panel does.
pub fn quadrature(course: &Course, path: &Path, rate_hz: f64, samples: u64) -> Option<Quadrature> {
    let mut numbers = Vec::new();
    for [from_s, to_s] in pieces(course, path) {
        let first = (from_s * rate_hz).floor() as u64 + 1;
        let last = ((to_s * rate_hz).floor() as u64 + 1).min(samples);
        numbers.extend(first..=last.max(first).min(samples));
        if numbers.len() as u64 >= TRIED {
            break;
        }
    }
    numbers.truncate(TRIED as usize);
    let integrate = |nodes: usize| -> Vec<Increment<f64>> {
        let rule = Quadrature::of_nodes(nodes);
        numbers.iter().map(|&n| course.sample(rule, n, rate_hz)).collect()
    };
    // Rules whose numbers of nodes differ by two are compared, so each is worked out once.
    let mut known: Vec<Option<Vec<Increment<f64>>>> = vec![None; NODES + 3];
    (1..=NODES)
        .find(|&nodes| {
            for n in [nodes, nodes + 2] {
                if known[n].is_none() {
                    known[n] = Some(integrate(n));
                }
            }
            let (Some(few), Some(more)) = (&known[nodes], &known[nodes + 2]) else { return false };
            let is_same = |of: fn(&Increment<f64>) -> [f64; 3]| {
                let largest = more.iter().flat_map(of).fold(0.0_f64, |most, x| most.max(x.abs()));
                let ulp = largest.next_up() - largest;
                let apart = |(a, b): (&Increment<f64>, &Increment<f64>)| {
                    of(a).into_iter().zip(of(b)).all(|(a, b)| (a - b).abs() <= ulp)
                };
                few.iter().zip(more).all(apart)
            };
            is_same(|i| i.angle_b.into_array()) && is_same(|i| i.velocity_b.into_array())
        })
        .map(Quadrature::of_nodes)
}
