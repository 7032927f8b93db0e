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
//! (`=`). Rows may be left out, digests count them all the same.

use crate::input::{Complaint, InputError, read_text};
use std::fmt::Write as _;

const MAGIC: &str = "schuler chain 1";

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

    fn digits(self) -> usize {
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

    /// The text of the file.
    pub fn text(&self) -> String {
        let mut text = format!("{MAGIC}\n");
        for (key, value) in &self.about {
            let _ = writeln!(text, "{key}: {value}");
        }
        for Stage { name, width, fields, .. } in &self.stages {
            let _ = writeln!(text, "stage: {name} {} {}", width.name(), fields.join(" "));
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

    /// From a file.
    pub fn read(file: &str) -> Result<Self, InputError> {
        Self::parse(file, &read_text(file)?)
    }

    /// From a text; `file` names it in errors.
    pub fn parse(file: &str, text: &str) -> Result<Self, InputError> {
        let mut chain = Self::default();
        let mut lines = (1..).zip(text.lines().map(str::trim_end));
        let bad = |line: u64, what: &str, accepted: &str| {
            InputError::line(file, line, Complaint::new(what, accepted))
        };
        if lines.next().is_none_or(|(_, line)| line != MAGIC) {
            return Err(bad(1, "is not a chain", &format!("the first line \"{MAGIC}\"")));
        }
        for (number, line) in lines.by_ref() {
            if line.is_empty() {
                break;
            }
            let Some((key, value)) = line.split_once(": ") else {
                return Err(bad(
                    number,
                    "is not a line of the head",
                    "key: value, or a blank line",
                ));
            };
            if key == "stage" {
                let stage = Stage::parse(value)
                    .ok_or_else(|| bad(number, "is not a stage", "stage: NAME f32|f64 FIELD …"))?;
                chain.stages.push(stage);
            } else {
                chain.about.push((key.to_owned(), value.to_owned()));
            }
        }
        for (number, line) in lines {
            let Some((stage, rest)) = line.split_once(' ').and_then(|(name, rest)| {
                Some((chain.stages.iter_mut().find(|stage| stage.name == name)?, rest))
            }) else {
                return Err(bad(number, "does not begin with the name of a stage", ""));
            };
            if stage.take(rest).is_none() {
                let what = format!("{} samples, in order, and words", stage.name);
                let digits = stage.width.digits();
                let accepted = format!(
                    "SAMPLE and {} words of {digits} hexadecimal digits, or # or = SAMPLE and a \
                     digest of 16; samples ascend",
                    stage.fields.len()
                );
                return Err(bad(number, &format!("is not a row of {what}"), &accepted));
            }
        }
        Ok(chain)
    }
}

impl Stage {
    /// Without rows.
    pub fn new(name: &str, width: Width) -> Self {
        let (name, fields, rows, checkpoints) = (name.to_owned(), vec![], vec![], vec![]);
        Self { name, width, fields, rows, checkpoints, end: None }
    }

    fn parse(text: &str) -> Option<Self> {
        let mut words = text.split_whitespace();
        let name = words.next()?;
        let width = [Width::Single, Width::Double];
        let kind = words.next()?;
        let mut stage = Self::new(name, width.into_iter().find(|w| w.name() == kind)?);
        stage.fields = words.map(str::to_owned).collect();
        Some(stage)
    }

    /// Takes a line after the stage's name.
    fn take(&mut self, line: &str) -> Option<()> {
        let mut words = line.split_whitespace();
        let first = words.next()?;
        if first == "#" || first == "=" {
            let sample = words.next()?.parse().ok()?;
            let digest = hex(words.next()?, 16)?;
            let checkpoint = Checkpoint { sample, digest };
            if first == "=" {
                self.end = Some(checkpoint);
            } else {
                ascends(self.checkpoints.last().map(|c| c.sample), sample)?;
                self.checkpoints.push(checkpoint);
            }
            return words.next().is_none().then_some(());
        }
        let sample = first.parse().ok()?;
        ascends(self.rows.last().map(|row| row.sample), sample)?;
        let words: Option<Vec<_>> = words.map(|word| hex(word, self.width.digits())).collect();
        let words = words.filter(|words| words.len() == self.fields.len())?;
        self.rows.push(Row { sample, words });
        Some(())
    }
}

fn ascends(last: Option<u64>, next: u64) -> Option<()> {
    last.is_none_or(|last| last < next).then_some(())
}

fn hex(text: &str, digits: usize) -> Option<u64> {
    let plain = text.len() == digits && text.bytes().all(|b| b.is_ascii_hexdigit());
    plain.then(|| u64::from_str_radix(text, 16).ok()).flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "schuler chain 1\nscene: paper\nstage: noise f64 angle_b\n\
        stage: nav f32 v v v\n\nnoise 1 3ff0000000000000\nnav 1 3f800000 00000000 bf000000\n\
        nav # 1 0123456789abcdef\nnoise = 1 00000000000000ff\nnav = 1 0123456789abcdef\n";

    #[test]
    fn reads_what_it_writes() {
        let chain = Chain::parse("a", TEXT).unwrap();
        assert_eq!(chain.text(), TEXT);
        assert_eq!(chain.get("scene"), Some("paper"));
        let nav = &chain.stages[1];
        assert_eq!(nav.rows[0].words, [0x3f80_0000, 0, 0xbf00_0000]);
        assert_eq!((nav.label(0), nav.label(2)), ("v x".into(), "v z".into()));
        assert_eq!(nav.end, Some(Checkpoint { sample: 1, digest: 0x0123_4567_89ab_cdef }));
    }

    #[test]
    fn names_the_line_that_is_wrong() {
        for (from, to, line) in [
            ("schuler chain 1", "schuler chain 2", 1),
            ("scene: paper", "scene paper", 2),
            ("f64 angle_b", "f16 angle_b", 3),
            ("noise 1", "nose 1", 6),
            ("3ff0000000000000", "3ff", 6),
            ("bf000000", "bf00000g", 7),
            (" bf000000", "", 7),
            ("nav # 1 0123", "nav # 1 012", 8),
            ("= 1 00000000000000ff", "= 1 00000000000000ff 1", 9),
        ] {
            let error = Chain::parse("a", &TEXT.replacen(from, to, 1)).unwrap_err();
            assert_eq!(error.line, Some(line), "{error}");
        }
    }
}
