//! Limits of the linear error model: errors that are too large, and quantization that is too coarse.

use super::moments::Moments;
use super::sources::{SENSORS, Sources};
use super::steps::step;
use crate::number::{Quantity, rounded};
use crate::units::{ARCSECOND, DEGREE};
use schuler::earth::EQUATORIAL_GRAVITY;
use std::fmt::{self, Display, Formatter};

/// Rotations above this are not small, rad: sin ψ = ψ(1 − ψ²/6), cos ψ = 1 − ψ²/2 and the errors that
/// come on top of them are off by ψ/2 of themselves, 5 %.
const LARGEST_ROTATION: f64 = 0.1;
/// Drift up to which the Earth's field and curvature are linear enough, m.
const FARTHEST_M: f64 = 2e5;
/// Second-order terms above this share of what is expected are too large, in a single run.
pub const SHARE: f64 = 0.1;
/// Less than this is nobody's concern, m and m/s.
const LEAST: [f64; 2] = [1e-6, 1e-8];
/// Steps matter above this share of the standard deviation.
const STEPS_SHARE: f64 = 0.3;
/// Errors of attitude act on velocity for so long at most: Schuler's period over 2π, s.
const SCHULER_S: f64 = 806.0;

/// What the linear error model does not know.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outside {
    /// A rotation that is not small, rad.
    Rotation(f64),
    /// Neglected terms: their size, and the standard deviation (or the mean) beside it; m or m/s.
    SecondOrder(Quantity, f64, f64),
    /// A drift over which the Earth is not flat, m.
    Position(f64),
    /// A step of the gyros that their motion does not cross, rad.
    GyroStep(f64),
    /// A step of the accelerometers that their motion does not cross, m/s.
    AccelerometerStep(f64),
    /// The sampling jitters.
    Jitter,
    /// The path goes over a pole.
    Pole,
    /// Navigation begins with an alignment.
    Aligned,
    /// Sensors were at their limit, or samples lost.
    Samples,
}

impl Display for Outside {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rotation(rad) => {
                let degrees = rounded(rad / DEGREE, 3);
                write!(f, "attitude errors of {degrees}° are no small rotations")
            }
            Self::SecondOrder(quantity, size, beside) => {
                let (size, beside) = (quantity.show(*size), quantity.show(*beside));
                write!(f, "second-order terms of attitude come to {size} beside {beside}")
            }
            Self::Position(m) => {
                write!(f, "{} of drift is beyond it", Quantity::Position.show(*m))
            }
            Self::GyroStep(rad) => {
                let step = rounded(rad / ARCSECOND, 4);
                write!(f, "gyro steps of {step}″ are coarse against the motion")
            }
            Self::AccelerometerStep(m_s) => {
                let step = rounded(*m_s, 4);
                write!(f, "accelerometer steps of {step} m/s are coarse against the motion")
            }
            Self::Jitter => f.write_str("the sampling jitters"),
            Self::Pole => f.write_str("the path goes over a pole, where north turns round"),
            Self::Aligned => f.write_str("an alignment comes before navigation"),
            Self::Samples => f.write_str("samples were saturated or lost"),
        }
    }
}

/// Which of the nine numbers second-order terms shift by more than a share of their σ. The vertical, say,
/// feels a tilt by its square alone: theory's σ of it may be nothing beside that.
pub fn shifted(moments: &Moments, share: f64) -> [bool; 9] {
    let second = moments.second.into_array();
    std::array::from_fn(|i| second[i].abs() > share * moments.covariance[i][i].max(0.0).sqrt())
}

/// What ends the model where the moments are these, a time after the start; `share` is what
/// second-order terms may come to.
pub fn outside(
    moments: &Moments,
    sources: &Sources,
    coarse: &[bool; SENSORS],
    time_s: f64,
    share: f64,
) -> Option<Outside> {
    let (mean, second) = (&moments.mean, &moments.second);
    let variance = |i: usize| moments.covariance[i][i].max(0.0);
    let sigma = |from: usize| (from..from + 3).map(variance).sum::<f64>().sqrt();
    let rotation = mean.attitude.norm().hypot(sigma(6));
    if rotation > LARGEST_ROTATION {
        return Some(Outside::Rotation(rotation));
    }
    let position = mean.position.norm() + sigma(0);
    if position > FARTHEST_M {
        return Some(Outside::Position(position));
    }
    let groups = [
        (Quantity::Position, 0, mean.position, second.position),
        (Quantity::Velocity, 3, mean.velocity, second.velocity),
    ];
    for ((quantity, from, mean, second), least) in groups.into_iter().zip(LEAST) {
        let size = second.norm();
        let beside = if sigma(from) > 0.0 { sigma(from) } else { mean.norm() };
        if size > least && size > share * beside {
            return Some(Outside::SecondOrder(quantity, size, beside));
        }
    }
    // A step that is not crossed stays, up to the time over which its effect comes back.
    let stays_s = time_s.min(SCHULER_S);
    let [position, velocity, attitude] = [sigma(0), sigma(3), sigma(6)];
    for sensor in (0..SENSORS).filter(|&sensor| coarse[sensor]) {
        let error = sources.quantization[sensor].sqrt();
        let is_gyro = sensor < 3;
        let matters = if is_gyro {
            error > STEPS_SHARE * attitude
                || error * EQUATORIAL_GRAVITY * stays_s > STEPS_SHARE * velocity
        } else {
            error > STEPS_SHARE * velocity || error * stays_s > STEPS_SHARE * position
        };
        if matters {
            let step = step(sources, sensor);
            let outside = if is_gyro { Outside::GyroStep } else { Outside::AccelerometerStep };
            return Some(outside(step));
        }
    }
    None
}
