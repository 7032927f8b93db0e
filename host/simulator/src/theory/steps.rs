//! Steps of quantization that are too coarse to be noise.

use super::sources::{SENSORS, Sources};
use schuler::math::compensated::Pair;
use schuler::trajectory::Trajectory;

/// The rounding of a step is white noise where the signal crosses so many steps per sample, or noise
/// of so many steps shakes it: its next value then keeps e^{−2π²·½²} = 0.7 % of the last one.
const CROSSED: f64 = 2.0;
const SHAKEN: f64 = 0.5;
/// Instants at which a course's readings are looked at.
const LOOKS: u32 = 64;

/// Which sensors' steps are not crossed by what they should read.
pub fn coarse(
    trajectory: &impl Trajectory<f64>,
    sources: &Sources,
    duration_s: f64,
) -> [bool; SENSORS] {
    let interval_s = sources.sample_interval_s;
    let mut squares = [0.0; SENSORS];
    if sources.quantization == squares {
        return [false; SENSORS];
    }
    for look in 0..LOOKS {
        let time_s = duration_s * f64::from(look) / f64::from(LOOKS);
        let rates = trajectory.rates_at(Pair::new(time_s));
        let [x, y, z] = rates.rate_ib_b.into_array();
        let [u, v, w] = rates.specific_force_b.into_array();
        for (square, reading) in squares.iter_mut().zip([x, y, z, u, v, w]) {
            *square += reading * reading / f64::from(LOOKS);
        }
    }
    std::array::from_fn(|i| {
        let step = step(sources, i);
        let crossed = squares[i].sqrt() * interval_s >= CROSSED * step;
        let shaken = sources.noise_of_a_sample(i).sqrt() >= SHAKEN * step;
        step > 0.0 && !crossed && !shaken
    })
}

/// A sensor's step: Q² = step²/12.
pub fn step(sources: &Sources, sensor: usize) -> f64 {
    (12.0 * sources.quantization[sensor]).sqrt()
}
