//! A recording read once: its clock, its length, missing samples, and the window that its samples support.

use super::Kind;
use super::clock::{Clock, Judge};
use super::habits::{COARSE, Habits};
use super::measure::{Measure, Motion};
use super::periods::PERIODS;
use super::rows::Recording;
use super::timeline::{Mends, Timeline};
use crate::input::{Complaint, InputError};
use crate::scene::WindowShape;
use schuler::sample::Increment;

/// What a look through a recording shows.
#[derive(Clone, Debug)]
pub struct Survey {
    /// The stamps' unit and usual step.
    pub habits: Habits,
    /// The samples' intervals.
    pub clock: Clock,
    /// What the clock is, for people.
    pub clock_said: String,
    /// Rows that were read.
    pub rows: u64,
    /// Where the first sample begins, s.
    pub start_s: f64,
    /// Where the last sample ends, s.
    pub end_s: f64,
    /// What was mended in the stamps.
    pub mends: Mends,
    /// The window that the samples support; none where they do not tell.
    pub window: Option<WindowShape>,
    /// How fast the motion is.
    pub motion: Motion,
}

/// Rows whose values are looked at: all of a short recording, some of a long one.
fn looked_at(row: u64) -> bool {
    row < 8192 || row % 1024 < 128
}

/// One way to read the stamps.
struct Reading {
    habits: Habits,
    judge: Judge,
    rows: u64,
    first_s: f64,
    last_s: f64,
    mends: Mends,
    /// Of the samples, and of the samples over their steps.
    measures: [Measure; 2],
}

impl Survey {
    /// Looks through a recording; `stated` is the sample interval where it is known, s. What motion is
    /// there is measured between two times, s.
    pub fn of(
        recording: &Recording,
        stated: Option<f64>,
        (from_s, until_s): (f64, f64),
    ) -> Result<Self, InputError> {
        let name = &recording.name;
        let habits = Habits::of(recording)?;
        let stated = stated.or(recording.interval_s);
        let mut reading = Reading::of(recording, habits, (from_s, until_s))?;
        let mut judged = reading.judge.judge(name, stated, &habits);
        let alike = reading.mends.copies + reading.mends.stuck;
        let share = alike as f64 / reading.rows.max(1) as f64;
        let otherwise = if habits.coarse { Some(false) } else { (share > COARSE).then_some(true) };
        let even = matches!(judged, Ok((Clock::Even { .. }, _)));
        if let Some(coarse) = otherwise
            && (coarse || !even)
        {
            // Whether rows that share a stamp are samples of their own shows in which count is even.
            let habits = habits.with_coarse(coarse, share);
            let other = Reading::of(recording, habits, (from_s, until_s))?;
            let other_judged = other.judge.judge(name, stated, &habits);
            if matches!(other_judged, Ok((Clock::Even { .. }, _))) || judged.is_err() {
                (reading, judged) = (other, other_judged);
            }
        }
        let (clock, clock_said) = judged?;
        if clock.interval_s() > 1.0 {
            let what = format!("has samples of {} s", clock.interval_s());
            let accepted = "two samples or more, at most 1 s each";
            return Err(InputError::file(name, Complaint::new(what, accepted)));
        }
        let [own, over_steps] = reading.measures;
        let (measure, start_s, end_s) = match clock {
            Clock::Even { interval_s, first_s, coarse } => {
                // Where stamps are not rounded they are the rounder numbers.
                let off_s = (first_s - reading.first_s).abs();
                let first_end_s = if off_s < 1e-9 { reading.first_s } else { first_s };
                let last_s = first_s + reading.judge.spanned(interval_s);
                let end_s = if coarse { last_s } else { reading.last_s };
                (own, rounded(first_end_s - interval_s), end_s)
            }
            Clock::Stamps { interval_s } => {
                (over_steps, rounded(reading.first_s - interval_s), reading.last_s)
            }
        };
        Ok(Self {
            habits: reading.habits,
            clock,
            clock_said,
            rows: reading.rows,
            start_s,
            end_s,
            mends: reading.mends,
            window: measure.window(),
            motion: measure.motion(),
        })
    }

