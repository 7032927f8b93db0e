//! The drift of a replay from its reference, for a terminal.

use super::comparison::{Comparison, Has};
use crate::report::norm;
use crate::report::table::{Column, columns_of, rows_of, unit_note};
use crate::report::verdict;
use schuler_simulator::flight::Instant;
use schuler_simulator::number::{Quantity, parameter};

/// Characters of a column.
const WIDTH: usize = 10;

/// The columns of which something is known.
pub fn columns(comparison: &Comparison) -> Vec<Column> {
    let rows = rows_of(&comparison.overview, &comparison.last);
    let Has { velocity, attitude } = comparison.has;
    let known = [true, true, true, velocity, attitude];
    columns_of(&rows).into_iter().zip(known).filter(|(_, known)| *known).map(|(c, _)| c).collect()
}

/// Errors at a dozen times, what was compared, and what it came to.
pub fn table(comparison: &Comparison) -> String {
    let columns = columns(comparison);
    let [mut heads, mut units] = ["time", "s"].map(|text| format!("{text:>12} "));
    let mut line = "─".repeat(13);
    for column in &columns {
        let bars = if column.is_norm { "|" } else { "" };
        let name = format!("{bars}{}{bars}", column.name);
        heads += &format!("│ {name:^WIDTH$} ");
        units += &format!("│ {:^WIDTH$} ", column.unit.name);
        line += &format!("┼{}", "─".repeat(WIDTH + 2));
    }
    let mut lines = vec![compared(comparison), lag(comparison), heads, units, line];
    for instant in rows_of(&comparison.overview, &comparison.last) {
        let mut line = format!("{:>12} ", time(instant));
        for column in &columns {
            let [error, ..] = column.cells(instant);
            line += &format!("│ {error:>w$}  ", w = WIDTH - 1);
        }
        lines.push(line);
    }
    lines.push(String::new());
    lines.push(outcome(comparison));
    lines.extend(claimed(comparison));
    lines.extend(unit_note(&columns));
    lines.iter().map(|line| format!("{}\n", line.trim_end())).collect()
}

/// The time of an instant, to the millisecond.
pub fn time(instant: &Instant) -> String {
    format!("{:.3}", instant.time_s)
}

/// What was compared with what.
pub fn compared(comparison: &Comparison) -> String {
    let Comparison { reference, rows, outside, others, has, .. } = comparison;
    let mut text = format!("compared with {reference} at {rows} times");
    if !has.velocity || !has.attitude {
        let lacks = match (has.velocity, has.attitude) {
            (true, _) => "attitudes",
            (_, true) => "velocities",
            _ => "velocities and attitudes",
        };
        text += &format!("; it has no {lacks}");
    }
    if *outside > 0 {
        text += &format!("; {outside} more are outside what was flown");
    }
    if !others.is_empty() {
        text += &format!("; columns not compared: {}", others.join(", "));
    }
    text
}

/// How late the reference's stamps seem to be, and are taken to be.
pub fn lag(comparison: &Comparison) -> String {
    let taken = format!("{} s", parameter(comparison.lag_s));
    match comparison.estimated {
        None => format!("lag of its stamps: taken as {taken}; the motion does not tell"),
        Some(lag) => {
            let off_s = (lag.lag_s - comparison.lag_s).abs();
            let hint = if off_s > 6.0 * lag.sigma_s && off_s > 1e-6 {
                "; --lag auto takes it out"
            } else {
                ""
            };
            let digits = (1.0 - lag.sigma_s.log10().floor()).clamp(1.0, 9.0) as usize;
            format!(
                "lag of its stamps: {:.digits$} ± {:.digits$} s fits best, taken as {taken}{hint}",
                // Zero has no sign for people.
                (lag.lag_s * 1e9).round() / 1e9 + 0.0,
                lag.sigma_s
            )
        }
    }
}

/// What an aided flight's filter says of the last error, in a line.
pub fn claimed(comparison: &Comparison) -> Option<String> {
    let is_claimed = comparison.last.sigma.position_m.iter().all(|sigma| sigma.is_finite());
    is_claimed.then(|| verdict::claimed(&comparison.last))
}

/// What it came to, in a line.
pub fn outcome(comparison: &Comparison) -> String {
    let Comparison { last, max, has, .. } = comparison;
    let mut text = format!(
        "Position error {} at {} s, {} at its largest",
        Quantity::Position.show(norm(last.drift.position_m)),
        time(last),
        Quantity::Position.show(max.norms[0]),
    );
    let end = [
        (has.velocity, "velocity", Quantity::Velocity, last.drift.velocity_m_s),
        (has.attitude, "attitude", Quantity::Attitude, last.drift.attitude_arcsec),
    ];
    let end: Vec<_> = end
        .into_iter()
        .filter(|(known, ..)| *known)
        .map(|(_, name, quantity, error)| format!("{name} {}", quantity.show(norm(error))))
        .collect();
    if !end.is_empty() {
        text += &format!("; {} at the end", end.join(", "));
    }
    text + "."
}
