//! The table: a line for each filter that has flown.

use crate::judge::Sums;
use crate::{Failed, files};
use std::path::Path;

/// Filters by the names of their files; the first is the unit of cost.
const FILTERS: [&str; 5] = ["schuler", "schuler-f32", "kinavis-ins", "KF-GINS", "pyins"];

/// What is told of each.
const COLUMNS: [&str; 8] = [
    "position m",
    "velocity m/s",
    "tilt ′",
    "heading ′",
    "outage end m",
    "(error/σ)²",
    "CPU µs per sample",
    "of ours",
];

/// Prints that of folders.
pub fn print(folders: &[&Path]) -> Result<(), Failed> {
    println!("| {} flights | {} |", folders.len(), COLUMNS.join(" | "));
    println!("|---{}|", "|--:".repeat(COLUMNS.len()));
    let unit = cost(folders, FILTERS[0])?;
    for name in FILTERS {
        if !folders.iter().all(|folder| folder.join(format!("{name}.csv")).exists()) {
            continue;
        }
        let mut sums = Sums::default();
        for folder in folders {
            sums.add(folder, name)?;
        }
        let [position, velocity, tilt, heading, end, consistency] = sums.figures();
        let cost = cost(folders, name)?;
        let errors = format!("{position:.3} | {velocity:.4} | {tilt:.2} | {heading:.2} | {end:.2}");
        println!("| {name} | {errors} | {consistency:.2} | {cost:.2} | {:.1} |", cost / unit);
    }
    Ok(())
}

/// The median over folders, µs per sample.
fn cost(folders: &[&Path], name: &str) -> Result<f64, Failed> {
    let mut costs = Vec::new();
    for folder in folders {
        let number = files::text(&folder.join(format!("{name}.cost")))?;
        costs.push(number.trim().parse::<f64>()?);
    }
    costs.sort_by(f64::total_cmp);
    costs.get(costs.len() / 2).copied().ok_or_else(|| "no folders".into())
}
