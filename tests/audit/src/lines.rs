//! The output on every target: a line for each checkpoint of each stage.

use crate::platform;
use crate::recording::Reader;
use core::fmt::{self, Write};
use schuler::digest::Checkpoint;
use schuler::flight::configuration::Configuration;

/// Prints `paper/f32-local-level-textbook nav 64 0123456789abcdef`, and `=1200` at the end.
pub struct Lines {
    /// The scene's name.
    pub scene: &'static str,
    /// The configuration, unless it is a stage that all of them share.
    pub configuration: Option<Configuration>,
}

impl Lines {
    fn print(&self, stage: &str, end: bool, at: Checkpoint) {
        let mut line = Line { bytes: [0; 96], length: 0 };
        line.text(self.scene);
        line.byte(b'/');
        // A line takes everything.
        let _ = match self.configuration {
            Some(configuration) => write!(Name(&mut line), "{configuration}"),
            None => write!(Name(&mut line), "{stage}"),
        };
        line.byte(b' ');
        line.text(stage);
        line.byte(b' ');
        if end {
            line.byte(b'=');
        }
        line.decimal(at.sample);
        line.byte(b' ');
        line.hexadecimal(at.digest);
        line.byte(b'\n');
        platform::print(line.bytes.get(..line.length).unwrap_or(&[]));
    }
}

impl Reader for Lines {
    fn checkpoint(&mut self, stage: &'static str, at: Checkpoint) {
        self.print(stage, false, at);
    }

    fn end(&mut self, stage: &'static str, at: Checkpoint) {
        self.print(stage, true, at);
    }
}

/// A line as it is put together.
struct Line {
    bytes: [u8; 96],
    length: usize,
}

impl Line {
    fn byte(&mut self, byte: u8) {
        if let Some(place) = self.bytes.get_mut(self.length) {
            *place = byte;
            self.length += 1;
        }
    }

    fn text(&mut self, text: &str) {
        text.bytes().for_each(|byte| self.byte(byte));
    }

    fn decimal(&mut self, number: u64) {
        if number >= 10 {
            self.decimal(number / 10);
        }
        self.byte(b'0' + (number % 10) as u8);
    }

    fn hexadecimal(&mut self, number: u64) {
        for digit in (0..16).rev().map(|place| (number >> (4 * place)) as u8 & 15) {
            self.byte(if digit < 10 { b'0' + digit } else { b'a' + (digit - 10) });
        }
    }
}

/// Writes a configuration as a name: `f32-local-level-taylor-0-4-0`.
struct Name<'a>(&'a mut Line);

impl Write for Name<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        text.bytes().map(name_byte).for_each(|byte| self.0.byte(byte));
        Ok(())
    }
}

/// A byte of a configuration's words as it is in a name.
fn name_byte(byte: u8) -> u8 {
    if matches!(byte, b' ' | b',') { b'-' } else { byte }
}
