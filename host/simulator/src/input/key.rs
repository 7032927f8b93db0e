//! Keys of a file: one description for the parser, for its complaints and for the reference of all keys.

use super::document::Section;
use super::{InputError, Range};
use std::fmt::Write as _;

/// A key of a table.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// Its name.
    pub name: &'static str,
    /// What it takes.
    pub takes: Takes,
    /// What its absence means; empty where it must be there.
    pub absent: &'static str,
    /// What it is.
    pub means: &'static str,
}

/// What a key takes.
#[derive(Clone, Copy, Debug)]
pub enum Takes {
    /// A number.
    Number(Range),
    /// Something else, in words.
    Said(&'static str),
}

/// A table of keys.
#[derive(Clone, Copy, Debug)]
pub struct Table {
    /// How a file writes it.
    pub name: &'static str,
    /// What it is.
    pub means: &'static str,
    /// Its keys.
    pub keys: &'static [Key],
}

impl Key {
    /// The numbers that it takes; every finite one where it takes something else.
    pub const fn range(&self) -> Range {
        match self.takes {
            Takes::Number(range) => range,
            Takes::Said(accepted) => Range { accepted, ..Range::FINITE },
        }
    }

    /// What it takes, for people.
    pub const fn accepted(&self) -> &'static str {
        self.range().accepted
    }
}

impl Table {
    /// The names of its keys.
    pub fn names(&self) -> Vec<&'static str> {
        self.keys.iter().map(|key| key.name).collect()
    }

    /// Its part of the reference, in Markdown.
    pub fn reference(&self) -> String {
        let mut text = format!("## {}\n\n{}\n\n", self.name, self.means);
        text += "| key | takes | absent | is |\n|---|---|---|---|\n";
        for key in self.keys {
            let Key { name, absent, means, .. } = key;
            let absent = if absent.is_empty() { "must be there" } else { absent };
            // A String takes all that is written.
            let _ = writeln!(text, "| `{name}` | {} | {absent} | {means} |", key.accepted());
        }
        text
    }
}

impl Section<'_> {
    /// The number of a key, if it is there.
    pub fn read(&self, key: &Key) -> Result<Option<f64>, InputError> {
        self.get(key.name).map(|value| value.number(&key.range())).transpose()
    }

    /// The number of a key that must be there.
    pub fn need(&self, key: &Key) -> Result<f64, InputError> {
        self.number(key.name, &key.range())
    }

    /// A table of a table's keys, if it is there.
    pub fn table(&self, key: &str, table: &Table) -> Result<Option<Self>, InputError> {
        self.section(key, &table.names())
    }
}

/// Keys as constants, and the table of them.
///
/// ```
/// schuler_simulator::table! {
///     /// A link.
///     LINK = "[link]", "What happens to samples on their way.";
///     LOSS = "loss": Takes::Number(Range::NOT_NEGATIVE), "0", "the share that is lost";
/// }
/// use schuler_simulator::input::{Range, key::Takes};
/// assert_eq!(LINK.names(), ["loss"]);
/// assert_eq!(LOSS.absent, "0");
/// ```
#[macro_export]
macro_rules! table {
    ($(#[$about:meta])* $table:ident = $path:literal, $said:literal;
     $($key:ident = $name:literal: $takes:expr, $absent:literal, $means:literal;)+) => {
        $(#[doc = concat!("`", $name, "`")]
        pub const $key: $crate::input::key::Key = $crate::input::key::Key {
            name: $name,
            takes: $takes,
            absent: $absent,
            means: $means,
        };)+
        $(#[$about])*
        pub const $table: $crate::input::key::Table = $crate::input::key::Table {
            name: $path,
            means: $said,
            keys: &[$($key),+],
        };
    };
}
