//! Words and deviates that are made at once, and the generators that they come from.

/// How many deviates are made at once, of all lanes together.
pub const AT_ONCE: usize = 256;

/// As many things, in whole lines of the cache.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct Lines<T>(pub [T; AT_ONCE]);

/// Words.
pub type Drawn = Lines<u64>;

/// Deviates, in the order of the words.
pub type Deviates = Lines<f64>;

/// The states of the generators of all lanes, xoshiro256++.
pub type Generator<const N: usize> = [[u64; N]; 4];
