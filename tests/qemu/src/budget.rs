//! The table of what the core costs on each machine: held against its budget and against the one stored.

use std::collections::BTreeMap;

/// Something measured, with the most that it may be on the reference board.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measure {
    /// What it is.
    pub what: &'static str,
    /// Where the number comes from.
    pub source: Source,
    /// The most that it may be, where hardware computes in f32.
    pub budget: Option<f64>,
}

/// Where a number comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// A key that the image `budget` reports.
    Budget(&'static str),
    /// A key that the image `selftest` reports.
    Selftest(&'static str),
    /// A key that the image `aiding` reports.
    Aiding(&'static str),
    /// The functions of core and libm that a sample can run through in the image `single`.
    Step,
    /// The same in the image `single-planned`.
    PlannedStep,
    /// Code and constants of the image `single`.
    Image,
    /// `.data` and `.bss` of the image `single`.
    Statics,
}

const fn measure(what: &'static str, source: Source, budget: Option<f64>) -> Measure {
    Measure { what, source, budget }
}

/// Every measure, as the table shows them.
#[rustfmt::skip]
pub const MEASURES: &[Measure] = &[
    measure("f32 taylor H0B4A0, instructions per sample", Source::Budget("f32, per sample"), Some(1100.0)),
    measure("f32 worst block over mean, random samples", Source::Budget("f32, worst block over mean"), Some(1.05)),
    measure("f32 code of a step with all of core and libm, series order fixed at 3, bytes", Source::Step, Some(10240.0)),
    measure("the same, series order known at run time, bytes", Source::PlannedStep, None),
    measure("f32 code and constants of the first as a whole image with start-up and libraries, bytes", Source::Image, None),
    measure("f32 `.data` and `.bss` of that image, bytes", Source::Statics, Some(0.0)),
    measure("f32 state, bytes", Source::Budget("f32, state, bytes"), Some(512.0)),
    measure("f32 stack, bytes", Source::Budget("f32, stack, bytes"), Some(1024.0)),
    measure("f32x2 H0B4A0, instructions per sample", Source::Budget("f32x2, per sample"), Some(2500.0)),
    measure("f32x2 state, bytes", Source::Budget("f32x2, state, bytes"), None),
    measure("f32x2 stack, bytes", Source::Budget("f32x2, stack, bytes"), None),
    measure("f32 textbook, instructions per sample", Source::Budget("f32 textbook, per sample"), Some(650.0)),
    measure("f32 textbook, state, bytes", Source::Budget("f32 textbook, state, bytes"), None),
    measure("f32 textbook, stack, bytes", Source::Budget("f32 textbook, stack, bytes"), None),
    measure("f64 taylor H0B4A0, instructions per sample", Source::Budget("f64, per sample"), Some(55000.0)),
    measure("f64 state, bytes", Source::Budget("f64, state, bytes"), None),
    measure("f64 stack, bytes", Source::Budget("f64, stack, bytes"), None),
    measure("f32 error terms, instructions per sample", Source::Budget("f32 error terms, per sample"), Some(1000.0)),
    measure("f64 error terms, instructions per sample", Source::Budget("f64 error terms, per sample"), None),
    measure("f64 perfect samples, instructions per sample", Source::Budget("f64 perfect increments, per sample"), None),
    measure("f32 covariance step of 0.1 s, instructions", Source::Aiding("f32 covariance step, bias noise each second"), Some(16_000.0)),
    measure("the same of 1 s, with bias noise, instructions", Source::Aiding("f32 covariance step with bias noise"), None),
    measure("f32 scalar measurement with its gate, instructions", Source::Aiding("f32 scalar measurement with its gate"), None),
    measure("the same, covariance alone, instructions", Source::Aiding("f32 scalar measurement, covariance alone"), Some(2500.0)),
    measure("f32 filter of 15 states, bytes", Source::Aiding("f32 filter, bytes"), Some(1024.0)),
    measure("f32 aided flight at 100 Hz with a position each second, instructions per sample", Source::Aiding("f32 aided, per sample"), None),
    measure("f32 aided flight, state with 8 steps and 4 measurements, bytes", Source::Aiding("f32 aided state, bytes"), None),
    measure("f32 aided flight, stack, bytes", Source::Aiding("f32 aided, stack, bytes"), None),
    measure("self-test, samples", Source::Selftest("samples"), None),
    measure("self-test, f32 on perfect samples, largest drift, m", Source::Selftest("paper-perfect f32, largest, m"), Some(0.15)),
    measure("self-test, f32x2 on perfect samples, largest drift, m", Source::Selftest("paper-perfect f32x2, largest, m"), Some(5e-3)),
    measure("self-test, f32 from f64 with sensor errors, m", Source::Selftest("f32 from f64, largest, m"), Some(0.15)),
    measure("self-test, deepest stack of all, bytes", Source::Selftest("stack_bytes"), None),
];

/// The table's numbers: by machine, in the order of [`MEASURES`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    columns: BTreeMap<String, Column>,
}

/// A machine's numbers, with the compiler that they belong to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Column {
    /// Version of the compiler.
    pub compiler: String,
    /// One number per measure, as it is written.
    pub values: Vec<String>,
}

const HEAD: &str = "# What the core costs on a target

`tests/firmware.sh` measures this in QEMU and fails where a budget is exceeded or a number has moved by more
than 2 %; `tests/firmware.sh --store` writes it anew. The budgets are for the first two machines, which share
an image and compute in f32 by hardware.

A step's code is the function that takes a sample, with every other function of the core and of libm that is
linked beside it but start-up. The series of the paper's flight has the order 3; where that is known when the
image is built, higher orders are left out of it. The other rows compute with the order known at run time.

