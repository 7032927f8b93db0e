//! The smooth step: a change from one value to another with six continuous derivatives.
//!
//! S(x) = x⁷ Σ_{j=0..6} C(6+j, j) C(13, 6−j) (−x)ʲ, which is ∫₀ˣ 12012 ξ⁶(1−ξ)⁶ dξ: 0 before x = 0, 1 after
//! x = 1. Its integral over the step is ½, its steepest slope 12012/2¹² ≈ 2.93.
//! Source: the Hermite polynomial that matches 0 and 1 to order 6; Ebert et al., *Texturing and Modeling*, §2
//! has its lower orders.
//!
//! ```
//! use schuler::trajectory::segment::step::Step;
//!
//! // From 10 s to 14 s, by 3.
//! let step = Step { start_s: 10.0, duration_s: 4.0, change: 3.0 };
//! let at = |time_s| step.series::<3>(time_s, time_s).value();
//! assert_eq!([at(9.0), at(12.0), at(15.0)], [0.0, 1.5, 3.0]);
//! ```

use crate::trajectory::series::Series;

/// The steepest slope of a step of 1 over a unit of time.
pub const STEEPEST: f64 = 12012.0 / 4096.0;

/// A change by `change` that begins at a time and lasts for another.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Step {
    /// When it begins, s.
    pub start_s: f64,
    /// How long it lasts, s.
    pub duration_s: f64,
    /// What it adds in the end, in the unit of what changes.
    pub change: f64,
}

impl Step {
    /// No change.
    pub const NONE: Self = Self { start_s: 0.0, duration_s: 0.0, change: 0.0 };

    /// When it ends, s.
    pub fn end_s(&self) -> f64 {
        self.start_s + self.duration_s
    }

    /// Whether it goes on at a time, s.
    pub fn is_active(&self, time_s: f64) -> bool {
        self.change != 0.0 && self.start_s < time_s && time_s < self.end_s()
    }

    /// Its Taylor coefficients about a time, s: those of the polynomial that holds at the time `inside_s`.
    pub fn series<const N: usize>(&self, time_s: f64, inside_s: f64) -> Series<N> {
        if inside_s >= self.end_s() {
            return Series::constant(self.change);
        }
        if !self.is_active(inside_s) {
            return Series::ZERO;
        }
        // b = x(1 − x) about the time: both factors are exact at either end, so b is 0 there.
        let slope = 1.0 / self.duration_s;
        let (x, y) = ((time_s - self.start_s) * slope, (self.end_s() - time_s) * slope);
        let mut b = Series::constant(x * y);
        b.set(1, (y - x) * slope);
        b.set(2, -slope * slope);
        // S' = 12012 b⁶/T
        let square = b * b;
        let power = square * square * square;
        let mut step = power.scaled(12012.0 * slope).integral();
        step.set(0, if x < y { head(x) } else { 1.0 - head(y) });
        step.scaled(self.change)
    }
}

/// S(x) for x ≤ ½.
fn head(x: f64) -> f64 {
    const TERMS: [f64; 7] = [1716.0, -9009.0, 20020.0, -24024.0, 16380.0, -6006.0, 924.0];
    let cube = x * x * x;
    TERMS.iter().rev().fold(0.0, |sum, c| sum * x + c) * cube * cube * x
}
