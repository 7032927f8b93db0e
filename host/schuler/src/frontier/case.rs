//! What is compared: algorithm and window, frame, precision, the source of functions.

use super::rates::{NavigateRates, OnRates};
use schuler::flight::catalogue::{Catalogue as _, Every};
use schuler::flight::configuration::Configuration;
use schuler::flight::plan::{self, Demand};
use schuler::math::coarse::Coarse;
use schuler::math::compensated::{Pair, Plain};
use schuler::solution::Solution;
use schuler::strapdown::block::window::NAMED;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook};
use schuler::trajectory::Bound;
use schuler_simulator::navigator::{self, COMPARED, Navigate, Unavailable};
use schuler_simulator::scene::{Algorithm, Axes, Navigator, Precision, WindowShape};
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

/// Arithmetic, how the state is summed up, and where functions come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Arithmetic {
    /// As `--precision` names it. Textbook and Runge-Kutta compensate nothing in any of them.
    Named(Precision),
    /// Double, sums without compensation.
    PlainDouble,
    /// Single, sums without compensation.
    PlainSingle,
    /// Single with micromath's rough functions.
    Coarse,
}

impl Arithmetic {
    /// Its name in the files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Named(precision) => precision.name(),
            Self::PlainDouble => "f64-plain",
            Self::PlainSingle => "f32-plain",
            Self::Coarse => Precision::F32.name(),
        }
    }

    /// Whether it is double precision.
    pub fn is_double(self) -> bool {
        matches!(self, Self::Named(Precision::F64) | Self::PlainDouble)
    }

    /// How many digits it has.
    fn precision(self) -> Precision {
        match self {
            Self::Named(precision) => precision,
            Self::PlainDouble => Precision::F64,
            Self::PlainSingle | Self::Coarse => Precision::F32,
        }
    }

    /// Where square roots and the functions of the start come from.
    pub fn math(self) -> &'static str {
        if self == Self::Coarse { "micromath" } else { "libm" }
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
        let (algorithm, shape) = match self.method {
            Method::RungeKutta => return self.start_on_rates(interval_s.hi, initial),
            Method::Textbook => (Algorithm::Textbook, plan::UNKNOWN),
            Method::Taylor(shape) => (Algorithm::Taylor, shape),
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
        let order = plan::order(&demand, shape);
        // Uncompensated, the interval too is one number.
        let (double, single) = (Pair::new(interval_s.hi), Pair::new(interval_s.hi as f32));
        let coarse = Pair::narrow(interval_s);
        let navigator = match (self.arithmetic, algorithm, self.frame) {
            (Arithmetic::Named(precision), ..) => {
                let frame = self.frame;
                let navigator = Navigator { algorithm, precision, frame, ..Default::default() };
                navigator::start(&navigator, shape, order, interval_s, initial)
            }
            (Arithmetic::PlainDouble, _, Axes::LocalLevel) => {
                navigator::taylor_compared::<LocalLevel<Plain<f64>>>(shape, order, double, initial)
            }
            (Arithmetic::PlainDouble, _, Axes::EarthFixed) => {
                navigator::taylor_compared::<EarthFixed<Plain<f64>>>(shape, order, double, initial)
            }
            (Arithmetic::PlainSingle, _, Axes::LocalLevel) => {
                navigator::taylor_compared::<LocalLevel<Plain<f32>>>(shape, order, single, initial)
            }
            (Arithmetic::PlainSingle, _, Axes::EarthFixed) => {
                navigator::taylor_compared::<EarthFixed<Plain<f32>>>(shape, order, single, initial)
            }
            (Arithmetic::Coarse, Algorithm::Textbook, Axes::LocalLevel) => {
                navigator::textbook::<LocalLevelTextbook<Coarse>>(coarse.hi, initial)
            }
            (Arithmetic::Coarse, Algorithm::Textbook, Axes::EarthFixed) => {
                navigator::textbook::<EarthFixedTextbook<Coarse>>(coarse.hi, initial)
            }
            (Arithmetic::Coarse, Algorithm::Taylor, Axes::LocalLevel) => {
                navigator::taylor_compared::<LocalLevel<Pair<Coarse>>>(
                    shape, order, coarse, initial,
                )
            }
            (Arithmetic::Coarse, Algorithm::Taylor, Axes::EarthFixed) => {
                navigator::taylor_compared::<EarthFixed<Pair<Coarse>>>(
                    shape, order, coarse, initial,
                )
            }
        };
        Ok(Craft::Increments(navigator?))
    }

    fn start_on_rates(
        &self,
        interval_s: f64,
        initial: &Solution<f64>,
    ) -> Result<Craft, Unavailable> {
        let navigator: Box<dyn NavigateRates> = match self.arithmetic {
            Arithmetic::Named(Precision::F64) | Arithmetic::PlainDouble => {
                Box::new(OnRates::<f64>::new(interval_s, initial)?)
            }
            Arithmetic::Coarse => Box::new(OnRates::<Coarse>::new(interval_s, initial)?),
            Arithmetic::Named(Precision::F32 | Precision::F32x2) | Arithmetic::PlainSingle => {
                Box::new(OnRates::<f32>::new(interval_s, initial)?)
            }
        };
        Ok(Craft::Rates(navigator))
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
