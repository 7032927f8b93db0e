//! The matrix as tables.

use super::{Matrix, Row, Verdict};
use crate::audit::page::Table;

/// A row that has ended, in a line.
pub fn ended(row: &Row) -> String {
    format!("{:32} {:4.0} s  {}\n", row.target, row.time_s, verdict(row, "done"))
}

/// The table of targets, and that of digests.
pub fn tables(matrix: &Matrix) -> Vec<Table> {
    let heads = ["target", "compiler", "built with", "run by", "digest", "verdict"];
    let title = format!("{} of {} targets give the same bits", matrix.equal(), matrix.rows.len());
    let title = match matrix.golden {
        0 => title,
        golden => format!("{title}, {golden} digests of them golden"),
    };
    let mut targets = Table::new(&title, &heads);
    for row in &matrix.rows {
        let name = match row.target == row.triple {
            true => row.target.to_owned(),
            false => format!("{} {}", row.triple, row.target),
        };
        let digest = row.digest.clone().unwrap_or_else(|| "-".to_owned());
        let Row { compiler, flags, runner, .. } = row.clone();
        targets.rows.push(vec![name, compiler, flags, runner, digest, verdict(row, "the first")]);
    }
    let title = format!("{} digests of the first row", matrix.flights.len());
    let mut flights = Table::new(&title, &["flight", "stage", "samples", "digest"]);
    for flight in &matrix.flights {
        let super::Flight { flight, stage, samples, digest } = flight.clone();
        flights.rows.push(vec![flight, stage, samples, digest]);
    }
    vec![targets, flights]
}

fn verdict(row: &Row, first: &str) -> String {
    match &row.verdict {
        Verdict::First => first.to_owned(),
        Verdict::Equal if row.digest.is_none() => first.to_owned(),
        Verdict::Equal => "equal".to_owned(),
        Verdict::Parts(place) => format!("PARTS: {place}"),
        Verdict::PartsFromGolden(place) => format!("PARTS FROM GOLDEN: {place}"),
        Verdict::Failed(what) => format!("FAILED: {what}"),
        Verdict::Missing(what) => format!("skipped: {what}"),
    }
}
