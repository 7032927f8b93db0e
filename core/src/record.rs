//! One list of a state's fields, for digest, storage, link and audit.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::record::Record;
//!
//! let mut state = Vector::new(1.0_f32, 2.0, 3.0);
//! let mut words = Vec::new();
//! state.record("velocity", &mut |_, bits| {
//!     words.push(bits);
//!     bits
//! });
//! assert_eq!(words[1], u64::from(2.0_f32.to_bits()));
//! ```

use crate::earth::Geodetic;
use crate::math::compensated::{Pair, Plain, TwoFloat};
use crate::math::quaternion::Quaternion;
use crate::math::vector::Vector;

/// A state that can name its fields, to read them or to write them back.
///
/// `visit` gets a field's name and its bits in the low end of a word, and returns the bits that the
/// field is to have; to read, it returns the same bits. The order is fixed. A vector's components share its name.
pub trait Record {
    /// Visits the fields; `name` is this field's name in its owner.
    fn record(&mut self, name: &'static str, visit: &mut impl FnMut(&'static str, u64) -> u64);
}

macro_rules! record_numbers {
    ($($t:ty: $bits:expr, $back:expr;)+) => {
        $(impl Record for $t {
            #[inline(always)]
            fn record(
                &mut self,
                name: &'static str,
                visit: &mut impl FnMut(&'static str, u64) -> u64,
            ) {
                *self = $back(visit(name, $bits(*self)));
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

#[cfg(feature = "micromath")]
impl Record for crate::math::coarse::Coarse {
    #[inline(always)]
    fn record(&mut self, name: &'static str, visit: &mut impl FnMut(&'static str, u64) -> u64) {
        self.0.record(name, visit);
    }
}

macro_rules! record_fields {
    ($t:ident: $($field:ident),+) => {
        impl<T: Record> Record for $t<T> {
            #[inline(always)]
            fn record(
                &mut self,
                name: &'static str,
                visit: &mut impl FnMut(&'static str, u64) -> u64,
            ) {
                $(self.$field.record(name, visit);)+
            }
        }
    };
}

record_fields!(Pair: hi, lo);
record_fields!(Vector: x, y, z);
record_fields!(Quaternion: w, v);
record_fields!(Geodetic: latitude, longitude, altitude);

macro_rules! record_wrapper {
    ($($t:ident),+) => {
        $(impl<T: Record> Record for $t<T> {
            #[inline(always)]
            fn record(
                &mut self,
                name: &'static str,
                visit: &mut impl FnMut(&'static str, u64) -> u64,
            ) {
                self.0.record(name, visit);
            }
        })+
    };
}

record_wrapper!(Plain, TwoFloat);

/// Lists fields of a struct for [`Record`], each under its own name.
macro_rules! record {
    ($($field:ident),+) => {
        #[inline(always)]
        fn record(
            &mut self,
            _: &'static str,
            visit: &mut impl FnMut(&'static str, u64) -> u64,
        ) {
            $(self.$field.record(stringify!($field), visit);)+
        }
    };
}
pub(crate) use record;
