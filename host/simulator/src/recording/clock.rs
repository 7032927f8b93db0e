//! The time of the samples: a constant rate with rounded stamps, or the steps of the stamps themselves.

use super::habits::Habits;
use super::line::{LeastSquares, Strip};
use super::timeline::Timed;
use crate::input::{Complaint, InputError};
use schuler::math::compensated::Pair;

/// The finest rounding that is told from none, as a power of ten of the stamps' unit.
const FINEST: i32 = 9;
/// How far a rate that is stated may be from that of the stamps: clocks are better.
const STATED: f64 = 0.01;

/// Intervals of the samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Clock {
    /// All alike: the n-th sample, missing ones counted, ends at `first_s` + n `interval_s`.
    Even {
        /// s.
        interval_s: f64,
        /// The end of the first sample, s.
        first_s: f64,
        /// Whether stamps are too coarse to stand for the samples' times.
        coarse: bool,
    },
    /// From stamp to stamp.
    Stamps {
        /// The usual one, s.
        interval_s: f64,
    },
}

impl Clock {
    /// The sample interval, or the usual one, s.
    pub fn interval_s(&self) -> f64 {
        match self {
            Self::Even { interval_s, .. } | Self::Stamps { interval_s } => *interval_s,
        }
    }

    /// The same to about twice the digits, where it is one over a whole rate.
    pub fn interval(&self) -> Pair<f64> {
        let interval_s = self.interval_s();
        let rate = (1.0 / interval_s).round();
        if 1.0 / rate == interval_s { Pair::new(rate).reciprocal() } else { Pair::new(interval_s) }
    }
}

/// Gathers stamps, and judges them in the end.
#[derive(Clone, Debug)]
pub struct Judge {
    unit_s: f64,
    /// Stamps are whole multiples of 10 to the minus this, in their unit.
    decimals: i32,
    /// Whether all stamps are numbers of single precision.
    single: bool,
    origin_s: f64,
    largest: f64,
    count: u64,
    /// Number of the last one, missing ones counted.
    n: u64,
    line: LeastSquares,
    strip: Strip,
    single_strip: Strip,
    shortest_s: f64,
    longest_s: f64,
}

impl Judge {
    /// Of no stamps yet.
    pub fn new(habits: &Habits) -> Self {
        Self {
            unit_s: habits.unit_s,
            decimals: 0,
            single: true,
            origin_s: 0.0,
            largest: 0.0,
            count: 0,
            n: 0,
            line: LeastSquares::default(),
            strip: Strip::default(),
            single_strip: Strip::default(),
            shortest_s: f64::INFINITY,
            longest_s: 0.0,
        }
    }

    /// Takes the next row, and the one before.
    pub fn add(&mut self, row: &Timed, before_s: Option<f64>) {
        match before_s {
            None => self.origin_s = row.time_s,
            Some(before_s) => {
                self.n += 1 + row.missing;
                let interval_s = (row.time_s - before_s) / (1 + row.missing) as f64;
                self.shortest_s = self.shortest_s.min(interval_s);
                self.longest_s = self.longest_s.max(interval_s);
            }
        }
        self.count += 1;
        self.largest = self.largest.max(row.stamp.abs());
        while self.decimals < FINEST && !is_multiple(row.stamp, self.decimals) {
            self.decimals += 1;
        }
        let (n, t) = (self.n as f64, row.time_s - self.origin_s);
        self.line.add(n, t);
        self.strip.add(n, t, 0.0);
        if self.single {
            let spacing = spacing_of_single(row.stamp);
            // Where decimals are coarser, they say it all.
            self.single = spacing <= 10f64.powi(-self.decimals) || is_single(row.stamp);
            let exact = f64::from(row.stamp as f32);
            let t = t + (exact - row.stamp) * self.unit_s;
            self.single_strip.add(n, t, 0.5 * spacing * self.unit_s);
        }
    }

    /// From the first sample's end to the last one's, s.
    pub fn spanned(&self, interval_s: f64) -> f64 {
        self.n as f64 * interval_s
    }

