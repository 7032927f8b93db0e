//! Which states part from theory, when, and by how much, in sentences.

use super::findings::{Findings, group_name};
use super::statistics::{Comparison, RISK};
use schuler_simulator::flight::Nine;
use schuler_simulator::number::{parameter, rounded, short};
use statrs::distribution::{ChiSquared, ContinuousCDF, Normal};

/// Sentences of what parts from theory, at most.
const MOST: usize = 6;

/// A sentence for each state whose mean or spread parts from theory, and for states together; the least likely
/// first. Where nothing does, what would have been found.
pub fn sentences(findings: &Findings) -> Vec<String> {
    let mut parted: Vec<(f64, String)> = Vec::new();
    for component in 0..Nine::NAMES.len() {
        for which in 0..2 {
            parted.extend(of_component(findings, component, which));
        }
    }
    parted.extend(together(findings));
    parted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let more = parted.len().saturating_sub(MOST);
    let mut sentences: Vec<String> =
        parted.into_iter().take(MOST).map(|(_, sentence)| sentence).collect();
    if more > 0 {
        sentences.push(format!("And {more} more: ensemble.csv and consistency.csv have all."));
    }
    if sentences.is_empty() {
        sentences.extend(power(findings));
    }
    sentences
}

/// How mean (0) or spread (1) of a component part from theory, with the probability of the worst.
fn of_component(findings: &Findings, component: usize, which: usize) -> Option<(f64, String)> {
    let verdict = &findings.verdict;
    let of_it = findings.comparisons.iter().filter(|c| c.component == component);
    let tested = of_it.filter_map(|c| Some((c, c.tests?[which].probability)));
    let tested: Vec<(&Comparison, f64)> = tested.collect();
    let failed: Vec<_> = tested.iter().filter(|(_, p)| verdict.fails(*p)).collect();
    let &&(worst, probability) =
        failed.iter().min_by(|a, b| a.1.total_cmp(&b.1).then(b.0.time_s.total_cmp(&a.0.time_s)))?;
    let n = findings.ended as f64;
    let by = match which {
        0 => {
            let off = worst.mean - worst.mean_theory;
            let errors = (off / (worst.sigma_theory / n.sqrt())).abs();
            let side = if off > 0.0 { "above" } else { "below" };
            format!(
                "lies {} {side} theory's {} ({} standard errors)",
                short(off.abs()),
                short(worst.mean_theory),
                rounded(errors, 2)
            )
        }
        _ => {
            let ratio = worst.sigma / worst.sigma_theory;
            let [low, high] = ratio_interval(n - 1.0).map(|factor| percent(ratio * factor));
            let off = percent(ratio);
            let side = if off > 0.0 { "above" } else { "below" };
            format!(
                "is {} % {side} theory's {} (95 %: {} to {} %)",
                rounded(off.abs(), 3),
                short(worst.sigma_theory),
                rounded(low, 3),
                rounded(high, 3)
            )
        }
    };
    let what = ["mean", "standard deviation"][which];
    let name = Nine::NAMES[component];
    let when = parameter(worst.time_s);
    let extent = match (failed.len(), tested.len()) {
        (1, 1) => String::new(),
        (failed, tested) if failed == tested => "; it fails at every time".to_owned(),
        (1, _) => "; at no other time".to_owned(),
        (count, tested) => {
            let first = failed.iter().map(|(c, _)| c.time_s).fold(f64::INFINITY, f64::min);
            format!("; it fails at {count} of {tested} times, first at {} s", parameter(first))
        }
    };
    let chance = chance(probability);
    Some((probability, format!("The {what} of {name} at {when} s {by}, {chance}{extent}.")))
}

/// How states together part from theory.
fn together(findings: &Findings) -> Vec<(f64, String)> {
    let verdict = &findings.together;
    let failed = findings.consistency().filter(|c| verdict.fails(c.test.probability));
    let mut worst: Vec<&super::consistency::Consistency> = Vec::new();
    for candidate in failed {
        match worst.iter_mut().find(|known| known.group == candidate.group) {
            Some(known) if candidate.test.probability < known.test.probability => {
                *known = candidate;
            }
            Some(_) => {}
            None => worst.push(candidate),
        }
    }
    let sentence = |c: &super::consistency::Consistency| {
        let (states, side) =
            (c.states as f64, if c.mean > c.states as f64 { "more" } else { "less" });
        let [low, high] = chi_square_interval(c.runs as f64 * states).map(|x| x / c.runs as f64);
        let text = format!(
            "At {} s {} scatter {side} than theory says: NEES {} where {} is expected (95 %: {} to {}), {}.",
            parameter(c.time_s),
            group_name(c),
            rounded(c.mean, 4),
            c.states,
            rounded(low, 4),
            rounded(high, 4),
            chance(c.test.probability)
        );
        (c.test.probability, text)
    };
    worst.into_iter().map(sentence).collect()
}

/// What so many runs would have shown.
fn power(findings: &Findings) -> Option<String> {
    let verdict = &findings.verdict;
    if verdict.tests == 0 || findings.ended < 2 {
        return None;
    }
    // z of the level on both sides and of four in five, over the relative error of s: 1/√(2(n − 1)).
    let law = Normal::standard();
    let z = -law.inverse_cdf(0.5 * verdict.level()) + law.inverse_cdf(0.8);
    let n = findings.ended as f64;
    let share = 100.0 * z * (0.5 / (n - 1.0)).sqrt();
    Some(format!(
        "With {n} runs, a standard deviation that is off by {} % would be found four times in five, at {} %.",
        rounded(share, 2),
        parameter(100.0 * (1.0 - RISK))
    ))
}

fn percent(ratio: f64) -> f64 {
    100.0 * (ratio - 1.0)
}

fn chance(probability: f64) -> String {
    match probability {
        p if p.is_nan() => "which is no number".to_owned(),
        p if p < 1e-15 => "p < 1e-15".to_owned(),
        p => format!("p = {}", rounded(p, 2)),
    }
}

/// What s is to be multiplied by for the ends of σ's interval of 95 %.
fn ratio_interval(freedom: f64) -> [f64; 2] {
    let [low, high] = chi_square_interval(freedom);
    [(freedom / high).sqrt(), (freedom / low).sqrt()]
}

/// Between which χ² lies in 95 % of cases.
pub fn chi_square_interval(freedom: f64) -> [f64; 2] {
    match ChiSquared::new(freedom) {
        Ok(law) => [0.025, 0.975].map(|p| law.inverse_cdf(p)),
        Err(_) => [f64::NAN; 2],
    }
}
