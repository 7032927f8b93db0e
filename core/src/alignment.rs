//! Level and north from a vehicle at rest: two vectors known in both frames.
//!
//! At rest the accelerometers feel −g, straight up, and the gyros the Earth's rate, which has no
//! component to the east. Source: Groves, 2nd ed., §5.6 (levelling and gyrocompassing); the triad of
//! Black (1964).
//!
//! ```
//! use schuler::alignment::Alignment;
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//!
//! // At 45° N, level, with the forward axis pointing 30° east of north; samples of 10 ms.
//! let (rate, yaw) = (7.292115e-5_f64, 30_f64.to_radians());
//! let (level, up) = (rate * 45_f64.to_radians().cos(), rate * 45_f64.to_radians().sin());
//! let rate_b = Vector::new(level * yaw.cos(), -level * yaw.sin(), -up);
//! let mut alignment = Alignment::default();
//! for _ in 0..1000 {
//!     alignment.add(&Increment { angle_b: rate_b * 0.01, velocity_b: Vector::new(0.0, 0.0, -0.098) });
//! }
//! let attitude = alignment.attitude()?;
//! assert!((attitude.yaw - yaw).abs() < 1e-9 && attitude.roll.abs() < 1e-9);
//! # Ok::<(), schuler::alignment::AlignmentError>(())
//! ```

pub mod inertial;
pub mod judge;
pub mod place;
mod scatter;
pub mod signs;
pub mod still;
pub mod units;

use crate::math::compensated::Pair;
use crate::math::real::Scalar;
use crate::math::vector::Vector;
use crate::sample::Increment;
use crate::solution::Euler;

/// Sums samples at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Alignment<R> {
    angle_b: Vector<Pair<R>>,
    velocity_b: Vector<Pair<R>>,
    samples: u32,
}

/// Why there is no alignment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum AlignmentError {
    /// No sample was given.
    Empty,
    /// Specific force or angular rate vanish, are not finite, or are parallel (as at a pole).
    Undetermined,
}

impl core::fmt::Display for AlignmentError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Empty => "there is no sample to align on",
            Self::Undetermined => {
                "specific force and angular rate do not determine an attitude: \
                 one vanishes, or they are parallel"
            }
        })
    }
}

impl core::error::Error for AlignmentError {}

impl<R: Scalar> Alignment<R> {
    /// Adds a sample.
    pub fn add(&mut self, sample: &Increment<R>) {
        self.angle_b.accumulate(sample.angle_b);
        self.velocity_b.accumulate(sample.velocity_b);
        self.samples = self.samples.saturating_add(1);
    }

    /// Mean angular rate (rad/s) and specific force (m/s²) for samples of an interval in seconds.
    pub fn mean(&self, interval_s: R) -> (Vector<R>, Vector<R>) {
        let per_second = R::ONE / (interval_s * R::count(self.samples.max(1)));
        (self.angle_b.value() * per_second, self.velocity_b.value() * per_second)
    }

    /// Roll and pitch, with a yaw that is known from elsewhere, rad.
    ///
    /// # Errors
    ///
    /// [`AlignmentError`] without samples, or if the vectors vanish, are not finite or are parallel.
    pub fn level(&self, yaw: R) -> Result<Euler<R>, AlignmentError> {
        if self.samples == 0 {
            return Err(AlignmentError::Empty);
        }
        let down = unit(-self.velocity_b.value(), R::of(1e-12))?;
        let cosine = (down.y * down.y + down.z * down.z).sqrt();
        // With the unit on end, roll and yaw are one angle; it is given as yaw.
        let upright = cosine > R::entry(1e-6, 1e-12);
        let roll = if upright { down.y.atan2(down.z) } else { R::ZERO };
        Ok(Euler { roll, pitch: (-down.x).atan2(cosine), yaw })
    }

    /// The attitude, rad.
    ///
    /// # Errors
    ///
    /// [`AlignmentError`] without samples, or if the vectors vanish, are not finite or are parallel.
    pub fn attitude(&self) -> Result<Euler<R>, AlignmentError> {
        if self.samples == 0 {
            return Err(AlignmentError::Empty);
        }
        // ẑⁿ = −fᵇ/|f|,  ŷⁿ = ẑⁿ × ω/|ẑⁿ × ω|,  x̂ⁿ = ŷⁿ × ẑⁿ
        let least = R::of(1e-12);
        let down = unit(-self.velocity_b.value(), least)?;
        let rate = unit(self.angle_b.value(), least)?;
        // Below this the product of parallel vectors is nothing but rounding.
        let east = unit(down.cross(rate), R::entry(1e-6, 1e-12))?;
        let north = east.cross(down);
        // The rows of C_bⁿ are north, east and down in body axes.
        let cosine = (down.y * down.y + down.z * down.z).sqrt();
        let roll = down.y.atan2(down.z);
        // With roll removed, the body's right axis is level, at ψ from east: ŷ = (0, cosγ, −sinγ) in body
        // axes and (−sinψ, cosψ, 0) in north, east, down. So roll and yaw are consistent even where the unit
        // stands on end and rounding decides the roll.
        let (sine, cosine_roll) = roll.sin_cos();
        Ok(Euler {
            roll,
            pitch: (-down.x).atan2(cosine),
            yaw: (north.z * sine - north.y * cosine_roll)
                .atan2(east.y * cosine_roll - east.z * sine),
        })
    }
}

/// The direction of a vector; `None` if it is too short to have one.
fn unit<R: Scalar>(v: Vector<R>, least: R) -> Result<Vector<R>, AlignmentError> {
    let norm = v.norm();
    if norm > least && norm.is_within(R::of(1e12)) {
        Ok(v * (R::ONE / norm))
    } else {
        Err(AlignmentError::Undetermined)
    }
}
