//! A run as ROS 2 messages: what the sensors read, the true motion and the computed one.

use super::every::Every;
use super::thinned::Thinned;
use schuler_simulator::flight::Instant;
use schuler_simulator::formats::mcap::{McapWriter, Motion};
use schuler_simulator::input::InputError;
use schuler_simulator::output::OutputFile;
use schuler_simulator::source::{Samples, Source};
use std::path::Path;

/// The file being written.
pub struct Messages<'a> {
    writer: McapWriter,
    interval_s: f64,
    /// The samples once more: they are the same for every stream that a source starts.
    samples: Samples<'a>,
    kept: Thinned,
    is_begun: bool,
}

impl<'a> Messages<'a> {
    /// Of the run of a number, to be at a path. All samples are written, and the states that are wanted.
    pub fn create(
        path: &Path,
        source: &'a Source,
        run: u64,
        every: Option<Every>,
    ) -> Result<Self, InputError> {
        Ok(Self {
            writer: McapWriter::create(path)?,
            interval_s: 1.0 / source.rate_hz(),
            samples: source.start(run),
            kept: Thinned::new(every, 0.0),
            is_begun: false,
        })
    }

    /// Takes the next instant, the end of the next sample; the first is the start.
    pub fn row(&mut self, instant: &Instant) -> Result<(), InputError> {
        if self.is_begun
            && let Some(increment) = self.samples.advance()
        {
            self.writer.increment(instant.time_s, self.interval_s, &increment)?;
        }
        self.is_begun = true;
        if self.kept.keeps(instant) { self.write(instant) } else { Ok(()) }
    }

    fn write(&mut self, instant: &Instant) -> Result<(), InputError> {
        let Instant { time_s, computed, truth, .. } = instant;
        self.writer.state(Motion::Truth, *time_s, truth)?;
        self.writer.state(Motion::Computed, *time_s, computed)
    }

    /// The file, whole, but not in its place yet.
    pub fn into_file(mut self) -> Result<OutputFile, InputError> {
        if let Some(last) = self.kept.last() {
            self.write(&last)?;
        }
        self.writer.into_file()
    }
}
