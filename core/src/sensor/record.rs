//! The fields of composed states, for [`Record`]: from a restored state the run continues bit for bit.

use crate::noise::Stream;
use crate::record::{Record, record};

type Name = &'static str;

impl Record for () {
    fn record(&self, _: Name, _: &mut impl FnMut(Name, u64)) {}
    fn restore(&mut self, _: Name, _: &mut impl FnMut(Name, u64) -> u64) {}
}

impl Record for Stream {
    fn record(&self, name: Name, read: &mut impl FnMut(Name, u64)) {
        for word in self.to_bytes().as_chunks().0 {
            read(name, u64::from_le_bytes(*word));
        }
    }
    fn restore(&mut self, name: Name, write: &mut impl FnMut(Name, u64) -> u64) {
        let mut bytes = self.to_bytes();
        for word in bytes.as_chunks_mut().0 {
            *word = write(name, u64::from_le_bytes(*word)).to_le_bytes();
        }
        *self = Self::from_bytes(bytes);
    }
}

impl<A: Record, B: Record> Record for (A, B) {
    record!(0, 1;);
}

/// Whether the term is present is configuration, not state.
impl<T: Record> Record for Option<T> {
    fn record(&self, name: Name, read: &mut impl FnMut(Name, u64)) {
        if let Some(present) = self {
            present.record(name, read);
        }
    }
    fn restore(&mut self, name: Name, write: &mut impl FnMut(Name, u64) -> u64) {
        if let Some(present) = self {
            present.restore(name, write);
        }
    }
}
