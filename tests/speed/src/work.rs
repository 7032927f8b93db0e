//! What is measured, by instructions and by time: a navigator under way, the making of samples.

use crate::flight::{Course, Flight, Hard, Manoeuvre, Paper};
use crate::paper::{self, Sensors};
use schuler::digest::Digest;
use schuler::flight::carried::Carried;
use schuler::flight::configuration::{Axes, Precision};
use schuler::flight::plan;
use schuler::imu::Quadrature;
use schuler::math::compensated::{Pair, TwoFloat};
use schuler::math::real::Scalar;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::block::window::{H0B4A0, H2B4A2, Line8, Window};
use schuler::strapdown::frame::Frame;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::reference::textbook::{
    EarthFixedTextbook, LocalLevelTextbook, Textbook, TextbookFrame,
};
use schuler::trajectory::Trajectory as _;
use std::hint::black_box;
use std::marker::PhantomData;

/// Samples that a measurement goes over: whole blocks of every window.
pub const SAMPLES: u64 = 960;
/// Samples before them: past the first block, which is unlike the others.
const BEFORE: u64 = 40;

/// Something to be measured.
pub trait Work: Sized {
    /// Makes everything ready.
    fn prepare() -> Self;
    /// What is measured, over [`SAMPLES`] samples.
    fn run(&self);
}

/// A flight's motion with the quadrature of its rates.
pub struct Perfect {
    course: Course,
    rate_hz: f64,
    quadrature: Quadrature,
}

impl Perfect {
    fn new<C: Flight>() -> Self {
        let course = C::course().unwrap();
        let quadrature = Quadrature::plan(course.bound().bandwidth, 1.0 / C::RATE_HZ);
        Self { course, rate_hz: C::RATE_HZ, quadrature }
    }

    /// The perfect increment of a sample.
    #[inline]
    fn sample(&self, sample: u64) -> Increment<f64> {
        self.quadrature.sample(&self.course, sample, self.rate_hz)
    }

    fn initial(&self) -> Solution<f64> {
        self.course.at(0.0).initial()
    }
}

impl Work for Perfect {
    fn prepare() -> Self {
        Self::new::<Paper>()
    }

    #[inline(always)]
    fn run(&self) {
        for n in BEFORE + 1..=BEFORE + SAMPLES {
            black_box(self.sample(n));
        }
    }
}

/// A navigator in the middle of a flight, with the samples that come next.
pub struct Navigation<M: Mechanization> {
    mechanization: M,
    state: M::State,
    samples: Vec<Increment<M::Real>>,
}

impl<M: Mechanization<Real: Scalar>> Navigation<M> {
    fn new(motion: &Perfect, mechanization: M) -> Self {
        let initial = Solution::narrow(&motion.initial());
        let mut state = mechanization.start(&initial).unwrap();
        let mut carried = Carried::default();
        let mut sample = |n| carried.narrow(&motion.sample(n));
        for n in 1..=BEFORE {
            mechanization.push(&mut state, sample(n)).unwrap();
        }
        let samples = (BEFORE + 1..=BEFORE + SAMPLES).map(sample).collect();
        Self { mechanization, state, samples }
    }

    /// Block ends only: no row is read.
    #[inline(always)]
    fn fly(&self) {
        let mut state = self.state;
        for &sample in &self.samples {
            let _ = self.mechanization.push(&mut state, sample);
        }
        black_box(&state);
    }

    /// Every row is read. Flights share this code.
    #[inline(never)]
    fn fly_rows(&self) {
        let mut state = self.state;
        for &sample in &self.samples {
            let read = |n, row| {
                black_box((n, row));
            };
            let _ = self.mechanization.push_rows(&mut state, sample, read);
        }
        black_box(&state);
    }
}

