//! Columns that nobody names: the one that grows steadily is the time, and of six more in a row those three are
//! accelerometers that read gravity.

use super::super::lines::Lines;
use super::dialect::Text;
use super::dialect::{Splitter, comment, number};
use super::head::Head;
use super::look::{Look, likely_unit};
use super::map::{Column, Given, Map};
use super::settle::USUAL;
use crate::input::{Complaint, InputError};
use std::fs::File;

/// Rows that are looked at.
const ROWS: usize = 4096;
/// What says it.
const ACCEPTED: &str = "--columns with seven names or numbers (time, gyros x, y, z, accelerometers x, y, z), or a map (--map)";

/// Numbers of a file, row by row.
struct Grid {
    rows: Vec<Vec<Option<f64>>>,
    width: usize,
}

/// A map of the columns that a file's numbers show, and what to say of it; or why they do not.
pub fn columns(
    head: &Head,
    file: &File,
    given: &Given,
) -> Result<Result<(Map, String), Complaint>, InputError> {
    let grid = Grid::of(head, file)?;
    let wrong = |what: String| Ok(Err(Complaint::new(what, ACCEPTED)));
    let times: Vec<_> = (0..grid.width).filter(|&i| grid.grows(i)).collect();
    let time = match times[..] {
        [time] => time,
        [] => return wrong("no column grows steadily, as a time does".to_owned()),
        // A counter of rows beside it is none.
        ref several => {
            let mut left = several.iter().filter(|&&i| !grid.counts(i));
            match (left.next(), left.next()) {
                (Some(&time), None) => time,
                _ => {
                    let numbers: Vec<_> = several.iter().map(|i| (i + 1).to_string()).collect();
                    return wrong(format!(
                        "columns {} all grow as a time does",
                        numbers.join(", ")
                    ));
                }
            }
        }
    };
    let moving: Vec<_> =
        (0..grid.width).filter(|i| !times.contains(i) && grid.varies(*i)).collect();
    let [first, .., last] = moving[..] else {
        return wrong("no six columns beside the time vary".to_owned());
    };
    let in_a_row = last - first == 5 && !(first..=last).contains(&time);
    if moving.len() != 6 || !in_a_row {
        let numbers: Vec<_> = moving.iter().map(|i| (i + 1).to_string()).collect();
        return wrong(format!(
            "beside the time, column {}, the columns that vary are {}, not six in a row",
            time + 1,
            numbers.join(", ")
        ));
    }
    let rows = grid.samples(time, first);
    let Some(look) = Look::of(&rows) else {
        return wrong(format!("column {} has no steps", time + 1));
    };
    let h = look.step * given.units.time.map_or_else(|| likely_unit(look.step), |u| u.counted().1);
    let swapped: Vec<_> =
        rows.iter().map(|(t, [a, b, c, u, v, w])| (*t, [*u, *v, *w, *a, *b, *c])).collect();
    let feels = |look: &Look| !look.gravity(h, &USUAL).is_empty();
    let [behind, before] = [feels(&look), Look::of(&swapped).is_some_and(|look| feels(&look))];
    let (gyro, accelerometer) = match (behind, before) {
        (true, false) => (first, first + 3),
        (false, true) => (first + 3, first),
        _ => {
            let which = if behind { "both" } else { "none" };
            return wrong(format!(
                "{which} of columns {} to {} and {} to {} read gravity",
                first + 1,
                first + 3,
                first + 4,
                first + 6
            ));
        }
    };
    let mut map = Map { text: Text::default(), ..Map::default() };
    let three = |at: usize| (at + 1..=at + 3).map(Column::Number).collect::<Vec<_>>();
    map.time.columns = vec![Column::Number(time + 1)];
    map.gyro.columns = three(gyro);
    map.accelerometer.columns = three(accelerometer);
    let said = format!(
        "{}: by the numbers column {} is the time, {} to {} are accelerometers, {} to {} gyros",
        head.name,
        time + 1,
        accelerometer + 1,
        accelerometer + 3,
        gyro + 1,
        gyro + 3
    );
    Ok(Ok((map, said)))
}

impl Grid {
    fn of(head: &Head, file: &File) -> Result<Self, InputError> {
        let mut lines = Lines::new(&head.name, file, head.begins)?;
        let mut splitter = Splitter::new(head.delimiter);
        let width = head.first.len();
        let mut rows = Vec::new();
        while rows.len() < ROWS && lines.next_filled()? {
            if comment(&Text::default(), lines.text()).is_none() {
                splitter.split(lines.text());
                rows.push((0..width).map(|i| splitter.field(i).and_then(number)).collect());
            }
        }
        Ok(Self { rows, width })
    }

    fn column(&self, i: usize) -> impl Iterator<Item = f64> {
        self.rows.iter().filter_map(move |row| row.get(i).copied().flatten())
    }

    fn steps(&self, i: usize) -> Vec<f64> {
        let values: Vec<_> = self.column(i).collect();
        values.windows(2).map(|pair| pair[1] - pair[0]).collect()
    }

    /// Whether a column goes on as a time does, in steps that differ little; a start over is none.
    fn grows(&self, i: usize) -> bool {
        let mut steps = self.steps(i);
        let back = steps.iter().filter(|&&step| step < 0.0).count();
        steps.retain(|&step| step > 0.0);
        steps.sort_unstable_by(f64::total_cmp);
        let at = |part: usize| steps.get(steps.len() * part / 10).copied().unwrap_or(0.0);
        2 * steps.len() > self.rows.len()
            && back <= 1
            && at(9) <= 3.0 * at(5)
            && at(5) <= 3.0 * at(1)
    }

    /// Whether it counts rows.
    fn counts(&self, i: usize) -> bool {
        self.steps(i).iter().all(|&step| step == 1.0)
    }

    fn varies(&self, i: usize) -> bool {
        self.steps(i).iter().any(|&step| step != 0.0)
    }

    /// Times and the six columns from one on.
    fn samples(&self, time: usize, first: usize) -> Vec<(f64, [f64; 6])> {
        let whole = |row: &Vec<Option<f64>>| {
            let mut values = [0.0; 6];
            for (k, value) in values.iter_mut().enumerate() {
                *value = row.get(first + k).copied().flatten()?;
            }
            Some((row.get(time).copied().flatten()?, values))
        };
        self.rows.iter().filter_map(whole).collect()
    }
}
