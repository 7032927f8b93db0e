//! The page of an aided ensemble, and its picture for documents.

use super::super::accuracy::Figure;
use super::super::figures as terms;
use super::super::summary::Told;
use super::charts;
use super::findings::Findings;
use crate::report::{figures, head, plot};
use schuler_report::axis::printed;
use schuler_report::interactive::{Interactive, Width};
use schuler_report::page::{self, panel};
use schuler_report::svg::escape;
use schuler_simulator::aided::report::Count;
use schuler_simulator::aided::runs::Together;
use schuler_simulator::number::{Quantity, parameter, rounded, short};

/// The page.
pub fn page(told: &Told, findings: &Findings) -> String {
    let title = escape(&told.scene.title);
    let [runs, failed] = told.runs;
    let failed = match failed {
        0 => String::new(),
        failed => format!(", of which {failed} did not reach their end"),
    };
    let command = escape(&told.command.join(" "));
    let body = format!(
        "<h1>{title}</h1>\n<p class=\"quiet\">{runs} aided runs of {} s{failed}, seed {} · <code>schuler {command}</code></p>\n\
         {}{}{}{}{}{}",
        parameter(told.scene.duration_s),
        told.scene.seed,
        headline(told, findings),
        errors(findings),
        consistency(findings),
        measurements(findings),
        budget(findings),
        provenance(told, findings)
    );
    page::page(&format!("{title}: {runs} aided runs"), &body)
}

/// Errors over time as a picture for documents.
pub fn svg(told: &Told, findings: &Findings) -> String {
    let [runs, _] = told.runs;
    let about = format!(
        "rms of {runs} aided runs; the σ that filters say dashed, with the band of 95 % · seed {}",
        told.scene.seed
    );
    plot::svg_of(&told.scene.title, &about, &charts::errors(&findings.instants, findings.ended))
}

fn headline(told: &Told, findings: &Findings) -> String {
    let sentences: String = told
        .sentences
        .iter()
        .map(|sentence| format!("<p>{}</p>\n", printed(&escape(sentence))))
        .collect();
    let Some(it) = findings.accuracy.last() else { return sentences };
    let (tests, failed) = (findings.verdict.tests, findings.verdict.failed);
    let verdict = match failed {
        0 => format!("The errors are as the filters say: {tests} tests of NEES, none fails"),
        failed => {
            format!("The errors are not as the filters say: {failed} of {tests} tests of NEES fail")
        }
    };
    let show = |figure: &Figure| printed(&Quantity::Position.show(figure.runs.value));
    let cards = [
        (show(&it.cep50), "CEP50 at the end: half of the runs are within".to_owned()),
        (show(&it.cep95), "CEP95 at the end".to_owned()),
        (show(&it.vertical95), "vertical, 95 %".to_owned()),
    ];
    // That nothing fails is said already.
    let sentences = if failed == 0 { String::new() } else { sentences };
    page::verdict(failed == 0, &verdict) + &page::cards(&cards) + &sentences
}

fn errors(findings: &Findings) -> String {
    if findings.instants.is_empty() {
        return String::new();
    }
    let nine = |instants: &[Together]| {
        let charts = charts::errors(instants, findings.ended).into_iter().flatten();
        figures::grid(charts.map(|chart| Interactive::of(chart).sharing("time")))
    };
    let smoothed = match findings.smoothed.is_empty() {
        true => String::new(),
        false => format!(
            "<h2>Smoothed</h2>\n<p class=\"quiet\">The same of what all measurements of a run, also later ones, say of each \
             instant.</p>\n{}",
            nine(&findings.smoothed)
        ),
    };
    format!(
        "<h2>Errors, and what the filters say</h2>\n<p class=\"quiet\">Root mean square over the runs, drawn through. The \
         standard deviation that the filters say is dashed; 95 % of the rms of so many runs lie in the band about \
         it.</p>\n{}{smoothed}",
        nine(&findings.instants)
    )
}

fn consistency(findings: &Findings) -> String {
    let Some((mut map, each)) = charts::scatter(findings) else { return String::new() };
    map.width = Width::Half;
    let each = if each > 1 { format!(" A dot is one run in {each}.") } else { String::new() };
    format!(
        "<h2>Consistency</h2>\n<p class=\"quiet\">The normalized error squared (NEES), by its degrees of freedom: 1 is \
         expected, and 95 % of the means of so many runs lie in the band.{each}</p>\n{}",
        figures::grid(charts::nees(findings).into_iter().chain([map]))
    )
}

fn measurements(findings: &Findings) -> String {
    let report = &findings.report;
    let row = |count: &Count| {
        let (nis, interval) = match count.consistency() {
            Some((nis, [least, most])) => {
                (rounded(nis, 3), format!("{} to {}", rounded(least, 3), rounded(most, 3)))
            }
            None => ("–".to_owned(), "–".to_owned()),
        };
        let numbers = [count.accepted, count.refused, count.lockouts].map(|n| n.to_string());
        std::iter::once(count.sensor.to_owned()).chain(numbers).chain([nis, interval]).collect()
    };
    let rows: Vec<Vec<String>> = report.sensors.iter().map(row).collect();
    if rows.is_empty() {
        return String::new();
    }
    let odd = [
        (report.again, "came again"),
        (report.late, "came too late"),
        (report.dropped, "found no room"),
    ];
    let odd = odd.into_iter().filter(|(count, _)| *count > 0);
    let odd: Vec<String> = odd.map(|(count, what)| format!("{count} {what}")).collect();
    let odd = match odd.is_empty() {
        true => String::new(),
        false => format!("<p class=\"quiet\">Of all measurements {}.</p>\n", odd.join(", ")),
    };
    let heads = ["sensor", "taken", "refused", "lockouts", "NIS", "95 %"];
    format!("<h2>Measurements</h2>\n{odd}{}", panel(&heads, &rows))
}

fn budget(findings: &Findings) -> String {
    let rows: Vec<Vec<String>> = terms::rows(&findings.budget)
        .iter()
        .map(|row| {
            let it = row.best();
            let numbers = [it.horizontal, it.vertical, it.heading];
            let numbers = numbers.map(|x| printed(&short(x)));
            std::iter::once(row.name.to_owned()).chain(numbers).collect()
        })
        .collect();
    if rows.is_empty() {
        return String::new();
    }
    let heads = ["term", "horizontal, m", "vertical, m", "heading, ″"];
    format!(
        "<h2>What the error is made of</h2>\n<p class=\"quiet\">Root mean square at the end of each run less the same \
         run without the term, whose filter still expects it.</p>\n{}",
        panel(&heads, &rows)
    )
}

fn provenance(told: &Told, findings: &Findings) -> String {
    let row = |name: &str, value: String| vec![name.to_owned(), value];
    let rows = [
        row("seed", told.scene.seed.to_string()),
        row("samples of each run", told.scene.samples().to_string()),
        row("saturated samples", findings.saturated.to_string()),
        row("SHA-256 of the scene", told.scene.text_sha256.clone()),
        row("version", head::versions()),
    ];
    format!("<h2>Seed, scene, version</h2>\n{}", panel(&[], &rows))
}
