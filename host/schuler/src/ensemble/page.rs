//! `ensemble.html`: an ensemble on one self-contained page.

use super::accuracy::Figure;
use super::summary::Outcome;
use super::{charts, figures};
use crate::report::{figures as drawing, head, plot};
use schuler_report::axis::printed;
use schuler_report::chart::Chart;
use schuler_report::interactive::{Interactive, Width};
use schuler_report::page::{self, panel};
use schuler_report::svg::escape;
use schuler_simulator::number::{Quantity, parameter, rounded, short};

/// The file's name.
pub const NAME: &str = "ensemble.html";

/// The page.
pub fn page(outcome: &Outcome) -> String {
    let title = escape(&outcome.scene.title);
    let [runs, failed] = outcome.runs;
    let failed = match failed {
        0 => String::new(),
        failed => format!(", of which {failed} did not reach their end"),
    };
    let command = escape(&outcome.command.join(" "));
    let body = format!(
        "<h1>{title}</h1>\n<p class=\"quiet\">{runs} runs of {} s{failed}, seed {} · <code>schuler {command}</code></p>\n{}{}{}{}{}{}",
        parameter(outcome.scene.duration_s),
        outcome.scene.seed,
        headline(outcome),
        about_the_truth(outcome),
        budget(outcome),
        spread(outcome),
        histograms(outcome),
        provenance(outcome)
    );
    page::page(&format!("{title}: {runs} runs"), &body)
}

/// Standard deviations over time as a picture for documents.
pub fn svg(outcome: &Outcome) -> String {
    let [runs, _] = outcome.runs;
    let about = format!(
        "standard deviation of {runs} runs with its interval of 95 %; theory dashed · seed {}",
        outcome.scene.seed
    );
    plot::svg_of(&outcome.scene.title, &about, &charts::sigma(outcome.findings))
}

fn headline(outcome: &Outcome) -> String {
    let findings = outcome.findings;
    let card = |value: String, what: &str| (printed(&value), what.to_owned());
    let sentences: String = outcome
        .sentences
        .iter()
        .map(|sentence| format!("<p>{}</p>\n", printed(&escape(sentence))))
        .collect();
    let Some(at) = findings.instants.last() else {
        return format!(
            "<p>Too few runs reached their end: there is nothing to compare.</p>\n{sentences}"
        );
    };
    let it = &at.accuracy;
    let show = |figure: &Figure| Quantity::Position.show(figure.runs.value);
    let tests = findings.verdict.tests + findings.together.tests;
    let failed = findings.verdict.failed + findings.together.failed;
    let verdict = match failed {
        0 => format!("The runs scatter as theory says: {tests} tests, none fails"),
        failed => format!("The runs do not scatter as theory says: {failed} of {tests} tests fail"),
    };
    let cards = [
        card(show(&it.cep50), "CEP50 at the end: half of the runs are within"),
        card(show(&it.cep95), "CEP95 at the end"),
        card(show(&it.vertical95), "vertical, 95 %"),
        card(format!("{} nmi/h", rounded(it.nmi_h(it.cep50.runs.value), 3)), "CEP50 over time"),
    ];
    page::verdict(failed == 0, &verdict) + &page::cards(&cards) + &sentences
}

fn about_the_truth(outcome: &Outcome) -> String {
    let findings = outcome.findings;
    let Some((map, each)) = charts::scatter(findings) else { return String::new() };
    let each = if each > 1 { format!(" A dot is one run in {each}.") } else { String::new() };
    let time = Interactive::of(charts::accuracy(findings))
        .sharing("time")
        .sized(Width::TwoThirds, map.height);
    let cell = |figure: &Figure| {
        let theory = if figure.theory.is_nan() { "–".to_owned() } else { short(figure.theory) };
        let interval = figure.runs.interval;
        let interval =
            interval.map_or("–".to_owned(), |[a, b]| format!("{} to {}", short(a), short(b)));
        [short(figure.runs.value), interval, theory]
    };
    let rows: Vec<Vec<String>> = findings
        .instants
        .iter()
        .map(|at| {
            let it = &at.accuracy;
            let figures = [&it.cep50, &it.cep95, &it.vertical95].into_iter().flat_map(cell);
            let rate = rounded(it.nmi_h(it.cep50.runs.value), 3);
            let cells = [parameter(it.time_s)].into_iter().chain(figures).chain([rate]);
            cells.map(|cell| printed(&cell)).collect()
        })
        .collect();
    let heads = [
        "s",
        "CEP50, m",
        "95 %",
        "theory",
        "CEP95, m",
        "95 %",
        "theory",
        "vertical 95 %, m",
        "95 %",
        "theory",
        "nmi/h",
    ];
    format!(
        "<h2>About the truth</h2>\n<p class=\"quiet\">Ellipses of 50 % and 95 %: of the runs drawn through, of theory \
         dashed. Over time: the circles that hold 50 % (blue) and 95 % (orange) of the runs and the height that 95 % keep \
         (green), with intervals of 95 %; theory dashed.{each}</p>\n\
         {}{}",
        drawing::grid([map, time]),
        panel(&heads, &rows)
    )
}

