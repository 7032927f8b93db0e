//! Runs that fly together on one core: abreast where a window is compiled for lanes, else one.

use crate::lanes::abreast::{Abreast, Packed, Refused, pack};
use crate::lanes::pack::Lanes;
use crate::lanes::{InLanes, Registers, in_registers};
use crate::navigator::{self, Navigate, Unavailable};
use crate::plan::Plan;
use crate::scene::{Frame, Scene};
use crate::simulate;
use crate::source::{Samples, Source};
use crate::timing;
use schuler::math::compensated::Pair;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::earth_fixed::EarthFixed;
use schuler::strapdown::frame::Output;
use schuler::strapdown::local_level::LocalLevel;
use schuler::strapdown::window::{H0B4A0, H2B4A2, H4B4A4, Line8, Parabola20, Window};
use std::array;
use std::ops::Range;

/// Samples that pass from the sensors to the navigator at once: they stay in the first cache.
const PIECE: usize = 64;

/// Runs of an ensemble, flown together.
pub trait Group: Send {
    /// Takes the perfect increments of the next samples; stops before one that is refused in any run.
    fn fly(&mut self, perfect: &[Increment<f64>]) -> Result<(), Refused>;
    /// Integrates what is pending: the samples are at their end.
    fn finish(&mut self);
    /// Samples of each run that were integrated so far.
    fn integrated(&self) -> u64;
    /// Navigation of each run at the end of the last block.
    fn solutions(&self) -> Vec<Solution<f64>>;
    /// Samples so far in which a sensor was at its limit, over all runs.
    fn saturated(&self) -> u64;
    /// What navigation alone costs, ns per sample and run, over perfect increments after those `before`.
    fn navigation_ns(&mut self, before: &[Increment<f64>], perfect: &[Increment<f64>]) -> f64;
}

/// What runs are flown in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Abreast in vector registers.
    In(Registers),
    /// Each run by itself.
    Alone,
}

impl Unit {
    /// All there are, the widest first.
    pub const ALL: &[Self] = &[Self::In(Registers::Avx512), Self::In(Registers::Avx2), Self::Alone];

    /// How many runs it takes side by side.
    pub fn runs(self) -> usize {
        match self {
            Self::In(registers) => registers.runs(),
            Self::Alone => 1,
        }
    }
}

/// A scene from which runs start.
pub struct Ground<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Its truth and sensors.
    pub source: &'a Source,
    /// Window and order.
    pub plan: Plan,
    /// Where navigation starts.
    pub initial: Solution<f64>,
}

impl<'a> Ground<'a> {
    /// Of a scene and its source.
    pub fn new(scene: &'a Scene, source: &'a Source) -> Self {
        let plan = Plan::new(scene, source, false);
        let initial = simulate::offset(&source.motion(0).initial(), scene);
        Self { scene, source, plan, initial }
    }

    /// The widest unit that so many runs fill, this machine has and the window is compiled for.
    pub fn widest(&self, runs: u64) -> Unit {
        let starts = |&unit: &Unit| {
            unit.runs() as u64 <= runs && matches!(self.start(unit, 0..1), Ok(Some(_)))
        };
        Unit::ALL.iter().copied().find(starts).unwrap_or(Unit::Alone)
    }

    /// Starts runs of these numbers, as many as the unit takes or fewer; `None` if this machine or
    /// this window has no such unit.
    pub fn start(
        &self,
        unit: Unit,
        runs: Range<u64>,
    ) -> Result<Option<Box<dyn Group + 'a>>, Unavailable> {
        match unit {
            Unit::In(registers) => {
                in_registers(registers, Start { ground: self, runs }).unwrap_or(Ok(None))
            }
            Unit::Alone => {
                let (navigator, plan) = (&self.scene.navigator, &self.plan);
                let interval_s = self.interval_s();
                let navigator = navigator::start(
                    navigator,
                    plan.window,
                    plan.order,
                    interval_s,
                    &self.initial,
                )?;
                Ok(Some(Box::new(Alone { navigator, stream: self.source.start(runs.start) })))
            }
        }
    }

    fn interval_s(&self) -> Pair<f64> {
        Pair::new(self.scene.rate_hz).reciprocal()
    }

    fn abreast<P: Lanes<N>, const N: usize>(
        &self,
        runs: Range<u64>,
    ) -> Result<Option<Box<dyn Group + 'a>>, Unavailable> {
        match self.scene.navigator.frame {
            Frame::LocalLevel => self.in_frame::<LocalLevel<Pair<P>>, N>(runs),
            Frame::EarthFixed => self.in_frame::<EarthFixed<Pair<P>>, N>(runs),
        }
    }

    fn in_frame<F, const N: usize>(
        &self,
        runs: Range<u64>,
    ) -> Result<Option<Box<dyn Group + 'a>>, Unavailable>
    where
        F: Packed<N, Alone: Send> + Send + 'static,
    {
        let window = self.plan.window;
        let shape = (window.history, window.block, window.lookahead);
        // Each is a copy of the navigator: slow motion, the planned ones, the widest.
        macro_rules! windows {
            ($($name:ident),+) => {
                $(if ($name::HISTORY, $name::BLOCK, $name::LOOKAHEAD) == shape {
                    let abreast = Abreast::<F, $name, N>::start(
                        self.interval_s(),
                        self.plan.order,
                        &[self.initial; N],
                    )?;
                    let streams = runs.map(|run| self.source.start(run)).collect();
                    return Ok(Some(Box::new(Pack { abreast, streams, measured: Vec::new() })));
                })+
            };
        }
        windows!(H0B4A0, H2B4A2, H4B4A4, Line8, Parabola20);
        Ok(None)
    }
}

