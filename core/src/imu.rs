//! The perfect inertial unit: rates from the motion, increments by quadrature of the rates.
//!
//! ```
//! use schuler::imu::{Quadrature, rates};
//! use schuler::trajectory::harmonic::{Channel, Channels, Harmonic, HarmonicTrajectory};
//! use schuler::trajectory::Trajectory;
//!
//! let fixed = |offset| Channel { offset, rate: 0.0, harmonics: &[] };
//! let swing = [Harmonic { amplitude: 0.1_f64, angular_rate: 2.0, phase: 0.0 }];
//! let flight = HarmonicTrajectory::<f64, 1>::new(Channels {
//!     roll: Channel { harmonics: &swing, ..fixed(0.0) },
//!     pitch: fixed(0.0),
//!     yaw: fixed(0.0),
//!     latitude: fixed(0.8),
//!     longitude: fixed(0.1),
//!     altitude: fixed(100.0),
//! })?;
//! let quadrature = Quadrature::plan(flight.bound().bandwidth, 0.01);
//! let first = quadrature.sample(&flight, 1, 100.0);
//! // The increment is about the rate in the middle times the interval.
//! let middle = rates(&flight.at(0.005));
//! assert!((first.angle_b - middle.rate_ib_b * 0.01).norm() < 1e-8);
//! # Ok::<(), schuler::trajectory::harmonic::CourseError>(())
//! ```

use crate::math::compensated::{Pair, two_product, two_sum};
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::sample::{Increment, Rates};
use crate::trajectory::{Motion, Trajectory};

/// Angular rate and specific force of a motion.
#[inline(always)]
pub fn rates<R: Real>(motion: &Motion<R>) -> Rates<R> {
    motion.rates()
}

/// Gauss-Legendre quadrature with n nodes in each of some equal panels of a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Quadrature {
    nodes: usize,
    panels: u32,
}

/// The largest truncation, relative to the integrand's range, that a plan accepts: a hundredth of
/// the rounding of one sample.
const TRUNCATION: f64 = 1e-18;

impl Quadrature {
    /// The fewest evaluations that reach the rounding floor for a motion of this bandwidth, rad/s,
    /// over an interval in seconds; for still faster motion, 8 nodes in each of 1024 panels.
    pub fn plan(bandwidth: f64, interval_s: f64) -> Self {
        let mut panels = 1;
        loop {
            let x = bandwidth * interval_s / f64::from(panels);
            for nodes in 1..=NODES.len() {
                if truncation(nodes, x) <= TRUNCATION {
                    return Self { nodes, panels };
                }
            }
            // Such a motion turns hundreds of times within a sample: no sampling resolves it.
            if panels >= 1024 {
                return Self { nodes: NODES.len(), panels };
            }
            panels *= 2;
        }
    }

    /// So many nodes, from 1 to 8, in one panel; where there are no such rules, the nearest.
    pub fn of_nodes(nodes: usize) -> Self {
        Self { nodes: nodes.clamp(1, NODES.len()), panels: 1 }
    }

    /// The same panels with the largest number of nodes.
    pub fn finest(self) -> Self {
        Self { nodes: NODES.len(), ..self }
    }

    /// Evaluations of the motion per sample.
    pub fn evaluations(self) -> usize {
        self.nodes * self.panels as usize
    }

    /// The increment from one time to another, s.
    #[inline]
    pub fn increment<R: Real, T: Trajectory<R> + ?Sized>(
        self,
        trajectory: &T,
        from_s: R,
        to_s: R,
    ) -> Increment<R> {
        let centre = Pair::sum(from_s, to_s);
        let centre = Pair { hi: centre.hi * R::HALF, lo: centre.lo * R::HALF };
        self.increment_about(trajectory, centre, Pair::sum(to_s, -from_s))
    }

    /// The increment of a sample by its number, counted from 1, at a rate in samples per second.
    #[inline]
    pub fn sample<T: Trajectory<f64> + ?Sized>(
        self,
        trajectory: &T,
        number: u64,
        rate_hz: f64,
    ) -> Increment<f64> {
        self.samples(trajectory, number as f64, rate_hz)
    }

