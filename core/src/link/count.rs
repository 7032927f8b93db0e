//! The samples of a numbered stream: how many have come, and whether it has ended.
//!
//! A host may say a number again, and may leave some out. Samples that are missing are numbered as if they had been
//! there.

use super::frame::Writer;
use super::gap::MOST_BRIDGED;
use super::refusal::Refusal;
use crate::record::{Record, record};

/// What has come of a stream.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Count {
    /// Number of the last sample, and of the last 32 a bit each: whether it came.
    taken: u32,
    came: u32,
    /// 1 after the end of the stream.
    finished: u32,
}

impl Count {
    /// How many samples are missing before the one of a number, from 1; `None` if that was taken before.
    #[inline]
    pub fn before(&self, number: u32) -> Result<Option<u32>, Refusal> {
        if number <= self.taken {
            return Ok(None);
        }
        self.goes_on()?;
        self.missing(number.saturating_sub(1)).map(Some)
    }

    /// Counts the sample of a number, with those that are missing before it.
    #[inline]
    pub fn take(&mut self, number: u32, missing: u32) {
        self.taken = number;
        self.came = self.came.unbounded_shl(missing) << 1 | 1;
    }

    /// How many samples are missing at the end of a stream of so many; `None` if it has ended before.
    #[inline]
    pub fn before_end(&self, samples: u32) -> Result<Option<u32>, Refusal> {
        if self.finished != 0 {
            return Ok(None);
        }
        if samples < self.taken {
            return Err(Refusal::Count);
        }
        self.missing(samples).map(Some)
    }

    /// Ends the stream after so many samples, with those that are missing.
    #[inline]
    pub fn end(&mut self, samples: u32, missing: u32) {
        self.taken = samples;
        self.came = self.came.unbounded_shl(missing);
        self.finished = 1;
    }

    /// Whether the stream goes on.
    #[inline]
    pub fn goes_on(&self) -> Result<(), Refusal> {
        if self.finished == 0 { Ok(()) } else { Err(Refusal::Finished) }
    }

    fn missing(&self, number: u32) -> Result<u32, Refusal> {
        let missing = number.saturating_sub(self.taken);
        if missing > MOST_BRIDGED { Err(Refusal::Gap) } else { Ok(missing) }
    }

    /// Number of the last sample taken, or filled in.
    pub fn taken(&self) -> u32 {
        self.taken
    }

    /// Of the last 32 samples a bit each, the newest lowest: whether it came.
    pub fn came(&self) -> u32 {
        self.came
    }

    /// Whether a restored count can be one.
    pub fn is_plausible(&self) -> bool {
        self.finished <= 1
    }

    /// The numbers that an answer begins with: the last sample, those that came, those integrated.
    pub fn write(&self, integrated: u64, to: &mut Writer) {
        to.u32(self.taken);
        to.u32(self.came);
        to.u64(integrated);
    }
}

impl Record for Count {
    record!(taken, came, finished);
}
