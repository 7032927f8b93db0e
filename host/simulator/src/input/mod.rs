//! Errors in a user's input, with their place.

pub mod document;
pub mod key;
pub mod name;

use std::fmt::{self, Display, Formatter};

/// What is wrong with a value, apart from where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Complaint {
    /// What is wrong.
    pub what: String,
    /// What would be accepted; empty where `what` says it all.
    pub accepted: String,
}

impl Complaint {
    /// From its two halves.
    pub fn new(what: impl Into<String>, accepted: impl Into<String>) -> Self {
        Self { what: what.into(), accepted: accepted.into() }
    }
}

impl Display for Complaint {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.what)?;
        if self.accepted.is_empty() { Ok(()) } else { write!(f, "; accepted: {}", self.accepted) }
    }
}

impl std::error::Error for Complaint {}

/// A complaint with its place: `file:line: key: what is wrong; accepted: what would be`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputError {
    /// The file, as it was given; absent for an option of the command line.
    pub file: Option<String>,
    /// The line, from 1; absent where the whole file is meant.
    pub line: Option<u64>,
    /// The key, column or option; absent where a whole line or file is meant.
    pub key: Option<String>,
    /// What is wrong.
    pub complaint: Complaint,
}

impl InputError {
    /// About a whole file.
    pub fn file(file: &str, complaint: Complaint) -> Self {
        Self { file: Some(file.to_owned()), line: None, key: None, complaint }
    }

    /// About one line of a file.
    pub fn line(file: &str, line: u64, complaint: Complaint) -> Self {
        Self { line: Some(line), ..Self::file(file, complaint) }
    }

    /// About a key or column in one line of a file.
    pub fn key(file: &str, line: u64, key: &str, complaint: Complaint) -> Self {
        Self { key: Some(key.to_owned()), ..Self::line(file, line, complaint) }
    }

    /// About an option of the command line, with its dashes.
    pub fn option(option: &str, complaint: Complaint) -> Self {
        Self { file: None, line: None, key: Some(option.to_owned()), complaint }
    }
}

impl Display for InputError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if let Some(file) = &self.file {
            f.write_str(file)?;
            if let Some(line) = self.line {
                write!(f, ":{line}")?;
            }
            f.write_str(": ")?;
        }
        if let Some(key) = &self.key {
            write!(f, "{key}: ")?;
        }
        self.complaint.fmt(f)
    }
}

impl std::error::Error for InputError {}

/// A file's text, or an error that names the file.
pub fn read_text(file: &str) -> Result<String, InputError> {
    let bytes = std::fs::read(name::path_of(file))
        .map_err(|e| InputError::file(file, Complaint::new(format!("cannot be read: {e}"), "")))?;
    String::from_utf8(bytes).map_err(|e| {
        let valid = e.utf8_error().valid_up_to();
        let line = 1 + e.as_bytes()[..valid].iter().filter(|&&b| b == b'\n').count() as u64;
        InputError::line(file, line, Complaint::new("is not text", "UTF-8"))
    })
}

/// The numbers that a key or an option takes, in its own unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The least.
    pub least: f64,
    /// Whether the least itself is taken.
    pub least_is_in: bool,
    /// The greatest; taken unless infinite.
    pub most: f64,
    /// What is accepted, for people.
    pub accepted: &'static str,
}

impl Range {
    /// Every finite number.
    pub const FINITE: Self = Self::from_to(f64::MIN, f64::MAX, "a finite number");
    /// Finite and not negative.
    pub const NOT_NEGATIVE: Self = Self::from_to(0.0, f64::MAX, "a number from 0 up");
    /// Finite and positive.
    pub const POSITIVE: Self = Self::above(0.0, f64::MAX, "a number above 0");

    /// Both ends included.
    pub const fn from_to(least: f64, most: f64, accepted: &'static str) -> Self {
        Self { least, least_is_in: true, most, accepted }
    }

    /// The lower end excluded.
    pub const fn above(least: f64, most: f64, accepted: &'static str) -> Self {
        Self { least, least_is_in: false, most, accepted }
    }

    /// The value itself, if it lies inside.
    pub fn check(&self, value: f64) -> Result<f64, Complaint> {
        let inside = if self.least_is_in { value >= self.least } else { value > self.least };
        if !value.is_finite() {
            Err(Complaint::new(format!("{value} is not a finite number"), self.accepted))
        } else if inside && value <= self.most {
            Ok(value)
        } else {
            Err(Complaint::new(format!("{value} is out of range"), self.accepted))
        }
    }
}
