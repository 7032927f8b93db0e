//! What is compared: algorithm and window, frame, precision, the source of functions.

use schuler::flight::catalogue::{Catalogue as _, Every};
use schuler::flight::configuration::Configuration;
use schuler::flight::plan::{self, Demand};
use schuler::math::compensated::Pair;
use schuler::solution::Solution;
use schuler::strapdown::block::window::NAMED;
use schuler::trajectory::Bound;
use schuler_simulator::navigator::compared::{self, Arithmetic, COMPARED};
use schuler_simulator::navigator::rates::{self, NavigateRates};
use schuler_simulator::navigator::{Navigate, Unavailable};
use schuler_simulator::scene::{Algorithm, Axes, Precision, WindowShape};
use std::fmt;

/// How samples are integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Single plus previous sample.
    Textbook,
    /// A window of samples.
    Taylor(WindowShape),
    /// Classical Runge-Kutta on instantaneous rates; a step and a row for every two samples.
    RungeKutta,
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Textbook => f.write_str(Algorithm::Textbook.name()),
            Self::Taylor(window) => write!(f, "{} {window}", Algorithm::Taylor),
            Self::RungeKutta => f.write_str("rk4"),
        }
    }
}

/// One way to navigate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// How samples are integrated.
    pub method: Method,
    /// Axes of the mechanization.
    pub frame: Axes,
    /// Arithmetic.
    pub arithmetic: Arithmetic,
}

impl Case {
    /// Every one that there is.
    pub fn all() -> Vec<Self> {
        use Arithmetic::{Coarse, Named, PlainDouble, PlainSingle};
        let uncompensated = [Named(Precision::F64), Named(Precision::F32), Coarse];
        let case = |method, frame| move |arithmetic| Self { method, frame, arithmetic };
        let mut all: Vec<_> = uncompensated.map(case(Method::RungeKutta, Axes::EarthFixed)).into();
        for &(_, frame) in Axes::NAMES {
            all.extend(uncompensated.map(case(Method::Textbook, frame)));
            let precisions_of = |shape: WindowShape| {
                let taylor = move |precision| Configuration {
                    precision,
                    axes: frame,
                    algorithm: Algorithm::Taylor,
                    window: shape,
                };
                Precision::NAMES.iter().filter(move |(_, p)| Every::has(&taylor(*p)))
            };
            for &shape in NAMED {
                let taylor = case(Method::Taylor(shape), frame);
                let (two_float, others): (Vec<_>, Vec<_>) = precisions_of(shape)
                    .map(|&(_, precision)| precision)
                    .partition(|&precision| precision == Precision::F32x2);
                all.extend(others.into_iter().map(Named).map(taylor));
                if COMPARED.contains(&shape) {
                    all.extend([PlainDouble, PlainSingle, Coarse].map(taylor));
                }
                all.extend(two_float.into_iter().map(Named).map(taylor));
            }
        }
        all
    }

    /// Whether its functions are micromath's.
    pub fn is_coarse(&self) -> bool {
        self.arithmetic == Arithmetic::Coarse
    }

    /// The algorithm's name in the files.
    pub fn algorithm(&self) -> &'static str {
        match self.method {
            Method::Textbook => Algorithm::Textbook.name(),
            Method::Taylor(_) => Algorithm::Taylor.name(),
            Method::RungeKutta => "rk4",
        }
    }

    /// History, block and look-ahead as `--window` takes them; empty without a window.
    pub fn window(&self) -> String {
        match self.method {
            Method::Taylor(window) => window.to_string(),
            Method::Textbook | Method::RungeKutta => String::new(),
        }
    }

    /// Starts it, for a motion within bounds.
    pub fn start(
        &self,
        rate_hz: f64,
        bound: Bound<f64>,
        initial: &Solution<f64>,
    ) -> Result<Craft, Unavailable> {
        let interval_s = Pair::new(rate_hz).reciprocal();
        let window = match self.method {
            Method::RungeKutta => {
                let navigator = rates::start(self.arithmetic, interval_s.hi, initial)?;
                return Ok(Craft::Rates(navigator));
            }
            Method::Textbook => None,
            Method::Taylor(shape) => Some(shape),
        };
        let demand = Demand {
            bandwidth: bound.bandwidth,
            angular_rate: bound.angular_rate,
            // No order depends on it.
            speed: 0.0,
            interval_s: interval_s.hi,
            precision: self.arithmetic.precision(),
            axes: self.frame,
        };
        let order = plan::order(&demand, window.unwrap_or(plan::UNKNOWN));
        let navigator =
            compared::start(self.arithmetic, self.frame, window, order, interval_s, initial)?;
        Ok(Craft::Increments(navigator))
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} {}", self.method, self.frame.name(), self.arithmetic.name())?;
        match self.arithmetic {
            Arithmetic::Coarse => write!(f, " {}", self.arithmetic.math()),
            _ => Ok(()),
        }
    }
}

/// A case in flight.
pub enum Craft {
    /// On increments.
    Increments(Box<dyn Navigate>),
    /// On instantaneous rates.
    Rates(Box<dyn NavigateRates>),
}
