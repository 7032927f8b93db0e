//! The word form of a state: one list of its fields, to save and to go on from.

use crate::math::real::Scalar;
use crate::math::vector::Vector;
use crate::noise::Stream;

/// A state that consists of 64-bit words.
pub trait Words {
    /// Shows every word to `visit`, in a fixed order, and replaces it by the answer: returned
    /// unchanged it is saved, exchanged for a saved one it is restored.
    fn words(&mut self, visit: &mut impl FnMut(u64) -> u64);
}

impl Words for () {
    fn words(&mut self, _: &mut impl FnMut(u64) -> u64) {}
}

impl Words for u64 {
    fn words(&mut self, visit: &mut impl FnMut(u64) -> u64) {
        *self = visit(*self);
    }
}

impl<R: Scalar> Words for Vector<R> {
    fn words(&mut self, visit: &mut impl FnMut(u64) -> u64) {
        *self = self.map(|x| R::from_bits(visit(x.to_bits())));
    }
}

impl Words for Stream {
    fn words(&mut self, visit: &mut impl FnMut(u64) -> u64) {
        let mut bytes = self.to_bytes();
        for chunk in bytes.as_chunks_mut::<8>().0 {
            *chunk = visit(u64::from_le_bytes(*chunk)).to_le_bytes();
        }
        *self = Self::from_bytes(bytes);
    }
}

impl<A: Words, B: Words> Words for (A, B) {
    fn words(&mut self, visit: &mut impl FnMut(u64) -> u64) {
        self.0.words(visit);
        self.1.words(visit);
    }
}

impl<T: Words> Words for Option<T> {
    fn words(&mut self, visit: &mut impl FnMut(u64) -> u64) {
        if let Some(present) = self {
            present.words(visit);
        }
    }
}

impl<T: Words, const N: usize> Words for [T; N] {
    fn words(&mut self, visit: &mut impl FnMut(u64) -> u64) {
        for item in self {
            item.words(visit);
        }
    }
}
