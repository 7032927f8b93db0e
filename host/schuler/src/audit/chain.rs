//! Chain files: a flight's stages row by row, word for word, with a running digest.
//!
//! Plain text that any language can write:
//!
//! ```text
//! schuler chain 1
//! scene: paper
//! configuration: f32 local-level taylor 0,4,0
//! stage: nav f32 velocity velocity velocity
//!
//! nav 4 3f800000 00000000 bf000000
//! nav # 64 0123456789abcdef
//! nav = 1200 0123456789abcdef
//! ```
//!
//! After the first line come `key: value` lines, of which `stage` names a stage, its words' type (f32 or
//! f64) and a field for each word. After a blank line, each line is a stage's row (sample, words in hex:
//! the IEEE bits, 8 or 16 digits), a checkpoint (`#`, sample, digest of all rows up to there) or the end
//! (`=`). Rows may be left out of the file; digests include them nevertheless.

use schuler_simulator::scene::Axes;
use std::fmt::Write as _;

/// The first line.
pub const MAGIC: &str = "schuler chain 1";

/// What one file holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chain {
    /// What is said of it: key and value, in order.
    pub about: Vec<(String, String)>,
    /// Its stages, in the order in which data flows.
    pub stages: Vec<Stage>,
}

/// One stage of a flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// Its name.
    pub name: String,
    /// The type of its words.
    pub width: Width,
    /// The field that each word belongs to.
    pub fields: Vec<String>,
    /// What is kept of its rows, in order.
    pub rows: Vec<Row>,
    /// Digests on the way.
    pub checkpoints: Vec<Checkpoint>,
    /// The digest of all of it.
    pub end: Option<Checkpoint>,
}

/// A stage's words after a number of samples.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// Samples behind it.
    pub sample: u64,
    /// Bits, a word for each field.
    pub words: Vec<u64>,
}

/// The digest of every row up to a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Checkpoint {
    /// Samples behind it.
    pub sample: u64,
    /// The digest.
    pub digest: u64,
}

/// The type of a stage's words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Width {
    /// f32.
    Single,
    /// f64.
    Double,
}

impl Width {
    /// The type's name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Single => "f32",
            Self::Double => "f64",
        }
    }

    /// The digits of a word.
    pub fn digits(self) -> usize {
        match self {
            Self::Single => 8,
            Self::Double => 16,
        }
    }
}

impl Chain {
    /// What is said under a key.
    pub fn get(&self, key: &str) -> Option<&str> {
        self.about.iter().find(|(k, _)| k == key).map(|(_, value)| value.as_str())
    }

    /// The frame of its navigator, by the `configuration` line.
    pub fn frame(&self) -> Option<Axes> {
        let name = self.get("configuration")?.split_whitespace().nth(1)?;
        name.parse().ok()
    }

    /// The text of the file.
    pub fn text(&self) -> String {
        let mut text = format!("{MAGIC}\n");
        for (key, value) in &self.about {
            let _ = writeln!(text, "{key}: {value}");
        }
        for stage in &self.stages {
            let _ = writeln!(text, "stage: {}", stage.line());
        }
        text.push('\n');
        let mut lines = Vec::new();
        for (place, stage) in self.stages.iter().enumerate() {
            let Stage { name, width, .. } = stage;
            for row in &stage.rows {
                let mut line = format!("{name} {}", row.sample);
                for word in &row.words {
                    let _ = write!(line, " {word:0digits$x}", digits = width.digits());
                }
                lines.push((row.sample, place, 0, line));
            }
            let digest = |mark: &str, c: &Checkpoint| {
                format!("{name} {mark} {} {:016x}", c.sample, c.digest)
            };
            for checkpoint in &stage.checkpoints {
                lines.push((checkpoint.sample, place, 1, digest("#", checkpoint)));
            }
            if let Some(end) = &stage.end {
                lines.push((u64::MAX, place, 2, digest("=", end)));
            }
        }
        lines.sort();
        for (.., line) in lines {
            text.push_str(&line);
            text.push('\n');
        }
        text
    }
}

impl Stage {
    /// Without rows.
    pub fn new(name: &str, width: Width) -> Self {
        let (name, fields, rows, checkpoints) = (name.to_owned(), vec![], vec![], vec![]);
        Self { name, width, fields, rows, checkpoints, end: None }
    }

    /// Its line in the head, after `stage: `.
    pub fn line(&self) -> String {
        format!("{} {} {}", self.name, self.width.name(), self.fields.join(" "))
    }

    /// Every digest, the end's too, in order.
    pub fn digests(&self) -> Vec<Checkpoint> {
        let mut digests = self.checkpoints.clone();
        digests.extend(self.end.filter(|end| digests.last() != Some(end)));
        digests
    }

    /// Samples behind the last of what is kept of it.
    pub fn last(&self) -> u64 {
        let row = self.rows.last().map(|row| row.sample);
        row.max(self.digests().last().map(|digest| digest.sample)).unwrap_or(0)
    }
}
