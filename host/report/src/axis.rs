//! Axes: their ranges, ticks and labels.

/// One direction of a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What is shown, with its unit.
    pub label: String,
    /// The value at the left or lower end.
    pub from: f64,
    /// The value at the right or upper end; greater than `from`.
    pub to: f64,
}

impl Axis {
    /// Spans the finite ones of the values, with a little air when `air` is set; one value alone
    /// gets room on both sides.
    pub fn spanning(label: &str, values: impl IntoIterator<Item = f64>, air: bool) -> Self {
        let finite = values.into_iter().filter(|value| value.is_finite());
        let (low, high) = finite.fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v), h.max(v)));
        let (low, high) = if low > high { (0.0, 0.0) } else { (low, high) };
        // Below this the labels would all read the same.
        let least = 1e-6 * low.abs().max(high.abs());
        let share = if air { 0.06 } else { 0.0 };
        let air = match high - low {
            span if span > least => share * span,
            _ if least > 0.0 => 5e4 * least,
            _ => 1.0,
        };
        Self { label: label.to_owned(), from: low - air, to: high + air }
    }

    /// Time from 0 to an end, s, in the unit that suits it, and how many of that unit make a second.
    pub fn time(end_s: f64) -> (Self, f64) {
        let (unit, per_second) = match end_s {
            ..200.0 => ("s", 1.0),
            ..12_000.0 => ("min", 1.0 / 60.0),
            _ => ("h", 1.0 / 3600.0),
        };
        (Self::spanning(&format!("time, {unit}"), [0.0, end_s * per_second], false), per_second)
    }

    /// Where a value lies, 0 at `from` to 1 at `to`.
    pub fn fraction(&self, value: f64) -> f64 {
        (value - self.from) / (self.to - self.from)
    }

    /// About `count` round values within the range, and their labels.
    pub fn ticks(&self, count: usize) -> Vec<(f64, String)> {
        let rough = (self.to - self.from) / count.max(1) as f64;
        let decade = 10f64.powf(rough.log10().floor());
        let step = [1.0, 2.0, 5.0].map(|digit| digit * decade);
        let step = step.into_iter().find(|&step| step >= rough * 0.72).unwrap_or(10.0 * decade);
        let exponent = |value: f64| (value.abs() * 1.0001).log10().floor();
        let most = exponent(self.from.abs().max(self.to.abs()));
        let label = |value: f64| match -exponent(step) {
            _ if value == 0.0 => "0".to_owned(),
            decimals if decimals <= 7.0 && most <= 7.0 => {
                format!("{value:.*}", decimals.max(0.0) as usize)
            }
            decimals => format!("{value:.*e}", (most + decimals).max(0.0) as usize),
        };
        let first = (self.from / step - 1e-9).ceil();
        let last = (self.to / step + 1e-9).floor();
        let steps = (last - first).clamp(0.0, 4.0 * count as f64) as usize;
        (0..=steps)
            .map(|i| (first + i as f64) * step)
            // −0 would carry a sign.
            .map(|value| if value.abs() < 0.5 * step { 0.0 } else { value })
            .map(|value| (value, printed(&label(value))))
            .collect()
    }
}

/// With the minus sign of print in place of the hyphen.
pub fn printed(number: &str) -> String {
    number.replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(from: f64, to: f64, count: usize) -> Vec<String> {
        let axis = Axis { label: String::new(), from, to };
        axis.ticks(count).into_iter().map(|(_, label)| label).collect()
    }

    #[test]
    fn ticks_are_round_and_inside() {
        assert_eq!(labels(0.0, 30.0, 6), ["0", "5", "10", "15", "20", "25", "30"]);
        assert_eq!(labels(-1.3, 0.9, 4), ["−1.0", "−0.5", "0", "0.5"]);
        assert_eq!(labels(-0.13, 0.09, 5), ["−0.10", "−0.05", "0", "0.05"]);
        assert_eq!(labels(1000.0, 1000.3, 3), ["1000.0", "1000.1", "1000.2", "1000.3"]);
        assert_eq!(labels(-4e-9, 4e-9, 3), ["−4e−9", "−2e−9", "0", "2e−9", "4e−9"]);
        assert_eq!(labels(0.0, 3.2e9, 3), ["0", "1e9", "2e9", "3e9"]);
        assert_eq!(labels(-4500.0, 12_000.0, 5), ["0", "5000", "10000"]);
    }

    #[test]
    fn a_range_is_never_empty() {
        for values in [vec![], vec![0.0], vec![1e3; 5], vec![f64::NAN, 7.0], vec![-1e-12; 2]] {
            let axis = Axis::spanning("", values.clone(), true);
            assert!(axis.to > axis.from && axis.from.is_finite(), "{values:?}: {axis:?}");
            let labels = labels(axis.from, axis.to, 5);
            assert!(labels.len() >= 2, "{values:?}: {labels:?}");
            assert!(labels.is_sorted_by(|a, b| a != b), "{values:?}: {labels:?}");
        }
    }
}
