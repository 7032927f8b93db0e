//! All comparisons as `ensemble.csv`.

use super::statistics::Comparison;
use schuler_simulator::flight::Nine;

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
    let mut lines = csv::Writer::from_writer(Vec::new());
    let number = |x: f64| zmij::Buffer::new().format(x).to_owned();
    let told = |x: f64| if x.is_nan() { String::new() } else { number(x) };
    // Records of one length, to memory: neither can fail.
    let _ = lines.write_record(COLUMNS);
    for c in comparisons {
        let tests = match c.tests {
            Some(tests) => tests.map(|t| [number(t.chi_square), number(t.probability)]),
            None => Default::default(),
        };
        let [[mean_chi_square, mean_probability], [sigma_chi_square, sigma_probability]] = tests;
        let _ = lines.write_record([
            number(c.time_s),
            Nine::NAMES[c.component].to_owned(),
            number(c.mean),
            told(c.mean_theory),
            number(c.sigma),
            told(c.sigma_theory),
            mean_chi_square,
            mean_probability,
            sigma_chi_square,
            sigma_probability,
        ]);
    }
    lines.into_inner().unwrap_or_default()
}
