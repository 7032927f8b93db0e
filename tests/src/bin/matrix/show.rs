//! The matrix as tables.

use super::verdict::{Flight, Matrix, Row, Verdict};
use schuler_host::audit::page::Table;

/// A row that has ended, in a line.
pub fn ended(row: &Row) -> String {
    format!("{:32} {:4.0} s  {}\n", row.target, row.time_s, verdict(row))
}

/// The table of targets, and that of digests.
pub fn tables(matrix: &Matrix) -> Vec<Table> {
    let heads = ["target", "compiler", "built with", "run by", "digest", "verdict"];
    let Matrix { digests, golden, .. } = matrix;
    let title = format!(
        "{} of {} targets give the same bits, {golden} of {digests} digests are golden",
        matrix.equal(),
        matrix.rows.len()
    );
    let mut targets = Table::new(&title, &heads);
    for row in &matrix.rows {
        let name = match row.target == row.triple {
            true => row.target.to_owned(),
            false => format!("{} {}", row.triple, row.target),
        };
        let digest = row.digest.clone().unwrap_or_else(|| "-".to_owned());
        let Row { compiler, flags, runner, .. } = row.clone();
        targets.rows.push(vec![name, compiler, flags, runner, digest, verdict(row)]);
    }
    let title = format!("{} digests of the first row", matrix.flights.len());
    let mut flights = Table::new(&title, &["flight", "stage", "samples", "digest"]);
    for flight in &matrix.flights {
        let Flight { flight, stage, samples, digest } = flight.clone();
        flights.rows.push(vec![flight, stage, samples, digest]);
    }
    vec![targets, flights]
}

fn verdict(row: &Row) -> String {
    match &row.verdict {
        None => "done".to_owned(),
        Some(Verdict::First) => "the first".to_owned(),
        Some(Verdict::Equal) => "equal".to_owned(),
        Some(Verdict::Parts(place)) => format!("PARTS: {place}"),
        Some(Verdict::PartsFromGolden(place)) => format!("PARTS FROM GOLDEN: {place}"),
        Some(Verdict::Failed(what)) => format!("FAILED: {what}"),
        Some(Verdict::Missing(what)) => format!("skipped: {what}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_title_counts_what_is_golden_even_if_nothing_is() {
        let matrix = Matrix { rows: Vec::new(), flights: Vec::new(), digests: 2, golden: 0 };
        let [targets, _] = tables(&matrix).try_into().unwrap();
        assert!(targets.title.ends_with("0 of 2 digests are golden"), "{}", targets.title);
    }
}
