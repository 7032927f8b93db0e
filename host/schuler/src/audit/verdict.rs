//! The verdict on fields that may be apart, in words and as a table.

use super::page::Table;
use super::tolerance::FieldVerdict;

/// The verdict on all fields, in a line.
pub fn near(fields: &[FieldVerdict]) -> String {
    let beyond = fields.iter().filter(|field| field.beyond > 0);
    let first = beyond.clone().min_by_key(|field| field.first);
    match first {
        None => format!("all of {} words are within their limits", fields.len()),
        Some(FieldVerdict { stage, field, first, .. }) => {
            let sample =
                first.map_or_else(String::new, |sample| format!(", from sample {sample} on"));
            format!(
                "{} of {} words are beyond: first stage {stage}, field {field}{sample}",
                beyond.count(),
                fields.len()
            )
        }
    }
}

/// The verdict on each field, with its worst.
pub fn table(fields: &[FieldVerdict]) -> Table {
    let heads =
        ["stage", "field", "limit", "verdict", "worst, ulps", "worst, difference", "at sample"];
    let mut table = Table::new("every word at its worst", &heads);
    for FieldVerdict { stage, field, limit, rows, beyond, sample, worst, .. } in fields {
        let verdict = match (beyond, worst) {
            (0, None) => "the same bits".to_owned(),
            (0, _) => "within".to_owned(),
            _ => format!("BEYOND in {beyond} of {rows} rows"),
        };
        let (ulps, difference) =
            worst.as_ref().map_or((0, 0.0), |worst| (worst.ulps, worst.difference));
        let sample = sample.map_or_else(String::new, |sample| sample.to_string());
        table.rows.push(vec![
            stage.clone(),
            field.clone(),
            limit.clone(),
            verdict,
            ulps.to_string(),
            format!("{difference:.3e}"),
            sample,
        ]);
    }
    table
}
