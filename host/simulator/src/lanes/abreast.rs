//! Runs that fly side by side, whole blocks at a time.
//!
//! Each run flies the first and the last blocks of a stream alone: their code is rarely used and out of
//! line, where lanes are slow. In between the states are in lanes, joined and split by the list of
//! fields that storage and digests use, too.

use super::joined::{join, split};
use super::pack::{Lanes, Task};
use super::samples::unpack;
use schuler::math::compensated::Pair;
use schuler::output::Output;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::block::unequal::Unequal;
use schuler::strapdown::block::window::Window;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::frame::{Blank, Frame};
use schuler::strapdown::limits::{Rejected, StartError};
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::navigator::{State, Strapdown};
use std::array;

pub use super::samples::{pack, replaced};

/// A frame over a pack of `N` runs.
pub trait Packed<const N: usize>: Frame<Real: Lanes<N>> + Record + Blank {
    /// The same frame of one run.
    type Alone: Frame<Real = f64> + Record;
}

impl<P: Lanes<N>, const N: usize> Packed<N> for LocalLevel<Pair<P>> {
    type Alone = LocalLevel<Pair<f64>>;
}

impl<P: Lanes<N>, const N: usize> Packed<N> for EarthFixed<Pair<P>> {
    type Alone = EarthFixed<Pair<f64>>;
}

/// `N` runs in flight, whatever their frame and window.
pub trait SideBySide<P, const N: usize>: Send {
    /// Takes samples, each of every run; stops before one that is wrong in any lane and says how many
    /// were taken.
    fn push(&mut self, samples: &[Increment<P>]) -> Result<(), Refused>;
    /// Why each run alone would not take a sample, which some lane has refused.
    fn refusals(&self, sample: &Increment<P>) -> [Option<Rejected>; N];
    /// Lets a lane go on as a copy of another one.
    fn replace(&mut self, lane: usize, by: usize);
    /// Sets height (m) and vertical velocity (down, m/s) of every run.
    fn hold_vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Result<(), Rejected>;
    /// Integrates what is pending: the streams are at their end.
    fn finish(&mut self);
    /// Samples of each run that were integrated so far.
    fn integrated(&self) -> u64;
    /// Navigation of every run at the end of the last block.
    fn solutions(&self) -> Vec<Solution<f64>>;
    /// Flies samples from here in a copy, to see what that takes; gives the samples that it integrated.
    fn fly_copy(&self, samples: &[Increment<P>]) -> u64;
}

/// `N` runs in flight: in frame `F` over a pack, with window `W`.
#[derive(Clone, Copy)]
pub struct Abreast<F: Packed<N>, W: Window, const N: usize> {
    lanes: Strapdown<F, W>,
    /// The host's own navigator of one run: the same bits, and compiled already.
    one: Strapdown<F::Alone, Unequal<W>>,
    /// Where the runs stand while `joined` holds.
    together: State<F, W>,
    /// Where they stand while it does not.
    apart: [State<F::Alone, Unequal<W>>; N],
    joined: bool,
}

impl<P: Lanes<N>, F: Packed<N, Real = P>, W: Window, const N: usize> Abreast<F, W, N> {
    /// Starts every run from its initial solution, with a sampling interval in seconds and series of
    /// the given order.
    pub fn start(
        interval_s: Pair<f64>,
        order: usize,
        initial: &[Solution<f64>; N],
    ) -> Result<Self, StartError> {
        let one = Strapdown::new(interval_s)?.with_order(order);
        let [first, ..] = initial.as_slice() else { return Err(StartError::Position) };
        let mut apart = [one.start(first)?; N];
        for (state, initial) in apart.iter_mut().zip(initial) {
            *state = one.start(initial)?;
        }
        let same = |x: Pair<f64>| Pair { hi: P::of(x.hi), lo: P::of(x.lo) };
        let lanes = Strapdown::new(same(interval_s))?.with_order(order);
        // In lanes a start would be out of line, and slow.
        Ok(Self { lanes, one, together: State::blank(), apart, joined: false })
    }

    /// Takes a sample in each run alone; joins the runs when the edge of the stream is behind them.
    fn push_apart(&mut self, sample: &Increment<P>) -> Result<(), Rejected> {
        let samples = unpack(sample);
        let mut apart = self.apart;
        for (state, sample) in apart.iter_mut().zip(samples) {
            self.one.push(state, sample)?;
        }
        self.apart = apart;
        if self.apart.iter().all(State::is_inside) {
            join(&mut self.together, &self.apart);
            self.joined = true;
        }
        Ok(())
    }

