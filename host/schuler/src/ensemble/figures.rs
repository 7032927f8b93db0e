//! Circular and vertical error, states together, and the error terms, as tables of 80 columns.

use super::findings::{Findings, Share};
use super::statistics::RISK;
use schuler_simulator::ensemble::budget::Contribution;
use schuler_simulator::number::{parameter, rounded, short};

const WIDTH: usize = 80;

/// Circular and vertical error over time, beside theory's.
pub fn accuracy(findings: &Findings) -> String {
    if findings.instants.is_empty() {
        return String::new();
    }
    let mut text = format!(
        "\nError about the truth, m, that half or 95 % of the runs keep\n{:>9} {:>9} {:>8}  {:>9} {:>8}  {:>9} {:>8}  {:>7}\n{:>9} {:>9} {:>8}  {:>9} {:>8}  {:>9} {:>8}  {:>7}\n{}\n",
        "s",
        "CEP50",
        "theory",
        "CEP95",
        "theory",
        "vertical",
        "theory",
        "CEP50",
        "",
        "",
        "",
        "",
        "",
        "95 %",
        "",
        "nmi/h",
        "─".repeat(WIDTH)
    );
    let told = |x: f64| if x.is_nan() { "–".to_owned() } else { short(x) };
    for at in &findings.instants {
        let it = &at.accuracy;
        text += &format!("{:>9}", parameter(it.time_s));
        for (figure, gap) in [(&it.cep50, " "), (&it.cep95, "  "), (&it.vertical95, "  ")] {
            text += &format!("{gap}{:>9} {:>8}", short(figure.runs.value), told(figure.theory));
        }
        text += &format!("  {:>7}\n", rounded(it.nmi_h(it.cep50.runs.value), 3));
    }
    text
}

/// Whether states together scatter as theory says, in a line; none where nothing could be tested.
pub fn together(findings: &Findings) -> String {
    let verdict = &findings.together;
    let confidence = parameter(100.0 * (1.0 - RISK));
    match (verdict.tests, verdict.failed) {
        (0, _) => String::new(),
        (tests, 0) => {
            format!("States together agree with it at {confidence} %: {tests} tests of NEES\n")
        }
        (tests, failed) => format!(
            "States together do not agree with it at {confidence} %: {failed} of {tests} tests of NEES fail\n"
        ),
    }
}

/// What a term adds to the error at the end, m or arcsec.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measures {
    /// North and east.
    pub horizontal: f64,
    /// Down.
    pub vertical: f64,
    /// About down.
    pub heading: f64,
}

impl Measures {
    /// Root mean squares.
    pub fn new(contribution: &Contribution) -> Self {
        let square = |i: usize| contribution.mean[i].powi(2) + contribution.sigma[i].powi(2);
        Self {
            horizontal: (square(0) + square(1)).sqrt(),
            vertical: square(2).sqrt(),
            heading: square(8).sqrt(),
        }
    }
}

/// Each term's share of the sum of squares of all, by one measure; not numbers where there is nothing.
pub fn shares_of(values: &[f64]) -> Vec<f64> {
    let sum: f64 = values.iter().filter(|x| !x.is_nan()).map(|x| x * x).sum();
    values.iter().map(|x| x * x / sum).collect()
}

/// Characters of a term's name: the longest, that of the accelerometers' scale factor by temperature, has 41. The rest
/// of a line of 80 is the numbers'.
const NAME: usize = 42;

/// What the error at the end is made of: by theory, and by switching terms off where that was flown.
pub fn budget(findings: &Findings) -> String {
    let terms = rows(&findings.budget);
    let Some(at) = findings.instants.last().filter(|_| !terms.is_empty()) else {
        return String::new();
    };
    let flown = findings.budget.iter().any(|share| !share.runs.is_empty());
    let mut text = format!(
        "\nWhat the error at {} s is made of: rms of each term alone",
        parameter(at.time_s)
    );
    text += if flown { ",\n\"runs\" by switching it off in runs\n" } else { "\n" };
    let line = |name: &str, cells: [&str; 5]| {
        let [theory, runs, share, down, heading] = cells;
        format!("{name:<NAME$}{theory:>10} {runs:>6} {share:>5} {down:>6} {heading:>7}\n")
    };
    text += &line("", ["horizontal", "runs", "share", "down", "heading"]);
    text += &line("", ["m", "m", "%", "m", "arcsec"]);
    text += &format!("{}\n", "─".repeat(WIDTH));
    let horizontal: Vec<f64> = terms.iter().map(|term| term.best().horizontal).collect();
    let told = |x: Option<f64>| x.filter(|x| !x.is_nan()).map_or("–".to_owned(), short);
    for (term, share) in terms.iter().zip(shares_of(&horizontal)) {
        let best = Some(term.best());
        let share = if share.is_nan() { "–".to_owned() } else { format!("{:.1}", 100.0 * share) };
        let cells = [
            told(term.theory.map(|x| x.horizontal)),
            told(term.runs.map(|x| x.horizontal)),
            share,
            told(best.map(|x| x.vertical)),
            told(best.map(|x| x.heading)),
        ];
        text += &line(term.name, cells.each_ref().map(String::as_str));
    }
    text
}

/// A term at the end.
#[derive(Clone, Debug)]
pub struct Row<'a> {
    /// Its name.
    pub name: &'a str,
    /// By theory.
    pub theory: Option<Measures>,
    /// By switching it off.
    pub runs: Option<Measures>,
}

impl Row<'_> {
    /// By theory, or by the runs where it says nothing.
    pub fn best(&self) -> Measures {
        let unknown = Measures { horizontal: f64::NAN, vertical: f64::NAN, heading: f64::NAN };
        let theory = self.theory.filter(|theory| !theory.horizontal.is_nan());
        theory.or(self.runs).unwrap_or(unknown)
    }
}

/// The terms at the end, the greatest first.
pub fn rows(budget: &[Share]) -> Vec<Row<'_>> {
    let row = |share: &'_ Share| -> [Option<Measures>; 2] {
        [share.theory.last().map(Measures::new), share.runs.last().map(Measures::new)]
    };
    let mut rows: Vec<Row> = budget
        .iter()
        .map(|share| {
            let [theory, runs] = row(share);
            Row { name: &share.name, theory, runs }
        })
        .collect();
    let size =
        |row: &Row| if row.best().horizontal.is_nan() { -1.0 } else { row.best().horizontal };
    rows.sort_by(|a, b| size(b).total_cmp(&size(a)));
    rows
}
