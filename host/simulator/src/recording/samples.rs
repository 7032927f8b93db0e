//! The samples of a recording as they are navigated: increments, each with its own interval, gaps filled.

use super::clock::Clock;
use super::quadrature::Quadrature;
use super::rows::Recording;
use super::survey::Survey;
use super::timeline::{Misfit, Timed, Timeline};
use super::{Kind, timeline};
use crate::input::InputError;
use schuler::sample::Increment;
use std::collections::VecDeque;

/// Samples that a gap may be bridged over, at most.
pub const MOST_BRIDGED: u64 = 100_000;

/// A sample with its place in time.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Its stamp, s; for one that was missing, between its neighbours'.
    pub time_s: f64,
    /// Its end by the recording's clock, s.
    pub end_s: f64,
    /// Its length, s.
    pub interval_s: f64,
    /// Increments over its interval: forward, right, down; rad, m/s.
    pub increment: Increment<f64>,
    /// Its line, or that of the sample after the gap that it fills.
    pub line: u64,
    /// How many are missing in the gap that it fills or, too long to be filled, follows; else zero.
    pub missing: u64,
    /// Whether it was missing, and is filled from its neighbours.
    pub filled: bool,
    /// What could not be read since the row before.
    pub unread: Vec<Misfit>,
}

/// Goes along the samples of a recording.
#[derive(Debug)]
pub struct Samples {
    timeline: Timeline,
    clock: Clock,
    kind: Kind,
    /// What known biases add to increments, per second.
    bias: Option<Increment<f64>>,
    /// When the first sample begins, where that is known from elsewhere, s.
    origin_s: Option<f64>,
    /// The last row, its number with missing ones counted, its end and its interval in s.
    last: Option<(Timed, u64, f64, f64)>,
    quadrature: Quadrature<Sample>,
    ready: VecDeque<Sample>,
    ended: bool,
}

impl Samples {
    /// From the first sample, which may be known to begin at a time, s.
    pub fn new(
        recording: &Recording,
        survey: &Survey,
        origin_s: Option<f64>,
    ) -> Result<Self, InputError> {
        Ok(Self {
            timeline: Timeline::new(recording, survey.habits, timeline::EVERY)?,
            clock: survey.clock,
            kind: recording.kind,
            bias: recording.bias_per_second(),
            origin_s,
            last: None,
            quadrature: Quadrature::new(0.0),
            ready: VecDeque::new(),
            ended: false,
        })
    }

    /// The next sample, or the end.
    pub fn advance(&mut self) -> Result<Option<Sample>, InputError> {
        loop {
            if let Some(sample) = self.ready.pop_front() {
                return Ok(Some(sample));
            }
            if let Some((increment, sample)) = self.quadrature.pop() {
                return Ok(Some(Sample { increment, ..sample }));
            }
            if self.ended {
                return Ok(None);
            }
            match self.timeline.advance()? {
                Some(row) => self.take(row),
                None => {
                    self.ended = true;
                    self.quadrature.end();
                }
            }
        }
    }

    /// What could not be read after the last sample.
    pub fn trailing(&self) -> &[Misfit] {
        self.timeline.trailing()
    }

    /// A time from the first row's on, s, where the clock tells it better than the difference of times does.
    fn since_first(&self, n: u64, end_s: f64) -> f64 {
        match self.clock {
            Clock::Even { interval_s, .. } => n as f64 * interval_s,
            Clock::Stamps { .. } => end_s,
        }
    }

