//! The navigators that an audit flies: every precision, frame and algorithm, shown step by step.

use super::chain::Width;
use crate::scene::{Algorithm, Frame, Precision};
use schuler::math::compensated::{Pair, TwoFloat};
use schuler::math::real::Scalar;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::sensor::carried::Carried;
use schuler::solution::Solution;
use schuler::strapdown::block::window::{H0B4A0, H2B4A2, Parabola20, Window};
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::limits::{Rejected, StartError};
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};

/// A state's words, each with its field.
pub type Words = Vec<(&'static str, u64)>;

/// Who sees a step: the number of samples at its end, the body's motion over it, the frame after it.
pub type See<'a> = dyn FnMut(u64, &Words, &Words) + 'a;

/// The words of a state.
pub fn words<S: Record>(state: &S) -> Words {
    let mut words = Vec::new();
    state.record("", &mut |name, bits| words.push((name, bits)));
    words
}

/// A navigator in flight.
pub trait Steps {
    /// Takes a sample and shows the steps that it completes.
    fn push(&mut self, sample: &Increment<f64>, see: &mut See) -> Result<(), Rejected>;
    /// Completes the steps that wait for samples.
    fn finish(&mut self, see: &mut See);
    /// Sets height and vertical velocity.
    fn hold_vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Result<(), Rejected>;
}

type Start = fn(Pair<f64>, &Solution<f64>) -> Result<Box<dyn Steps>, StartError>;

/// A navigator to fly.
#[derive(Clone, Copy, Debug)]
pub struct Configuration {
    /// Its arithmetic.
    pub precision: Precision,
    /// Its axes.
    pub frame: Frame,
    /// Its integration method.
    pub algorithm: Algorithm,
    /// The taylor algorithm's window: history, block, look-ahead; its series are of full order.
    pub window: Option<(usize, usize, usize)>,
    /// Starts it with an interval in seconds from an initial solution.
    pub start: Start,
}

impl Configuration {
    /// Its words, apart from each other by `gap`, the window's numbers by `comma`.
    fn spelled(&self, gap: &str, comma: &str) -> String {
        let mut words = [self.precision.name(), self.frame.name(), self.algorithm.name()].join(gap);
        if let Some((h, b, a)) = self.window {
            words = format!("{words}{gap}{h}{comma}{b}{comma}{a}");
        }
        words
    }

    /// As people read it: `f32 local-level taylor 0,4,0`.
    pub fn title(&self) -> String {
        self.spelled(" ", ",")
    }

    /// As files are named: `f32-local-level-taylor-0-4-0`.
    pub fn stem(&self) -> String {
        self.spelled("-", "-")
    }

    /// The type of its words.
    pub fn width(&self) -> Width {
        match self.precision {
            Precision::F64 => Width::Double,
            Precision::F32 | Precision::F32x2 => Width::Single,
        }
    }
}

/// A mechanization with its state.
struct Stepping<M: Mechanization> {
    mechanization: M,
    state: M::State,
    carried: Carried,
}

impl<M> Steps for Stepping<M>
where
    M: Mechanization<Real: Scalar, Frame: Record, Body: Record>,
{
    fn push(&mut self, sample: &Increment<f64>, see: &mut See) -> Result<(), Rejected> {
        let sample = self.carried.narrow(sample);
        self.mechanization.push_blocks(&mut self.state, sample, |n, body, frame| {
            see(n, &words(body), &words(frame));
        })
    }

    fn finish(&mut self, see: &mut See) {
        self.mechanization.finish_blocks(&mut self.state, |n, body, frame| {
            see(n, &words(body), &words(frame));
        });
    }

    fn hold_vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Result<(), Rejected> {
        let narrow = |x| M::Real::narrow(x);
        self.mechanization.hold_vertical(&mut self.state, narrow(altitude_m), narrow(down_m_s))
    }
}

fn start<M>(
    mechanization: Result<M, StartError>,
    initial: &Solution<f64>,
) -> Result<Box<dyn Steps>, StartError>
where
    M: Mechanization<Real: Scalar, Frame: Record, Body: Record> + 'static,
{
    let mechanization = mechanization?;
    let state = mechanization.start(&Solution::narrow(initial))?;
    Ok(Box::new(Stepping { mechanization, state, carried: Carried::default() }))
}

const fn textbook(precision: Precision, frame: Frame, start: Start) -> Configuration {
    Configuration { precision, frame, algorithm: Algorithm::Textbook, window: None, start }
}

const fn taylor<W: Window>(precision: Precision, frame: Frame, start: Start) -> Configuration {
    let window = Some((W::HISTORY, W::BLOCK, W::LOOKAHEAD));
    Configuration { precision, frame, algorithm: Algorithm::Taylor, window, start }
}

macro_rules! configurations {
    ($($precision:ident $frame:ident: $($mechanization:ident $of:ty),+;)+) => {
        /// All of them.
        pub const ALL: &[Configuration] = &[
            $($(configurations!(@ $mechanization $precision, $frame, $of)),+),+
        ];
    };
    (@ textbook $precision:ident, $frame:ident, $of:ty) => {
        textbook(Precision::$precision, Frame::$frame, |interval_s, initial| {
            start(Textbook::<$of>::new(Pair::narrow(interval_s).hi), initial)
        })
    };
    (@ $window:ident $precision:ident, $frame:ident, $of:ty) => {
        taylor::<$window>(Precision::$precision, Frame::$frame, |interval_s, initial| {
            start(Strapdown::<$of, $window>::new(Pair::narrow(interval_s)), initial)
        })
    };
}

type Level<R> = LocalLevel<Pair<R>>;
type Fixed<R> = EarthFixed<Pair<R>>;
type PreciseLevel = LocalLevel<TwoFloat<f32>>;
type PreciseFixed = EarthFixed<TwoFloat<f32>>;

configurations! {
    F64 LocalLevel: textbook LocalLevelTextbook<f64>, H0B4A0 Level<f64>, H2B4A2 Level<f64>,
        Parabola20 Level<f64>;
    F64 EarthFixed: textbook EarthFixedTextbook<f64>, H0B4A0 Fixed<f64>, H2B4A2 Fixed<f64>;
    F32 LocalLevel: textbook LocalLevelTextbook<f32>, H0B4A0 Level<f32>, H2B4A2 Level<f32>,
        Parabola20 Level<f32>;
    F32 EarthFixed: textbook EarthFixedTextbook<f32>, H0B4A0 Fixed<f32>, H2B4A2 Fixed<f32>;
    F32x2 LocalLevel: H0B4A0 PreciseLevel, H2B4A2 PreciseLevel;
    F32x2 EarthFixed: H0B4A0 PreciseFixed, H2B4A2 PreciseFixed;
}