    /// The clock, and what to say of it.
    pub fn judge(
        &self,
        name: &str,
        stated: Option<f64>,
        habits: &Habits,
    ) -> Result<(Clock, String), InputError> {
        let count = self.count;
        let squares_s = self.line.slope();
        if let Some(interval_s) = stated {
            let whole = (1.0 / interval_s).round();
            let interval_s =
                if (whole * interval_s - 1.0).abs() < 1e-15 { 1.0 / whole } else { interval_s };
            let (stamps, rate) = (1.0 / squares_s, 1.0 / interval_s);
            if (stamps / rate - 1.0).abs() > STATED {
                let what = format!("{rate} Hz is not the rate of the stamps, {stamps:.4} Hz");
                let complaint = Complaint::new(what, "their rate, as it is known better");
                return Err(InputError::option("--rate", complaint));
            }
            let first_s = self.origin_s + self.line.offset(interval_s);
            let coarse = habits.coarse;
            let said = format!("{rate:.4} Hz as stated; stamps say {stamps:.4} Hz");
            return Ok((Clock::Even { interval_s, first_s, coarse }, said));
        }
        // Beside what is written, stamps have the rounding of their own numbers.
        let ulps_s = 4.0 * f64::EPSILON * self.largest * self.unit_s;
        let quantum_s = 10f64.powi(-self.decimals) * self.unit_s;
        let decimal = self.strip.slopes(quantum_s + ulps_s);
        let found = match decimal {
            Some(slopes) => Some((slopes, &self.strip, quantum_s)),
            None if self.single => {
                let slopes = self.single_strip.slopes(ulps_s);
                let quantum_s = spacing_of_single(self.largest) * self.unit_s;
                slopes.map(|slopes| (slopes, &self.single_strip, quantum_s))
            }
            None => None,
        };
        let Some(((low_s, high_s), strip, quantum_s)) = found else {
            let (slow, fast) = (1.0 / self.longest_s, 1.0 / self.shortest_s);
            if self.shortest_s <= 0.0 {
                let what = format!(
                    "several samples share a stamp, and {count} stamps are not those of one rate"
                );
                return Err(InputError::file(
                    name,
                    Complaint::new(what, "--rate HZ, which states it"),
                ));
            }
            let said = format!(
                "intervals are the steps of {count} stamps: {:.4} Hz in the mean, {slow:.4} to {fast:.4} Hz",
                1.0 / squares_s
            );
            return Ok((Clock::Stamps { interval_s: squares_s }, said));
        };
        let interval_s = within(squares_s, low_s, high_s);
        let first_s = self.origin_s + strip.offset(interval_s);
        let coarse = habits.coarse
            || quantum_s > 0.5 * interval_s && strip.excess(interval_s) > 0.1 * interval_s;
        let width_s = self.strip.excess(interval_s);
        let rounded = if width_s > 1e-6 * interval_s && width_s > 1e-9 {
            format!(", rounded to {}", span(quantum_s))
        } else {
            String::new()
        };
        let said =
            format!("{:.4} Hz by least squares over {count} stamps{rounded}", 1.0 / interval_s);
        Ok((Clock::Even { interval_s, first_s, coarse }, said))
    }
}

/// The interval by least squares if it is one that the stamps' rounding allows, else the middle of those; a
/// whole rate or a whole number of microseconds if that is allowed.
fn within(squares_s: f64, low_s: f64, high_s: f64) -> f64 {
    let allowed = |s: f64| {
        s >= low_s * (1.0 - 4.0 * f64::EPSILON) && s <= high_s * (1.0 + 4.0 * f64::EPSILON)
    };
    let interval_s = if allowed(squares_s) { squares_s } else { 0.5 * (low_s + high_s) };
    let whole_s = 1.0 / (1.0 / interval_s).round();
    let micro_s = (interval_s * 1e6).round() / 1e6;
    [whole_s, micro_s].into_iter().find(|&s| allowed(s)).unwrap_or(interval_s)
}

fn is_multiple(stamp: f64, decimals: i32) -> bool {
    let scaled = stamp * 10f64.powi(decimals);
    (scaled - scaled.round()).abs() <= 4.0 * f64::EPSILON * scaled.abs()
}

fn spacing_of_single(stamp: f64) -> f64 {
    let single = stamp.abs() as f32;
    f64::from(single.next_up()) - f64::from(single)
}

/// Whether a number is of single precision, exactly or as the fewest digits that tell it.
fn is_single(stamp: f64) -> bool {
    let single = stamp as f32;
    f64::from(single) == stamp
        || zmij::Buffer::new().format(single).parse().is_ok_and(|shortest: f64| shortest == stamp)
}

/// A span of time for people.
pub fn span(seconds: f64) -> String {
    let (factor, unit) = match seconds {
        s if s >= 1.0 => (1.0, "s"),
        s if s >= 1e-3 => (1e3, "ms"),
        s if s >= 1e-6 => (1e6, "µs"),
        _ => (1e9, "ns"),
    };
    let value = (seconds * factor * 1e4).round() / 1e4;
    format!("{value} {unit}")
}
