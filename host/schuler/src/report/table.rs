//! The drift table: errors at a dozen times beside their theoretical values.

use super::verdict::verdict;
use super::{largest, norm};
use schuler_simulator::flight::{Flight, Instant, Nine, Used};
use schuler_simulator::number::{Quantity, Unit, rounded};

/// How many rows the table has.
const ROWS: usize = 12;
/// What stands where theory has ended.
const NOTHING: &str = "–";
/// Characters of theory's mean ± 1σ.
const THEORY_WIDTH: usize = 13;
/// Characters of a column that has errors alone.
const ALONE: usize = 11;

/// A column: one number of [`Nine`], in a unit that suits the whole run.
pub struct Column {
    /// What it is.
    pub name: &'static str,
    /// The unit of its numbers.
    pub unit: Unit,
    /// Whether it is a norm rather than a signed component.
    pub is_norm: bool,
    pick: fn(&Nine) -> f64,
}

impl Column {
    /// Characters of an error: a norm has no sign.
    fn width(&self) -> usize {
        if self.is_norm { 5 } else { 6 }
    }

    /// Error, mean and standard deviation. Of a norm they are the norms of each; the norm of
    /// the standard deviations is the root of the covariance's trace.
    pub fn cells(&self, instant: &Instant) -> [String; 3] {
        [(&instant.drift, 4), (&instant.mean, 3), (&instant.sigma, 3)].map(|(nine, digits)| {
            match (self.pick)(nine) * self.unit.factor {
                value if value.is_nan() => NOTHING.to_owned(),
                value => rounded(value, digits),
            }
        })
    }
}

/// The table's five columns.
pub fn columns(flight: &Flight) -> [Column; 5] {
    columns_of(&rows(flight))
}

/// The five columns of some rows.
pub fn columns_of(rows: &[&Instant]) -> [Column; 5] {
    let unit = |quantity: Quantity, part: fn(&Nine) -> [f64; 3]| {
        let rows = rows.iter();
        quantity.unit(largest(rows.flat_map(|i| [i.drift, i.mean, i.sigma]).flat_map(|n| part(&n))))
    };
    let position = unit(Quantity::Position, |nine| nine.position_m);
    let velocity = unit(Quantity::Velocity, |nine| nine.velocity_m_s);
    let attitude = unit(Quantity::Attitude, |nine| nine.attitude_arcsec);
    let component = |name, pick| Column { name, unit: position, is_norm: false, pick };
    [
        component("north", |nine| nine.position_m[0]),
        component("east", |nine| nine.position_m[1]),
        component("down", |nine| nine.position_m[2]),
        Column {
            name: "velocity",
            unit: velocity,
            is_norm: true,
            pick: |nine| norm(nine.velocity_m_s),
        },
        Column {
            name: "attitude",
            unit: attitude,
            is_norm: true,
            pick: |nine| norm(nine.attitude_arcsec),
        },
    ]
}

/// The instants of the table's rows: spread evenly, the last one included.
pub fn rows(flight: &Flight) -> Vec<&Instant> {
    rows_of(&flight.overview, &flight.last)
}

/// The same of some instants and the last one.
pub fn rows_of<'a>(overview: &'a [Instant], last: &'a Instant) -> Vec<&'a Instant> {
    let start_s = overview.first().map_or(0.0, |instant| instant.time_s);
    let mut rows: Vec<&Instant> = Vec::with_capacity(ROWS);
    for k in 1..ROWS {
        let time_s = start_s + (last.time_s - start_s) * k as f64 / ROWS as f64;
        let after = overview.partition_point(|instant| instant.time_s < time_s);
        let nearest = overview[after.saturating_sub(1)..]
            .iter()
            .take(2)
            .min_by(|a, b| (a.time_s - time_s).abs().total_cmp(&(b.time_s - time_s).abs()));
        rows.extend(nearest);
    }
    rows.retain(|instant| instant.time_s < last.time_s);
    rows.dedup_by_key(|instant| instant.time_s);
    rows.push(last);
    rows
}

/// Columns of a block with theory beside the errors, and without.
const BLOCKS: [usize; 2] = [3, 5];

/// The table for a terminal, 80 columns at most, with a verdict below it. Where theory expects nothing, the errors stand
/// alone.
pub fn table(flight: &Flight) -> String {
    let columns = columns(flight);
    let rows = rows(flight);
    let is_expected = rows.iter().any(|instant| expects(instant));
    let mut lines = Vec::new();
    for block in columns.chunks(BLOCKS[usize::from(!is_expected)]) {
        lines.extend(self::block(block, &rows, is_expected, flight.last.time_s >= 1000.0));
        lines.push(String::new());
    }
    lines.extend(super::ended(flight));
    lines.extend(verdict(flight));
    lines.extend(edges(flight));
    lines.extend(unit_note(&columns));
    lines.iter().map(|line| format!("{}\n", line.trim_end())).collect()
}

/// Whether theory says anything but zero of an instant.
fn expects(instant: &Instant) -> bool {
    let numbers = [instant.mean, instant.sigma].map(|nine| nine.numbers());
    numbers.iter().flatten().any(|number| *number != 0.0)
}