Instructions are those of QEMU's `-icount shift=0`; they are not cycles. On a board the feature `dwt` counts
cycles in their place (README.md).
";

/// As a number is written and compared; what is not measured on a machine is none.
pub fn written(value: f64) -> String {
    match value.abs() {
        _ if value.is_nan() => "–".to_owned(),
        0.0 => "0".to_owned(),
        1000.0.. => format!("{value:.0}"),
        1.0.. if value.fract() == 0.0 => format!("{value:.0}"),
        10.0.. => format!("{value:.1}"),
        0.1.. => format!("{value:.4}"),
        _ => format!("{value:.2e}"),
    }
}

impl Table {
    /// Adds a machine: its name, with that of its core.
    pub fn add(&mut self, machine: String, column: Column) {
        self.columns.insert(machine, column);
    }

    /// As Markdown, the machines in the order given.
    pub fn text(&self, machines: &[String]) -> String {
        let columns: Vec<_> =
            machines.iter().filter_map(|m| Some((m, self.columns.get(m)?))).collect();
        let row = |what: &str, budget: &str, cell: &dyn Fn(&Column) -> String| {
            let cells: Vec<_> = columns.iter().map(|(_, column)| cell(column)).collect();
            format!("| {what} | {budget} | {} |\n", cells.join(" | "))
        };
        let names: Vec<_> = columns.iter().map(|(name, _)| name.as_str()).collect();
        let mut text = format!("{HEAD}\n| what | budget | {} |\n", names.join(" | "));
        text += &format!("|---|--:|{}\n", "--:|".repeat(names.len()));
        text += &row("compiler", "", &|column| column.compiler.clone());
        for (n, measure) in MEASURES.iter().enumerate() {
            let budget = measure.budget.map(|b| format!("≤ {}", written(b))).unwrap_or_default();
            let cell = |column: &Column| column.values.get(n).cloned().unwrap_or_default();
            text += &row(measure.what, &budget, &cell);
        }
        text
    }

    /// Back from [`Table::text`].
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut rows = text.lines().filter_map(|line| {
            let cells = line.strip_prefix("| ")?.strip_suffix(" |")?.split(" | ");
            Some(cells.map(|cell| cell.trim().to_owned()).collect::<Vec<_>>())
        });
        let names = rows.next().ok_or("no table")?;
        let body: Vec<_> = rows.collect();
        let mut table = Self::default();
        for (n, name) in names.iter().enumerate().skip(2) {
            let cell = |what: &str| {
                let row = body.iter().find(|row| row.first().is_some_and(|cell| cell == what));
                let cell = row.and_then(|row| row.get(n)).cloned();
                cell.ok_or_else(|| format!("no `{what}` of {name}"))
            };
            let values = MEASURES.iter().map(|measure| cell(measure.what));
            let column =
                Column { compiler: cell("compiler")?, values: values.collect::<Result<_, _>>()? };
            table.add(name.clone(), column);
        }
        Ok(table)
    }

    /// What has moved from a stored table by more than 2 %, and what cannot be compared.
    pub fn moved(&self, stored: &Self) -> (Vec<String>, Vec<String>) {
        let (mut moved, mut skipped) = (Vec::new(), Vec::new());
        for (machine, column) in &self.columns {
            match stored.columns.get(machine) {
                None => moved.push(format!("{machine}: not stored")),
                Some(old) if old.compiler != column.compiler => skipped.push(format!(
                    "skipped: {machine} was measured with rustc {}, this is {}",
                    old.compiler, column.compiler
                )),
                Some(old) => {
                    for ((measure, new), old) in
                        MEASURES.iter().zip(&column.values).zip(&old.values)
                    {
                        if !is_close(new, old) {
                            moved.push(format!("{machine}: {}: {old} became {new}", measure.what));
                        }
                    }
                }
            }
        }
        (moved, skipped)
    }
}

/// Within 2 % of the old one.
fn is_close(new: &str, old: &str) -> bool {
    match (new.parse::<f64>(), old.parse::<f64>()) {
        (Ok(new), Ok(old)) => (new - old).abs() <= 0.02 * old.abs(),
        _ => new == old,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(compiler: &str, first: f64) -> Column {
        let value = |n: usize| written(first * (n + 1) as f64);
        Column { compiler: compiler.to_owned(), values: (0..MEASURES.len()).map(value).collect() }
    }

    fn table(compiler: &str, first: f64) -> Table {
        let mut table = Table::default();
        table.add("M4F".to_owned(), column(compiler, first));
        table
    }

    #[test]
    fn a_table_comes_back() {
        let mut both = table("1.95.0", 640.0);
        both.add("M0".to_owned(), column("1.96.0", 3.25e-4));
        let text = both.text(&["M4F".to_owned(), "M0".to_owned()]);
        assert!(text.contains("| 640 | 3.25e-4 |"), "{text}");
        assert_eq!(Table::parse(&text), Ok(both));
        assert!(Table::parse("nothing").is_err());
    }

    #[test]
    fn two_percent_may_be_between() {
        let stored = table("1.95.0", 1000.0);
        assert_eq!(table("1.95.0", 1019.0).moved(&stored), (vec![], vec![]));
        let (moved, _) = table("1.95.0", 979.0).moved(&stored);
        assert_eq!(moved.len(), MEASURES.len());
        let what = MEASURES[0].what;
        assert_eq!(moved[0], format!("M4F: {what}: 1000 became 979"));
        let (moved, skipped) = table("1.96.0", 1.0).moved(&stored);
        assert!(moved.is_empty());
        assert_eq!(skipped, ["skipped: M4F was measured with rustc 1.95.0, this is 1.96.0"]);
        assert_eq!(table("1.95.0", 1.0).moved(&Table::default()).0, ["M4F: not stored"]);
    }
}
