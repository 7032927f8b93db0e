//! Whether a vehicle stands still, by the scatter of its samples.
//!
//! At rest the readings of n samples scatter about their mean by nothing but the sensors' noise. The sum of the squared
//! deviations by the noise's variance then has a χ² distribution of 6(n − 1) degrees of freedom; a vehicle that
//! moves shakes, turns and accelerates, and exceeds its quantile. Biases and the Earth's rate are in the mean.
//! This is the generalised likelihood ratio of any steady reading against any reading at all.
//! Source: Skog et al., IEEE Trans. Biomedical Engineering 57 (2010), 2657.
//!
//! A vehicle that moves without any change passes for one at rest; a filter refuses its zero velocity then, if it knows
//! better.
//!
//! ```
//! use schuler::aiding::standstill::{Standstill, Stillness};
//! use schuler::math::vector::Vector;
//! use schuler::sample::Increment;
//!
//! let detector = Standstill::new(10, 0.01_f64, 3e-5, 8e-4, 1e-3).unwrap();
//! let mut state = Stillness::default();
//! let mut said = None;
//! for k in 0..10 {
//!     let shaken = if k % 2 == 0 { 1e-3 } else { -1e-3 };
//!     let sample = Increment {
//!         angle_b: Vector::ZERO,
//!         velocity_b: Vector::new(shaken, 0.0, -0.098),
//!     };
//!     said = detector.push(&mut state, &sample);
//! }
//! assert_eq!(said, Some(false));
//! ```

use super::chi_square::quantile;
use crate::math::real::{Real, Scalar};
use crate::math::vector::Vector;
use crate::record::{Record, record};
use crate::sample::Increment;

/// Samples of a window at most.
const MOST: u32 = 4096;

/// A detector: configuration.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Standstill<R> {
    window: u32,
    /// 1/(N²Δt) of gyros and accelerometers.
    weights: [R; 2],
    limit: R,
}

/// Sums over the samples of a window, relative to the first, to keep digits.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stillness<R> {
    count: u32,
    first: [Vector<R>; 2],
    sums: [Vector<R>; 2],
    squares: [R; 2],
    /// The statistic of the last window by its degrees of freedom; 0 before the first.
    ratio: R,
}

impl<R: Real> Default for Stillness<R> {
    fn default() -> Self {
        Self {
            count: 0,
            first: [Vector::ZERO; 2],
            sums: [Vector::ZERO; 2],
            squares: [R::ZERO; 2],
            ratio: R::ZERO,
        }
    }
}

impl<R: Real> Stillness<R> {
    /// The scatter of the last window by what noise alone gives: about 1 at rest.
    pub fn ratio(&self) -> R {
        self.ratio
    }
}

impl<R: Scalar> Standstill<R> {
    /// For windows of so many samples of an interval, s, with the sensors' angle random walk, rad/√s, and velocity
    /// random walk, m/s/√s. A window at rest is taken for motion as often as `false_alarm` says. `None` if there
    /// are fewer than two samples or more than 4096, or a number is not above 0.
    pub fn new(
        window: u32,
        interval_s: R,
        gyro_noise: R,
        accelerometer_noise: R,
        false_alarm: R,
    ) -> Option<Self> {
        let positive = |x: R| x > R::ZERO && x.is_within(R::of(1e6));
        let sound = (2..=MOST).contains(&window)
            && [interval_s, gyro_noise, accelerometer_noise, false_alarm].into_iter().all(positive)
            && false_alarm < R::HALF;
        let weight = |noise: R| R::ONE / (noise * noise * interval_s);
        sound.then(|| Self {
            window,
            weights: [weight(gyro_noise), weight(accelerometer_noise)],
            limit: quantile(false_alarm, Self::degrees(window)),
        })
    }

    /// Degrees of freedom.
    fn degrees(window: u32) -> u32 {
        6 * (window - 1)
    }

    /// Takes a sample. At the end of a window it says whether the vehicle stood still in it.
    pub fn push(&self, state: &mut Stillness<R>, sample: &Increment<R>) -> Option<bool> {
        let read = [sample.angle_b, sample.velocity_b];
        if state.count == 0 {
            *state = Stillness { first: read, ratio: state.ratio, ..Stillness::default() };
        }
        let Stillness { count, first, sums, squares, .. } = state;
        for (((read, first), sum), square) in
            read.iter().zip(first).zip(&mut *sums).zip(&mut *squares)
        {
            let x = *read - *first;
            *sum = *sum + x;
            *square = *square + x.dot(x);
        }
        *count += 1;
        if *count < self.window {
            return None;
        }
        // Σ(x − x̄)² = Σx² − (Σx)²/n
        let inverse = R::ONE / R::count(self.window);
        let mut scatter = R::ZERO;
        for ((sum, square), weight) in sums.iter().zip(squares).zip(self.weights) {
            scatter = scatter + (*square - sum.dot(*sum) * inverse) * weight;
        }
        (state.count, state.ratio) = (0, scatter / R::count(Self::degrees(self.window)));
        Some(scatter < self.limit)
    }
}

impl<R: Record> Record for Stillness<R> {
    record!(count, first, sums, squares, ratio);
}
