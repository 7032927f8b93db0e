//! Numbers for people: units with a fitting prefix, about four significant digits.

/// So many of something, with the verb that goes with it: "1 sample is", "2 samples are".
///
/// ```
/// use schuler_simulator::number::counted;
/// assert_eq!(counted(1, "sample is", "samples are"), "1 sample is");
/// assert_eq!(counted(0, "sample is", "samples are"), "0 samples are");
/// ```
pub fn counted(count: u64, one: &str, several: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { several })
}

/// With so many decimals; what rounds to nothing has no sign.
///
/// ```
/// use schuler_simulator::number::fixed;
/// assert_eq!([-0.04, -0.06, 12.0].map(|x| fixed(x, 1)), ["0.0", "-0.1", "12.0"]);
/// ```
pub fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(magnitude) if magnitude.bytes().all(|b| b == b'0' || b == b'.') => {
            magnitude.to_owned()
        }
        _ => text,
    }
}

/// What a number measures, in the unit of [`Nine`](crate::flight::Nine).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// m.
    Position,
    /// m/s.
    Velocity,
    /// arcsec.
    Attitude,
}

/// A unit to show numbers in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// Its symbol.
    pub name: &'static str,
    /// How many of it make one m, m/s or arcsec.
    pub factor: f64,
}

const fn units(named: [(&'static str, f64); 6]) -> [Unit; 6] {
    let mut units = [Unit { name: "", factor: 1.0 }; 6];
    let mut i = 0;
    while i < 6 {
        units[i] = Unit { name: named[i].0, factor: named[i].1 };
        i += 1;
    }
    units
}

// The largest first; the second is the quantity's own.
const POSITION: [Unit; 6] =
    units([("km", 1e-3), ("m", 1.0), ("mm", 1e3), ("µm", 1e6), ("nm", 1e9), ("pm", 1e12)]);
const VELOCITY: [Unit; 6] = units([
    ("km/s", 1e-3),
    ("m/s", 1.0),
    ("mm/s", 1e3),
    ("µm/s", 1e6),
    ("nm/s", 1e9),
    ("pm/s", 1e12),
]);
const ATTITUDE: [Unit; 6] = units([
    ("°", 1.0 / 3600.0),
    ("arcsec", 1.0),
    ("mas", 1e3),
    ("µas", 1e6),
    ("nas", 1e9),
    ("pas", 1e12),
]);

impl Quantity {
    /// The unit in which numbers up to `largest` (m, m/s, arcsec) are best read: the plain one
    /// from 1 to 99999, of angles to 1800, else the one that makes the largest at least 1; half a degree is one.
    pub fn unit(self, largest: f64) -> Unit {
        let [huge, plain, small @ .., tiny] = match self {
            Self::Position => POSITION,
            Self::Velocity => VELOCITY,
            Self::Attitude => ATTITUDE,
        };
        let most = if self == Self::Attitude { 1800.0 } else { 1e5 };
        if largest >= most {
            huge
        } else if largest >= 1.0 || largest == 0.0 || !largest.is_finite() {
            plain
        } else {
            small.into_iter().find(|unit| largest * unit.factor >= 1.0).unwrap_or(tiny)
        }
    }

    /// A value (m, m/s, arcsec) with the unit that fits it.
    pub fn show(self, value: f64) -> String {
        let unit = self.unit(value.abs());
        format!("{} {}", short(value * unit.factor), unit.name)
    }
}

/// About `digits` significant digits: from -99999 to 99999 no longer than `digits` + 2 or 6.
pub fn rounded(value: f64, digits: i32) -> String {
    let magnitude = value.abs();
    if value == 0.0 {
        return "0".to_owned();
    }
    if magnitude < 0.5 * 10f64.powi(1 - digits) {
        return format!("{value:.0e}");
    }
    // As many decimals as the rounded number leaves room for.
    let is_below = |power: i32| magnitude < 10f64.powi(power) * (1.0 - 0.5 * 10f64.powi(-digits));
    match (1..=5).find(|&power| is_below(power)) {
        Some(power) => format!("{value:.*}", (digits - power).max(0) as usize),
        None => format!("{value:.1e}"),
    }
}

/// About four significant digits.
pub fn short(value: f64) -> String {
    rounded(value, 4)
}

/// The digits that bring back its bits: for files.
pub fn exact(value: f64) -> String {
    zmij::Buffer::new().format(value).to_owned()
}

/// Six significant digits without the zeros that end them: for parameters.
pub fn parameter(value: f64) -> String {
    let magnitude = value.abs();
    if value != 0.0 && !(1e-4..1e7).contains(&magnitude) {
        let text = format!("{value:.5e}");
        return match text.split_once('e') {
            Some((digits, exponent)) => format!("{}e{exponent}", trim(digits)),
            None => text,
        };
    }
    let before = if value == 0.0 { 0 } else { magnitude.log10().floor() as i32 };
    trim(&format!("{value:.*}", (5 - before).clamp(0, 9) as usize)).to_owned()
}

fn trim(digits: &str) -> &str {
    if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_numbers_fit_six_characters() {
        for (value, text) in [
            (0.0, "0"),
            (-1.23456, "-1.235"),
            (9.9999, "10.00"),
            (99.999, "100.0"),
            (-999.99, "-1000"),
            (-99_999.0, "-1.0e5"),
            (-99_994.0, "-99994"),
            (3.2e-7, "3e-7"),
            (1.26e6, "1.3e6"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(short(value), text);
        }
        for (value, text) in [(-12.345, "-12.3"), (0.0049, "5e-3"), (999.7, "1000"), (0.5, "0.50")]
        {
            assert_eq!(rounded(value, 3), text);
        }
    }

    #[test]
    fn units_follow_the_largest_number() {
        for (largest, name) in [
            (0.0, "m"),
            (3e-9, "nm"),
            (0.999, "mm"),
            (1.0, "m"),
            (99_999.0, "m"),
            (2e5, "km"),
            (1e-15, "pm"),
        ] {
            assert_eq!(Quantity::Position.unit(largest).name, name, "{largest}");
        }
        assert_eq!(Quantity::Attitude.show(-1.8e5), "-50.00 °");
        assert_eq!(Quantity::Attitude.show(1800.0), "0.500 °");
        assert_eq!(Quantity::Attitude.show(1799.0), "1799 arcsec");
        assert_eq!(Quantity::Velocity.show(2.5e-4), "250.0 µm/s");
    }

    #[test]
    fn parameters_drop_idle_zeros() {
        for (value, text) in [
            (0.0, "0"),
            (0.1 * (1.0 + 1e-15), "0.1"),
            (720.0, "720"),
            (-1_234_567.0, "-1234567"),
            (1.5e-6, "1.5e-6"),
            (0.000_123_456_7, "0.000123457"),
        ] {
            assert_eq!(parameter(value), text);
        }
    }
}
