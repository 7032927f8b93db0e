//! Little-endian numbers taken from a payload.
//!
//! ```
//! use schuler::link::bytes::Bytes;
//!
//! let mut payload = Bytes(&[1, 2, 0, 0, 0, 128, 63]);
//! assert_eq!(payload.u8(), Some(1));
//! assert_eq!(payload.u16(), Some(2));
//! assert_eq!(payload.scalar::<f32>(), Some(1.0));
//! assert_eq!(payload.u8(), None);
//! ```

use crate::math::compensated::Pair;
use crate::math::real::Scalar;
use crate::math::vector::Vector;
use crate::record::Record;
use crate::sample::Increment;

/// What is left of a payload. `None`: it was too short.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bytes<'a>(pub &'a [u8]);

impl<'a> Bytes<'a> {
    /// So many bytes.
    pub fn array<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (first, rest) = self.0.split_first_chunk::<N>()?;
        self.0 = rest;
        Some(*first)
    }

    /// One byte.
    pub fn u8(&mut self) -> Option<u8> {
        self.array().map(u8::from_le_bytes)
    }

    /// Two bytes.
    pub fn u16(&mut self) -> Option<u16> {
        self.array().map(u16::from_le_bytes)
    }

    /// Four bytes.
    pub fn u32(&mut self) -> Option<u32> {
        self.array().map(u32::from_le_bytes)
    }

    /// Eight bytes.
    pub fn u64(&mut self) -> Option<u64> {
        self.array().map(u64::from_le_bytes)
    }

    /// The bits of a scalar, from as many bytes as it has.
    pub fn bits<R: Scalar>(&mut self) -> Option<u64> {
        if size_of::<R>() == 4 { self.u32().map(u64::from) } else { self.u64() }
    }

    /// A scalar.
    pub fn scalar<R: Scalar>(&mut self) -> Option<R> {
        self.bits::<R>().map(R::from_bits)
    }

    /// A number and what rounding dropped from it.
    pub fn pair<R: Scalar>(&mut self) -> Option<Pair<R>> {
        Some(Pair { hi: self.scalar()?, lo: self.scalar()? })
    }

    /// Six scalars.
    pub fn increment<R: Scalar>(&mut self) -> Option<Increment<R>> {
        let mut vector = || Some(Vector::new(self.scalar()?, self.scalar()?, self.scalar()?));
        Some(Increment { angle_b: vector()?, velocity_b: vector()? })
    }

    /// A record, eight bytes a word; `None` too where it would not be written so again.
    pub fn record<T: Record>(&mut self, mut to: T) -> Option<T> {
        let (mut from, mut complete) = (*self, true);
        to.restore("", &mut |_, bits| {
            let word = from.u64();
            complete &= word.is_some();
            word.unwrap_or(bits)
        });
        to.record("", &mut |_, bits| complete &= self.u64() == Some(bits));
        complete.then_some(to)
    }

    /// Everything that is left.
    pub fn rest(&mut self) -> Self {
        Self(core::mem::take(&mut self.0))
    }

    /// The end, if there is nothing left.
    pub fn end(self) -> Option<()> {
        self.0.is_empty().then_some(())
    }
}
