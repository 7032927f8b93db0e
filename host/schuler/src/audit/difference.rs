//! Two values of a word: decimal, bits, and the units in the last place between them.

use super::chain::{Stage, Width};
use schuler_simulator::scene::Axes;
use serde::Serialize;

/// Two values of a field.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// The field.
    pub field: String,
    /// Its value in each, with the digits that bring back its bits.
    pub decimal: [String; 2],
    /// The second value less the first.
    pub difference: f64,
    /// The bits of each.
    pub bits: [String; 2],
    /// How many numbers of the type lie between, and one.
    pub ulps: u64,
}

/// Between two values of a stage's word.
pub fn between(stage: &Stage, frame: Option<Axes>, word: usize, a: u64, b: u64) -> Difference {
    let value = |bits: u64| match stage.width {
        Width::Single => f64::from(f32::from_bits(bits as u32)),
        Width::Double => f64::from_bits(bits),
    };
    let decimal = |bits: u64| match stage.width {
        Width::Single => zmij::Buffer::new().format(f32::from_bits(bits as u32)).to_owned(),
        Width::Double => zmij::Buffer::new().format(f64::from_bits(bits)).to_owned(),
    };
    let hex = |bits: u64| format!("0x{bits:0digits$x}", digits = stage.width.digits());
    Difference {
        field: stage.label(word, frame),
        decimal: [decimal(a), decimal(b)],
        difference: value(b) - value(a),
        bits: [hex(a), hex(b)],
        ulps: ulps(stage.width, a, b),
    }
}

/// How many numbers of a type one has to step over to come from one to the other; −0 and +0 are one
/// apart, so that no difference of bits counts as none.
pub fn ulps(width: Width, a: u64, b: u64) -> u64 {
    let sign = match width {
        Width::Single => 1 << 31,
        Width::Double => 1 << 63,
    };
    // In order of value: −0 is −1, +0 is 0.
    let ordered = |bits: u64| {
        let magnitude = i128::from(bits & (sign - 1));
        if bits & sign == 0 { magnitude } else { -magnitude - 1 }
    };
    u64::try_from((ordered(a) - ordered(b)).unsigned_abs()).unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ulps_count_steps() {
        let of = |a: f64, b: f64| ulps(Width::Double, a.to_bits(), b.to_bits());
        assert_eq!(of(1.0, 1.0), 0);
        assert_eq!(of(1.0, 1.0f64.next_up()), 1);
        assert_eq!(of(1.0f64.next_down(), 1.0f64.next_up()), 2);
        assert_eq!(of(0.0, -0.0), 1);
        assert_eq!(of(f64::from_bits(1), -f64::from_bits(1)), 3);
        assert_eq!(of(f64::INFINITY, f64::NEG_INFINITY), 2 * f64::INFINITY.to_bits() + 1);
        let single = |a: f32, b: f32| ulps(Width::Single, a.to_bits().into(), b.to_bits().into());
        assert_eq!(single(-2.0, -2.0f32.next_down()), 1);
    }
}
