//! Rows in the order of time: stamps in seconds that continue where a counter wrapped around, without duplicate
//! rows, and for each the number of rows missing before it.

use super::habits::Habits;
use super::periods::{PERIODS, come_round};
use super::rows::{Recording, Rows};
use super::{Row, Unread};
use crate::input::{Complaint, InputError};
use schuler::sample::Increment;
use std::collections::VecDeque;

/// Rows that are looked at ahead, to tell a gap from a change of rate.
const AHEAD: usize = 5;
/// Rows with one stamp, at most.
const MOST_ALIKE: usize = 64;

/// Rows are all read whole.
pub const EVERY: fn(u64) -> bool = |_| true;

/// A row in its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Timed {
    /// s, of the recording's own time.
    pub time_s: f64,
    /// As it stands in the file.
    pub stamp: f64,
    /// The line in its file.
    pub line: u64,
    /// What it holds; zero where only the stamp was asked for.
    pub values: Increment<f64>,
    /// Rows that are missing before it.
    pub missing: u64,
    /// What could not be read since the row before: the first such line, and the last.
    pub unread: Vec<Misfit>,
    /// Whether it was read whole.
    pub whole: bool,
    repeated: bool,
}

/// A line without a place in time, or without values.
#[derive(Clone, Debug, PartialEq)]
pub struct Misfit {
    /// Its own time, or about what it would be, s.
    pub time_s: f64,
    /// What is wrong.
    pub error: InputError,
}

/// What was mended on the way.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mends {
    /// Counters that came round: the line, and which of the known periods.
    pub rounds: Vec<(u64, usize)>,
    /// Rows that were there twice, and the first of them.
    pub copies: u64,
    /// The line of the first copy.
    pub first_copy: u64,
    /// Rows with the stamp of the row before that have a place of their own.
    pub stuck: u64,
    /// The line of the first such row.
    pub first_stuck: u64,
}

/// Goes along a recording.
#[derive(Debug)]
pub struct Timeline {
    rows: Rows,
    name: String,
    habits: Habits,
    /// Which rows are read whole, by their number from 0.
    whole: fn(u64) -> bool,
    pulled: u64,
    ended: bool,
    /// What counters that came round add, s.
    offset_s: f64,
    /// The last row that was pulled.
    pulled_s: Option<f64>,
    /// What the next row pulled is to carry.
    unread: Vec<Misfit>,
    queue: VecDeque<Timed>,
    /// The last row that was handed on, and its number, missing ones counted.
    last: Option<(f64, u64)>,
    first_s: f64,
    /// The usual step hereabouts, s.
    step_s: f64,
    /// What was mended so far.
    pub mends: Mends,
}

impl Timeline {
    /// From the first row. `whole` says which rows are read whole, by their number from 0.
    pub fn new(
        recording: &Recording,
        habits: Habits,
        whole: fn(u64) -> bool,
    ) -> Result<Self, InputError> {
        Ok(Self {
            rows: recording.rows()?,
            name: recording.name.clone(),
            habits,
            whole,
            pulled: 0,
            ended: false,
            offset_s: 0.0,
            pulled_s: None,
            unread: Vec::new(),
            queue: VecDeque::new(),
            last: None,
            first_s: 0.0,
            step_s: habits.step_s,
            mends: Mends::default(),
        })
    }

    /// The next row, or the end.
    pub fn advance(&mut self) -> Result<Option<Timed>, InputError> {
        loop {
            while !self.ended && self.queue.len() < AHEAD {
                self.pull()?;
            }
            let Some(front) = self.queue.front() else { return Ok(None) };
            let time_s = front.time_s;
            let stands = self.last.is_some_and(|(last_s, _)| time_s <= last_s);
            if stands && !self.habits.coarse {
                if !self.settle(time_s)? {
                    continue;
                }
                // A row with a place of its own.
                let Some(front) = self.queue.pop_front() else { continue };
                return Ok(Some(self.hand_on(front, 0)));
            }
            let missing = self.missing(time_s);
            let Some(front) = self.queue.pop_front() else { continue };
            return Ok(Some(self.hand_on(front, missing)));
        }
    }

    /// The time of the row after the last that was handed on, s.
    pub fn coming_s(&self) -> Option<f64> {
        self.queue.front().map(|row| row.time_s)
    }

    /// What could not be read after the last row.
    pub fn trailing(&self) -> &[Misfit] {
        &self.unread
    }

    fn hand_on(&mut self, mut row: Timed, missing: u64) -> Timed {
        if let Some((last_s, n)) = self.last {
            let step_s = row.time_s - last_s;
            if missing == 0 && step_s > 0.0 && !self.habits.coarse {
                self.step_s += (step_s - self.step_s) / 16.0;
            }
            self.last = Some((row.time_s, n + missing + 1));
        } else {
            self.first_s = row.time_s;
            self.last = Some((row.time_s, 0));
        }
        row.missing = missing;
        row
    }

    /// Rows missing before one that stands at the head of the queue.
    fn missing(&self, time_s: f64) -> u64 {
        let Some((last_s, n)) = self.last else { return 0 };
        let step_s = time_s - last_s;
        let Habits { coarse, distinct_s, spread_s, .. } = self.habits;
        let usual_s = if coarse { self.step_s } else { self.step_s.max(self.coming()) };
        let rounding_s = if coarse { distinct_s } else { 0.5 * spread_s };
        if step_s <= 1.5 * usual_s + rounding_s {
            return 0;
        }
        // Over all rows so far a step is known better than from a few, unless it changes.
        let mean_s = (last_s - self.first_s) / n.max(1) as f64;
        let steady = n > 16 && (mean_s / usual_s - 1.0).abs() < 0.05;
        let usual_s = if steady { mean_s } else { usual_s };
        ((step_s / usual_s).round() as u64).saturating_sub(1).max(1)
    }

