//! The true motion of the body over a stretch, sample by sample.
//!
//! A sample's motion comes from a polynomial of degree 12 or 13 through its neighbours, in fast motion
//! through increments that are four times as dense. Motions are stored less the sums of the increments, which
//! a window's block passes on exactly, so their rounding is far below that of the navigator.

use schuler::imu::Quadrature;
use schuler::math::compensated::two_sum;
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::strapdown::block::body::{BodyMotion, Sum, integrate};
use schuler::strapdown::block::fit::{Fit, table_f32, table_f64};
use schuler::trajectory::Trajectory;

/// Samples before and after a stretch that its windows see.
pub const MARGIN: usize = 6;
/// Bandwidth times interval up to which the samples themselves are dense enough.
const DENSE: f64 = 0.05;
/// Increments to a sample where they are not.
const FINE: usize = 4;

/// The true motion over some samples.
#[derive(Clone, Copy, Debug, Default)]
pub struct Part {
    angle: Vector<f64>,
    angle_low: Vector<f64>,
    velocity: Vector<f64>,
    velocity_low: Vector<f64>,
    /// e = q − 1: its scalar part, and its vector part beyond ½ΣΔθ.
    scalar: f64,
    curved: Vector<f64>,
    /// u beyond ΣΔv, m/s.
    bent: Vector<f64>,
    /// s, m.
    position: Vector<f64>,
    /// ∫s dt, m·s.
    position_integral: Vector<f64>,
    time_s: f64,
}

/// What a computed motion has wrong, in the axes at the start.
#[derive(Clone, Copy, Debug, Default)]
pub struct Miss {
    /// Rotation vector, rad.
    pub angle: Vector<f64>,
    /// m/s.
    pub velocity: Vector<f64>,
    /// m.
    pub position: Vector<f64>,
}

impl Miss {
    /// What this one misses beyond another.
    pub fn less(&self, other: &Self) -> Self {
        Self {
            angle: self.angle - other.angle,
            velocity: self.velocity - other.velocity,
            position: self.position - other.position,
        }
    }
}

impl Part {
    /// Of one sample, from what a navigator's step makes of it.
    fn of(sample: &Increment<f64>, body: &BodyMotion<f64>, time_s: f64) -> Self {
        Self {
            angle: sample.angle_b,
            velocity: sample.velocity_b,
            scalar: body.rotation.w,
            curved: (body.rotation.v - sample.angle_b * 0.5) + body.rotation_low,
            bent: (body.velocity - sample.velocity_b) + body.velocity_low,
            position: body.position,
            position_integral: body.position_integral,
            time_s,
            ..Self::default()
        }
    }

    /// q − 1.
    pub fn rotation(&self) -> Quaternion<f64> {
        Quaternion::new(self.scalar, self.angle * 0.5 + self.curved)
    }

    /// This and then another.
    fn then(&self, next: &Self) -> Self {
        let (a, b) = (self.rotation(), next.rotation());
        let (angle, angle_low) = sums(self.angle, next.angle);
        let (velocity, velocity_low) = sums(self.velocity, next.velocity);
        let (u, v) = (self.velocity + self.bent, next.velocity + next.bent);
        Self {
            angle,
            angle_low: self.angle_low + next.angle_low + angle_low,
            velocity,
            velocity_low: self.velocity_low + next.velocity_low + velocity_low,
            scalar: a.w + b.w + (a.w * b.w - a.v.dot(b.v)),
            // e₁ + e₂ + e₁ ⊗ e₂
            curved: self.curved + next.curved + (b.v * a.w + a.v * b.w + a.v.cross(b.v)),
            // u₁ + R₁u₂,  s₁ + u₁T₂ + R₁s₂,  ∫s₁ + s₁T₂ + ½u₁T₂² + R₁∫s₂
            bent: self.bent + next.bent + a.turn_less_one(v),
            position: self.position
                + u * next.time_s
                + (next.position + a.turn_less_one(next.position)),
            position_integral: self.position_integral
                + (self.position + u * (0.5 * next.time_s)) * next.time_s
                + (next.position_integral + a.turn_less_one(next.position_integral)),
            time_s: self.time_s + next.time_s,
        }
    }

    /// The motion over all of some parts, which are not none.
    pub fn all(parts: &[Self]) -> Self {
        let (first, rest) = parts.split_first().expect("a block has samples");
        rest.iter().fold(*first, |sum, next| sum.then(next))
    }

    /// Over so many parts each.
    pub fn blocks(parts: &[Self], block: usize) -> Vec<Self> {
        parts.chunks_exact(block).map(Self::all).collect()
    }

