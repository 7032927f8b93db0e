//! Samples of all runs, packed into lanes and unpacked.

use super::pack::Lanes;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use std::array;

/// The samples of all runs as one.
#[inline]
pub fn pack<P: Lanes<N>, const N: usize>(samples: &[Increment<f64>; N]) -> Increment<P> {
    let join = |part: fn(&Increment<f64>) -> Vector<f64>| {
        let parts = samples.each_ref().map(part);
        Vector {
            x: P::from_lanes(parts.map(|v| v.x)),
            y: P::from_lanes(parts.map(|v| v.y)),
            z: P::from_lanes(parts.map(|v| v.z)),
        }
    };
    Increment { angle_b: join(|s| s.angle_b), velocity_b: join(|s| s.velocity_b) }
}

/// The same where a lane's sample is replaced by that of another.
pub fn replaced<P: Lanes<N>, const N: usize>(
    sample: &Increment<P>,
    lane: usize,
    by: usize,
) -> Increment<P> {
    let mut samples = unpack(sample);
    samples[lane] = samples[by];
    pack(&samples)
}

/// The sample of every run.
pub(super) fn unpack<P: Lanes<N>, const N: usize>(sample: &Increment<P>) -> [Increment<f64>; N] {
    array::from_fn(|run| Increment {
        angle_b: sample.angle_b.map(|x| x.lanes()[run]),
        velocity_b: sample.velocity_b.map(|x| x.lanes()[run]),
    })
}
