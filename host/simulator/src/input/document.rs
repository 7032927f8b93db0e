//! TOML read key by key, so that every error message has its line.

use super::{Complaint, InputError, Range};
use std::ops::Range as Span;
use toml::de::{DeTable, DeValue};

/// A parsed document: its root table and where it came from.
#[derive(Debug)]
pub struct Document<'a> {
    file: &'a str,
    text: &'a str,
    root: toml::Spanned<DeTable<'a>>,
}

/// The table of a document, whose keys are all known.
#[derive(Clone, Debug)]
pub struct Section<'a> {
    source: Source<'a>,
    /// Dotted name with a trailing dot; empty for the root.
    prefix: String,
    start: usize,
    table: &'a DeTable<'a>,
}

/// One value of a document.
#[derive(Clone, Debug)]
pub struct Value<'a> {
    source: Source<'a>,
    key: String,
    start: usize,
    value: &'a DeValue<'a>,
}

#[derive(Clone, Copy, Debug)]
struct Source<'a> {
    file: &'a str,
    text: &'a str,
}

impl Source<'_> {
    fn line(self, offset: usize) -> u64 {
        1 + self.text.bytes().take(offset).filter(|&b| b == b'\n').count() as u64
    }

    fn error(self, offset: usize, key: &str, complaint: Complaint) -> InputError {
        InputError::key(self.file, self.line(offset), key, complaint)
    }
}

impl<'a> Document<'a> {
    /// From a file's text; `file` is its name for complaints.
    pub fn parse(file: &'a str, text: &'a str) -> Result<Self, InputError> {
        let root = DeTable::parse(text).map_err(|e| {
            let offset = e.span().map_or(text.len(), |span: Span<usize>| span.start);
            let what = format!("is not TOML: {}", e.message());
            InputError::line(file, Source { file, text }.line(offset), Complaint::new(what, ""))
        })?;
        Ok(Self { file, text, root })
    }

    /// The root table, which may have these keys.
    pub fn root(&'a self, known: &[&str]) -> Result<Section<'a>, InputError> {
        let source = Source { file: self.file, text: self.text };
        Section { source, prefix: String::new(), start: 0, table: self.root.get_ref() }
            .knowing(known)
    }

    /// A complaint about a dotted key, at the line of as much of it as there is.
    pub fn error(&self, key: &str, complaint: Complaint) -> InputError {
        let mut offset = 0;
        let mut table = Some(self.root.get_ref());
        for part in key.split('.') {
            let Some((name, value)) = table.and_then(|t| t.get_key_value(part)) else { break };
            offset = name.span().start;
            table = value.get_ref().as_table();
        }
        Source { file: self.file, text: self.text }.error(offset, key, complaint)
    }
}

impl<'a> Section<'a> {
    fn knowing(self, known: &[&str]) -> Result<Self, InputError> {
        let unknown = self.table.keys().filter(|key| !known.contains(&key.get_ref().as_ref()));
        match unknown.min_by_key(|key| key.span().start) {
            None => Ok(self),
            Some(key) => {
                let place = if self.prefix.is_empty() {
                    "the top level".to_owned()
                } else {
                    format!("[{}]", self.prefix.trim_end_matches('.'))
                };
                let complaint = Complaint::new(
                    format!("is not a key of {place}{}", did_you_mean(key.get_ref(), known)),
                    known.join(", "),
                );
                let name = self.name(key.get_ref());
                Err(self.source.error(key.span().start, &name, complaint))
            }
        }
    }

    fn name(&self, key: &str) -> String {
        format!("{}{key}", self.prefix)
    }

    /// The value of a key, if it is there.
    pub fn get(&self, key: &str) -> Option<Value<'a>> {
        let (name, value) = self.table.get_key_value(key)?;
        Some(Value {
            source: self.source,
            key: self.name(key),
            start: name.span().start,
            value: value.get_ref(),
        })
    }

    /// The value of a key that must be there; `accepted` says what it would be.
    pub fn require(&self, key: &str, accepted: &str) -> Result<Value<'a>, InputError> {
        self.get(key).ok_or_else(|| {
            let complaint = Complaint::new("is missing", accepted);
            self.source.error(self.start, &self.name(key), complaint)
        })
    }

    /// A number that must be there.
    pub fn number(&self, key: &str, range: &Range) -> Result<f64, InputError> {
        self.require(key, range.accepted)?.number(range)
    }

    /// A number, or what it is when absent.
    pub fn number_or(&self, key: &str, absent: f64, range: &Range) -> Result<f64, InputError> {
        self.get(key).map_or(Ok(absent), |value| value.number(range))
    }

    /// A complaint about the whole.
    pub fn error(&self, complaint: Complaint) -> InputError {
        self.source.error(self.start, self.prefix.trim_end_matches('.'), complaint)
    }

    /// A complaint about one of its keys, where that stands if it is there.
    pub fn blame(&self, key: &str, complaint: Complaint) -> InputError {
        match self.get(key) {
            Some(value) => value.error(complaint),
            None => self.source.error(self.start, &self.name(key), complaint),
        }
    }

    /// A table with these keys, if it is there.
    pub fn section(&self, key: &str, known: &[&str]) -> Result<Option<Self>, InputError> {
        self.get(key).map(|value| value.section(known)).transpose()
    }
}

impl<'a> Value<'a> {
    /// A complaint about this value.
    pub fn error(&self, complaint: Complaint) -> InputError {
        self.source.error(self.start, &self.key, complaint)
    }

    fn mismatch(&self, accepted: &str) -> InputError {
        let article = if self.value.type_str().starts_with(['a', 'i']) { "an" } else { "a" };
        self.error(Complaint::new(format!("is {article} {}", self.value.type_str()), accepted))
    }