    /// The same of several samples, one in each lane of a pack.
    #[inline(always)]
    pub fn samples<R: Real, T: Trajectory<R> + ?Sized>(
        self,
        trajectory: &T,
        numbers: R,
        rate_hz: R,
    ) -> Increment<R> {
        let centre = instant(numbers - R::HALF, rate_hz);
        self.increment_about(trajectory, centre, Pair::new(rate_hz).reciprocal())
    }

    /// The increment over an interval about its centre, s: both are more precise than a single `f64` time.
    /// It is summed over the parts between the joints of the motion.
    #[inline(always)]
    pub fn increment_about<R: Real, T: Trajectory<R> + ?Sized>(
        self,
        trajectory: &T,
        centre_s: Pair<R>,
        interval_s: Pair<R>,
    ) -> Increment<R> {
        let half_s = interval_s.hi * R::HALF;
        let is_within = |joint_s: R| R::any(joint_s.less(centre_s.hi + half_s));
        match trajectory.joint_after(centre_s.hi - half_s) {
            Some(joint_s) if is_within(joint_s) => self.in_parts(trajectory, centre_s, interval_s),
            _ => self.unbroken(trajectory, centre_s, interval_s),
        }
    }

    /// The same across joints.
    #[inline(never)]
    fn in_parts<R: Real, T: Trajectory<R> + ?Sized>(
        self,
        trajectory: &T,
        centre_s: Pair<R>,
        interval_s: Pair<R>,
    ) -> Increment<R> {
        let half_of = |a: Pair<R>| Pair { hi: a.hi * R::HALF, lo: a.lo * R::HALF };
        let half_s = half_of(interval_s);
        let (mut from_s, end_s) = (centre_s - half_s, centre_s + half_s);
        let mut sum = Increment { angle_b: Vector::ZERO, velocity_b: Vector::ZERO };
        loop {
            let joint_s = trajectory.joint_after(from_s.hi);
            let joint_s = joint_s.filter(|joint_s| R::any(joint_s.less(end_s.hi)));
            let to_s = joint_s.map_or(end_s, Pair::new);
            let part = self.unbroken(trajectory, half_of(from_s + to_s), to_s - from_s);
            sum.angle_b = sum.angle_b + part.angle_b;
            sum.velocity_b = sum.velocity_b + part.velocity_b;
            if joint_s.is_none() {
                return sum;
            }
            from_s = to_s;
        }
    }

    /// The increment of a motion without joints in between.
    #[inline(always)]
    fn unbroken<R: Real, T: Trajectory<R> + ?Sized>(
        self,
        trajectory: &T,
        centre_s: Pair<R>,
        interval_s: Pair<R>,
    ) -> Increment<R> {
        let share = R::ONE / R::count(self.panels);
        let half_s = interval_s.hi * share * R::HALF;
        let mut sum = Rates::default();
        for panel in 0..self.panels {
            let from_centre = half_s * (R::count(2 * panel + 1) - R::count(self.panels));
            let mean = self.mean(trajectory, centre_s, from_centre, half_s);
            sum.rate_ib_b = sum.rate_ib_b + mean.rate_ib_b;
            sum.specific_force_b = sum.specific_force_b + mean.specific_force_b;
        }
        let (time, low) = (interval_s.hi * share, interval_s.lo * share);
        Increment {
            angle_b: sum.rate_ib_b * time + sum.rate_ib_b * low,
            velocity_b: sum.specific_force_b * time + sum.specific_force_b * low,
        }
    }

