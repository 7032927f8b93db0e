//! Navigators in arithmetics that are there to be compared with.

use super::flying::Flying;
use super::{Navigate, Unavailable, start as start_named};
use crate::scene::{Algorithm, Axes, Navigator, Precision, WindowShape};
use schuler::flight::configuration::Configuration;
use schuler::math::coarse::Coarse;
use schuler::math::compensated::{Pair, Plain};
use schuler::math::real::Scalar;
use schuler::record::Record;
use schuler::solution::Solution;
use schuler::strapdown::block::any_window::AnyWindow;
use schuler::strapdown::block::window::*;
use schuler::strapdown::frame::Frame;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::navigator::selected::Selected;
use schuler::strapdown::reference::textbook::{
    EarthFixedTextbook, LocalLevelTextbook, Textbook, TextbookFrame,
};

/// Arithmetic, how the state is summed up, and where functions come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
        self.precision() == Precision::F64
    }

    /// How many digits it has.
    pub fn precision(self) -> Precision {
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

/// Starts a navigator in some arithmetic, with a series of at most this order. The textbook has no window.
pub fn start(
    arithmetic: Arithmetic,
    axes: Axes,
    window: Option<WindowShape>,
    order: usize,
    interval_s: Pair<f64>,
    initial: &Solution<f64>,
) -> Result<Box<dyn Navigate>, Unavailable> {
    // Uncompensated, the interval too is one number.
    let (double, single) = (Pair::new(interval_s.hi), Pair::new(interval_s.hi as f32));
    let coarse = Pair::narrow(interval_s);
    match (arithmetic, window, axes) {
        (Arithmetic::Coarse, None, Axes::LocalLevel) => {
            textbook::<LocalLevelTextbook<Coarse>>(coarse.hi, initial)
        }
        (Arithmetic::Coarse, None, Axes::EarthFixed) => {
            textbook::<EarthFixedTextbook<Coarse>>(coarse.hi, initial)
        }
        (Arithmetic::Coarse, Some(shape), Axes::LocalLevel) => {
            taylor::<LocalLevel<Pair<Coarse>>>(shape, order, coarse, initial)
        }
        (Arithmetic::Coarse, Some(shape), Axes::EarthFixed) => {
            taylor::<EarthFixed<Pair<Coarse>>>(shape, order, coarse, initial)
        }
        (Arithmetic::PlainDouble, Some(shape), Axes::LocalLevel) => {
            taylor::<LocalLevel<Plain<f64>>>(shape, order, double, initial)
        }
        (Arithmetic::PlainDouble, Some(shape), Axes::EarthFixed) => {
            taylor::<EarthFixed<Plain<f64>>>(shape, order, double, initial)
        }
        (Arithmetic::PlainSingle, Some(shape), Axes::LocalLevel) => {
            taylor::<LocalLevel<Plain<f32>>>(shape, order, single, initial)
        }
        (Arithmetic::PlainSingle, Some(shape), Axes::EarthFixed) => {
            taylor::<EarthFixed<Plain<f32>>>(shape, order, single, initial)
        }
        (Arithmetic::Named(_), ..) | (_, None, _) => {
            let algorithm = if window.is_some() { Algorithm::Taylor } else { Algorithm::Textbook };
            let shape = window.unwrap_or(Configuration::ONE_SAMPLE);
            let precision = arithmetic.precision();
            let navigator = Navigator { algorithm, precision, frame: axes, ..Default::default() };
            start_named(&navigator, shape, order, interval_s, initial)
        }
    }
}

macro_rules! compared {
    ($($window:ident),+) => {
        /// The windows that are compared in every arithmetic.
        pub const COMPARED: &[WindowShape] = &[$($window::SHAPE),+];

        fn taylor<F>(
            shape: WindowShape,
            order: usize,
            interval_s: Pair<F::Real>,
            initial: &Solution<f64>,
        ) -> Result<Box<dyn Navigate>, Unavailable>
        where
            F: Frame<Real: Scalar + Send> + Record + Send + 'static,
        {
            $(if shape == $window::SHAPE {
                let window = AnyWindow::of::<$window>();
                let selected = Selected::<F>::new(interval_s, window)?.with_order(order);
                return Ok(Flying::boxed(selected, interval_s, initial)?);
            })+
            Err(Unavailable::Window { shape, of: "the comparison", accepted: COMPARED.into() })
        }
    };
}
schuler::windows_of! { compared compared! }

fn textbook<F>(
    interval_s: F::Real,
    initial: &Solution<f64>,
) -> Result<Box<dyn Navigate>, Unavailable>
where
    F: TextbookFrame<Real: Scalar + Send> + Record + Send + 'static,
{
    Ok(Flying::boxed(Textbook::<F>::new(interval_s)?, Pair::new(interval_s), initial)?)
}