    /// A number within a range.
    pub fn number(&self, range: &Range) -> Result<f64, InputError> {
        let number = match self.value {
            DeValue::Float(x) => x.as_str().parse().ok(),
            DeValue::Integer(n) if n.radix() == 10 => n.as_str().parse().ok(),
            DeValue::Integer(n) => {
                i128::from_str_radix(n.as_str(), n.radix()).ok().map(|n| n as f64)
            }
            _ => return Err(self.mismatch(range.accepted)),
        };
        number
            .ok_or_else(|| Complaint::new("is not a number that fits", range.accepted))
            .and_then(|number| range.check(number))
            .map_err(|complaint| self.error(complaint))
    }

    /// One number for all axes, or [x, y, z].
    pub fn axes(&self, range: &Range) -> Result<[f64; 3], InputError> {
        let accepted = || format!("{}, or [x, y, z] of such", range.accepted);
        match self.value {
            DeValue::Array(_) => {
                let items = self.items("")?;
                let [x, y, z] = items.as_slice() else {
                    let what = format!("has {} values", items.len());
                    return Err(self.error(Complaint::new(what, accepted())));
                };
                Ok([x.number(range)?, y.number(range)?, z.number(range)?])
            }
            DeValue::Float(_) | DeValue::Integer(_) => self.number(range).map(|x| [x; 3]),
            _ => Err(self.mismatch(&accepted())),
        }
    }

    /// Three rows of three numbers.
    pub fn rows(&self, range: &Range) -> Result<[[f64; 3]; 3], InputError> {
        let accepted = format!("three rows [x, y, z] of numbers: {}", range.accepted);
        let items = self.items(&accepted)?;
        let [x, y, z] = items.as_slice() else {
            let what = format!("has {} rows", items.len());
            return Err(self.error(Complaint::new(what, accepted)));
        };
        let row = |value: &Value<'_>| match value.is_list() {
            true => value.axes(range),
            false => Err(value.mismatch(&accepted)),
        };
        Ok([row(x)?, row(y)?, row(z)?])
    }

    /// An integer from `least` to `most`.
    pub fn integer(&self, least: u64, most: u64) -> Result<u64, InputError> {
        let accepted = format!("an integer from {least} to {most}");
        let DeValue::Integer(n) = self.value else { return Err(self.mismatch(&accepted)) };
        match u64::from_str_radix(n.as_str(), n.radix()) {
            Ok(n) if (least..=most).contains(&n) => Ok(n),
            _ => Err(self.error(Complaint::new(format!("{n} is out of range"), accepted))),
        }
    }

    /// True or false.
    pub fn truth(&self, accepted: &str) -> Result<bool, InputError> {
        match self.value {
            DeValue::Boolean(truth) => Ok(*truth),
            _ => Err(self.mismatch(accepted)),
        }
    }

    /// Text.
    pub fn text(&self, accepted: &str) -> Result<&'a str, InputError> {
        self.value.as_str().ok_or_else(|| self.mismatch(accepted))
    }

    /// One of some names.
    pub fn choice<T: Copy>(&self, names: &[(&str, T)]) -> Result<T, InputError> {
        let accepted = choices(names);
        let text = self.text(&accepted)?;
        let found = names.iter().find(|(name, _)| *name == text).map(|(_, choice)| *choice);
        found.ok_or_else(|| self.error(Complaint::new(format!("there is no \"{text}\""), accepted)))
    }

    /// The elements of an array.
    pub fn items(&self, accepted: &str) -> Result<Vec<Value<'a>>, InputError> {
        let array = self.value.as_array().ok_or_else(|| self.mismatch(accepted))?;
        let item = |(i, item): (usize, &'a toml::Spanned<DeValue<'a>>)| Value {
            source: self.source,
            key: format!("{}[{i}]", self.key),
            start: item.span().start,
            value: item.get_ref(),
        };
        Ok(array.iter().enumerate().map(item).collect())
    }

    /// Whether it is a table.
    pub fn is_table(&self) -> bool {
        self.value.is_table()
    }

    /// Whether it is a list.
    pub fn is_list(&self) -> bool {
        self.value.is_array()
    }

    /// Whether it is text.
    pub fn is_text(&self) -> bool {
        self.value.is_str()
    }

    /// A table with these keys.
    pub fn section(&self, known: &[&str]) -> Result<Section<'a>, InputError> {
        let table = self
            .value
            .as_table()
            .ok_or_else(|| self.mismatch(&format!("a table with the keys {}", known.join(", "))))?;
        let prefix = format!("{}.", self.key);
        Section { source: self.source, prefix, start: self.start, table }.knowing(known)
    }
}

/// The names as a person would write them.
pub fn choices<T>(names: &[(&str, T)]) -> String {
    let names: Vec<_> = names.iter().map(|(name, _)| format!("\"{name}\"")).collect();
    names.join(", ")
}

/// ": did you mean …?" with the known names nearest to one that isn't, or nothing if none is near.
pub fn did_you_mean(name: &str, known: &[&str]) -> String {
    let mut near: Vec<_> = known
        .iter()
        .map(|candidate| (strsim::jaro_winkler(name, candidate), candidate))
        .filter(|(likeness, _)| *likeness > 0.75)
        .collect();
    near.sort_by(|a, b| b.0.total_cmp(&a.0));
    let names: Vec<_> = near.iter().take(3).map(|(_, name)| format!("`{name}`")).collect();
    if names.is_empty() { String::new() } else { format!(": did you mean {}?", names.join(", ")) }
}
