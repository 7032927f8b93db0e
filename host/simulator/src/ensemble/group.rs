//! Runs that fly together on one core: several in lanes if the window is compiled for that, else one.

use super::alone::Alone;
use super::pack::Pack;
use super::runs::Group;
use crate::alignment::begin::begin;
use crate::lanes::abreast::{Abreast, Packed};
use crate::lanes::pack::Lanes;
use crate::lanes::{InLanes, Registers, in_registers};
use crate::navigator::Unavailable;
use crate::plan::Plan;
use crate::scene::{Axes, Precision, Scene};
use crate::simulate::start;
use crate::source::Source;
use schuler::math::compensated::Pair;
use schuler::solution::Solution;
use schuler::strapdown::block::window::*;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use std::ops::Range;

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
    /// Where navigation starts without error.
    pub truth: Solution<f64>,
}

impl<'a> Ground<'a> {
    /// Of a scene and its source.
    pub fn new(scene: &'a Scene, source: &'a Source) -> Self {
        let plan = Plan::new(scene, source, false);
        Self { scene, source, plan, truth: source.initial(0) }
    }

    /// Where the run of a number starts.
    pub fn initial(&self, run: u64) -> Solution<f64> {
        start::of_run(&self.truth, self.scene, run)
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
            // Lanes are of double precision, and begin together.
            Unit::In(_) if self.scene.navigator.precision != Precision::F64 => Ok(None),
            Unit::In(_) if self.scene.alignment.is_some() => Ok(None),
            Unit::In(registers) => {
                in_registers(registers, Start { ground: self, runs }).unwrap_or(Ok(None))
            }
            Unit::Alone => {
                let run = runs.start;
                let begun = begin(self.scene, self.source, &self.plan, run)?;
                Ok(Some(Box::new(Alone::new(begun.navigator, self.source, run, begun.before))))
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
            Axes::LocalLevel => self.in_frame::<LocalLevel<Pair<P>>, N>(runs),
            Axes::EarthFixed => self.in_frame::<EarthFixed<Pair<P>>, N>(runs),
        }
    }

    fn in_frame<F, const N: usize>(
        &self,
        runs: Range<u64>,
    ) -> Result<Option<Box<dyn Group + 'a>>, Unavailable>
    where
        F: Packed<N, Alone: Send> + Send + 'static,
    {
        let shape = self.plan.window;
        // Lanes without a run of their own fly the last one's.
        let last = runs.end.saturating_sub(1).max(runs.start);
        let starts = std::array::from_fn(|lane| self.initial(last.min(runs.start + lane as u64)));
        // Each is a copy of the navigator: slow motion, the planned ones, the widest.
        macro_rules! windows {
            ($($name:ident),+) => {
                $(if $name::SHAPE == shape {
                    let abreast = Abreast::<F, $name, N>::start(
                        self.interval_s(),
                        self.plan.order,
                        &starts,
                    )?;
                    return Ok(Some(Box::new(Pack::new(Box::new(abreast), self.source, runs))));
                })+
            };
        }
        schuler::windows_of! { lanes windows! }
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
