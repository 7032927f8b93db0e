//! The vertical channel of a replay, held to a height that is known.

use schuler::strapdown::limits::Rejected;
use schuler_simulator::navigator::Navigate;
use schuler_simulator::recording::heights::Heights;
use std::collections::VecDeque;

/// Holds the vertical at the end of every block.
pub struct Held<'a> {
    heights: &'a Heights,
    /// Ends of samples that wait in a block, s.
    ends_s: VecDeque<f64>,
    integrated: u64,
}

impl<'a> Held<'a> {
    /// To a height over time.
    pub fn new(heights: &'a Heights) -> Self {
        Self { heights, ends_s: VecDeque::new(), integrated: 0 }
    }

    /// A sample with this end has been taken.
    pub fn hold(&mut self, navigator: &mut dyn Navigate, end_s: f64) -> Result<(), Rejected> {
        self.ends_s.push_back(end_s);
        let reached = navigator.integrated();
        let mut block_end_s = None;
        while self.integrated < reached {
            block_end_s = self.ends_s.pop_front();
            self.integrated += 1;
        }
        let Some(block_end_s) = block_end_s else { return Ok(()) };
        let [altitude_m, down_m_s] = self.heights.at(block_end_s);
        navigator.hold_vertical(altitude_m, down_m_s)
    }
}
