//! A navigator in flight, and the times of its rows.

use crate::arrays::increment;
use numpy::ndarray::ArrayView1;
use schuler::solution::Solution;
use schuler::strapdown::limits::Rejected;
use schuler_simulator::navigator::Navigate;
use std::collections::VecDeque;

/// What a sample changes.
pub struct Flying {
    /// The navigator.
    pub navigator: Box<dyn Navigate>,
    /// Where it started, s.
    start_s: f64,
    /// Samples taken.
    pub taken: u64,
    /// The end of the last sample, s.
    end_s: f64,
    /// Whether every sample so far had the nominal interval.
    even: bool,
    /// Ends of the samples whose rows are still to come, s.
    ends_s: VecDeque<f64>,
    /// The end of the last block, s.
    pub block_end_s: f64,
    /// Samples whose ends are behind that.
    integrated: u64,
    /// Ends of the samples that are not integrated yet, s.
    waiting_s: VecDeque<f64>,
}

impl Flying {
    /// At a time, s.
    pub fn new(navigator: Box<dyn Navigate>, start_s: f64) -> Self {
        Self {
            navigator,
            start_s,
            taken: 0,
            end_s: start_s,
            even: true,
            ends_s: VecDeque::new(),
            block_end_s: start_s,
            integrated: 0,
            waiting_s: VecDeque::new(),
        }
    }

    /// Takes a sample, and shows the rows that it completes with their times, s.
    pub fn push(
        &mut self,
        sample: ArrayView1<'_, f64>,
        interval_s: Option<f64>,
        rate_hz: f64,
        see: &mut dyn FnMut(f64, &Solution<f64>),
    ) -> Result<(), (f64, Rejected)> {
        let even = self.even && interval_s.is_none();
        let end_s = match interval_s {
            None if even => self.start_s + (self.taken + 1) as f64 / rate_hz,
            None => self.end_s + 1.0 / rate_hz,
            Some(interval_s) => self.end_s + interval_s,
        };
        self.ends_s.push_back(end_s);
        let (navigator, ends_s) = (&mut self.navigator, &mut self.ends_s);
        let mut read = |_: u64, row: &Solution<f64>| {
            see(ends_s.pop_front().unwrap_or(end_s), row);
        };
        let sample = increment(sample);
        let pushed = match interval_s {
            None => navigator.push(&sample, &mut read),
            Some(interval_s) => navigator.push_over(&sample, interval_s, &mut read),
        };
        if let Err(why) = pushed {
            self.ends_s.pop_back();
            return Err((end_s, why));
        }
        (self.even, self.end_s) = (even, end_s);
        self.taken += 1;
        self.waiting_s.push_back(end_s);
        self.settle();
        Ok(())
    }

    /// Completes the rows that wait for samples.
    pub fn finish(&mut self, see: &mut dyn FnMut(f64, &Solution<f64>)) {
        let (ends_s, end_s) = (&mut self.ends_s, self.end_s);
        self.navigator.finish(&mut |_, row| see(ends_s.pop_front().unwrap_or(end_s), row));
        self.settle();
    }

    /// Notes how far it is integrated.
    fn settle(&mut self) {
        while self.integrated < self.navigator.integrated() {
            self.block_end_s = self.waiting_s.pop_front().unwrap_or(self.block_end_s);
            self.integrated += 1;
        }
    }
}
