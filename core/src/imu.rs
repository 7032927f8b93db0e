//! The perfect inertial unit: rates from the motion, increments by quadrature of the rates.

use crate::earth::{self, Radii};
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::sample::{Increment, Rates};
use crate::trajectory::{Motion, Trajectory};

/// Angular rate and specific force of a motion.
#[inline]
pub fn rates<R: Real>(motion: &Motion<R>) -> Rates<R> {
    let Motion { roll, pitch, yaw, latitude, longitude, altitude } = *motion;
    let (s, c) = latitude.value.sin_cos();
    let radii = Radii::at(s, c);
    let north_radius = radii.meridian + altitude.value;
    let east_radius = radii.prime_vertical + altitude.value;
    // v_N = (R_M + h)φ̇,  v_E = (R_N + h)cosφ·λ̇,  v_D = −ḣ
    let v = Vector::new(
        north_radius * latitude.first,
        east_radius * c * longitude.first,
        -altitude.first,
    );
    // v̇ⁿ, by the product rule
    let north_growth = radii.meridian_slope * latitude.first + altitude.first;
    let east_growth = radii.prime_vertical_slope * latitude.first + altitude.first;
    let acceleration = Vector::new(
        north_growth * latitude.first + north_radius * latitude.second,
        (east_growth * c - east_radius * s * latitude.first) * longitude.first
            + east_radius * c * longitude.second,
        -altitude.second,
    );
    let earth_rate = earth::rotation_ned(s, c);
    let transport_rate = motion.transport_rate(s, c);
    // fⁿ = v̇ⁿ + (2ω_ieⁿ + ω_enⁿ) × vⁿ − gⁿ
    let coriolis = (earth_rate + earth_rate + transport_rate).cross(v);
    let mut specific_force = acceleration + coriolis;
    specific_force.z = specific_force.z - earth::gravity(s, altitude.value);

    let (sin_roll, cos_roll) = roll.value.sin_cos();
    let (sin_pitch, cos_pitch) = pitch.value.sin_cos();
    let (sin_yaw, cos_yaw) = yaw.value.sin_cos();
    // C_nᵇ = Rx(γ)·Ry(θ)·Rz(ψ)
    let to_body = |n: Vector<R>| {
        let (x, y) = (cos_yaw * n.x + sin_yaw * n.y, cos_yaw * n.y - sin_yaw * n.x);
        let (x, z) = (cos_pitch * x - sin_pitch * n.z, sin_pitch * x + cos_pitch * n.z);
        Vector::new(x, cos_roll * y + sin_roll * z, cos_roll * z - sin_roll * y)
    };
    // ω_nbᵇ = (γ̇ − ψ̇ sinθ, θ̇ cosγ + ψ̇ sinγ cosθ, −θ̇ sinγ + ψ̇ cosγ cosθ)
    let rate_nb = Vector::new(
        roll.first - yaw.first * sin_pitch,
        pitch.first * cos_roll + yaw.first * sin_roll * cos_pitch,
        yaw.first * cos_roll * cos_pitch - pitch.first * sin_roll,
    );
    Rates {
        rate_ib_b: rate_nb + to_body(earth_rate + transport_rate),
        specific_force_b: to_body(specific_force),
    }
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
    /// over an interval in seconds; for what is faster still, 8 nodes in each of 1024 panels.
    pub fn plan(bandwidth: f64, interval_s: f64) -> Self {
        let mut panels = 1;
        loop {
            let x = bandwidth * interval_s / f64::from(panels);
            for nodes in 1..=NODES.len() {
                if truncation(nodes, x) <= TRUNCATION {
                    return Self { nodes, panels };
                }
            }
            // Such a motion turns hundreds of times within a sample, and cannot be sampled anyhow.
            if panels >= 1024 {
                return Self { nodes: NODES.len(), panels };
            }
            panels *= 2;
        }
    }

    /// The same panels with every node there is.
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
        let panels = R::count(self.panels);
        let mut sum = Increment::default();
        for panel in 0..self.panels {
            let at = |n: u32| from_s + (to_s - from_s) * R::count(n) / panels;
            let (a, b) = (at(panel), at(panel + 1));
            let mean = self.mean(trajectory, (a + b) * R::HALF, (b - a) * R::HALF);
            sum.angle_b = sum.angle_b + mean.rate_ib_b * (b - a);
            sum.velocity_b = sum.velocity_b + mean.specific_force_b * (b - a);
        }
        sum
    }

    /// The mean of the rates over centre ± half.
    #[inline]
    fn mean<R: Real, T: Trajectory<R> + ?Sized>(
        self,
        trajectory: &T,
        centre_s: R,
        half_s: R,
    ) -> Rates<R> {
        let rule = NODES.get(self.nodes.wrapping_sub(1)).copied().unwrap_or(&[]);
        let mut reference = None;
        let mut angle = Vector::ZERO;
        let mut velocity = Vector::ZERO;
        for &(node, weight) in rule {
            let r = rates(&trajectory.at(centre_s + half_s * R::of(node)));
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