    /// What was found, a line each.
    pub fn said(&self, recording: &Recording) -> Vec<String> {
        let mut lines = recording.said.clone();
        let name = &recording.name;
        if self.habits.unit_s != 1.0 && recording.time.is_none() {
            lines.push(format!("{name}: stamps are in {}, taken as such", self.habits.unit));
        }
        for (line, period) in &self.mends.rounds {
            let (what, period_s) = PERIODS[*period];
            lines.push(format!("{name}:{line}: {what} came round, {period_s} s: time goes on"));
        }
        let Mends { copies, first_copy, stuck, first_stuck, .. } = self.mends;
        if copies > 0 {
            lines.push(format!(
                "{name}:{first_copy}: rows that are there twice, left out: {copies}"
            ));
        }
        if stuck > 0 {
            lines.push(format!(
                "{name}:{first_stuck}: stamps that stood still, {stuck}: these samples were spread evenly"
            ));
        }
        if recording.interval_s.is_none() {
            lines.push(format!("samples: {}", self.clock_said));
        }
        lines
    }
}

/// To the nanosecond, for people.
fn rounded(time_s: f64) -> f64 {
    // Zero has no sign for people.
    (time_s * 1e9).round() / 1e9 + 0.0
}

impl Reading {
    fn of(
        recording: &Recording,
        habits: Habits,
        (from_s, until_s): (f64, f64),
    ) -> Result<Self, InputError> {
        let mut timeline = Timeline::new(recording, habits, looked_at)?;
        let mut judge = Judge::new(&habits);
        let mut measures = [Measure::default(), Measure::default()];
        let (mut rows, mut first_s) = (0, 0.0);
        let mut before_s = None;
        while let Some(row) = timeline.advance()? {
            judge.add(&row, before_s);
            let inside = row.time_s > from_s && row.time_s <= until_s;
            if !row.whole || !inside || row.missing > 0 {
                measures.iter_mut().for_each(Measure::cut);
            }
            if row.whole && inside {
                let [own, over_steps] = &mut measures;
                own.add(&row.values);
                let step_s = before_s.map(|before_s| row.time_s - before_s);
                match (recording.kind, step_s.filter(|step_s| *step_s > 0.0)) {
                    (Kind::Rates, _) => over_steps.add(&row.values),
                    (Kind::Increments, Some(step_s)) => {
                        let Increment { angle_b, velocity_b } = row.values;
                        let per_second = (1 + row.missing) as f64 / step_s;
                        over_steps.add(&Increment {
                            angle_b: angle_b * per_second,
                            velocity_b: velocity_b * per_second,
                        });
                    }
                    (Kind::Increments, None) => over_steps.cut(),
                }
            }
            if rows == 0 {
                first_s = row.time_s;
            }
            rows += 1;
            before_s = Some(row.time_s);
        }
        measures.iter_mut().for_each(Measure::cut);
        if rows < 2 {
            let what = format!("has {rows} samples");
            let complaint = Complaint::new(what, "two samples or more, at most 1 s each");
            return Err(InputError::file(&recording.name, complaint));
        }
        let last_s = before_s.unwrap_or(first_s);
        Ok(Self { habits, judge, rows, first_s, last_s, mends: timeline.mends, measures })
    }
}

impl Survey {
    /// How fast the motion is, for people.
    pub fn motion_said(&self) -> String {
        match self.motion {
            Motion::None => "nothing moves".to_owned(),
            Motion::Resolved(samples) => {
                format!("the fastest motion that is resolved has {samples:.1} samples per cycle")
            }
            Motion::Noise => "what moves looks like noise".to_owned(),
            Motion::Unresolved(samples) => {
                format!(
                    "the fastest motion has {samples:.1} samples per cycle, too few to resolve it"
                )
            }
        }
    }
}