impl<F: Frame<Real: Scalar>, W: Window> Navigation<Strapdown<F, W>> {
    /// With a series of the order that the plan chooses for the motion.
    fn on<C: Flight>() -> Self {
        let motion = Perfect::new::<C>();
        let interval_s = Pair::new(C::RATE_HZ).reciprocal();
        let bound = motion.course.bound();
        let demand = plan::Demand {
            bandwidth: bound.bandwidth,
            angular_rate: bound.angular_rate,
            // No order depends on it.
            speed: 0.0,
            interval_s: interval_s.hi,
            precision: Precision::F64,
            axes: Axes::EarthFixed,
        };
        let order = plan::order(&demand, W::SHAPE);
        let strapdown = Strapdown::new(Pair::narrow(interval_s)).unwrap();
        Self::new(&motion, strapdown.with_order(order))
    }
}

impl<F: TextbookFrame<Real: Scalar>> Work for Navigation<Textbook<F>> {
    fn prepare() -> Self {
        let interval_s = F::Real::narrow(1.0 / Paper::RATE_HZ);
        Self::new(&Perfect::new::<Paper>(), Textbook::new(interval_s).unwrap())
    }

    #[inline(always)]
    fn run(&self) {
        self.fly();
    }
}

impl<F: Frame<Real: Scalar>, W: Window> Work for Navigation<Strapdown<F, W>> {
    fn prepare() -> Self {
        Self::on::<Paper>()
    }

    #[inline(always)]
    fn run(&self) {
        self.fly();
    }
}

/// A navigator with a window on a flight, every row read.
pub struct Rows<C, F: Frame, W: Window> {
    navigation: Taylor<F, W>,
    flight: PhantomData<C>,
}

impl<C: Flight, F: Frame<Real: Scalar>, W: Window> Work for Rows<C, F, W> {
    fn prepare() -> Self {
        Self { navigation: Navigation::on::<C>(), flight: PhantomData }
    }

    #[inline(always)]
    fn run(&self) {
        self.navigation.fly_rows();
    }
}

/// A navigator with a window on the paper's flight, its state taken into a digest after every block.
pub struct Digested<F: Frame, W: Window>(Taylor<F, W>);

impl<F: Frame<Real: Scalar> + Record, W: Window> Work for Digested<F, W> {
    fn prepare() -> Self {
        Self(Navigation::on::<Paper>())
    }

    #[inline(always)]
    fn run(&self) {
        let mut state = self.0.state;
        let mut digest = Digest::default();
        let mut integrated = state.integrated();
        for &sample in &self.0.samples {
            let _ = self.0.mechanization.push(&mut state, sample);
            if state.integrated() != integrated {
                integrated = state.integrated();
                digest.add(<Strapdown<F, W> as Mechanization>::frame(&state));
            }
        }
        black_box((&state, digest.value()));
    }
}

/// The paper's sensors with all their error terms, fed with perfect increments.
pub struct Emulation {
    sensors: Sensors,
    perfect: Vec<Increment<f64>>,
}

impl Work for Emulation {
    fn prepare() -> Self {
        let motion = Perfect::new::<Paper>();
        let perfect = (1..=SAMPLES).map(|n| motion.sample(n)).collect();
        Self { sensors: paper::sensors().unwrap(), perfect }
    }

    #[inline(always)]
    fn run(&self) {
        let mut state = self.sensors.start(1, 0);
        for perfect in &self.perfect {
            black_box(self.sensors.emulate(&mut state, perfect));
        }
    }
}

/// A navigator with a window.
type Taylor<F, W> = Navigation<Strapdown<F, W>>;

