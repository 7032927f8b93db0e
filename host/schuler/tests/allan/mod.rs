//! Sensors identified by their Allan deviation, and by their data sheets.

mod command;
mod datasheet;
mod fit;
