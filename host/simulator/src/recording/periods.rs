//! Counters that wrap around: the period of each.

/// Name and length, s, of what is known to come round.
pub const PERIODS: [(&str, f64); 6] = [
    ("a GPS week", 604_800.0),
    ("a day", 86_400.0),
    ("a 32-bit counter of milliseconds", 4_294_967.296),
    ("a 32-bit counter of microseconds", 4_294.967_296),
    ("a 16-bit counter of milliseconds", 65.536),
    ("a 24-bit counter of microseconds", 16.777_216),
];

/// What came round between two stamps of which the second is less, if exactly one counter explains it: the
/// step is then an ordinary one, and the second stamp lies within it of the counter's start.
pub fn come_round(before_s: f64, after_s: f64, longest_step_s: f64) -> Option<usize> {
    let explains = |period_s: f64| {
        let step_s = after_s - before_s + period_s;
        let ordinary = step_s > 0.0 && step_s <= longest_step_s;
        // A counter with a sign starts over from the least number.
        let start_s = if before_s > 0.75 * period_s { 0.0 } else { -0.5 * period_s };
        let slack_s = 1e-6 * longest_step_s;
        ordinary && after_s >= start_s - slack_s && after_s <= start_s + step_s + slack_s
    };
    let mut found = (0..PERIODS.len()).filter(|&i| explains(PERIODS[i].1));
    let first = found.next()?;
    found.next().is_none().then_some(first)
}
