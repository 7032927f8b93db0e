//! The middle of a few values, which no outlier moves.

/// The n-th quartile of some values, the second the median; NaN of none.
pub fn quartile(values: &[f64], n: usize) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let last = sorted.len().saturating_sub(1);
    sorted.get((n * last + 2) / 4).copied().unwrap_or(f64::NAN)
}
