//! All comparisons as `ensemble.csv`.

use super::statistics::Comparison;
use schuler_simulator::flight::Nine;
use schuler_simulator::number::exact;
use schuler_simulator::output;

/// The file's name.
pub const NAME: &str = "ensemble.csv";

/// The columns of `ensemble.csv`, in the unit that the component's name carries. The χ² of the mean has
/// one degree of freedom, that of the standard deviation one less than there are runs; `_probability`
/// is how often chance alone lies that far out. They are empty where theory sees nothing scatter, and so is what it expects where its model has ended.
pub const COLUMNS: [&str; 10] = [
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
];

/// All comparisons, one a line; numbers round-trip.
pub fn bytes(comparisons: &[Comparison]) -> Vec<u8> {
    let told = |x: f64| if x.is_nan() { String::new() } else { exact(x) };
    let rows = comparisons.iter().map(|c| {
        let tests = match c.tests {
            Some(tests) => tests.map(|t| [exact(t.chi_square), exact(t.probability)]),
            None => Default::default(),
        };
        let [[mean_chi_square, mean_probability], [sigma_chi_square, sigma_probability]] = tests;
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
        ]
    });
    output::csv(COLUMNS, rows)
}
