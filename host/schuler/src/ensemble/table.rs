//! The ensemble beside theory, as a table.

use super::statistics::{Comparison, RISK, Test, Verdict};
use schuler_simulator::ensemble::runs::Failure;
use schuler_simulator::flight::Nine;
use schuler_simulator::number::{parameter, rounded, short};

/// Characters of a line.
const WIDTH: usize = 80;
/// What each of a comparison's tests is about.
const TESTED: [&str; 2] = ["mean", "standard deviation"];

/// The end in numbers, every instant as ratios, the verdict.
pub fn table(comparisons: &[Comparison], runs: u64) -> String {
    if comparisons.is_empty() {
        return verdict(comparisons);
    }
    let instants: Vec<&[Comparison]> = comparisons.chunks(Nine::NAMES.len()).collect();
    let mut text = String::new();
    if let Some(end) = instants.last() {
        text += &at_end(end);
    }
    text += &every_instant(
        "\nStandard deviation over theory's",
        &instants,
        |c| c.sigma / c.sigma_theory,
        &format!("chance alone: 1 ± {}", rounded((0.5 / (runs as f64 - 1.0)).sqrt(), 2)),
    );
    text += &every_instant(
        "\nMean less theory's, in standard errors",
        &instants,
        |c| (c.mean - c.mean_theory) / c.sigma_theory * (runs as f64).sqrt(),
        "chance alone: 0 ± 1",
    );
    text + "\n" + &verdict(comparisons)
}

/// Runs that are named, at most.
const NAMED: usize = 20;

/// The runs that did not reach their end: which, where and why.
pub fn failures(failed: &[Failure], seed: u64, runs: u64, time_s: impl Fn(u64) -> f64) -> String {
    if failed.is_empty() {
        return String::new();
    }
    let ended = runs - failed.len() as u64;
    let mut text = format!("of the {ended} runs of {runs} that reached their end:\n");
    for Failure { run, sample, why } in failed.iter().take(NAMED) {
        let time_s = time_s(*sample);
        text += &format!("run {run} of seed {seed} ended at sample {sample}, {time_s} s: {why}\n");
    }
    if failed.len() > NAMED {
        text += &format!("and {} more\n", failed.len() - NAMED);
    }
    text
}

fn at_end(end: &[Comparison]) -> String {
    let time_s = end.first().map_or(0.0, |c| c.time_s);
    let mut text = format!(
        "{:<21} {:>9} {:>9} {:>9} {:>9} {:>8} {:>8}\n{:59}{:>20}\n{}\n",
        format!("at {} s", parameter(time_s)),
        "mean",
        "theory",
        "std dev",
        "theory",
        "p",
        "p",
        "",
        "mean   std dev",
        "─".repeat(WIDTH)
    );
    for c in end {
        let tests = c.tests.map(|tests| tests.map(|t: Test| rounded(t.probability, 2)));
        let [mean, sigma] = tests.unwrap_or(["–", "–"].map(str::to_owned));
        text += &format!(
            "{:<21} {:>9} {:>9} {:>9} {:>9} {mean:>8} {sigma:>8}\n",
            Nine::NAMES[c.component],
            short(c.mean),
            told(c.mean_theory),
            short(c.sigma),
            told(c.sigma_theory),
        );
    }
    text
}

/// What theory says; a dash where it says nothing.
fn told(value: f64) -> String {
    if value.is_nan() { "–".to_owned() } else { short(value) }
}

/// A row per instant, a column per component.
fn every_instant(
    title: &str,
    instants: &[&[Comparison]],
    value: impl Fn(&Comparison) -> f64,
    chance: &str,
) -> String {
    let groups =
        ["position, m", "velocity, m/s", "attitude, ″"].map(|group| format!("{group:>24}"));
    let names = ["north", "east", "down"].map(|name| format!("{name:>8}")).concat().repeat(3);
    let line = "─".repeat(WIDTH);
    let mut text =
        format!("{title} ({chance})\n{:7}{}\n{:>7}{names}\n{line}\n", "", groups.concat(), "s");
    for instant in instants {
        let Some(first) = instant.first() else { continue };
        text += &format!("{:>7}", parameter(first.time_s));
        for c in *instant {
            let cell =
                if c.tests.is_some() { format!("{:.2}", value(c)) } else { "–".to_owned() };
            text += &format!("{cell:>8}");
        }
        text.push('\n');
    }
    text
}

/// Whether the ensemble agrees with theory, in a line.
fn verdict(comparisons: &[Comparison]) -> String {
    let Verdict { tests, failed, worst } = Verdict::new(comparisons);
    let confidence = parameter(100.0 * (1.0 - RISK));
    if comparisons.is_empty() {
        return "too few runs reached their end: nothing to compare\n".to_owned();
    }
    let Some((place, which, probability)) = worst else {
        if comparisons.iter().any(|c| c.sigma_theory.is_nan()) {
            return "The ensemble is not comparable with theory.\n".to_owned();
        }
        return "theory sees nothing scatter: nothing to compare\n".to_owned();
    };
    let Comparison { component, time_s, .. } = comparisons[place];
    let (name, time_s, what) = (Nine::NAMES[component], parameter(time_s), TESTED[which]);
    let worst = format!("{what} of {name} at {time_s} s, p = {}", rounded(probability, 2));
    if failed == 0 {
        format!(
            "The ensemble agrees with theory at {confidence} %: {tests} tests,\n\
             the least likely the {worst}\n"
        )
    } else {
        format!(
            "The ensemble does not agree with theory at {confidence} %: {failed} of {tests} tests fail,\n\
             the worst the {worst}\n"
        )
    }
}
