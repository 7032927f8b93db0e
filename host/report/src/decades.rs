//! Logarithmic axes.

/// A logarithmic axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decades {
    /// log₁₀ of the ends.
    from: f64,
    to: f64,
}

impl Decades {
    /// Spans what is positive and finite among the values, with some air.
    pub fn spanning(values: impl IntoIterator<Item = f64>) -> Self {
        let exponents = values.into_iter().filter(|x| *x > 0.0 && x.is_finite()).map(f64::log10);
        let (low, high) = exponents.fold((f64::MAX, f64::MIN), |(l, h), e| (l.min(e), h.max(e)));
        let (low, high) = if low > high { (0.0, 0.0) } else { (low, high) };
        let air = 0.15_f64.max(0.03 * (high - low));
        Self { from: low - air, to: high + air }
    }

    /// Where a value lies, 0 to 1; what is zero, at the lower end.
    pub fn fraction(self, value: f64) -> f64 {
        ((value.log10() - self.from) / (self.to - self.from)).clamp(0.0, 1.0)
    }

    /// Round values, at most about so many: whole decades, with 2 and 5 where there are few.
    pub fn ticks(self, most: usize) -> Vec<f64> {
        let decades = self.to - self.from;
        let step = (decades / most.max(1) as f64).ceil().max(1.0) as usize;
        let digits: &[f64] = if 3.0 * decades <= most as f64 { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let (first, last) = (self.from.floor() as i32, self.to.ceil() as i32);
        (first..=last)
            .filter(|exponent| exponent.rem_euclid(step as i32) == 0)
            .flat_map(|exponent| digits.iter().map(move |digit| digit * 10f64.powi(exponent)))
            .filter(|value| (self.from..=self.to).contains(&value.log10()))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_are_marked() {
        let axis = Decades::spanning([0.0, 1e-9, f64::NAN, 1e3, f64::INFINITY]);
        assert!(axis.fraction(1e-9) > 0.0 && axis.fraction(1e3) < 1.0);
        assert!((axis.fraction(1e-3) - 0.5).abs() < 1e-9);
        let near = |ticks: Vec<f64>, expected: &[f64]| {
            assert_eq!(ticks.len(), expected.len(), "{ticks:?}");
            assert!(ticks.iter().zip(expected).all(|(a, b)| (a / b - 1.0).abs() < 1e-12));
        };
        near(axis.ticks(7), &[1e-8, 1e-6, 1e-4, 1e-2, 1e0, 1e2]);
        near(Decades::spanning([1.5, 40.0]).ticks(12), &[2.0, 5.0, 10.0, 20.0, 50.0]);
        assert_eq!(axis.fraction(0.0), 0.0);
    }
}
