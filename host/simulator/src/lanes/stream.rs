//! A stream in each lane, ahead of what was drawn: deviates are made many at a time.

use super::drawn::{AT_ONCE, Deviates, Generator, Lines};
use super::pack::{LANE, Lanes};
use schuler::noise::{Stream, Streams};
use schuler::record::Record;
use std::array;
use std::fmt;

/// The streams of `N` runs, one after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct LaneStream<const N: usize>(Box<Ahead<N>>);

#[derive(Clone, PartialEq)]
#[repr(C)]
struct Ahead<const N: usize> {
    deviates: Deviates,
    /// Before and after the words of these deviates.
    before: Generator<N>,
    after: Generator<N>,
    /// Deviates of each lane that were taken, of those made.
    taken: usize,
    made: usize,
}

impl<const N: usize> fmt::Debug for Ahead<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Ahead").field("before", &self.before).field("taken", &self.taken).finish()
    }
}

/// The generators of streams.
fn generator<const N: usize>(streams: &[Stream; N]) -> Generator<N> {
    let states = streams.each_ref().map(|stream| {
        let bytes = stream.to_bytes();
        let words: &[[u8; 8]] = bytes.as_chunks().0;
        array::from_fn::<_, 4, _>(|word| u64::from_le_bytes(words[word]))
    });
    array::from_fn(|word| states.map(|state| state[word]))
}

/// The streams of generators.
fn streams<const N: usize>(generator: &Generator<N>) -> [Stream; N] {
    array::from_fn(|lane| {
        let mut bytes = [0; Stream::BYTES];
        for (bytes, words) in bytes.as_chunks_mut().0.iter_mut().zip(generator) {
            *bytes = words[lane].to_le_bytes();
        }
        Stream::from_bytes(bytes)
    })
}

impl<const N: usize> LaneStream<N> {
    /// At this place of the tree: the first of the run told, the next of the run after it, and so on.
    pub fn open(place: Streams) -> Self {
        Self::from_generator(generator(&array::from_fn(|lane| place.later(lane as u64).open())))
    }

    fn from_generator(generator: Generator<N>) -> Self {
        let (before, after) = (generator, generator);
        Self(Box::new(Ahead { deviates: Lines([0.0; AT_ONCE]), before, after, taken: 0, made: 0 }))
    }

    /// The next deviate of each lane.
    #[inline(always)]
    pub fn next<P: Lanes<N>>(&mut self) -> P {
        let ahead = &mut *self.0;
        if ahead.taken == ahead.made {
            refill::<P, N>(ahead);
        }
        let deviates: &[[f64; N]] = ahead.deviates.0.as_chunks().0;
        let next = deviates[ahead.taken % (AT_ONCE / N)];
        ahead.taken += 1;
        P::from_lanes(next)
    }

    /// The generators as they are when each deviate is made alone.
    fn reached(&self) -> Generator<N> {
        let mut streams = streams(&self.0.before);
        for stream in &mut streams {
            (0..self.0.taken).for_each(|_| _ = stream.next_u64());
        }
        generator(&streams)
    }
}

/// More deviates, once these are taken.
#[cold]
#[inline(never)]
fn refill<P: Lanes<N>, const N: usize>(ahead: &mut Ahead<N>) {
    let Ahead { deviates, before, after, taken, made } = ahead;
    *before = *after;
    P::fill(after, deviates);
    (*taken, *made) = (0, AT_ONCE / N);
}

impl<const N: usize> Record for LaneStream<N> {
    fn record(&self, _: &'static str, read: &mut impl FnMut(&'static str, u64)) {
        self.reached().record(LANE, read);
    }
    fn restore(&mut self, _: &'static str, write: &mut impl FnMut(&'static str, u64) -> u64) {
        let mut generator = self.reached();
        generator.restore(LANE, write);
        *self = Self::from_generator(generator);
    }
}