    /// u, m/s.
    pub fn velocity(&self) -> Vector<f64> {
        self.velocity + self.bent
    }

    /// As a navigator's step takes it.
    pub fn body(&self) -> BodyMotion<f64> {
        BodyMotion {
            rotation: self.rotation(),
            velocity: self.velocity(),
            position: self.position,
            position_integral: self.position_integral,
            ..BodyMotion::default()
        }
    }

    /// What a motion computed with what rounding drops misses of this one.
    pub fn miss(&self, body: &BodyMotion<f64>) -> Miss {
        let half = (self.angle * 0.5, self.angle_low * 0.5);
        let curved = (body.rotation.v - half.0) + (body.rotation_low - half.1);
        let bent = (body.velocity - self.velocity) + (body.velocity_low - self.velocity_low);
        let apart = Quaternion::new(body.rotation.w - self.scalar, curved - self.curved);
        // q − q₀ = δ gives the rotation 2 vec(δ ⊗ q₀*).
        let turned = apart.v + (apart * self.rotation().conjugate()).v;
        Miss {
            angle: turned + turned,
            velocity: bent - self.bent,
            position: body.position - self.position,
        }
    }
}

fn sums(a: Vector<f64>, b: Vector<f64>) -> (Vector<f64>, Vector<f64>) {
    let pairs = a.zip(b, two_sum);
    (pairs.map(|(s, _)| s), pairs.map(|(_, e)| e))
}

/// Some samples in a row with their truth.
pub struct Stretch {
    /// With [`MARGIN`] more on either side.
    pub samples: Vec<Increment<f64>>,
    /// The true motion over each.
    pub parts: Vec<Part>,
    /// When it begins, s.
    pub begin_s: f64,
}

impl Stretch {
    /// Of a motion, so many samples from the one of a number on.
    pub fn new(motion: &impl Trajectory<f64>, interval_s: f64, first: u64, count: usize) -> Self {
        let bandwidth = motion.bound().bandwidth;
        let fine = if bandwidth * interval_s <= DENSE { 1 } else { FINE };
        let step_s = interval_s / fine as f64;
        let quadrature = Quadrature::plan(bandwidth, step_s);
        let begin_s = (first as f64 - MARGIN as f64) * interval_s;
        let edge = |n: usize| begin_s + n as f64 * step_s;
        let all = fine * (count + 2 * MARGIN);
        let increments: Vec<_> =
            (0..all).map(|n| quadrature.increment(motion, edge(n), edge(n + 1))).collect();
        let samples: Vec<_> = increments.chunks_exact(fine).map(sum).collect();
        let part = |n: usize| {
            let half_s = 0.5 * interval_s;
            let at = (MARGIN + n) * fine;
            if fine == 1 {
                let window = increments.get(at - 6..at + 7)?.first_chunk()?;
                let (fit, _) = Fit::<f64, 13>::from_samples(window, 6, 1, PLAIN_SINGLE, PLAIN);
                let sum = Sum::exact(increments.get(at..at + 1)?);
                Some(integrate::<f64, 13, 17>(&fit, &sum, half_s, 8).0)
            } else {
                let window = increments.get(at - 5..at + 9)?.first_chunk()?;
                let (fit, _) =
                    Fit::<f64, 14>::from_samples(window, 5, FINE, DENSE_SINGLE, DENSE_TABLE);
                let sum = Sum::exact(samples.get(MARGIN + n..MARGIN + n + 1)?);
                Some(integrate::<f64, 14, 17>(&fit, &sum, half_s, 14).0)
            }
        };
        let parts = (0..count)
            .filter_map(|n| Some(Part::of(samples.get(MARGIN + n)?, &part(n)?, interval_s)))
            .collect();
        Self { samples, parts, begin_s: first as f64 * interval_s }
    }
}

const PLAIN: &[[f64; 13]; 13] = &table_f64(6, 1);
const PLAIN_SINGLE: &[[f32; 13]; 13] = &table_f32(6, 1);
const DENSE_TABLE: &[[f64; 14]; 14] = &table_f64(5, FINE);
const DENSE_SINGLE: &[[f32; 14]; 14] = &table_f32(5, FINE);

fn sum(increments: &[Increment<f64>]) -> Increment<f64> {
    let mut sum = Increment::ZERO;
    for increment in increments {
        sum.angle_b = sum.angle_b + increment.angle_b;
        sum.velocity_b = sum.velocity_b + increment.velocity_b;
    }
    sum
}