/// The start of runs abreast, in lanes of any kind.
struct Start<'g, 'a> {
    ground: &'g Ground<'a>,
    runs: Range<u64>,
}

impl<'a> InLanes for Start<'_, 'a> {
    type Output = Result<Option<Box<dyn Group + 'a>>, Unavailable>;
    fn run<P: Lanes<N>, const N: usize>(self) -> Self::Output {
        self.ground.abreast::<P, N>(self.runs)
    }
}

/// Runs abreast; with fewer than lanes, the last one flies in the idle ones too.
struct Pack<'a, F: Packed<N>, W: Window, const N: usize> {
    abreast: Abreast<F, W, N>,
    streams: Vec<Samples<'a>>,
    measured: Vec<Increment<F::Real>>,
}

impl<F: Packed<N>, W: Window, const N: usize> Pack<'_, F, W, N> {
    fn measure(&mut self, perfect: &[Increment<f64>]) {
        self.measured.clear();
        for perfect in perfect {
            let mut last = *perfect;
            let lanes: [_; N] = array::from_fn(|lane| {
                if let Some(stream) = self.streams.get_mut(lane) {
                    last = stream.sense(perfect);
                }
                last
            });
            self.measured.push(pack(&lanes));
        }
    }
}

impl<F, W, const N: usize> Group for Pack<'_, F, W, N>
where
    F: Packed<N>,
    W: Window,
    Self: Send,
{
    fn fly(&mut self, perfect: &[Increment<f64>]) -> Result<(), Refused> {
        for (piece, perfect) in perfect.chunks(PIECE).enumerate() {
            self.measure(perfect);
            self.abreast
                .push(&self.measured)
                .map_err(|refused| Refused { taken: piece * PIECE + refused.taken, ..refused })?;
        }
        Ok(())
    }

    fn finish(&mut self) {
        self.abreast.finish();
    }

    fn integrated(&self) -> u64 {
        self.abreast.integrated()
    }

    fn solutions(&self) -> Vec<Solution<f64>> {
        let all = self.abreast.output();
        all.iter().take(self.streams.len()).map(Output::wide).collect()
    }

    fn saturated(&self) -> u64 {
        self.streams.iter().map(Samples::saturated).sum()
    }

    fn navigation_ns(&mut self, before: &[Increment<f64>], perfect: &[Increment<f64>]) -> f64 {
        // What cannot be right was refused in the flight itself.
        let _ = self.fly(before);
        self.measure(perfect);
        timing::per_sample((perfect.len() * N) as u64, &mut || {
            let mut abreast = self.abreast;
            let _ = abreast.push(&self.measured);
            std::hint::black_box(&abreast);
        })
    }
}

/// One run by itself.
struct Alone<'a> {
    navigator: Box<dyn Navigate>,
    stream: Samples<'a>,
}

impl Alone<'_> {
    fn measure(&mut self, perfect: &[Increment<f64>]) -> Vec<Increment<f64>> {
        perfect.iter().map(|perfect| self.stream.sense(perfect)).collect()
    }
}

impl Group for Alone<'_> {
    fn fly(&mut self, perfect: &[Increment<f64>]) -> Result<(), Refused> {
        let measured = self.measure(perfect);
        self.navigator.fly(&measured)
    }

    fn finish(&mut self) {
        self.navigator.finish(&mut |_, _| {});
    }

    fn integrated(&self) -> u64 {
        self.navigator.integrated()
    }

    fn solutions(&self) -> Vec<Solution<f64>> {
        vec![self.navigator.solution()]
    }

    fn saturated(&self) -> u64 {
        self.stream.saturated()
    }

    fn navigation_ns(&mut self, before: &[Increment<f64>], perfect: &[Increment<f64>]) -> f64 {
        let (before, measured) = (self.measure(before), self.measure(perfect));
        let mut pass = self.navigator.fly_unread(&before, &measured);
        timing::per_sample(measured.len() as u64, &mut pass)
    }
}
