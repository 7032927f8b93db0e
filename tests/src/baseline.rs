//! Stored instruction counts, and how far a measurement may be from them.

use std::collections::BTreeMap;
use std::fmt::Write;
use toml::de::{DeTable, DeValue};

/// Part of the stored count that a measurement may be off by, either way.
pub const BAND: f64 = 0.02;
/// The same where another compiler made the code.
pub const WIDE_BAND: f64 = 0.10;

/// The table of the counts in the file.
const TABLE: &str = "instructions_per_sample";

/// Instructions per sample by name, with their provenance.
#[derive(Clone, Debug, PartialEq)]
pub struct Baseline {
    /// The compiler: `rustc --version`.
    pub rustc: String,
    /// What it compiled for.
    pub target: String,
    /// Instructions per sample.
    pub instructions_per_sample: BTreeMap<String, f64>,
}

impl Baseline {
    /// From the text that [`Baseline::text`] makes.
    pub fn parse(text: &str) -> Result<Self, String> {
        let root = DeTable::parse(text).map_err(|error| error.to_string())?;
        let root = root.get_ref();
        let word = |key: &str| match root.get(key).map(|value| value.get_ref()) {
            Some(DeValue::String(text)) => Ok(text.to_string()),
            _ => Err(format!("no {key}")),
        };
        let counts = match root.get(TABLE).map(|value| value.get_ref()) {
            Some(DeValue::Table(counts)) => counts,
            _ => return Err(format!("no [{TABLE}]")),
        };
        let count = |value: &DeValue| match value {
            DeValue::Float(count) => count.as_str().parse().ok(),
            _ => None,
        };
        let instructions_per_sample = counts
            .iter()
            .map(|(name, value)| {
                let count = count(value.get_ref()).ok_or(format!("{name:?} is not a number"))?;
                Ok((name.get_ref().to_string(), count))
            })
            .collect::<Result<_, String>>()?;
        Ok(Self { rustc: word("rustc")?, target: word("target")?, instructions_per_sample })
    }

    /// The counts from Gungraun's summaries, a JSON object a line, each over so many samples.
    pub fn measured(
        summaries: &str,
        samples: u64,
        rustc: &str,
        target: &str,
    ) -> Result<Self, String> {
        let mut counts = BTreeMap::new();
        for line in summaries.lines().filter(|line| line.starts_with('{')) {
            let summary: serde_json::Value =
                serde_json::from_str(line).map_err(|error| error.to_string())?;
            let name = summary["function_name"].as_str().ok_or("a summary without a name")?;
            let count = instructions(&summary).ok_or_else(|| format!("{name}: no count"))?;
            counts.insert(name.to_owned(), count as f64 / samples as f64);
        }
        let (rustc, target) = (rustc.to_owned(), target.to_owned());
        Ok(Self { rustc, target, instructions_per_sample: counts })
    }

    /// The file, with a head that says what it is.
    pub fn text(&self, head: &str) -> String {
        let mut text = String::new();
        for line in head.lines() {
            let _ = writeln!(text, "# {line}");
        }
        let _ = writeln!(text, "rustc = {:?}\ntarget = {:?}\n", self.rustc, self.target);
        let _ = writeln!(text, "[{TABLE}]");
        for (name, count) in &self.instructions_per_sample {
            let _ = writeln!(text, "{name} = {count:.1}");
        }
        text
    }

    /// How a measurement compares: the band that counts, and what is not within it, a line each.
    pub fn compare(&self, measured: &Self) -> (f64, Vec<String>) {
        let band = if self.rustc == measured.rustc { BAND } else { WIDE_BAND };
        let (old, new) = (&self.instructions_per_sample, &measured.instructions_per_sample);
        let mut faults = Vec::new();
        for (name, stored) in old {
            match new.get(name) {
                None => faults.push(format!("{name}: stored {stored:.1}, not measured")),
                Some(count) if (count / stored - 1.0).abs() <= band => {}
                Some(count) => {
                    let percent = 100.0 * (count / stored - 1.0);
                    faults.push(format!(
                        "{name}: stored {stored:.1}, measured {count:.1} ({percent:+.1} %)"
                    ));
                }
            }
        }
        for (name, count) in new.iter().filter(|(name, _)| !old.contains_key(*name)) {
            faults.push(format!("{name}: not stored, measured {count:.1}"));
        }
        (band, faults)
    }
}

/// The instructions of a benchmark's summary.
fn instructions(summary: &serde_json::Value) -> Option<u64> {
    let profiles = summary["profiles"].as_array()?;
    let callgrind = profiles.iter().find(|profile| profile["tool"] == "Callgrind")?;
    callgrind["data"]["total"]["metrics"]["Ir"]["values"]["new"].as_u64()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn baseline(rustc: &str, counts: &[(&str, f64)]) -> Baseline {
        let counts = counts.iter().map(|&(name, count)| (name.to_owned(), count));
        let (rustc, target) = (rustc.to_owned(), "x86_64".to_owned());
        Baseline { rustc, target, instructions_per_sample: counts.collect() }
    }

    #[test]
    fn what_is_off_by_more_than_the_band_is_named() {
        let stored = baseline("rustc 1", &[("a", 100.0), ("b", 200.0), ("gone", 5.0)]);
        let same = baseline("rustc 1", &[("a", 101.9), ("b", 196.1), ("gone", 5.0)]);
        assert_eq!(stored.compare(&same), (BAND, vec![]));
        let off = baseline("rustc 1", &[("a", 102.1), ("b", 195.9), ("new", 7.0)]);
        let faults = [
            "a: stored 100.0, measured 102.1 (+2.1 %)",
            "b: stored 200.0, measured 195.9 (-2.0 %)",
            "gone: stored 5.0, not measured",
            "new: not stored, measured 7.0",
        ];
        assert_eq!(stored.compare(&off), (BAND, faults.map(str::to_owned).into()));
        let other = baseline("rustc 2", &[("a", 109.0), ("b", 181.0), ("gone", 5.6)]);
        let (band, faults) = stored.compare(&other);
        assert_eq!(band, WIDE_BAND);
        assert_eq!(faults, ["gone: stored 5.0, measured 5.6 (+12.0 %)"]);
        let nothing = baseline("rustc 1", &[("a", f64::NAN), ("b", 200.0), ("gone", 5.0)]);
        assert_eq!(stored.compare(&nothing).1.len(), 1);
    }

    #[test]
    fn the_file_reads_back() {
        let stored = baseline("rustc 1.2 (3 4)", &[("a", 100.5), ("b", 2.0)]);
        let text = stored.text("Two lines\nof head.");
        assert!(
            text.starts_with("# Two lines\n# of head.\nrustc = \"rustc 1.2 (3 4)\"\n"),
            "{text}"
        );
        assert_eq!(Baseline::parse(&text), Ok(stored));
        assert!(Baseline::parse("rustc = 1").is_err());
    }

    #[test]
    fn counts_come_from_callgrind() {
        let summary = r#"a line that is no summary
{"function_name":"a","profiles":[{"tool":"Callgrind","data":{"total":{"metrics":{"Ir":{"values":{"new":960}}}}}}]}"#;
        let measured = Baseline::measured(summary, 96, "r", "t").expect("a summary");
        assert_eq!(measured.instructions_per_sample["a"], 10.0);
        let without = r#"{"function_name":"a","profiles":[]}"#;
        let error = Baseline::measured(without, 96, "r", "t").expect_err("no profile");
        assert_eq!(error, "a: no count");
    }
}