fn block(columns: &[Column], rows: &[&Instant], is_expected: bool, whole_s: bool) -> Vec<String> {
    let mut lines = vec![format!("{:>6} ", "time"), format!("{:>6} ", "s"), "─".repeat(7)];
    for column in columns {
        let (error, theory) = (column.width(), THEORY_WIDTH);
        let width = if is_expected { error + 1 + theory } else { ALONE };
        let bars = if column.is_norm { "|" } else { "" };
        let name = format!("{bars}{}{bars}", column.name);
        lines[0] += &match is_expected {
            true => format!("│ {:^width$} ", format!("{name} {}", column.unit.name)),
            false => format!("│ {name:^width$} "),
        };
        lines[1] += &match is_expected {
            true => format!("│ {:>error$} {:>theory$} ", "error", "mean ± 1σ  "),
            false => format!("│ {:^width$} ", column.unit.name),
        };
        lines[2] += &format!("┼{}", "─".repeat(width + 2));
    }
    for instant in rows {
        let decimals = if whole_s { 0 } else { 2 };
        let mut line = format!("{:>6.decimals$} ", instant.time_s);
        for column in columns {
            let [error, mean, sigma] = column.cells(instant);
            let theory = match sigma.as_str() {
                NOTHING => format!("{NOTHING:^THEORY_WIDTH$}"),
                _ => format!("{mean:>5} ± {sigma:<5}"),
            };
            line += &match is_expected {
                true => format!("│ {error:>w$} {theory} ", w = column.width()),
                false => format!("│ {error:>w$} ", w = ALONE),
            };
        }
        lines.push(line);
    }
    lines
}

/// How long the windows were that stand at an edge, if any did.
fn edges(flight: &Flight) -> Option<String> {
    let part = |name: &str, used: Option<Used>| {
        let Used { gyro, accelerometer } = used?;
        Some(format!("{name} block {gyro} and {accelerometer}"))
    };
    let edges = flight.edges?;
    let parts: Vec<_> =
        [part("first", edges.first), part("last", edges.last)].into_iter().flatten().collect();
    (!parts.is_empty()).then(|| {
        format!("Samples fitted at the edges, of gyros and accelerometers: {}.", parts.join("; "))
    })
}

/// What the attitude's unit means where it is not the usual one.
pub fn unit_note(columns: &[Column]) -> Option<String> {
    let unit = columns.iter().map(|column| column.unit).find(|unit| unit.name.ends_with("as"))?;
    Some(format!("{} is {:e} arcsec.", unit.name, 1.0 / unit.factor))
}

#[cfg(test)]
mod tests {
    use super::super::sample;
    use super::*;

    /// Characters of the table's lines; a terminal breaks the sentences below it.
    fn widest(text: &str) -> usize {
        let lines = text.lines().filter(|line| line.contains(['│', '┼']));
        lines.map(|line| line.chars().count()).max().unwrap()
    }

    #[test]
    fn shows_a_dozen_times_with_theory_beside() {
        let flight = sample::flight();
        let text = table(&flight);
        assert!(widest(&text) <= 80, "{}\n{text}", widest(&text));
        let times: Vec<f64> =
            rows(&flight).iter().map(|instant| (instant.time_s / 10.0).round() * 10.0).collect();
        assert_eq!(times, (1..=12).map(|k| 150.0 * f64::from(k)).collect::<Vec<_>>());
        let last = text.lines().find(|line| line.trim_start().starts_with("1800")).unwrap();
        let cells: Vec<&str> = last.split('│').map(str::trim).collect();
        let [down, mean, sigma] =
            [(&flight.last.drift, 4), (&flight.last.mean, 3), (&flight.last.sigma, 3)]
                .map(|(nine, digits)| rounded(nine.position_m[2], digits));
        let plain = |cell: &str| cell.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(plain(cells[3]), format!("{down} {mean} ± {sigma}"));
        let velocity = rounded(norm(flight.last.drift.velocity_m_s), 4);
        let below = text.lines().rfind(|line| line.trim_start().starts_with("1800")).unwrap();
        let cells: Vec<&str> = below.split('│').map(str::trim).collect();
        assert_eq!(plain(cells[1]).split(' ').next().unwrap(), velocity);
        let bars = |line: &str| -> Vec<usize> {
            line.chars().enumerate().filter(|(_, c)| "│┼".contains(*c)).map(|(i, _)| i).collect()
        };
        let lines: Vec<_> = text.lines().take(3 + ROWS).map(bars).collect();
        assert!(lines.iter().all(|columns| columns.len() == 3 && *columns == lines[0]), "{text}");
    }

    #[test]
    fn stays_aligned_from_nanometres_to_megametres() {
        for scale in [1e-13, 1e-9, 1e-3, 1.0, 1e3] {
            let text = table(&sample::scaled(scale));
            assert!(widest(&text) <= 80, "{scale}: {}\n{text}", widest(&text));
        }
        let text = table(&sample::perfect());
        assert!(!text.contains('±') && widest(&text) <= 80, "{text}");
        assert!(
            text.contains("│     nm      │") && text.ends_with("pas is 1e-12 arcsec.\n"),
            "{text}"
        );
    }

    #[test]
    fn a_single_instant_makes_a_single_row() {
        let mut flight = sample::flight();
        flight.overview = vec![flight.last];
        assert_eq!(rows(&flight).len(), 1);
        flight.overview.clear();
        assert_eq!(rows(&flight).len(), 1);
    }
}
