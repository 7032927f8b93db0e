//! The core's navigators behind one face: frame, precision, algorithm and window chosen at run time.

mod available;

pub use available::{Unavailable, check, terms};

use crate::flight::{Edges, Used};
use crate::lanes::abreast::Refused;
use crate::scene::{Algorithm, Frame, Navigator, Precision, WindowShape};
use schuler::digest::Digest;
use schuler::math::compensated::{Pair, TwoFloat};
use schuler::math::real::Scalar;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::sensor::carried::Carried;
use schuler::solution::Solution;
use schuler::strapdown::earth_fixed::EarthFixed;
use schuler::strapdown::frame::Output;
use schuler::strapdown::local_level::LocalLevel;
use schuler::strapdown::mechanization::{Mechanization, Rejected, StartError};
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::newton;
use schuler::strapdown::plan::Shape;
use schuler::strapdown::textbook::{
    EarthFixedTextbook, LocalLevelTextbook, Textbook, TextbookFrame,
};
use schuler::strapdown::unequal::{Unequal, UnequalIntervals};
use schuler::strapdown::window::*;

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

/// One of the core's mechanizations with its state.
struct Flying<M: Mechanization> {
    mechanization: M,
    /// The nominal interval, s.
    interval_s: Pair<M::Real>,
    initial: Solution<M::Real>,
    state: M::State,
    carried: Carried,
    /// What the intervals handed over lack of those taken in, s.
    interval_rest: f64,
    digest: Digest,
}

impl<M> Flying<M>
where
    M: UnequalIntervals<Real: Scalar + Send, Frame: Record, State: Send> + Send + 'static,
{
    fn boxed(
        mechanization: M,
        interval_s: Pair<M::Real>,
        initial: &Solution<f64>,
    ) -> Result<Box<dyn Navigate>, StartError> {
        let initial = Solution::narrow(initial);
        let state = mechanization.start(&initial)?;
        let (carried, digest) = Default::default();
        let interval_rest = 0.0;
        Ok(Box::new(Self {
            mechanization,
            interval_s,
            initial,
            state,
            carried,
            interval_rest,
            digest,
        }))
    }
}

/// Samples with a carried rest.
fn narrow<R: Scalar>(samples: &[Increment<f64>], carried: &mut Carried) -> Vec<Increment<R>> {
    samples.iter().map(|sample| carried.narrow(sample)).collect()
}

/// Hands rows on in double precision. One type for all uses: each is a copy of the navigator.
fn wide<R: Scalar, O: Output<R>>(read: &mut Reader) -> impl FnMut(u64, O) {
    move |n, row: O| read(n, &row.wide())
}

/// Takes a sample, and reads the rows that it completes: once for each mechanization, whoever flies it.
#[inline(never)]
pub fn push<M: Mechanization<Real: Scalar>>(
    mechanization: &M,
    state: &mut M::State,
    sample: Increment<M::Real>,
    read: &mut Reader,
) -> Result<(), Rejected> {
    mechanization.push_rows(state, sample, wide(read))
}

/// Takes a sample of its own interval, and reads the rows that it completes.
#[inline(never)]
fn push_over<M: UnequalIntervals<Real: Scalar>>(
    mechanization: &M,
    state: &mut M::State,
    sample: Increment<M::Real>,
    interval_s: Pair<M::Real>,
    read: &mut Reader,
) -> Result<(), Rejected> {
    mechanization.push_rows_over(state, sample, interval_s, wide(read))
}

/// Completes the rows that wait for samples, and reads them.
#[inline(never)]
pub fn finish<M: Mechanization<Real: Scalar>>(
    mechanization: &M,
    state: &mut M::State,
    read: &mut Reader,
) {
    mechanization.finish_rows(state, wide(read));
}

/// Takes samples without reading a row; stops before one that is refused.
#[inline(never)]
fn fly<M: Mechanization>(
    mechanization: &M,
    state: &mut M::State,
    samples: &[Increment<M::Real>],
) -> Result<(), Refused> {
    for (taken, &sample) in samples.iter().enumerate() {
        let pushed = mechanization.push(state, sample);
        pushed.map_err(|reason| Refused { taken, reason })?;
    }
    Ok(())
}

impl<M> Navigate for Flying<M>
where
    M: UnequalIntervals<Real: Scalar + Send, Frame: Record, State: Send> + Send + 'static,
{
    fn push(&mut self, sample: &Increment<f64>, read: &mut Reader) -> Result<(), Rejected> {
        let mut carried = self.carried;
        let sample = carried.narrow(sample);
        let before = M::integrated(&self.state);
        push(&self.mechanization, &mut self.state, sample, read)?;
        self.carried = carried;
        if M::integrated(&self.state) != before {
            self.digest.add(M::frame(&self.state));
        }
        Ok(())
    }

    fn push_over(
        &mut self,
        sample: &Increment<f64>,
        interval_s: f64,
        read: &mut Reader,
    ) -> Result<(), Rejected> {
        let nominal = self.interval_s;
        if interval_s == nominal.widen() || Pair::narrow(Pair::new(interval_s)) == nominal {
            return self.push(sample, read);
        }
        let mut carried = self.carried;
        let sample = carried.narrow(sample);
        let exact = Pair::sum(interval_s, self.interval_rest);
        let interval = Pair::<M::Real>::narrow(exact);
        let narrowed = interval.widen_pair();
        let before = M::integrated(&self.state);
        push_over(&self.mechanization, &mut self.state, sample, interval, read)?;
        self.carried = carried;
        self.interval_rest = (exact.hi - narrowed.hi) + (exact.lo - narrowed.lo);
        if M::integrated(&self.state) != before {
            self.digest.add(M::frame(&self.state));
        }
        Ok(())
    }

    fn fly(&mut self, samples: &[Increment<f64>]) -> Result<(), Refused> {
        let samples = narrow(samples, &mut self.carried);
        fly(&self.mechanization, &mut self.state, &samples)
    }

    fn solution(&self) -> Solution<f64> {
        self.mechanization.output(&self.state).wide()
    }

    fn finish(&mut self, read: &mut Reader) {
        finish(&self.mechanization, &mut self.state, read);
        self.digest.add(M::frame(&self.state));
    }

    fn hold_vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Result<(), Rejected> {
        let narrow = |x| M::Real::narrow(x);
        self.mechanization.hold_vertical(&mut self.state, narrow(altitude_m), narrow(down_m_s))
    }

    fn integrated(&self) -> u64 {
        M::integrated(&self.state)
    }

    fn edges(&self) -> Option<Edges> {
        let used = |used: newton::Used<M::Real>| {
            let [gyro, accelerometer] = [used.gyro, used.accelerometer].map(|n| n.widen() as u32);
            (gyro > 0).then_some(Used { gyro, accelerometer })
        };
        let edges = M::edges(&self.state)?;
        Some(Edges { first: used(edges.first), last: used(edges.last) })
    }

    fn digest(&self) -> u64 {
        self.digest.value()
    }

    fn fly_unread(
        &self,
        before: &[Increment<f64>],
        samples: &[Increment<f64>],
    ) -> Box<dyn FnMut() + '_> {
        let mut carried = Carried::default();
        let (before, samples) = (narrow(before, &mut carried), narrow(samples, &mut carried));
        // What cannot be right was refused in the run itself.
        let start = self.mechanization.start(&self.initial).map(|mut state| {
            let _ = fly(&self.mechanization, &mut state, &before);
            state
        });
        Box::new(move || {
            if let Ok(mut state) = start {
                let _ = fly(&self.mechanization, &mut state, &samples);
                std::hint::black_box(&state);
            }
        })
    }
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