/// Textbook, local-level, `f64`.
pub type TextbookLocalLevel = Navigation<Textbook<LocalLevelTextbook<f64>>>;
/// Textbook, Earth-fixed, `f64`.
pub type TextbookEarthFixed = Navigation<Textbook<EarthFixedTextbook<f64>>>;
/// Four samples, local-level, `f64`.
pub type LocalLevelH0B4A0 = Taylor<LocalLevel<Pair<f64>>, H0B4A0>;
/// Four samples, Earth-fixed, `f64`.
pub type EarthFixedH0B4A0 = Taylor<EarthFixed<Pair<f64>>, H0B4A0>;
/// Four samples, local-level, `f64`, with a digest of every block.
pub type DigestedH0B4A0 = Digested<LocalLevel<Pair<f64>>, H0B4A0>;
/// Eight samples about the block, local-level, `f64`.
pub type LocalLevelH2B4A2 = Taylor<LocalLevel<Pair<f64>>, H2B4A2>;
/// Eight samples about the block, Earth-fixed, `f64`.
pub type EarthFixedH2B4A2 = Taylor<EarthFixed<Pair<f64>>, H2B4A2>;
/// A straight line, local-level, `f64`.
pub type LocalLevelLine8 = Taylor<LocalLevel<Pair<f64>>, Line8>;
/// A straight line, Earth-fixed, `f64`.
pub type EarthFixedLine8 = Taylor<EarthFixed<Pair<f64>>, Line8>;
/// Four samples, local-level, `f32`.
pub type SingleH0B4A0 = Taylor<LocalLevel<Pair<f32>>, H0B4A0>;
/// Four samples, local-level, `f32x2`.
pub type TwoFloatH0B4A0 = Taylor<LocalLevel<TwoFloat<f32>>, H0B4A0>;
/// Eight samples about the block, every row, local-level, `f64`.
type LocalLevelRows<C> = Rows<C, LocalLevel<Pair<f64>>, H2B4A2>;
/// Eight samples about the block, every row, Earth-fixed, `f64`.
type EarthFixedRows<C> = Rows<C, EarthFixed<Pair<f64>>, H2B4A2>;
/// On the paper's flight.
pub type LocalLevelRowsPaper = LocalLevelRows<Paper>;
/// On the paper's flight.
pub type EarthFixedRowsPaper = EarthFixedRows<Paper>;
/// On `hard`.
pub type LocalLevelRowsHard = LocalLevelRows<Hard>;
/// On `hard`.
pub type EarthFixedRowsHard = EarthFixedRows<Hard>;
/// On `manoeuvre`.
pub type LocalLevelRowsManoeuvre = LocalLevelRows<Manoeuvre>;
/// On `manoeuvre`.
pub type EarthFixedRowsManoeuvre = EarthFixedRows<Manoeuvre>;

/// Hands every piece of work, with the name that the baseline knows it by, to a macro.
#[macro_export]
macro_rules! for_each_work {
    ($each:ident) => {
        $each! {
            textbook_local_level_f64 = TextbookLocalLevel,
            textbook_earth_fixed_f64 = TextbookEarthFixed,
            h0b4a0_local_level_f64 = LocalLevelH0B4A0,
            h0b4a0_local_level_f64_digested = DigestedH0B4A0,
            h0b4a0_earth_fixed_f64 = EarthFixedH0B4A0,
            h2b4a2_local_level_f64 = LocalLevelH2B4A2,
            h2b4a2_earth_fixed_f64 = EarthFixedH2B4A2,
            h2b4a2_local_level_f64_rows_paper = LocalLevelRowsPaper,
            h2b4a2_local_level_f64_rows_hard = LocalLevelRowsHard,
            h2b4a2_local_level_f64_rows_manoeuvre = LocalLevelRowsManoeuvre,
            h2b4a2_earth_fixed_f64_rows_paper = EarthFixedRowsPaper,
            h2b4a2_earth_fixed_f64_rows_hard = EarthFixedRowsHard,
            h2b4a2_earth_fixed_f64_rows_manoeuvre = EarthFixedRowsManoeuvre,
            line8_local_level_f64 = LocalLevelLine8,
            line8_earth_fixed_f64 = EarthFixedLine8,
            h0b4a0_local_level_f32 = SingleH0B4A0,
            h0b4a0_local_level_f32x2 = TwoFloatH0B4A0,
            emulator_paper = Emulation,
            perfect_increments_paper = Perfect
        }
    };
}
