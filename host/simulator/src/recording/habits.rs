//! Properties of a recording that its first rows show: the unit of the stamps, the usual step.

use super::Kind;
use super::rows::Recording;
use crate::input::{Complaint, InputError};

/// Rows that are looked at.
const ROWS: usize = 8192;
/// The longest sample that is navigated, s.
const LONGEST_S: f64 = 1.0;
/// Share of rows with the stamp of the row before, from which on stamps are coarser than samples: copies
/// of rows are rarer.
pub const COARSE: f64 = 0.1;

/// Units of time that stamps come in.
const UNITS: [(&str, f64); 4] =
    [("seconds", 1.0), ("milliseconds", 1e-3), ("microseconds", 1e-6), ("nanoseconds", 1e-9)];

/// How a recording's stamps go on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Habits {
    /// The stamps' unit.
    pub unit: &'static str,
    /// Seconds in the stamps' unit.
    pub unit_s: f64,
    /// The usual step from row to row, s.
    pub step_s: f64,
    /// The usual step between different stamps, s.
    pub distinct_s: f64,
    /// How much ordinary steps differ, s.
    pub spread_s: f64,
    /// Whether several samples share a stamp, since stamps are coarser than samples.
    pub coarse: bool,
}

impl Habits {
    /// From the first rows.
    pub fn of(recording: &Recording) -> Result<Self, InputError> {
        if let Some(step_s) = recording.interval_s {
            let (unit, unit_s) = UNITS[0];
            let distinct_s = step_s;
            return Ok(Self { unit, unit_s, step_s, distinct_s, spread_s: 0.0, coarse: false });
        }
        let mut rows = recording.rows()?;
        let mut unread = None;
        let (mut steps, mut count, mut repeats) = (Vec::new(), 0usize, 0usize);
        let mut last: Option<f64> = None;
        let mut force = 0.0;
        while count < ROWS {
            let row = match rows.next(true)? {
                None => break,
                Some(Ok(row)) => row,
                Some(Err(line)) => {
                    unread.get_or_insert(*line.error);
                    continue;
                }
            };
            if let Some(last) = last {
                match row.stamp - last {
                    step if step > 0.0 => steps.push(step),
                    0.0 => repeats += 1,
                    _ => {}
                }
            }
            last = Some(row.stamp);
            force += row.values.velocity_b.norm();
            count += 1;
        }
        if count < 2 || steps.is_empty() {
            let what = match count {
                0 | 1 => format!("has {count} samples"),
                _ => "has stamps that stand still".to_owned(),
            };
            let none = InputError::file(
                &recording.name,
                Complaint::new(what, "two samples or more, at most 1 s each"),
            );
            return Err(unread.unwrap_or(none));
        }
        steps.sort_unstable_by(f64::total_cmp);
        let at = |part: f64| steps[((steps.len() - 1) as f64 * part).round() as usize];
        let coarse = repeats as f64 > COARSE * count as f64;
        // Without the longest, which may be gaps.
        let ordinary: Vec<_> = steps.iter().filter(|&&step| step <= 1.75 * at(0.5)).collect();
        let mean = ordinary.iter().copied().sum::<f64>() / ordinary.len() as f64;
        let share = ordinary.len() as f64 / (ordinary.len() + repeats) as f64;
        let step = if coarse { mean * share } else { mean };
        let increment = force / count as f64;
        let increment = (recording.kind == Kind::Increments).then_some(increment);
        let (unit, unit_s) = match recording.time {
            Some(stated) => stated.counted(),
            None => unit(&recording.name, step, increment)?,
        };
        let spread_s = ((at(0.9) - at(0.1)) * unit_s).min(mean * unit_s);
        let (step_s, distinct_s) = (step * unit_s, mean * unit_s);
        Ok(Self { unit, unit_s, step_s, distinct_s, spread_s, coarse })
    }

    /// The same if rows that share a stamp are samples of their own, as many as this share of all; or if
    /// they are not.
    pub fn with_coarse(self, coarse: bool, share: f64) -> Self {
        let share = if coarse { 1.0 - share } else { 1.0 };
        Self { step_s: self.distinct_s * share, coarse, ..self }
    }
}

/// The unit of stamps with a usual step, and for increments their usual |Δv|, m/s: seconds, unless samples
/// were then longer than any that is navigated. Another unit is taken only if no third one would do.
fn unit(name: &str, step: f64, increment: Option<f64>) -> Result<(&'static str, f64), InputError> {
    // Standing or flying level, accelerometers feel about 10 m/s².
    let felt = |unit_s: f64| increment.map(|increment| increment / (step * unit_s));
    let like_gravity = |unit_s: f64| felt(unit_s).is_none_or(|f| (3.0..30.0).contains(&f));
    let rate_of_units = |unit_s: f64| (5.0..=20e3).contains(&(1.0 / (step * unit_s)));
    let seconds_would_do =
        step <= LONGEST_S && !(step > 0.05 && felt(1.0).is_some_and(|f| f < 0.1));
    let likely: Vec<_> = UNITS[1..]
        .iter()
        .filter(|(_, unit_s)| rate_of_units(*unit_s) && like_gravity(*unit_s))
        .collect();
    match likely[..] {
        _ if seconds_would_do => Ok(UNITS[0]),
        [unit] => Ok(*unit),
        _ if step <= LONGEST_S => Ok(UNITS[0]),
        _ => {
            let rates = UNITS[1..].iter().filter(|(_, unit_s)| rate_of_units(*unit_s));
            let looks: Vec<_> = rates.map(|(unit, _)| *unit).collect();
            let looks = match looks[..] {
                [] => String::new(),
                _ => format!("; these look like {}", looks.join(" or ")),
            };
            let what = format!("has samples of {step} s{looks}");
            let accepted = "stamps in seconds, samples of at most 1 s";
            Err(InputError::file(name, Complaint::new(what, accepted)))
        }
    }
}
