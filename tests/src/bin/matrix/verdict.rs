//! What is found: a row for each target, and what it came to.

use serde::Serialize;

/// The whole table.
#[derive(Clone, Debug, Serialize)]
pub struct Matrix {
    /// A row for each target.
    pub rows: Vec<Row>,
    /// The digests at the end of every stage, as the first row has them.
    pub flights: Vec<Flight>,
    /// How many digests the first row printed.
    pub digests: usize,
    /// How many of them are golden.
    pub golden: usize,
}

/// One target.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Its name.
    pub target: &'static str,
    /// The compiler's name of it.
    pub triple: String,
    /// The compiler.
    pub compiler: String,
    /// How it was built.
    pub flags: String,
    /// What ran it.
    pub runner: String,
    /// How long building and running took, s.
    pub time_s: f64,
    /// One digest over everything that it printed.
    pub digest: Option<String>,
    /// What it came to; absent until it is compared.
    pub verdict: Option<Verdict>,
}

/// What a row came to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// It is what the others are compared with.
    First,
    /// The same bits as the first row's.
    Equal,
    /// The first place at which it parts from the first row.
    Parts(String),
    /// The first place at which it parts from the golden chains.
    PartsFromGolden(String),
    /// What went wrong when it was built or run.
    Failed(String),
    /// What this machine lacks for it.
    Missing(String),
}

/// The digest of a stage at its end.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Flight {
    /// Scene and configuration, or scene and stage.
    pub flight: String,
    /// The stage.
    pub stage: String,
    /// Its samples.
    pub samples: String,
    /// The digest.
    pub digest: String,
}

impl Matrix {
    /// Rows that keep the promise.
    pub fn equal(&self) -> usize {
        let kept = |row: &&Row| matches!(row.verdict, Some(Verdict::First | Verdict::Equal));
        self.rows.iter().filter(kept).count()
    }

    /// Rows that break it, or that could not be had though they were required; digests that are not
    /// golden, where all is required, count as one more.
    pub fn failed(&self, require_all: bool) -> usize {
        let failed = |row: &&Row| match row.verdict {
            Some(Verdict::First | Verdict::Equal) => false,
            Some(Verdict::Missing(_)) => require_all,
            _ => true,
        };
        let lacks_golden = require_all && self.golden != self.digests;
        self.rows.iter().filter(failed).count() + usize::from(lacks_golden)
    }
}
