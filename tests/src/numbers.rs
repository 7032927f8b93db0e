//! What needs core alone: numbers to try, their comparison, the bits of states.

use schuler::math::vector::Vector;
use schuler::record::Record;
use schuler_simulator::rounding::split_mix;

/// Who reads rows, as one type for all closures: every type is a copy of the navigator to compile.
pub fn reader<'a, O>(read: &'a mut (dyn FnMut(u64, O) + 'a)) -> &'a mut (dyn FnMut(u64, O) + 'a) {
    read
}

/// The largest of some numbers; NaN if there is one.
pub fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().fold(0.0, |a, b| if a.is_nan() || a > b { a } else { b })
}

/// The bits of every field.
pub fn bits<S: Record>(state: &S) -> Vec<u64> {
    let mut words = Vec::new();
    state.record("", &mut |_, word| words.push(word));
    words
}

/// Reproducible numbers to try: Steele, Lea and Flood's SplitMix64.
pub struct Numbers(pub u64);

impl Numbers {
    /// Sixty-four bits.
    pub fn word(&mut self) -> u64 {
        split_mix::word(&mut self.0)
    }

    /// Evenly within ±bound.
    pub fn within(&mut self, bound: f64) -> f64 {
        bound * ((self.word() >> 11) as f64 * 2.0_f64.powi(-52) - 1.0)
    }

    /// Each component evenly within ±bound.
    pub fn vector(&mut self, bound: f64) -> Vector<f64> {
        Vector::new((), (), ()).map(|()| self.within(bound))
    }
}

/// Asserts a number to a share of what it should be.
pub fn near(value: f64, expected: f64, relative: f64, what: &str) {
    let error = (value - expected).abs();
    assert!(error <= relative * expected.abs(), "{what}: {value} is not {expected}");
}