    /// Takes a row, and what is missing before it.
    fn take(&mut self, mut row: Timed) {
        let unread = std::mem::take(&mut row.unread);
        let mut unread = Some(unread);
        let (n, end_s, interval_s) = self.place(&row);
        let broken = row.missing > MOST_BRIDGED;
        if self.last.is_none() || broken {
            self.stretch(interval_s);
        }
        let before = self.last.replace((row.clone(), n, end_s, interval_s));
        let stamp_s = match self.clock {
            Clock::Even { coarse: true, .. } => end_s,
            _ => row.time_s,
        };
        if let Some((before, _, before_end_s, before_interval_s)) = before
            && !broken
        {
            let before_stamp_s = stamp_s - (end_s - before_end_s);
            for i in 1..=row.missing {
                let part = i as f64 / (row.missing + 1) as f64;
                let between = |a: f64, b: f64| a + (b - a) * part;
                let values = match self.kind {
                    Kind::Rates => mixed(&before.values, &row.values, part, 1.0, 1.0),
                    Kind::Increments => {
                        let (a, b) = (interval_s / before_interval_s, 1.0);
                        mixed(&before.values, &row.values, part, a, b)
                    }
                };
                let filler = Sample {
                    time_s: between(before_stamp_s, stamp_s),
                    end_s: between(before_end_s, end_s),
                    interval_s,
                    increment: values,
                    line: row.line,
                    missing: row.missing,
                    filled: true,
                    unread: unread.take().unwrap_or_default(),
                };
                self.hand_on(
                    filler,
                    self.since_first(n - (row.missing + 1 - i), between(before_end_s, end_s)),
                );
            }
        }
        let node_s = self.since_first(n, end_s);
        let sample = Sample {
            time_s: stamp_s,
            end_s,
            interval_s,
            increment: row.values,
            line: row.line,
            missing: if broken { row.missing } else { 0 },
            filled: false,
            unread: unread.unwrap_or_default(),
        };
        self.hand_on(sample, node_s);
    }

    /// A row's number, its end and its interval, s.
    fn place(&self, row: &Timed) -> (u64, f64, f64) {
        let n = self.last.as_ref().map_or(0, |(_, n, ..)| n + 1 + row.missing);
        match (self.clock, &self.last) {
            (Clock::Even { interval_s, first_s, .. }, _) => {
                (n, first_s + n as f64 * interval_s, interval_s)
            }
            (Clock::Stamps { interval_s }, Some((before, ..))) => {
                let broken = row.missing > MOST_BRIDGED;
                let own_s = (row.time_s - before.time_s) / (1 + row.missing) as f64;
                (n, row.time_s, if broken { interval_s } else { own_s })
            }
            (Clock::Stamps { interval_s }, None) => {
                let next_s = self.timeline.coming_s().map(|next_s| next_s - row.time_s);
                let usual_s =
                    next_s.filter(|s| *s > 0.0 && *s < 1.5 * interval_s).unwrap_or(interval_s);
                let own_s = self.origin_s.map(|origin_s| row.time_s - origin_s);
                let plausible = |s: &f64| (0.5 * usual_s..=1.5 * usual_s).contains(s);
                (n, row.time_s, own_s.filter(plausible).unwrap_or(usual_s))
            }
        }
    }

    /// A stretch begins; what is left of the one before is done with.
    fn stretch(&mut self, first_interval_s: f64) {
        self.quadrature.end();
        while let Some((increment, sample)) = self.quadrature.pop() {
            self.ready.push_back(Sample { increment, ..sample });
        }
        self.quadrature = Quadrature::new(first_interval_s);
    }

    /// Hands a sample on, whose rates are those of a time, s.
    fn hand_on(&mut self, mut sample: Sample, node_s: f64) {
        if let Some(Increment { angle_b, velocity_b }) = self.bias {
            let increment = &mut sample.increment;
            increment.angle_b = increment.angle_b - angle_b * sample.interval_s;
            increment.velocity_b = increment.velocity_b - velocity_b * sample.interval_s;
        }
        match self.kind {
            Kind::Increments => self.ready.push_back(sample),
            Kind::Rates => self.quadrature.push(node_s, sample.increment, sample),
        }
    }
}

/// On the straight line from `a` times a factor to `b` times another.
fn mixed(
    before: &Increment<f64>,
    after: &Increment<f64>,
    part: f64,
    a: f64,
    b: f64,
) -> Increment<f64> {
    let (a, b) = (a * (1.0 - part), b * part);
    Increment {
        angle_b: before.angle_b * a + after.angle_b * b,
        velocity_b: before.velocity_b * a + after.velocity_b * b,
    }
}
