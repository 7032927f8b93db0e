//! The first field in which a target's answer differs from its twin's.

use schuler::flight::configuration::{Axes, Configuration, Precision};
use schuler_simulator::twin::Standing;
use std::fmt;

/// The fields of a solution in local-level and in Earth-fixed axes; each is a pair of scalars.
const LOCAL_LEVEL: [&str; 10] = [
    "latitude, rad",
    "longitude, rad",
    "altitude, m",
    "velocity north, m/s",
    "velocity east, m/s",
    "velocity down, m/s",
    "attitude w",
    "attitude x",
    "attitude y",
    "attitude z",
];
const EARTH_FIXED: [&str; 10] = [
    "position x, m",
    "position y, m",
    "position z, m",
    "velocity x, m/s",
    "velocity y, m/s",
    "velocity z, m/s",
    "attitude w",
    "attitude x",
    "attitude y",
    "attitude z",
];

/// A value on either side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Value {
    /// A count.
    Count(u64),
    /// A digest, or bits that each mean something.
    Bits(u64),
    /// The bits of a single.
    Single(u32),
    /// The bits of a double.
    Double(u64),
    /// Nothing: the answer is too short.
    Nothing,
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Count(count) => write!(f, "{count} ({count:#x})"),
            Self::Bits(bits) => write!(f, "{bits} ({bits:#018x})"),
            Self::Single(bits) => write!(f, "{:e} ({bits:#010x})", f32::from_bits(*bits)),
            Self::Double(bits) => write!(f, "{:e} ({bits:#018x})", f64::from_bits(*bits)),
            Self::Nothing => f.write_str("nothing"),
        }
    }
}

/// Where target and twin part.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Number of the sample after which they differ.
    pub sample: u64,
    /// Its end, s.
    pub time_s: f64,
    /// The field.
    pub field: String,
    /// What the target has.
    pub target: Value,
    /// What its twin has.
    pub twin: Value,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { sample, time_s, field, target, twin } = self;
        write!(
            f,
            "sample {sample} at {time_s} s: {field}: the target has {target}, its twin {twin}"
        )
    }
}

/// The first field in which two states differ, and both values.
pub fn first(
    configuration: &Configuration,
    target: &Standing,
    twin: &Standing,
) -> Option<(String, Value, Value)> {
    let count = |name: &str, a: u64, b: u64, value: fn(u64) -> Value| {
        (a != b).then(|| (name.to_owned(), value(a), value(b)))
    };
    let (double, names) = (
        configuration.precision == Precision::F64,
        if configuration.axes == Axes::LocalLevel { LOCAL_LEVEL } else { EARTH_FIXED },
    );
    let width = if double { 8 } else { 4 };
    let value = |bytes: &[u8], index: usize| {
        let scalar = bytes.get(index * width..(index + 1) * width).unwrap_or(&[]);
        match (<[u8; 4]>::try_from(scalar), <[u8; 8]>::try_from(scalar)) {
            (Ok(single), _) => Value::Single(u32::from_le_bytes(single)),
            (_, Ok(double)) => Value::Double(u64::from_le_bytes(double)),
            _ => Value::Nothing,
        }
    };
    let solution = || {
        // One more than there are: an answer may be too long.
        (0..=2 * names.len()).find_map(|index| {
            let (a, b) = (value(&target.solution, index), value(&twin.solution, index));
            let part = if index % 2 == 0 { "" } else { " (what rounding dropped)" };
            let name = names.get(index / 2).unwrap_or(&"beyond the last field");
            (a != b).then(|| (format!("{name}{part}"), a, b))
        })
    };
    count("samples taken", target.taken.into(), twin.taken.into(), Value::Count)
        .or_else(|| count("which samples came", target.came.into(), twin.came.into(), Value::Bits))
        .or_else(|| count("end of a sample, ns", target.time_ns, twin.time_ns, Value::Count))
        .or_else(|| count("samples integrated", target.integrated, twin.integrated, Value::Count))
        .or_else(solution)
        .or_else(|| count("digest of every state", target.digest, twin.digest, Value::Bits))
}
