//! Words, one of each lane: what numbers are made of, and random numbers from.

use std::ops::{Add, BitAnd, BitOr, BitXor};

/// A word of each of `N` lanes. A sum wraps around.
pub trait Words<const N: usize>:
    Copy + Add<Output = Self> + BitAnd<Output = Self> + BitOr<Output = Self> + BitXor<Output = Self>
{
    /// From a word of each lane.
    fn from_lanes(lanes: [u64; N]) -> Self;
    /// The words of all lanes.
    fn lanes(self) -> [u64; N];
    /// Moves every bit up by so many places, fewer than 64.
    fn up(self, places: u64) -> Self;
    /// Moves every bit down by so many places, fewer than 64.
    fn down(self, places: u64) -> Self;

    /// Turns every word up by so many places, from 1 to 63.
    #[inline(always)]
    fn turned(self, places: u64) -> Self {
        self.up(places) | self.down(64 - places)
    }

    /// The same word in each lane.
    #[inline(always)]
    fn all(word: u64) -> Self {
        Self::from_lanes([word; N])
    }
}
