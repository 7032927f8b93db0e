//! `--every`: which rows of a long table are kept.

use schuler_simulator::input::Complaint;
use std::fmt::{self, Display, Formatter};

/// The value of `--every`: each so many rows, or a row each so many seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Every {
    /// Every N-th row.
    Rows(u64),
    /// The first row at or after each multiple of this time, s, from the start on.
    Seconds(f64),
}

const ACCEPTED: &str = "a number of rows, such as 10, or of seconds, such as 10s or 0.5s";

impl Every {
    /// From `10` (rows) or `10s`, `0.5s` (seconds).
    pub fn parse(text: &str) -> Result<Self, Complaint> {
        let every = match text.strip_suffix('s') {
            Some(seconds) => seconds.parse().ok().map(Self::Seconds),
            None => text.parse().ok().map(Self::Rows),
        };
        let right = |every: &Self| match every {
            Self::Rows(rows) => *rows > 0,
            Self::Seconds(seconds) => seconds.is_finite() && *seconds > 0.0,
        };
        every.filter(right).ok_or_else(|| Complaint::new("is neither rows nor seconds", ACCEPTED))
    }

    /// How many rows of a table are kept, the last one included.
    pub fn kept(&self, rows: u64, interval_s: f64) -> u64 {
        let kept = match self {
            Self::Rows(each) => rows.div_ceil(*each),
            Self::Seconds(seconds) => (rows as f64 * interval_s / seconds).ceil() as u64,
        };
        kept.min(rows)
    }
}

impl Display for Every {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rows(rows) => write!(f, "{rows}"),
            Self::Seconds(seconds) => write!(f, "{seconds}s"),
        }
    }
}

/// Goes along a table and tells the rows that are kept. The last row is the caller's to add.
#[derive(Clone, Debug)]
pub struct Sieve {
    every: Every,
    start_s: f64,
    rows: u64,
    /// The multiple of seconds that the next row is for.
    next: u64,
}

impl Sieve {
    /// For rows that follow a start in time, s.
    pub fn new(every: Option<Every>, start_s: f64) -> Self {
        Self { every: every.unwrap_or(Every::Rows(1)), start_s, rows: 0, next: 1 }
    }

    /// Whether the next row, at a time in s, is kept.
    pub fn keeps(&mut self, time_s: f64) -> bool {
        self.rows += 1;
        match self.every {
            Every::Rows(each) => self.rows.is_multiple_of(each),
            Every::Seconds(seconds) => {
                // A time that should be a multiple is one up to its rounding.
                let passed = (time_s - self.start_s) / seconds * (1.0 + 1e-12) + 1e-6;
                let kept = passed >= self.next as f64;
                if kept {
                    self.next = passed as u64 + 1;
                }
                kept
            }
        }
    }
}
