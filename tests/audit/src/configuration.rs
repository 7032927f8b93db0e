//! The navigators: every precision, frame and algorithm.

use crate::recording::{Reader, Stage};
use crate::truth::{Flown, Refused};
use schuler::math::compensated::{Pair, TwoFloat};
use schuler::math::real::Scalar;
use schuler::record::Record;
use schuler::flight::carried::Carried;
use schuler::solution::Solution;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::limits::StartError;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};
use schuler::strapdown::block::window::{H0B4A0, H2B4A2, Parabola20};

/// A navigator to fly.
pub struct Configuration {
    /// Precision, frame, algorithm and window: `f32 local-level taylor 0,4,0`.
    pub title: &'static str,
    /// Flies it.
    pub fly: fn(&Flown, &mut dyn Reader) -> Result<(), Refused>,
}

macro_rules! configurations {
    ($($title:literal: $mechanization:ident<$($of:ty),+>;)+) => {
        /// All of them.
        pub const ALL: [Configuration; 18] = [$(Configuration {
            title: $title,
            fly: |flown, reader| {
                let interval_s = Pair::narrow(flown.interval_s);
                fly(configurations!(@ $mechanization<$($of),+> interval_s), flown, reader)
            },
        }),+];
    };
    (@ Textbook<$of:ty> $interval_s:ident) => { Textbook::<$of>::new($interval_s.hi) };
    (@ Strapdown<$of:ty, $window:ty> $interval_s:ident) => {
        Strapdown::<$of, $window>::new($interval_s)
    };
}

type Level<R> = LocalLevel<Pair<R>>;
type Fixed<R> = EarthFixed<Pair<R>>;
type PreciseLevel = LocalLevel<TwoFloat<f32>>;
type PreciseFixed = EarthFixed<TwoFloat<f32>>;

configurations! {
    "f64 local-level textbook": Textbook<LocalLevelTextbook<f64>>;
    "f64 local-level taylor 0,4,0": Strapdown<Level<f64>, H0B4A0>;
    "f64 local-level taylor 2,4,2": Strapdown<Level<f64>, H2B4A2>;
    "f64 local-level taylor 0,20,0": Strapdown<Level<f64>, Parabola20>;
    "f64 earth-fixed textbook": Textbook<EarthFixedTextbook<f64>>;
    "f64 earth-fixed taylor 0,4,0": Strapdown<Fixed<f64>, H0B4A0>;
    "f64 earth-fixed taylor 2,4,2": Strapdown<Fixed<f64>, H2B4A2>;
    "f32 local-level textbook": Textbook<LocalLevelTextbook<f32>>;
    "f32 local-level taylor 0,4,0": Strapdown<Level<f32>, H0B4A0>;
    "f32 local-level taylor 2,4,2": Strapdown<Level<f32>, H2B4A2>;
    "f32 local-level taylor 0,20,0": Strapdown<Level<f32>, Parabola20>;
    "f32 earth-fixed textbook": Textbook<EarthFixedTextbook<f32>>;
    "f32 earth-fixed taylor 0,4,0": Strapdown<Fixed<f32>, H0B4A0>;
    "f32 earth-fixed taylor 2,4,2": Strapdown<Fixed<f32>, H2B4A2>;
    "f32x2 local-level taylor 0,4,0": Strapdown<PreciseLevel, H0B4A0>;
    "f32x2 local-level taylor 2,4,2": Strapdown<PreciseLevel, H2B4A2>;
    "f32x2 earth-fixed taylor 0,4,0": Strapdown<PreciseFixed, H0B4A0>;
    "f32x2 earth-fixed taylor 2,4,2": Strapdown<PreciseFixed, H2B4A2>;
}

/// Flies one, from the true state and with the samples that the sensors deliver.
fn fly<M>(
    mechanization: Result<M, StartError>,
    flown: &Flown,
    reader: &mut dyn Reader,
) -> Result<(), Refused>
where
    M: Mechanization<Real: Scalar, Frame: Record, Body: Record>,
{
    let mechanization = mechanization.map_err(|_| Refused)?;
    let initial = Solution::narrow(&flown.initial);
    let mut state = mechanization.start(&initial).map_err(|_| Refused)?;
    let mut carried = Carried::default();
    let [mut body, mut nav] = ["body", "nav"].map(Stage::new);
    let mut see = |sample, motion: &M::Body, frame: &M::Frame| {
        body.row(sample, motion, reader);
        nav.row(sample, frame, reader);
    };
    for sample in flown.samples {
        let sample = carried.narrow(sample);
        mechanization.push_blocks(&mut state, sample, &mut see).map_err(|_| Refused)?;
    }
    mechanization.finish_blocks(&mut state, &mut see);
    body.end(reader);
    nav.end(reader);
    Ok(())
}
