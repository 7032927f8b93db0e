//! The core's navigators behind one interface: frame, precision, algorithm and window are chosen at run time.

mod available;
mod flying;

pub use available::{Unavailable, check, terms};
pub use flying::{finish, push};

use flying::Flying;

use crate::flight::Edges;
use crate::lanes::abreast::Refused;
use crate::scene::{Algorithm, Frame, Navigator, Precision, WindowShape};
use schuler::math::compensated::{Pair, TwoFloat};
use schuler::math::real::Scalar;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::block::unequal::Unequal;
use schuler::strapdown::block::window::*;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::limits::Rejected;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::plan::Shape;
use schuler::strapdown::reference::textbook::{
    EarthFixedTextbook, LocalLevelTextbook, Textbook, TextbookFrame,
};

/// Who reads rows: how many samples lie behind the row, and the navigation there.
pub type Reader<'a> = dyn FnMut(u64, &Solution<f64>) + 'a;

/// A navigator in flight. Samples come in double precision and are narrowed with a carried rest.
pub trait Navigate: Send {
    /// Takes a sample, and reads the rows that it completes.
    fn push(&mut self, sample: &Increment<f64>, read: &mut Reader) -> Result<(), Rejected>;
    /// Takes a sample of an interval of its own in seconds, and reads the rows that it completes.
    fn push_over(
        &mut self,
        sample: &Increment<f64>,
        interval_s: f64,
        read: &mut Reader,
    ) -> Result<(), Rejected>;
    /// Takes samples without reading a row; stops before one that is refused.
    fn fly(&mut self, samples: &[Increment<f64>]) -> Result<(), Refused>;
    /// Navigation at the end of the last block.
    fn solution(&self) -> Solution<f64>;
    /// Completes the rows that wait for samples.
    fn finish(&mut self, read: &mut Reader);
    /// Sets height and vertical velocity at the end of the last block.
    fn hold_vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Result<(), Rejected>;
    /// Samples integrated so far.
    fn integrated(&self) -> u64;
    /// How long the windows at the edges were so far; `None` for textbook.
    fn edges(&self) -> Option<Edges>;
    /// Digest of every state so far.
    fn digest(&self) -> u64;
    /// Flies samples from the start again, after those `before`, without reading a row: what a stage
    /// costs. Only what comes after `before` is flown each time that it is called.
    fn fly_unread(
        &self,
        before: &[Increment<f64>],
        samples: &[Increment<f64>],
    ) -> Box<dyn FnMut() + '_>;
}

/// Starts the navigator that is asked for, with the window and the order of series that are given.
pub fn start(
    navigator: &Navigator,
    shape: WindowShape,
    order: usize,
    interval_s: Pair<f64>,
    initial: &Solution<f64>,
) -> Result<Box<dyn Navigate>, Unavailable> {
    let single = Pair::narrow(interval_s);
    let boxed = match (navigator.algorithm, navigator.precision, navigator.frame) {
        (Algorithm::Textbook, Precision::F64, Frame::LocalLevel) => {
            textbook::<LocalLevelTextbook<f64>>(interval_s.hi, initial)?
        }
        (Algorithm::Textbook, Precision::F64, Frame::EarthFixed) => {
            textbook::<EarthFixedTextbook<f64>>(interval_s.hi, initial)?
        }
        (Algorithm::Textbook, Precision::F32, Frame::LocalLevel) => {
            textbook::<LocalLevelTextbook<f32>>(single.hi, initial)?
        }
        (Algorithm::Textbook, Precision::F32, Frame::EarthFixed) => {
            textbook::<EarthFixedTextbook<f32>>(single.hi, initial)?
        }
        (Algorithm::Taylor, Precision::F64, Frame::LocalLevel) => {
            taylor::<LocalLevel<Pair<f64>>>(shape, order, interval_s, initial)?
        }
        (Algorithm::Taylor, Precision::F64, Frame::EarthFixed) => {
            taylor::<EarthFixed<Pair<f64>>>(shape, order, interval_s, initial)?
        }
        (Algorithm::Taylor, Precision::F32, Frame::LocalLevel) => {
            taylor::<LocalLevel<Pair<f32>>>(shape, order, single, initial)?
        }
        (Algorithm::Taylor, Precision::F32, Frame::EarthFixed) => {
            taylor::<EarthFixed<Pair<f32>>>(shape, order, single, initial)?
        }
        (Algorithm::Taylor, Precision::F32x2, Frame::LocalLevel) => {
            taylor_two_float::<LocalLevel<TwoFloat<f32>>>(shape, order, single, initial)?
        }
        (Algorithm::Taylor, Precision::F32x2, Frame::EarthFixed) => {
            taylor_two_float::<EarthFixed<TwoFloat<f32>>>(shape, order, single, initial)?
        }
        (Algorithm::Textbook, Precision::F32x2, _) => return Err(Unavailable::TwoFloat),
    };
    Ok(boxed)
}

/// A function that starts a taylor navigator in a frame with one of some windows, and their shapes.
macro_rules! starter {
    ($(#[$doc:meta])* fn $start:ident, $shapes:ident, $of:literal; $($window:ident),+) => {
        #[doc = concat!("The windows of [`", stringify!($start), "`].")]
        pub(crate) const $shapes: &[Shape] = &[$($window::SHAPE),+];

        $(#[$doc])*
        pub(crate) fn $start<F>(
            shape: WindowShape,
            order: usize,
            interval_s: Pair<F::Real>,
            initial: &Solution<f64>,
        ) -> Result<Box<dyn Navigate>, Unavailable>
        where
            F: schuler::strapdown::frame::Frame<Real: Scalar + Send> + Record + Send + 'static,
        {
            $(if shape == $window::SHAPE.into() {
                let strapdown = Strapdown::<F, Unequal<$window>>::new(interval_s)?.with_order(order);
                return Ok(Flying::boxed(strapdown, interval_s, initial)?);
            })+
            Err(Unavailable::Window { shape, of: $of, accepted: $shapes })
        }
    };
}

schuler::every_window! { starter!
    /// A taylor navigator with any of the named windows.
    fn taylor, TAYLOR, "taylor";
}
starter! {
    /// The same in arithmetics that are there to be compared with.
    fn taylor_compared, COMPARED, "the comparison"; H0B4A0, H2B4A2, Line8
}
starter! {
    /// The same with two-float products.
    fn taylor_two_float, TWO_FLOAT, "f32x2"; H0B4A0, H4B4A0, H2B4A2, H4B4A4
}

/// A textbook navigator in a frame.
pub(crate) fn textbook<F>(
    interval_s: F::Real,
    initial: &Solution<f64>,
) -> Result<Box<dyn Navigate>, Unavailable>
where
    F: TextbookFrame<Real: Scalar + Send> + Record + Send + 'static,
{
    Ok(Flying::boxed(Textbook::<F>::new(interval_s)?, Pair::new(interval_s), initial)?)
}