    /// The mean of the rates over ± half about a time from the centre.
    #[inline(always)]
    fn mean<R: Real, T: Trajectory<R> + ?Sized>(
        self,
        trajectory: &T,
        centre_s: Pair<R>,
        from_centre_s: R,
        half_s: R,
    ) -> Rates<R> {
        let rule = NODES.get(self.nodes.wrapping_sub(1)).copied().unwrap_or(&[]);
        let mut reference = None;
        let mut angle = Vector::ZERO;
        let mut velocity = Vector::ZERO;
        for &(node, weight) in rule {
            let (hi, rest) = two_sum(centre_s.hi, from_centre_s + half_s * R::of(node));
            let r = trajectory.rates_at(Pair { hi, lo: rest + centre_s.lo });
            // f₁ + Σ ½wᵢ(fᵢ − f₁): the weights' rounding then has no bias
            let base = *reference.get_or_insert(r);
            let half_weight = R::of(weight) * R::HALF;
            angle = angle + (r.rate_ib_b - base.rate_ib_b) * half_weight;
            velocity = velocity + (r.specific_force_b - base.specific_force_b) * half_weight;
        }
        let base = reference.unwrap_or_default();
        Rates {
            rate_ib_b: base.rate_ib_b + angle,
            specific_force_b: base.specific_force_b + velocity,
        }
    }
}

/// The time after a number of samples, s, with the part that rounding drops: a time of day in one double has
/// an error of 10⁻¹¹ s, which is a nanometre in fast motion.
#[inline(always)]
pub fn instant<R: Real>(samples: R, rate_hz: R) -> Pair<R> {
    // n/f = t + (n − t·f)/f
    let hi = samples / rate_hz;
    let (product, rest) = two_product(hi, rate_hz);
    Pair { hi, lo: ((samples - product) - rest) / rate_hz }
}

/// Error of n-node quadrature over an interval h of a function with f⁽ᵏ⁾ ≤ Λᵏ, x = Λh, per h.
fn truncation(nodes: usize, x: f64) -> f64 {
    // x²ⁿ (n!)⁴/((2n+1)((2n)!)³)
    let mut term = 1.0 / (2.0 * nodes as f64 + 1.0);
    for k in 1..=nodes {
        let (k, low, high) = (k as f64, (2 * k - 1) as f64, (2 * k) as f64);
        term *= x * x * k * k * k * k / (low * high * low * high * low * high);
    }
    term
}

/// Nodes in [−1, 1] and weights of the rules of 1 to 8 nodes (Abramowitz & Stegun, table 25.4).
const NODES: [&[(f64, f64)]; 8] = [
    &[(0.0, 2.0)],
    &[(-0.5773502691896257, 1.0), (0.5773502691896257, 1.0)],
    &[
        (-0.7745966692414834, 0.5555555555555556),
        (0.0, 0.8888888888888888),
        (0.7745966692414834, 0.5555555555555556),
    ],
    &[
        (-0.8611363115940526, 0.34785484513745385),
        (-0.33998104358485626, 0.6521451548625461),
        (0.33998104358485626, 0.6521451548625461),
        (0.8611363115940526, 0.34785484513745385),
    ],
    &[
        (-0.906179845938664, 0.23692688505618908),
        (-0.5384693101056831, 0.47862867049936647),
        (0.0, 0.5688888888888889),
        (0.5384693101056831, 0.47862867049936647),
        (0.906179845938664, 0.23692688505618908),
    ],
    &[
        (-0.932469514203152, 0.17132449237917036),
        (-0.6612093864662645, 0.3607615730481386),
        (-0.2386191860831969, 0.46791393457269104),
        (0.2386191860831969, 0.46791393457269104),
        (0.6612093864662645, 0.3607615730481386),
        (0.932469514203152, 0.17132449237917036),
    ],
    &[
        (-0.9491079123427585, 0.1294849661688697),
        (-0.7415311855993945, 0.27970539148927664),
        (-0.4058451513773972, 0.3818300505051189),
        (0.0, 0.4179591836734694),
        (0.4058451513773972, 0.3818300505051189),
        (0.7415311855993945, 0.27970539148927664),
        (0.9491079123427585, 0.1294849661688697),
    ],
    &[
        (-0.9602898564975363, 0.10122853629037626),
        (-0.7966664774136267, 0.22238103445337448),
        (-0.525532409916329, 0.31370664587788727),
        (-0.1834346424956498, 0.362683783378362),
        (0.1834346424956498, 0.362683783378362),
        (0.525532409916329, 0.31370664587788727),
        (0.7966664774136267, 0.22238103445337448),
        (0.9602898564975363, 0.10122853629037626),
    ],
];