fn budget(outcome: &Outcome) -> String {
    let findings = outcome.findings;
    let rows = figures::rows(&findings.budget);
    if rows.is_empty() {
        return String::new();
    }
    let names: Vec<&str> = rows.iter().map(|row| row.name).collect();
    let stacks = [false, true].map(|by_runs| charts::stack(findings, &names, by_runs));
    let stacks = drawing::grid(stacks.into_iter().flatten());
    let horizontal: Vec<f64> = rows.iter().map(|row| row.best().horizontal).collect();
    let told =
        |x: Option<f64>| x.filter(|x| !x.is_nan()).map_or("–".to_owned(), |x| printed(&short(x)));
    let row = |(place, (row, share)): (usize, (&figures::Row, f64))| {
        let (ink, opacity) = charts::paint(place);
        let swatch = format!(
            "<svg class=\"i-{}\" viewBox=\"0 0 12 12\" style=\"display:inline-block;width:12px;margin-right:8px\" aria-hidden=\"true\">\
             <path d=\"M0 0L12 0L12 12L0 12Z\" fill=\"currentColor\" fill-opacity=\"{opacity}\"/></svg>",
            ink.name()
        );
        let share = if share.is_nan() { "–".to_owned() } else { format!("{:.1}", 100.0 * share) };
        let cells = [
            told(row.theory.map(|x| x.horizontal)),
            told(row.runs.map(|x| x.horizontal)),
            share,
            told(row.theory.map(|x| x.vertical)),
            told(row.runs.map(|x| x.vertical)),
            told(row.theory.map(|x| x.heading)),
            told(row.runs.map(|x| x.heading)),
        ];
        let cells: String = cells.iter().map(|cell| format!("<td>{cell}</td>")).collect();
        format!("<tr><td>{swatch}{}</td>{cells}</tr>\n", escape(row.name))
    };
    let body: String =
        rows.iter().zip(figures::shares_of(&horizontal)).enumerate().map(row).collect();
    let heads =
        ["term", "horizontal, m", "runs", "share, %", "vertical, m", "runs", "heading, ″", "runs"];
    let heads = heads.map(|head| format!("<th>{head}</th>")).concat();
    let flown = findings.budget.iter().any(|share| !share.runs.is_empty());
    let note = match flown {
        true => "“Runs” are the same runs flown without the term, subtracted run by run.",
        false => {
            "With <code>--budget</code> runs are flown without each term, too, and stand beside theory."
        }
    };
    format!(
        "<h2>What the error is made of</h2>\n<p class=\"quiet\">Root mean square of each term alone at the end, by \
         theory. Shares are of the sum of squares; fixed errors may also cancel one another. {note}</p>\n\
         {stacks}{}",
        page::framed(&format!("<table>\n<tr>{heads}</tr>\n{body}</table>"))
    )
}

fn spread(outcome: &Outcome) -> String {
    if outcome.findings.instants.is_empty() {
        return String::new();
    }
    format!(
        "<h2>Standard deviation over time</h2>\n<p class=\"quiet\">Of the runs, drawn through, with its interval of \
         95 %; theory dashed.</p>\n{}",
        nine(charts::sigma(outcome.findings), Some("time"))
    )
}

fn histograms(outcome: &Outcome) -> String {
    let charts = charts::histograms(outcome.findings);
    let note = "Of the runs, and theory’s normal density where it can be tested, dashed.";
    charts.map_or(String::new(), |charts| {
        format!(
            "<h2>Distribution at the end</h2>\n<p class=\"quiet\">{note}</p>\n{}",
            nine(charts, None)
        )
    })
}

fn nine(charts: [[Chart; 3]; 3], cursor: Option<&'static str>) -> String {
    let charts = charts.into_iter().flatten();
    drawing::grid(charts.map(|chart| Interactive { cursor, ..Interactive::of(chart) }))
}

fn provenance(outcome: &Outcome) -> String {
    let row = |name: &str, value: String| vec![name.to_owned(), value];
    let scene = outcome.scene;
    let rows = [
        row("seed", scene.seed.to_string()),
        row("samples of each run", scene.samples().to_string()),
        row("saturated samples", outcome.saturated.to_string()),
        row("SHA-256 of the scene", scene.text_sha256.clone()),
        row("version", head::versions()),
    ];
    format!("<h2>Seed, scene, version</h2>\n{}", panel(&[], &rows))
}