    /// The middle one of the steps that come after the row at the head of the queue, s; zero at the end.
    fn coming(&self) -> f64 {
        let times = self.queue.iter().zip(self.queue.iter().skip(1));
        let mut steps = [0.0; AHEAD];
        let mut count = 0;
        for ((a, b), step) in times.zip(&mut steps) {
            *step = b.time_s - a.time_s;
            count += usize::from(*step > 0.0);
        }
        steps.sort_unstable_by(|a, b| b.total_cmp(a));
        if count < 2 { 0.0 } else { steps[count / 2] }
    }

    /// Decides about rows at the head of the queue with the stamp of the row before: copies are left out
    /// (false); rows that were given a place of their own stay (true).
    fn settle(&mut self, time_s: f64) -> Result<bool, InputError> {
        let alike =
            |queue: &VecDeque<Timed>| queue.iter().take_while(|row| row.time_s <= time_s).count();
        while !self.ended && alike(&self.queue) == self.queue.len() && self.queue.len() < MOST_ALIKE
        {
            self.pull()?;
        }
        let count = alike(&self.queue);
        let next_s = self.queue.get(count).map(|row| row.time_s);
        let step_s = next_s.map(|next_s| next_s - time_s);
        let places = step_s.map_or(0.0, |step_s| (step_s / self.step_s).round());
        if places == (count + 1) as f64 {
            self.mends.stuck += count as u64;
            for (row, i) in self.queue.iter_mut().take(count).zip(1u32..) {
                if self.mends.first_stuck == 0 {
                    self.mends.first_stuck = row.line;
                }
                row.time_s += step_s.unwrap_or(0.0) * f64::from(i) / places;
            }
            return Ok(true);
        }
        for _ in 0..count {
            let Some(mut row) = self.queue.pop_front() else { break };
            let mut unread = std::mem::take(&mut row.unread);
            if row.repeated {
                if self.mends.copies == 0 {
                    self.mends.first_copy = row.line;
                }
                self.mends.copies += 1;
            } else {
                let what = format!("{} is not after {}, the row before", row.stamp, row.stamp);
                let complaint = Complaint::new(what, "times that increase, or the same row twice");
                let error = InputError::key(&self.name, row.line, "time_s", complaint);
                unread.push(Misfit { time_s: row.time_s, error });
            }
            match self.queue.get_mut(count.saturating_sub(1)) {
                Some(next) => next.unread.splice(0..0, unread).for_each(drop),
                None => self.unread.extend(unread),
            }
        }
        Ok(false)
    }

    /// Reads a row into the queue.
    fn pull(&mut self) -> Result<(), InputError> {
        let whole = (self.whole)(self.pulled);
        let Some(read) = self.rows.next(whole)? else {
            self.ended = true;
            return Ok(());
        };
        self.pulled += 1;
        let row = match read {
            Ok(row) => row,
            Err(unread) => {
                self.lay_aside(unread);
                return Ok(());
            }
        };
        let mut time_s = row.stamp * self.habits.unit_s + self.offset_s;
        if let Some(before_s) = self.pulled_s.filter(|&before_s| time_s < before_s) {
            let (from_s, to_s) = (before_s - self.offset_s, time_s - self.offset_s);
            let longest_s = 10.0 * self.step_s + self.habits.spread_s;
            let Some(period) = come_round(from_s, to_s, longest_s) else {
                let before = (before_s - self.offset_s) / self.habits.unit_s;
                let before = (before * 1e12).round() / 1e12;
                let what = format!("{} is not after {before}, the row before", row.stamp);
                let accepted =
                    "times that increase, or start over as a week, a day or a counter does";
                let complaint = Complaint::new(what, accepted);
                let error = InputError::key(&self.name, row.line, "time_s", complaint);
                self.lay_aside(Unread { stamp: None, error: Box::new(error) });
                return Ok(());
            };
            if self.mends.rounds.len() < 100 {
                self.mends.rounds.push((row.line, period));
            }
            self.offset_s += PERIODS[period].1;
            time_s += PERIODS[period].1;
        }
        self.pulled_s = Some(time_s);
        let unread = std::mem::take(&mut self.unread);
        let Row { stamp, line, values, repeated } = row;
        let missing = 0;
        self.queue.push_back(Timed {
            time_s,
            stamp,
            line,
            values,
            missing,
            unread,
            whole,
            repeated,
        });
        Ok(())
    }

    fn lay_aside(&mut self, unread: Unread) {
        let next_s = self.pulled_s.map_or(f64::NEG_INFINITY, |before_s| before_s + self.step_s);
        let own_s = unread.stamp.map(|stamp| stamp * self.habits.unit_s + self.offset_s);
        let own_s = own_s.filter(|&own_s| self.pulled_s.is_none_or(|before_s| own_s >= before_s));
        // The first and the last of a row of them say where it lies.
        self.unread.truncate(1);
        self.unread.push(Misfit { time_s: own_s.unwrap_or(next_s), error: *unread.error });
    }
}
