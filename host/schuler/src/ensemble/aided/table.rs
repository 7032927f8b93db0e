//! Aided runs beside what their filters say, as text of 80 columns.

use super::super::figures::{self, Measures};
use super::findings::Findings;
use crate::aided;
use schuler_simulator::aided::runs::{GROUPS, Together};
use schuler_simulator::number::{parameter, rounded, short};
use schuler_simulator::units::ARCSECOND;

/// Rows of the table.
const ROWS: usize = 12;

/// All of it.
pub fn text(findings: &Findings, sentences: &[String]) -> String {
    let instants = &findings.instants;
    let mut text = table(instants) + "\n" + &nees(instants);
    if !findings.smoothed.is_empty() {
        let (table, nees) = (table(&findings.smoothed), nees(&findings.smoothed));
        text += &format!("\nsmoothed, by all measurements of each run:\n{table}\n{nees}");
    }
    for sentence in sentences {
        text += &format!("{sentence}\n");
    }
    text += &aided::lines(&findings.report);
    if let Some(it) = findings.accuracy.last() {
        let [cep50, cep95, vertical] =
            [it.cep50, it.cep95, it.vertical95].map(|figure| short(figure.runs.value));
        text += &format!(
            "at {} s: CEP50 {cep50} m, CEP95 {cep95} m, vertical 95 % {vertical} m\n",
            parameter(it.time_s)
        );
    }
    if findings.saturated > 0 {
        text += &format!("a sensor was at its limit in {} samples\n", findings.saturated);
    }
    text + &budget(findings)
}

/// The root of the sum of squares over a group's three axes.
pub fn norm(nine: &[f64; 9], group: usize) -> f64 {
    nine[3 * group..3 * group + 3].iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Some instants: rms and σ of position, velocity and attitude, and NEES.
fn table(together: &[Together]) -> String {
    let mut text = format!(
        "{:>7}{:>11}{:>9}{:>11}{:>9}{:>11}{:>9}{:>9}\n{:>7}{:>11}{:>9}{:>11}{:>9}{:>11}{:>9}{:>9}\n",
        "time",
        "position",
        "σ",
        "velocity",
        "σ",
        "attitude",
        "σ",
        "NEES",
        "s",
        "rms m",
        "said",
        "rms m/s",
        "said",
        "rms ″",
        "said",
        "by 9"
    );
    let step = together.len().div_ceil(ROWS).max(1);
    let rows =
        together.iter().enumerate().filter(|(i, _)| (together.len() - 1 - i).is_multiple_of(step));
    for (_, one) in rows {
        let pairs = [1.0, 1.0, 1.0 / ARCSECOND].into_iter().enumerate();
        let cells: String = pairs
            .map(|(group, unit)| {
                let [rms, sigma] =
                    [&one.rms, &one.sigma].map(|nine| rounded(norm(nine, group) * unit, 4));
                format!("{rms:>11}{sigma:>9}")
            })
            .collect();
        let mark = if is_inside(one, 0) { ' ' } else { '!' };
        text +=
            &format!("{:>7}{cells}{:>8}{mark}\n", rounded(one.time_s, 5), rounded(one.nees[0], 3));
    }
    text
}

/// Whether the errors of a group are as the filters say, by chance in 95 of 100 cases.
fn is_inside(one: &Together, group: usize) -> bool {
    let [least, most] = one.expected[group];
    (least..=most).contains(&one.nees[group])
}

/// How many of the instants are within 95 %, in words.
fn nees(together: &[Together]) -> String {
    let mut text = String::new();
    for (group, name) in GROUPS.iter().enumerate() {
        let inside = together.iter().filter(|one| is_inside(one, group)).count();
        let n = together.len().max(1) as f64;
        let mean = together.iter().map(|one| one.nees[group]).sum::<f64>() / n;
        let [least, most] = together.last().map_or([0.0; 2], |one| one.expected[group]);
        text += &format!(
            "NEES of {name}: {} of 1 on average; {inside} of {} instants within {} to {} (95 %)\n",
            rounded(mean, 3),
            together.len(),
            rounded(least, 3),
            rounded(most, 3)
        );
    }
    text
}

/// What each error term contributes at the end.
fn budget(findings: &Findings) -> String {
    let rows = figures::rows(&findings.budget);
    if rows.is_empty() {
        return String::new();
    }
    let mut text = format!(
        "\nWhat each term contributes at the end, rms: runs less the same runs without it\n\
         {:<40}{:>13}{:>13}{:>14}\n",
        "", "horizontal, m", "vertical, m", "heading, ″"
    );
    for row in rows {
        let Measures { horizontal, vertical, heading } = row.best();
        let [horizontal, vertical, heading] = [horizontal, vertical, heading].map(short);
        text += &format!("{:<40}{horizontal:>13}{vertical:>13}{heading:>14}\n", row.name);
    }
    text
}
