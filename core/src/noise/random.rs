//! Numbers that random streams deliver: a scalar, or a pack of numbers of independent runs, each from a
//! stream of its own run.
//!
//! ```
//! use schuler::noise::Streams;
//! use schuler::noise::random::Axes;
//!
//! let mut axes = Axes::<f64>::open(Streams::new(7, 0));
//! let [mut x, ..] = Streams::new(7, 0).axes();
//! assert_eq!(axes.normal().x, x.normal::<f64>());
//! ```

use super::{Stream, Streams};
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::record::{Record, record};
use core::fmt::Debug;

/// A real number with random deviates.
pub trait Random: Real + Record {
    /// Where they come from.
    type Stream: Clone + Debug + PartialEq + Record + Send;

    /// The stream at a place of the tree; of a pack, the first number is that of the run told, the next that
    /// of the run after it, and so on.
    fn open(place: Streams) -> Self::Stream;

    /// The next standard normal deviate; uses one word of each stream.
    fn deviate(stream: &mut Self::Stream) -> Self;
}

macro_rules! of_a_stream {
    ($($t:ty),+) => {
        $(impl Random for $t {
            type Stream = Stream;

            #[inline(always)]
            fn open(place: Streams) -> Stream {
                place.open()
            }
            #[inline(always)]
            fn deviate(stream: &mut Stream) -> $t {
                stream.normal()
            }
        })+
    };
}

of_a_stream!(f32, f64);

/// A stream for each of the axes x, y, z.
#[derive(Clone, Debug, PartialEq)]
pub struct Axes<R: Random>([R::Stream; 3]);

impl<R: Random> Axes<R> {
    /// The streams at a place of the tree.
    #[inline]
    pub fn open(place: Streams) -> Self {
        Self([0, 1, 2].map(|axis| R::open(place.branch(axis))))
    }

    /// The next deviate of each axis.
    #[inline(always)]
    pub fn normal(&mut self) -> Vector<R> {
        let [x, y, z] = &mut self.0;
        Vector::new(R::deviate(x), R::deviate(y), R::deviate(z))
    }

    /// The stream of each axis.
    #[inline(always)]
    pub fn each_mut(&mut self) -> &mut [R::Stream; 3] {
        &mut self.0
    }
}

impl<R: Random> Record for Axes<R> {
    record!(0;);
}

#[cfg(feature = "defmt")]
impl<R: Random> defmt::Format for Axes<R> {
    fn format(&self, f: defmt::Formatter) {
        defmt::write!(f, "Axes(");
        self.record("", &mut |_, word| defmt::write!(f, "{=u64:016x} ", word));
        defmt::write!(f, ")");
    }
}
