//! The entries of the table: cases with their checks.

use schuler_simulator::progress::CaseProgress;
use std::fmt;

/// What a check's number must be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// No more than this; a NaN is too much.
    AtMost(f64),
    /// No less than this; a NaN is too little.
    AtLeast(f64),
}

impl Bound {
    /// Whether a number keeps it.
    pub fn holds(self, measured: f64) -> bool {
        match self {
            Self::AtMost(bound) => measured <= bound,
            Self::AtLeast(bound) => measured >= bound,
        }
    }

    /// The number itself.
    pub fn value(self) -> f64 {
        match self {
            Self::AtMost(bound) | Self::AtLeast(bound) => bound,
        }
    }
}

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AtMost(bound) => write!(f, "≤ {}", number(*bound)),
            Self::AtLeast(bound) => write!(f, "≥ {}", number(*bound)),
        }
    }
}

/// A number as the table prints it: three digits.
pub fn number(x: f64) -> String {
    if x == 0.0 || (0.1..1e4).contains(&x.abs()) {
        let digits = if x.abs() < 10.0 && x != x.trunc() { 2 } else { usize::from(x != x.trunc()) };
        format!("{x:.digits$}")
    } else {
        format!("{x:.2e}")
    }
}

/// One row of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// What is measured: a word or two.
    pub what: String,
    /// What it must be.
    pub bound: Bound,
    /// What it is.
    pub measured: f64,
    /// Unit of both.
    pub unit: &'static str,
    /// Where the bound comes from, in a line.
    pub why: &'static str,
}

impl Check {
    /// Of a number that must be no more than a bound.
    pub fn at_most(
        what: impl Into<String>,
        bound: f64,
        measured: f64,
        unit: &'static str,
        why: &'static str,
    ) -> Self {
        Self { what: what.into(), bound: Bound::AtMost(bound), measured, unit, why }
    }

    /// Of a number that must be no less than a bound.
    pub fn at_least(
        what: impl Into<String>,
        bound: f64,
        measured: f64,
        unit: &'static str,
        why: &'static str,
    ) -> Self {
        Self { what: what.into(), bound: Bound::AtLeast(bound), measured, unit, why }
    }

    /// Of how often something went wrong that never may.
    pub fn never(what: impl Into<String>, times: u64, why: &'static str) -> Self {
        Self::at_most(what, 0.0, times as f64, "times", why)
    }

    /// Whether the bound is kept.
    pub fn passes(&self) -> bool {
        self.bound.holds(self.measured)
    }
}

/// What running a case comes to; an error is a case that broke off.
pub type Outcome = Result<Vec<Check>, String>;

/// A case of the table.
pub struct Case {
    /// time, motion, place, numbers, rounding or aged.
    pub group: &'static str,
    /// What is done.
    pub name: String,
    /// Whether it takes so long that only `--full` runs it.
    pub long: bool,
    run: Box<dyn Fn(&CaseProgress) -> Outcome>,
}

impl Case {
    /// A case that the short table has.
    pub fn new(
        group: &'static str,
        name: impl Into<String>,
        run: impl Fn(&CaseProgress) -> Outcome + 'static,
    ) -> Self {
        Self { group, name: name.into(), long: false, run: Box::new(run) }
    }

    /// The same, for `--full` only.
    pub fn long(self) -> Self {
        Self { long: true, ..self }
    }

    /// What `--case` is compared with.
    pub fn full_name(&self) -> String {
        format!("{}: {}", self.group, self.name)
    }

    /// Runs it.
    pub fn run(&self, progress: &CaseProgress) -> Outcome {
        (self.run)(progress)
    }
}
