//! First-order Gauss-Markov bias: ḃ = −b/T + w, equations (5) and (7) of the paper, (7) with the correct sign.
//!
//! The bias at a sample's end and its integral over the sample are drawn jointly, so their statistics do not
//! depend on the sample rate. The initial value is drawn from the stationary distribution.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::noise::Streams;
//! use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing, gauss_markov::GaussMarkov};
//!
//! let timing = Timing::new(0.01_f64, 1000)?;
//! let axes = |x| Vector::new(x, x, x);
//! let term = GaussMarkov::new(axes(1e-3), axes(100.0), timing)?;
//! let mut state = term.start(Streams::new(1, 0));
//! let truth = Vector::new(0.02_f64, 0.0, 0.0);
//! let stimulus = Stimulus { sensed: truth, velocity_b: Vector::new(0.0, 0.0, -0.098) };
//! let mut reading = Reading::new(truth);
//! term.apply(&mut state, &stimulus, &mut reading);
//! assert!((reading.increment - truth).norm() < 1e-4);
//! # Ok::<(), schuler::sensor::parameter::ParameterError>(())
//! ```

use super::parameter::{Parameter, ParameterError};
use super::{ErrorTerm, Reading, Stimulus, Timing};
use crate::math::vector::Vector;
use crate::noise::random::{Axes, Random};
use crate::noise::{Deviate, Streams};
use crate::record::{Record, record};

/// One Gauss-Markov process of rms σ and correlation time T, advanced by an interval Δt.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Process<R> {
    rms: R,
    decay: R,
    drive: R,
    integral: R,
    coupled: R,
    independent: R,
}

impl<R: Deviate> Process<R> {
    /// From σ and T, s, which are not checked.
    pub fn new(rms: R, correlation_s: R, interval_s: R) -> Self {
        // x = Δt/T,  u = 1 − e⁻ˣ
        let x = interval_s / correlation_s;
        let u = -(-x).exp_m1();
        let rest = R::TWO - u;
        let area = rms * correlation_s;
        Self {
            rms,
            decay: u,
            // σ√(u(2−u))
            drive: rms * (u * rest).sqrt(),
            integral: correlation_s * u,
            // σTu²/√(u(2−u))
            coupled: area * u * (u / rest).sqrt(),
            // σT√(2x − 4tanh(x/2))
            independent: area * remainder(x, u).sqrt(),
        }
    }

    /// A number that is finite if and only if every coefficient is.
    pub(super) fn extent(&self) -> R {
        self.rms + self.drive + self.integral + self.coupled + self.independent
    }
}

impl<R: Copy> Process<R> {
    /// The same process in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> Process<T> {
        Process {
            rms: number(self.rms),
            decay: number(self.decay),
            drive: number(self.drive),
            integral: number(self.integral),
            coupled: number(self.coupled),
            independent: number(self.independent),
        }
    }
}

impl<R: Random> Process<R> {
    /// A value from its stationary distribution, b₀ = σz.
    #[inline]
    pub fn start(&self, stream: &mut R::Stream) -> R {
        self.rms * R::deviate(stream)
    }

    /// Advances the value by the interval, and returns its integral over it.
    #[inline(always)]
    pub fn advance(&self, value: &mut R, stream: &mut R::Stream) -> R {
        let (first, second) = (R::deviate(stream), R::deviate(stream));
        // ∫b = Tu b₀ + σTu²/√(u(2−u))·z₁ + σT√(2x − 4tanh(x/2))·z₂
        let integral = self.integral * *value + (self.coupled * first + self.independent * second);
        // b₁ = b₀ − u b₀ + σ√(u(2−u))·z₁: in single precision 1 − u would lose u's digits
        *value = *value + (self.drive * first - self.decay * *value);
        integral
    }
}

/// 2x − 4tanh(x/2), given u = 1 − e⁻ˣ.
fn remainder<R: Deviate>(x: R, u: R) -> R {
    // The difference cancels for small x: relative error of the series ≤ 1e-12 up to 0.03 and
    // ≤ 1e-6 up to 0.3, where the difference is as good in double and in single precision.
    if x < R::entry(0.3, 0.03) {
        // x³/6 − x⁵/60 + 17x⁷/10080
        let square = x * x;
        let factor =
            R::of(1.0 / 6.0) + square * (R::of(-1.0 / 60.0) + square * R::of(17.0 / 10080.0));
        square * x * factor
    } else {
        // tanh(x/2) = u/(2 − u)
        R::TWO * x - R::of(4.0) * (u / (R::TWO - u))
    }
}

/// A Gauss-Markov bias on each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GaussMarkov<R> {
    axes: [Process<R>; 3],
}

/// The bias and its random numbers.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GaussMarkovState<R: Random> {
    /// The bias at the end of the last sample, angle/s.
    pub bias: Vector<R>,
    streams: Axes<R>,
}

impl<R: Deviate> GaussMarkov<R> {
    /// From the rms of each axis, angle/s, and its correlation time, s.
    ///
    /// # Errors
    ///
    /// [`ParameterError`] if an rms is negative, a correlation time is not positive, or either is not finite.
    pub fn new(
        rms: Vector<R>,
        correlation_s: Vector<R>,
        timing: Timing<R>,
    ) -> Result<Self, ParameterError> {
        let rms = Parameter::GaussMarkovRms.magnitude(rms)?;
        let correlation_s = Parameter::CorrelationTime.positive(correlation_s)?;
        Parameter::GaussMarkovRms.computed(rms.zip(correlation_s, |s, t| s * t))?;
        let axes = rms.zip(correlation_s, |s, t| Process::new(s, t, timing.interval_s()));
        let Vector { x, y, z } = axes;
        Parameter::CorrelationTime.computed(Vector::new(x.extent(), y.extent(), z.extent()))?;
        Ok(Self { axes: [x, y, z] })
    }
}

impl<R: Copy> GaussMarkov<R> {
    /// The same term in numbers of another type, as `number` makes them from these.
    pub fn map<T>(&self, number: impl Fn(R) -> T) -> GaussMarkov<T> {
        GaussMarkov { axes: self.axes.map(|process| process.map(&number)) }
    }
}

impl<R: Random> ErrorTerm<R> for GaussMarkov<R> {
    type State = GaussMarkovState<R>;

    #[inline]
    fn start(&self, streams: Streams) -> GaussMarkovState<R> {
        let mut state = GaussMarkovState { bias: Vector::ZERO, streams: Axes::open(streams) };
        let GaussMarkovState { bias, streams } = &mut state;
        for ((bias, process), stream) in
            bias.each_mut().into_iter().zip(&self.axes).zip(streams.each_mut())
        {
            *bias = process.start(stream);
        }
        state
    }

    #[inline(always)]
    fn apply(&self, state: &mut Self::State, _: &Stimulus<R>, reading: &mut Reading<R>) {
        let GaussMarkovState { bias, streams } = state;
        let ([x, y, z], [along_x, along_y, along_z]) = (streams.each_mut(), &self.axes);
        let integral = Vector {
            x: along_x.advance(&mut bias.x, x),
            y: along_y.advance(&mut bias.y, y),
            z: along_z.advance(&mut bias.z, z),
        };
        reading.increment = reading.increment + integral;
    }
}

impl<R: Random> Record for GaussMarkovState<R> {
    record!(bias, streams);
}
