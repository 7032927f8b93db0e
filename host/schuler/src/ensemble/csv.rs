//! The tables of an ensemble. Numbers round-trip; what is not known is empty.

use super::accuracy::Figure;
use super::findings::{At, Findings, group_name};
use schuler_simulator::flight::Nine;
use schuler_simulator::number::exact;
use schuler_simulator::output;

/// The file of all comparisons, of all covariances, of circular and vertical errors, of states together, of error terms.
pub const NAMES: [&str; 5] =
    ["ensemble.csv", "covariance.csv", "accuracy.csv", "consistency.csv", "budget.csv"];

/// The columns of `ensemble.csv`, in the unit that the component's name carries. The χ² of the mean has
/// one degree of freedom, that of the standard deviation one less than there are runs; `_probability`
/// is how often chance alone lies that far out. They are empty where theory sees nothing scatter, and so is what it expects where its model has ended.
/// Then the runs' quantiles (`p2_5` has 2.5 % of the runs below it), the least and the greatest with the run that has it.
pub const COLUMNS: [&str; 19] = [
    "time_s",
    "component",
    "mean",
    "mean_theory",
    "sigma",
    "sigma_theory",
    "mean_chi_square",
    "mean_probability",
    "sigma_chi_square",
    "sigma_probability",
    "least",
    "least_run",
    "p2_5",
    "p25",
    "p50",
    "p75",
    "p97_5",
    "greatest",
    "greatest_run",
];

/// The columns of `accuracy.csv`.
pub const ACCURACY: [&str; 15] = [
    "time_s",
    "cep50_m",
    "cep50_low_m",
    "cep50_high_m",
    "cep50_theory_m",
    "cep95_m",
    "cep95_low_m",
    "cep95_high_m",
    "cep95_theory_m",
    "vertical95_m",
    "vertical95_low_m",
    "vertical95_high_m",
    "vertical95_theory_m",
    "cep50_nmi_h",
    "cep50_theory_nmi_h",
];

/// All tables, in the order of [`NAMES`].
pub fn tables(findings: &Findings) -> [Vec<u8>; 5] {
    [
        comparisons(findings),
        covariance(findings),
        accuracy(findings),
        consistency(findings),
        budget(findings),
    ]
}

fn told(x: f64) -> String {
    if x.is_nan() { String::new() } else { exact(x) }
}

fn comparisons(findings: &Findings) -> Vec<u8> {
    let nine = Nine::NAMES.len();
    let rows = findings.comparisons.iter().enumerate().map(|(place, c)| {
        let tests = match c.tests {
            Some(tests) => tests.map(|t| [exact(t.chi_square), exact(t.probability)]),
            None => Default::default(),
        };
        let [[mean_chi_square, mean_probability], [sigma_chi_square, sigma_probability]] = tests;
        let spread = &findings.instants[place / nine].spread;
        let [least, greatest] = spread.extremes[c.component];
        let [p2_5, p25, p50, p75, p97_5] = spread.quantiles[c.component].map(exact);
        [
            exact(c.time_s),
            Nine::NAMES[c.component].to_owned(),
            exact(c.mean),
            told(c.mean_theory),
            exact(c.sigma),
            told(c.sigma_theory),
            mean_chi_square,
            mean_probability,
            sigma_chi_square,
            sigma_probability,
            exact(least.value),
            least.run.to_string(),
            p2_5,
            p25,
            p50,
            p75,
            p97_5,
            exact(greatest.value),
            greatest.run.to_string(),
        ]
    });
    output::csv(COLUMNS, rows)
}

fn covariance(findings: &Findings) -> Vec<u8> {
    let pairs = || (0..9).flat_map(|a| (a..9).map(move |b| (a, b)));
    let rows = findings.instants.iter().flat_map(|at| {
        pairs().map(move |(a, b)| {
            [
                exact(at.time_s),
                Nine::NAMES[a].to_owned(),
                Nine::NAMES[b].to_owned(),
                exact(at.spread.covariance[a][b]),
                told(at.covariance_theory[a][b]),
            ]
        })
    });
    output::csv(["time_s", "component", "with", "covariance", "covariance_theory"], rows)
}

fn accuracy(findings: &Findings) -> Vec<u8> {
    output::csv(ACCURACY, findings.instants.iter().map(|at| accuracy_of(at).map(told)))
}

/// A row of `accuracy.csv`; not numbers where nothing is known.
pub fn accuracy_of(at: &At) -> [f64; 15] {
    let it = &at.accuracy;
    let figure = |figure: &Figure| {
        let [low, high] = figure.runs.interval.unwrap_or([f64::NAN; 2]);
        [figure.runs.value, low, high, figure.theory]
    };
    let [[a, b, c, d], [e, f, g, h], [i, j, k, l]] =
        [&it.cep50, &it.cep95, &it.vertical95].map(figure);
    let [rate, rate_theory] = [it.cep50.runs.value, it.cep50.theory].map(|m| it.nmi_h(m));
    [it.time_s, a, b, c, d, e, f, g, h, i, j, k, l, rate, rate_theory]
}

fn consistency(findings: &Findings) -> Vec<u8> {
    let rows = findings.consistency().map(|c| {
        [
            exact(c.time_s),
            group_name(c).to_owned(),
            c.states.to_string(),
            exact(c.mean),
            exact(c.test.chi_square),
            exact(c.test.probability),
        ]
    });
    output::csv(["time_s", "states", "degrees", "nees", "chi_square", "probability"], rows)
}

fn budget(findings: &Findings) -> Vec<u8> {
    const COLUMNS: [&str; 7] =
        ["time_s", "term", "component", "mean_theory", "sigma_theory", "mean", "sigma"];
    let times = findings.instants.iter().map(|at| at.time_s).enumerate();
    let rows = times.flat_map(|(place, time_s)| {
        findings.budget.iter().flat_map(move |share| {
            let theory = share.theory.get(place);
            let runs = share.runs.get(place);
            Nine::NAMES.iter().enumerate().map(move |(i, name)| {
                let at = |numbers: Option<[f64; 9]>| numbers.map_or(String::new(), |x| told(x[i]));
                [
                    exact(time_s),
                    share.name.clone(),
                    (*name).to_owned(),
                    at(theory.map(|x| x.mean)),
                    at(theory.map(|x| x.sigma)),
                    at(runs.map(|x| x.mean)),
                    at(runs.map(|x| x.sigma)),
                ]
            })
        })
    });
    output::csv(COLUMNS, rows)
}
