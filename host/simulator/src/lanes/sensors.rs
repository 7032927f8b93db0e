//! The sensors of runs that fly side by side: each lane has the bits of its run's sensors alone.

use super::one::One;
use super::pack::{Lanes, Task};
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::sensor::emulator::{Emulator, State};
use schuler::sensor::triad::Triad;

/// Every term there or not.
pub type Terms<P> = Emulator<P, Triad<P>, Triad<P>>;

/// The sensors of runs, one in each lane.
#[derive(Clone, Debug)]
pub struct Sensors<P: Lanes<N>, const N: usize> {
    state: State<P, Triad<P>, Triad<P>>,
    /// Samples in which a sensor was at its limit.
    saturated: P,
}

impl<P: Lanes<N>, const N: usize> Sensors<P, N> {
    /// Of run `first` and of those after it, before their first sample.
    pub fn start(terms: &Terms<One>, seed: u64, first: u64) -> Self {
        Self { state: in_lanes::<P, N>(terms).start(seed, first), saturated: P::ZERO }
    }

    /// What the sensors of every run make of the same perfect increments, after those of earlier calls.
    pub fn read(
        &mut self,
        terms: &Terms<P>,
        perfect: &[Increment<f64>],
        measured: &mut Vec<Increment<P>>,
    ) {
        P::compiled(Read { terms, sensors: self, perfect, measured });
    }

    /// Samples so far in which a sensor of each run was at its limit.
    pub fn saturated(&self) -> [u64; N] {
        self.saturated.lanes().map(|samples| samples as u64)
    }
}

/// The same terms in every lane.
pub fn in_lanes<P: Lanes<N>, const N: usize>(terms: &Terms<One>) -> Terms<P> {
    terms.map(|One(x)| P::of(x))
}

/// The same sample in every lane.
#[inline(always)]
pub fn same<P: Lanes<N>, const N: usize>(sample: &Increment<f64>) -> Increment<P> {
    let Increment { angle_b: a, velocity_b: v } = sample;
    Increment {
        angle_b: Vector { x: P::of(a.x), y: P::of(a.y), z: P::of(a.z) },
        velocity_b: Vector { x: P::of(v.x), y: P::of(v.y), z: P::of(v.z) },
    }
}

/// Samples to read.
struct Read<'a, P: Lanes<N>, const N: usize> {
    terms: &'a Terms<P>,
    sensors: &'a mut Sensors<P, N>,
    perfect: &'a [Increment<f64>],
    measured: &'a mut Vec<Increment<P>>,
}

impl<P: Lanes<N>, const N: usize> Task for Read<'_, P, N> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let Self { terms, sensors: Sensors { state, saturated }, perfect, measured } = self;
        for perfect in perfect {
            let (increment, mark) = terms.emulate_marked(state, &same(perfect));
            measured.push(increment);
            *saturated = *saturated + P::select(mark, P::ONE, P::ZERO);
        }
    }
}
