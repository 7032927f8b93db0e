//! One list of a state's fields, for digest, storage, link and audit.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::record::Record;
//!
//! let state = Vector::new(1.0_f32, 2.0, 3.0);
//! let mut words = Vec::new();
//! state.record("velocity", &mut |_, bits| words.push(bits));
//! assert_eq!(words[1], u64::from(2.0_f32.to_bits()));
//! ```

use crate::earth::Geodetic;
use crate::math::compensated::{Pair, Plain, TwoFloat};
use crate::math::quaternion::Quaternion;
use crate::math::vector::Vector;

/// A state that can name its fields, to read them or to write them back.
///
/// A field's bits are in the low end of a word. The order is fixed, and the same for both methods. A vector's
/// components share its name.
pub trait Record {
    /// Reads every field's name and bits; `name` is this field's name in its owner.
    fn record(&self, name: &'static str, read: &mut impl FnMut(&'static str, u64));

    /// Writes the fields: `write` gets a field's name and its bits, and returns the bits that the field
    /// is to have; to leave a field unchanged, it returns the same bits.
    fn restore(&mut self, name: &'static str, write: &mut impl FnMut(&'static str, u64) -> u64);
}

macro_rules! record_numbers {
    ($($t:ty: $bits:expr, $back:expr;)+) => {
        $(impl Record for $t {
            #[inline(always)]
            fn record(&self, name: &'static str, read: &mut impl FnMut(&'static str, u64)) {
                read(name, $bits(*self));
            }
            #[inline(always)]
            fn restore(
                &mut self,
                name: &'static str,
                write: &mut impl FnMut(&'static str, u64) -> u64,
            ) {
                *self = $back(write(name, $bits(*self)));
            }
        })+
    };
}

record_numbers! {
    u32: u64::from, |word| word as u32;
    u64: u64::from, u64::from;
    usize: |x| x as u64, |word| word as usize;
    f32: |x: f32| x.to_bits().into(), |word| f32::from_bits(word as u32);
    f64: f64::to_bits, f64::from_bits;
}

/// Lists a struct's fields for [`Record`]: `record!(field, ..)` gives each its own name,
/// `record!(field, ..; field, ..)` gives those before the semicolon the owner's.
macro_rules! record {
    ($($field:ident),+) => {
        $crate::record::record!(@ [] [$($field)+]);
    };
    ($($whole:tt),+; $($field:ident),*) => {
        $crate::record::record!(@ [$($whole)+] [$($field)*]);
    };
    (@ [$($whole:tt)*] [$($field:ident)*]) => {
        #[inline(always)]
        fn record(&self, _name: &'static str, read: &mut impl FnMut(&'static str, u64)) {
            $(self.$whole.record(_name, read);)*
            $(self.$field.record(stringify!($field), read);)*
        }
        #[inline(always)]
        fn restore(
            &mut self,
            _name: &'static str,
            write: &mut impl FnMut(&'static str, u64) -> u64,
        ) {
            $(self.$whole.restore(_name, write);)*
            $(self.$field.restore(stringify!($field), write);)*
        }
    };
}
pub(crate) use record;

#[cfg(feature = "micromath")]
impl Record for crate::math::coarse::Coarse {
    record!(0;);
}

impl<T: Record> Record for Plain<T> {
    record!(0;);
}

impl<T: Record> Record for TwoFloat<T> {
    record!(0;);
}

impl<T: Record> Record for Pair<T> {
    record!(hi, lo;);
}

impl<T: Record> Record for Vector<T> {
    record!(x, y, z;);
}

impl<T: Record> Record for Quaternion<T> {
    record!(w, v;);
}

impl<T: Record> Record for Geodetic<T> {
    record!(latitude, longitude, altitude;);
}

impl<T: Record> Record for [T] {
    #[inline(always)]
    fn record(&self, name: &'static str, read: &mut impl FnMut(&'static str, u64)) {
        for item in self {
            item.record(name, read);
        }
    }
    #[inline(always)]
    fn restore(&mut self, name: &'static str, write: &mut impl FnMut(&'static str, u64) -> u64) {
        for item in self {
            item.restore(name, write);
        }
    }
}

impl<T: Record, const N: usize> Record for [T; N] {
    #[inline(always)]
    fn record(&self, name: &'static str, read: &mut impl FnMut(&'static str, u64)) {
        self.as_slice().record(name, read);
    }
    #[inline(always)]
    fn restore(&mut self, name: &'static str, write: &mut impl FnMut(&'static str, u64) -> u64) {
        self.as_mut_slice().restore(name, write);
    }
}
