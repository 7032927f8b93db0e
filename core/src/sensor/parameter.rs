//! Errors in parameters, and the checks that every constructor makes.
//!
//! ```
//! use schuler::sensor::Timing;
//! use schuler::sensor::parameter::{Fault, Parameter};
//!
//! let refused = Timing::new(0.0_f64, 1).unwrap_err();
//! assert_eq!((refused.parameter, refused.fault), (Parameter::Interval, Fault::NotPositive));
//! ```

use crate::math::quaternion::Matrix;
use crate::math::real::Scalar;
use crate::math::vector::Vector;
use core::error::Error;
use core::fmt::{self, Display, Formatter};

/// A parameter of a sensor model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Parameter {
    /// Sample interval.
    Interval,
    /// Number of samples in a run.
    Samples,
    /// Constant bias.
    Constant,
    /// Rms of the turn-on bias.
    TurnOnRms,
    /// Rms of a Gauss-Markov bias.
    GaussMarkovRms,
    /// Correlation time of a Gauss-Markov bias.
    CorrelationTime,
    /// Angle or velocity random walk.
    WhiteNoise,
    /// Rate or acceleration random walk.
    RandomWalk,
    /// Bias instability.
    BiasInstability,
    /// Scale factor error.
    ScaleFactor,
    /// Misalignment.
    Misalignment,
    /// g-sensitivity.
    GSensitivity,
    /// Largest output.
    Saturation,
    /// Least significant bit.
    Quantization,
    /// Misalignment of each axis.
    MisalignmentMatrix,
    /// g-sensitivity across axes.
    GSensitivityMatrix,
    /// Temperature and its rate.
    Temperature,
    /// How long the temperature changes.
    RampTime,
    /// Bias by temperature.
    TemperatureBias,
    /// Scale factor by temperature.
    TemperatureScale,
    /// Bandwidth.
    Bandwidth,
    /// Delay of the output.
    Latency,
    /// Time of an aiding sensor's first measurement.
    FirstTime,
    /// Jitter of a delay.
    Jitter,
    /// A probability.
    Probability,
    /// Size of an outlier.
    Outlier,
    /// Offset of a spoofed position, or its rate.
    Spoofing,
    /// Times between which a fault holds.
    FaultTimes,
    /// Lever arm.
    LeverArm,
    /// White noise of a measurement.
    MeasurementNoise,
    /// Standard deviation that a sensor claims.
    ClaimedSigma,
    /// Limit of a speed.
    SpeedLimit,
}

/// What is wrong with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Fault {
    /// Infinite, or not a number.
    NotFinite,
    /// Below zero.
    Negative,
    /// Zero or below.
    NotPositive,
    /// So large or small that the model's coefficients overflow.
    OutOfRange,
}

/// A parameter that is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ParameterError {
    /// Which one.
    pub parameter: Parameter,
    /// Of which axis: 0, 1, 2 for x, y, z; `None` if there is one value for all.
    pub axis: Option<u8>,
    /// The reason.
    pub fault: Fault,
}

impl Display for Parameter {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Interval => "sample interval",
            Self::Samples => "number of samples",
            Self::Constant => "constant bias",
            Self::TurnOnRms => "rms of the turn-on bias",
            Self::GaussMarkovRms => "rms of the Gauss-Markov bias",
            Self::CorrelationTime => "correlation time of the Gauss-Markov bias",
            Self::WhiteNoise => "white noise",
            Self::RandomWalk => "random walk of the bias",
            Self::BiasInstability => "bias instability",
            Self::ScaleFactor => "scale factor error",
            Self::Misalignment => "misalignment",
            Self::GSensitivity => "g-sensitivity",
            Self::Saturation => "saturation",
            Self::Quantization => "quantization",
            Self::MisalignmentMatrix => "misalignment of each axis",
            Self::GSensitivityMatrix => "g-sensitivity across axes",
            Self::Temperature => "temperature",
            Self::RampTime => "time of the temperature ramp",
            Self::TemperatureBias => "bias by temperature",
            Self::TemperatureScale => "scale factor by temperature",
            Self::Bandwidth => "bandwidth",
            Self::Latency => "latency",
            Self::FirstTime => "time of the first measurement",
            Self::Jitter => "jitter of the latency",
            Self::Probability => "probability",
            Self::Outlier => "size of an outlier",
            Self::Spoofing => "spoofing",
            Self::FaultTimes => "time of a fault",
            Self::LeverArm => "lever arm",
            Self::MeasurementNoise => "noise of a measurement",
            Self::ClaimedSigma => "claimed standard deviation",
            Self::SpeedLimit => "limit of the speed",
        })
    }
}

