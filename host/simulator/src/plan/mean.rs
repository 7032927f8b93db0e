//! The mean error of a stretch's blocks in north, east and down, without its oscillation.

use super::growth::Rate;
use super::middle::taper;
use super::reference::{Miss, Part};
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::trajectory::Motion;

/// A stretch's misses in north, east and down.
pub struct Mean {
    attitude: Quaternion<f64>,
    misses: Vec<(Miss, Vector<f64>)>,
}

impl Mean {
    /// Nothing yet, from a motion on.
    pub fn new(motion: &Motion<f64>) -> Self {
        let attitude = motion.solution().attitude.map(|c| c.hi);
        Self { attitude, misses: Vec::new() }
    }

    /// The next block.
    pub fn add(&mut self, miss: &Miss, part: &Part) {
        let matrix = self.attitude.matrix(1.0);
        let turned = Miss {
            angle: matrix * miss.angle,
            velocity: matrix * miss.velocity,
            position: matrix * miss.position,
        };
        self.misses.push((turned, matrix * part.velocity()));
        self.attitude = self.attitude + self.attitude * part.rotation();
    }

    /// What its blocks add per second.
    pub fn rate(&self, time_s: f64, block_s: f64) -> Rate {
        let zero = (Vector::ZERO, Vector::ZERO, Vector::ZERO);
        let (mut angles, mut velocities, mut positions) = zero;
        let (mut angle, mut tilts, mut gained) = zero;
        let (mut rectified, mut all) = (Vector::ZERO, 0.0);
        let count = self.misses.len().max(1) as f64;
        for (n, (miss, gain)) in self.misses.iter().enumerate() {
            let weight = taper((n as f64 + 0.5) / count);
            all += weight;
            // The tilt in the block's middle, times what it then gains.
            let tilt = angle + miss.angle * 0.5;
            rectified = rectified + tilt.cross(*gain) * weight;
            tilts = tilts + tilt * weight;
            gained = gained + *gain * weight;
            angle = angle + miss.angle;
            angles = angles + miss.angle * weight;
            velocities = velocities + miss.velocity * weight;
            positions = positions + miss.position * weight;
        }
        let all = if all > 0.0 { all } else { 1.0 };
        // Tilt and gain that go together add up; their means are the tilt's own growth.
        rectified = rectified - tilts.cross(gained) * (1.0 / all);
        let per_s = 1.0 / (all * block_s);
        Rate {
            time_s,
            tilt: angles * per_s,
            acceleration: (velocities + rectified) * per_s,
            velocity: positions * per_s,
        }
    }
}
