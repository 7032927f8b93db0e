//! `aided.csv`, `smoothed.csv`, `accuracy.csv`, `budget.csv` and `runs.csv` of aided runs. Numbers round-trip; what is not known is empty.

use super::super::accuracy::Accuracy;
use super::super::csv::ACCURACY;
use super::findings::Findings;
use schuler_simulator::aided::runs::{GROUPS, Together};
use schuler_simulator::flight::Nine;
use schuler_simulator::number::exact;
use schuler_simulator::output;
use schuler_simulator::units::ARCSECOND;

/// The file of errors and claims, of circular and vertical errors, of error terms.
pub const NAMES: [&str; 3] = ["aided.csv", "accuracy.csv", "budget.csv"];

/// The same as `aided.csv` of smoothed runs.
pub const SMOOTHED: &str = "smoothed.csv";

/// All tables, in the order of [`NAMES`].
pub fn tables(findings: &Findings) -> [Vec<u8>; 3] {
    [errors(&findings.instants), accuracy(findings), budget(findings)]
}

fn told(x: f64) -> String {
    if x.is_nan() { String::new() } else { exact(x) }
}

/// Every instant: rms and σ of the nine, NEES.
pub fn errors(instants: &[Together]) -> Vec<u8> {
    let mut text = "time_s".to_owned();
    for kind in ["rms", "sigma"] {
        for name in Nine::NAMES {
            text += &format!(",{name}_{kind}");
        }
    }
    for group in GROUPS {
        text += &format!(",nees_{group},nees_{group}_least,nees_{group}_most");
    }
    text.push('\n');
    for one in instants {
        text += &one.time_s.to_string();
        for nine in [&one.rms, &one.sigma] {
            for x in of_files(nine) {
                text += &format!(",{x}");
            }
        }
        for (nees, [least, most]) in one.nees.iter().zip(one.expected) {
            text += &format!(",{},{least},{most}", told(*nees));
        }
        text.push('\n');
    }
    text.into_bytes()
}

/// Nine numbers in the units of files: m, m/s, arcsec.
pub fn of_files(nine: &[f64; 9]) -> [f64; 9] {
    std::array::from_fn(|i| if i < 6 { nine[i] } else { nine[i] * (1.0 / ARCSECOND) })
}

/// As of an ensemble that is compared with theory, which is not known.
fn accuracy(findings: &Findings) -> Vec<u8> {
    let row = |it: &Accuracy| {
        let figures = [it.cep50, it.cep95, it.vertical95].map(|figure| {
            let [low, high] = figure.runs.interval.unwrap_or([f64::NAN; 2]);
            [figure.runs.value, low, high, f64::NAN]
        });
        let rate = it.nmi_h(it.cep50.runs.value);
        let [a, b, c, d, e, f, g, h, i, j, k, l] = {
            let [[a, b, c, d], [e, f, g, h], [i, j, k, l]] = figures;
            [a, b, c, d, e, f, g, h, i, j, k, l]
        };
        [it.time_s, a, b, c, d, e, f, g, h, i, j, k, l, rate, f64::NAN].map(told)
    };
    output::csv(ACCURACY, findings.accuracy.iter().map(row))
}

fn budget(findings: &Findings) -> Vec<u8> {
    let times = findings.instants.iter().map(|at| at.time_s).enumerate();
    let rows = times.flat_map(|(place, time_s)| {
        findings
            .budget
            .iter()
            .filter_map(move |share| Some((share, share.runs.get(place)?)))
            .flat_map(move |(share, it)| {
                Nine::NAMES.iter().enumerate().map(move |(i, name)| {
                    let numbers = [it.mean[i], it.sigma[i]].map(told);
                    let [mean, sigma] = numbers;
                    [exact(time_s), share.name.clone(), (*name).to_owned(), mean, sigma]
                })
            })
    });
    output::csv(["time_s", "term", "component", "mean", "sigma"], rows)
}

/// A row for each instant of each run that reached its end.
pub fn every_run(findings: &Findings) -> String {
    let mut text = [["run", "time_s"].as_slice(), &Nine::NAMES].concat().join(",") + "\n";
    let runs = findings.values.first().map_or([].as_slice(), |values| values.runs.as_slice());
    for (place, run) in runs.iter().enumerate() {
        for (at, values) in findings.instants.iter().zip(&findings.values) {
            text += &format!("{run},{}", exact(at.time_s));
            for number in values.numbers[place] {
                text.push(',');
                text += &exact(number);
            }
            text.push('\n');
        }
    }
    text
}