impl Display for ParameterError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        Display::fmt(&self.parameter, f)?;
        match self.axis {
            Some(0) => f.write_str(", axis x,")?,
            Some(1) => f.write_str(", axis y,")?,
            Some(_) => f.write_str(", axis z,")?,
            None => {}
        }
        f.write_str(match self.fault {
            Fault::NotFinite => " must be finite",
            Fault::Negative => " must not be negative",
            Fault::NotPositive => " must be positive",
            Fault::OutOfRange => " is too large or too small to compute with",
        })
    }
}

impl Error for ParameterError {}

/// What is wrong with a number that must be finite, if anything.
fn finite<R: Scalar>(x: R) -> Result<(), Fault> {
    // Infinity and NaN times zero are NaN.
    if x * R::ZERO == R::ZERO { Ok(()) } else { Err(Fault::NotFinite) }
}

fn at_least_zero<R: Scalar>(x: R) -> Result<(), Fault> {
    finite(x)?;
    if x < R::ZERO { Err(Fault::Negative) } else { Ok(()) }
}

fn above_zero<R: Scalar>(x: R) -> Result<(), Fault> {
    finite(x)?;
    if x > R::ZERO { Ok(()) } else { Err(Fault::NotPositive) }
}

impl Parameter {
    fn each<R: Scalar>(
        self,
        value: Vector<R>,
        check: fn(R) -> Result<(), Fault>,
    ) -> Result<Vector<R>, ParameterError> {
        for (axis, x) in (0..).zip(value.into_array()) {
            check(x).map_err(|fault| ParameterError {
                parameter: self,
                axis: Some(axis),
                fault,
            })?;
        }
        Ok(value)
    }

    /// A value per axis, of any sign.
    pub(super) fn signed<R: Scalar>(self, value: Vector<R>) -> Result<Vector<R>, ParameterError> {
        self.each(value, finite)
    }

    /// A row of values per axis, of any sign.
    pub(super) fn rows<R: Scalar>(self, value: Matrix<R>) -> Result<Matrix<R>, ParameterError> {
        for (axis, row) in (0..).zip(value.rows) {
            self.each(row, finite).map_err(|error| ParameterError { axis: Some(axis), ..error })?;
        }
        Ok(value)
    }

    /// A value per axis that is zero or more.
    pub(super) fn magnitude<R: Scalar>(
        self,
        value: Vector<R>,
    ) -> Result<Vector<R>, ParameterError> {
        self.each(value, at_least_zero)
    }

    /// A value per axis that is more than zero.
    pub(super) fn positive<R: Scalar>(self, value: Vector<R>) -> Result<Vector<R>, ParameterError> {
        self.each(value, above_zero)
    }

    /// A coefficient computed from checked values, which may exceed the range of the type.
    pub(super) fn computed<R: Scalar>(self, value: Vector<R>) -> Result<Vector<R>, ParameterError> {
        self.each(value, |x| finite(x).map_err(|_| Fault::OutOfRange))
    }

    /// One value for all axes that is more than zero.
    pub(super) fn single<R: Scalar>(self, value: R) -> Result<R, ParameterError> {
        above_zero(value).map_err(|fault| self.fault(fault))?;
        Ok(value)
    }

    /// One value for all axes that is zero or more.
    #[cfg(feature = "aiding")]
    pub(super) fn size<R: Scalar>(self, value: R) -> Result<R, ParameterError> {
        at_least_zero(value).map_err(|fault| self.fault(fault))?;
        Ok(value)
    }

    /// One value for all axes, of any sign.
    #[cfg(feature = "aiding")]
    pub(super) fn number<R: Scalar>(self, value: R) -> Result<R, ParameterError> {
        finite(value).map_err(|fault| self.fault(fault))?;
        Ok(value)
    }

    /// A probability.
    #[cfg(feature = "aiding")]
    pub(super) fn share<R: Scalar>(self, value: R) -> Result<R, ParameterError> {
        let value = self.size(value)?;
        if value > R::ONE { Err(self.fault(Fault::OutOfRange)) } else { Ok(value) }
    }

    /// An error of all axes.
    pub(super) fn fault(self, fault: Fault) -> ParameterError {
        ParameterError { parameter: self, axis: None, fault }
    }
}