    /// Navigation of every run at the end of the last block, in its own axes.
    pub fn output(&self) -> [<F::Alone as Frame>::Output; N] {
        self.states().map(|state| state.output())
    }

    /// Every run's state.
    fn states(&self) -> [State<F::Alone, Unequal<W>>; N] {
        let mut states = self.apart;
        if self.joined {
            split(&self.together, &mut states);
        }
        states
    }
}

impl<P: Lanes<N>, F: Packed<N, Real = P>, W: Window, const N: usize> SideBySide<P, N>
    for Abreast<F, W, N>
where
    Self: Send,
{
    fn push(&mut self, samples: &[Increment<P>]) -> Result<(), Refused> {
        let mut taken = 0;
        while !self.joined {
            let Some(sample) = samples.get(taken) else { return Ok(()) };
            self.push_apart(sample).map_err(|reason| Refused { taken, reason })?;
            taken += 1;
        }
        let rest = samples.get(taken..).unwrap_or(&[]);
        let push = Push { strapdown: &self.lanes, state: &mut self.together, samples: rest };
        P::compiled(push).map_err(|refused| Refused { taken: taken + refused.taken, ..refused })
    }

    fn refusals(&self, sample: &Increment<P>) -> [Option<Rejected>; N] {
        let (mut states, mut samples) = (self.states().into_iter(), unpack(sample).into_iter());
        array::from_fn(|_| {
            let (mut state, sample) = (states.next()?, samples.next()?);
            self.one.push(&mut state, sample).err()
        })
    }

    fn replace(&mut self, lane: usize, by: usize) {
        let mut states = self.states();
        if let Some(&other) = states.get(by)
            && let Some(state) = states.get_mut(lane)
        {
            *state = other;
        }
        self.apart = states;
        if self.joined {
            join(&mut self.together, &self.apart);
        }
    }

    fn hold_vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Result<(), Rejected> {
        if self.joined {
            let vertical = [altitude_m, down_m_s].map(P::of);
            return P::compiled(Hold {
                strapdown: &self.lanes,
                state: &mut self.together,
                vertical,
            });
        }
        let hold = |state| self.one.hold_vertical(state, altitude_m, down_m_s);
        self.apart.iter_mut().try_for_each(hold)
    }

    fn finish(&mut self) {
        self.apart = self.states();
        self.joined = false;
        for state in &mut self.apart {
            self.one.finish(state);
        }
    }

    fn integrated(&self) -> u64 {
        if self.joined {
            self.together.integrated()
        } else {
            self.apart.first().map_or(0, State::integrated)
        }
    }

    fn solutions(&self) -> Vec<Solution<f64>> {
        self.output().iter().map(Output::wide).collect()
    }

    fn fly_copy(&self, samples: &[Increment<P>]) -> u64 {
        let mut copy = *self;
        // What cannot be right was refused in the flight itself.
        let _ = copy.push(samples);
        std::hint::black_box(&copy).integrated()
    }
}

/// A sample that some lane could not take. The state is that after the samples before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Refused {
    /// Samples of this call that were taken.
    pub taken: usize,
    /// Why the next one was not.
    pub reason: Rejected,
}

impl std::fmt::Display for Refused {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "after {} samples: {}", self.taken, self.reason)
    }
}

impl std::error::Error for Refused {}

/// Samples to push.
struct Push<'a, F: Frame, W: Window> {
    strapdown: &'a Strapdown<F, W>,
    state: &'a mut State<F, W>,
    samples: &'a [Increment<F::Real>],
}

impl<F: Frame, W: Window> Task for Push<'_, F, W> {
    type Output = Result<(), Refused>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        for (taken, &sample) in self.samples.iter().enumerate() {
            let pushed = self.strapdown.push_inside(self.state, sample);
            pushed.map_err(|reason| Refused { taken, reason })?;
        }
        Ok(())
    }
}

/// A vertical to hold.
struct Hold<'a, F: Frame, W: Window> {
    strapdown: &'a Strapdown<F, W>,
    state: &'a mut State<F, W>,
    vertical: [F::Real; 2],
}

impl<F: Frame, W: Window> Task for Hold<'_, F, W> {
    type Output = Result<(), Rejected>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        let [altitude, down] = self.vertical;
        self.strapdown.hold_vertical(self.state, altitude, down)
    }
}
