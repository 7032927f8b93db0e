//! The fields of composed states, for [`Record`]: from a restored state the run continues bit for bit.

use crate::noise::Stream;
use crate::record::Record;

type Name = &'static str;

impl Record for () {
    fn record(&mut self, _: Name, _: &mut impl FnMut(Name, u64) -> u64) {}
}

impl Record for Stream {
    fn record(&mut self, name: Name, visit: &mut impl FnMut(Name, u64) -> u64) {
        let mut bytes = self.to_bytes();
        for word in bytes.as_chunks_mut().0 {
            *word = visit(name, u64::from_le_bytes(*word)).to_le_bytes();
        }
        *self = Self::from_bytes(bytes);
    }
}

impl<A: Record, B: Record> Record for (A, B) {
    fn record(&mut self, name: Name, visit: &mut impl FnMut(Name, u64) -> u64) {
        self.0.record(name, visit);
        self.1.record(name, visit);
    }
}

impl<T: Record> Record for Option<T> {
    /// Whether the term is present is configuration, not state.
    fn record(&mut self, name: Name, visit: &mut impl FnMut(Name, u64) -> u64) {
        if let Some(present) = self {
            present.record(name, visit);
        }
    }
}

impl<T: Record, const N: usize> Record for [T; N] {
    fn record(&mut self, name: Name, visit: &mut impl FnMut(Name, u64) -> u64) {
        for item in self {
            item.record(name, visit);
        }
    }
}
