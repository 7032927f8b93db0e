//! Recorded inertial data: reading it row by row, its time, writing it, and the state it starts from.

pub mod clock;
pub mod csv;
pub mod foreign;
pub mod habits;
pub mod heights;
pub mod instant;
pub mod lag;
pub mod line;
pub mod lines;
pub mod measure;
pub mod mounting;
pub mod navigation;
pub mod periods;
pub mod psins;
pub mod quadrature;
pub mod reduction;
pub mod reference;
pub mod rows;
pub mod samples;
pub mod survey;
pub mod table;
pub mod time_tag;
pub mod timeline;
pub mod track;
pub mod writer;

pub use schuler::alignment::units::Kind;

use crate::input::InputError;
use schuler::sample::Increment;

/// A row as it stands in its file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Its time stamp, in whatever unit the file has.
    pub stamp: f64,
    /// The line in its file, from 1.
    pub line: u64,
    /// What it holds, forward, right, down; rates stand in the place of increments. Zero where only the
    /// stamp was asked for.
    pub values: Increment<f64>,
    /// Whether its text is that of the row before.
    pub repeated: bool,
}

/// A line that is not a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Unread {
    /// Its time stamp, where that can be read.
    pub stamp: Option<f64>,
    /// What is wrong.
    pub error: Box<InputError>,
}
