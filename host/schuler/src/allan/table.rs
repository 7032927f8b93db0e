//! What was found, in the terminal: 80 columns.

use super::{Axis, whole_verdict};
use schuler_simulator::allan::TRIADS;
use schuler_simulator::allan::fit::Found;
use schuler_simulator::allan::record::Record;
use schuler_simulator::allan::section::{Name, name};
use schuler_simulator::allan::shape::Shape;
use schuler_simulator::allan::verdict::Verdict;
use schuler_simulator::number::parameter;
use schuler_simulator::units::{DEGREE_PER_HOUR, MICRO_G};
use statrs::distribution::{ChiSquared, ContinuousCDF};
use std::fmt::Write as _;

/// The unit of a triad's rates, in SI and for people.
pub const RATES: [(f64, &str); 2] = [(DEGREE_PER_HOUR, "°/h"), (MICRO_G, "µg")];
const LETTERS: [&str; 3] = ["x", "y", "z"];

/// The 95 % interval of a deviation of so many degrees of freedom, over the deviation.
pub fn bounds(freedom: f64) -> [f64; 2] {
    let Ok(chi) = ChiSquared::new(freedom) else { return [0.0, f64::INFINITY] };
    [0.975, 0.025].map(|part| (freedom / chi.inverse_cdf(part)).sqrt())
}

/// About four digits.
pub fn four(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        large if large >= 99_999.5 => format!("{value:.2e}"),
        large if large >= 999.95 => format!("{value:.0}"),
        large if large >= 99.995 => format!("{value:.1}"),
        large if large >= 9.9995 => format!("{value:.2}"),
        large if large >= 0.1 => format!("{value:.4}"),
        large if large >= 0.001 => format!("{value:.5}"),
        _ => format!("{value:.2e}"),
    }
}

/// The letter of a term.
pub fn letter(shape: Shape) -> &'static str {
    match shape {
        Shape::Quantization => "Q",
        Shape::White => "N",
        Shape::Flicker(_) => "B",
        Shape::RandomWalk => "K",
        Shape::Ramp => "R",
        Shape::GaussMarkov(_) => "GM",
    }
}

/// All of it.
pub fn text(title: &str, record: &Record, axes: &[Option<Axis>; 6]) -> String {
    let (interval_s, samples) = (record.timing.interval_s(), record.timing.samples());
    let length = parameter(interval_s * samples as f64);
    let mut text =
        format!("{title}: {samples} samples at {} Hz, {length} s\n", parameter(1.0 / interval_s));
    for line in &record.said {
        text += &format!("{line}\n");
    }
    for (triad, three) in axes.chunks(3).enumerate() {
        if let Some(first) = three.iter().flatten().next() {
            deviations(&mut text, triad, three, first);
            configured(&mut text, triad, three);
            identified(&mut text, triad, three);
        }
    }
    text
}

/// A String takes all that is written.
macro_rules! put {
    ($text:expr, $($arguments:tt)+) => {
        let _ = writeln!($text, $($arguments)+);
    };
}

fn deviations(text: &mut String, triad: usize, three: &[Option<Axis>], first: &Axis) {
    let (unit, symbol) = RATES[triad];
    put!(text, "\n{}: Allan deviation, {symbol}", TRIADS[triad]);
    let mut head = format!("{:>9}", "τ, s");
    for (axis, letter) in three.iter().zip(LETTERS) {
        head += &format!(" {:>9}", if axis.is_some() { letter } else { "—" });
    }
    head += &format!(" {:>12}", "95 %");
    let terms: Vec<_> = first.configured.iter().take(2).collect();
    if !first.configured.is_empty() {
        head += &format!(" {:>9}", "expected");
        terms.iter().for_each(|(shape, _)| head += &format!(" {:>8}", letter(*shape)));
    }
    put!(text, "{head}");
    for (i, point) in first.points.iter().enumerate() {
        let mut line = format!("{:>9}", parameter(point.tau_s));
        for axis in three {
            let point = axis.as_ref().and_then(|axis| axis.points.get(i));
            let cell = point.map_or("—".to_owned(), |point| four(point.deviation() / unit));
            line += &format!(" {cell:>9}");
        }
        let known = three.iter().flatten().filter_map(|axis| axis.identified.fit.freedom.get(i));
        let [lower, upper] = bounds(known.copied().fold(f64::INFINITY, f64::min));
        let off = |bound: f64| {
            let percent = 100.0 * (bound - 1.0);
            if percent.abs() < 9.95 { format!("{percent:+.1}") } else { format!("{percent:+.0}") }
        };
        line += &format!(" {:>12}", format!("{} {} %", off(lower), off(upper)));
        if !first.configured.is_empty() {
            line += &format!(" {:>9}", four(first.expected(point.tau_s).sqrt() / unit));
            for (shape, square) in &terms {
                let own = (square * shape.variance(point.tau_s)).sqrt() / unit;
                line += &format!(" {:>8}", four(own));
            }
        }
        put!(text, "{line}");
    }
    if first.configured.len() > 2 {
        closed_forms(text, first, unit);
    }
}

/// The closed form of each configured term, where they do not fit beside the measurement.
fn closed_forms(text: &mut String, axis: &Axis, unit: f64) {
    let heads = axis.configured.iter().map(|(shape, _)| format!(" {:>9}", letter(*shape)));
    put!(text, "{:>9}{} {:>9}", "closed", heads.collect::<String>(), "sum");
    for point in &axis.points {
        let own =
            axis.configured.iter().map(|(shape, square)| square * shape.variance(point.tau_s));
        let cells = own.map(|square| format!(" {:>9}", four(square.sqrt() / unit)));
        let sum = four(axis.expected(point.tau_s).sqrt() / unit);
        put!(text, "{:>9}{} {sum:>9}", parameter(point.tau_s), cells.collect::<String>());
    }
}

/// A magnitude with its interval, in a key's unit.
fn told(found: &Found, name: &Name) -> [String; 2] {
    let shown = |magnitude: f64| four(magnitude * name.factor / name.unit);
    let [from, to] = found.interval().map(shown);
    [shown(found.magnitude()), format!("[{from}, {to}]")]
}

/// A term's name on its own triad: what is "angle, velocity random walk" is one of the two there.
fn own(name: &str, triad: usize) -> String {
    match name.split_once(", ").zip(name.strip_suffix(" random walk")) {
        Some(((gyro, _), both)) => {
            let accelerometer = both.rsplit(", ").next().unwrap_or(both);
            format!("{} random walk", if triad == 0 { gyro } else { accelerometer })
        }
        None => name.to_owned(),
    }
}

/// A verdict in a narrow column.
fn brief(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::NotIdentifiable => "not seen",
        told => told.words(),
    }
}

fn configured(text: &mut String, triad: usize, three: &[Option<Axis>]) {
    if three.iter().flatten().all(|axis| axis.compared.is_empty()) {
        return;
    }
    put!(text, "\n{}: configured terms", TRIADS[triad]);
    put!(text, "{:33} {:>8} {:>8} {:18} verdict", "", "set", "found", "95 %");
    for (axis, letter) in three.iter().zip(LETTERS).filter_map(|(a, l)| Some((a.as_ref()?, l))) {
        for compared in &axis.compared {
            let name = name(compared.shape, triad);
            let [found, interval] = told(&compared.found, &name);
            let configured = four(compared.configured * name.factor / name.unit);
            let what = format!("{letter} {}, {}", own(name.name, triad), name.symbol);
            let verdict = brief(compared.verdict);
            put!(text, "{what:33} {configured:>8} {found:>8} {interval:18} {verdict}");
        }
        if let Some(time) = axis.time {
            let what = format!("{letter} correlation time, s");
            let [from, to] = time.interval_s.map(four);
            let interval = format!("[{from}, {to}]");
            put!(
                text,
                "{what:33} {:>8} {:>8} {interval:18} {}",
                four(time.configured_s),
                four(time.found_s),
                brief(time.verdict)
            );
        }
        if let Some(whole) = &axis.whole {
            let what = format!("{letter} all of them");
            let chi = format!("χ² {} of {}", four(whole.chi_square), whole.left);
            put!(text, "{what:33} {:17} {chi:18} {}", "", brief(whole_verdict(whole)));
        }
    }
    let verdicts = three.iter().flatten().flat_map(Axis::verdicts);
    if verdicts.into_iter().any(|verdict| verdict == Verdict::NotIdentifiable) {
        put!(text, "not seen: not identifiable in this span");
    }
}

fn identified(text: &mut String, triad: usize, three: &[Option<Axis>]) {
    put!(text, "\n{}: terms that fit", TRIADS[triad]);
    for (axis, letter) in three.iter().zip(LETTERS).filter_map(|(a, l)| Some((a.as_ref()?, l))) {
        let Axis { identified, .. } = axis;
        for found in &identified.fit.terms {
            let name = name(found.shape, triad);
            let [value, interval] = told(found, &name);
            let time = match found.shape {
                Shape::GaussMarkov(correlation_s) => format!(" T {} s", four(correlation_s)),
                _ => String::new(),
            };
            let what = format!("{letter} {}, {}{time}", own(name.name, triad), name.symbol);
            put!(text, "{what:38} {value:>9}  {interval}");
        }
        for found in &identified.hidden {
            let name = name(found.shape, triad);
            let most = four(found.interval()[1] * name.factor / name.unit);
            let what = format!("{letter} {}, {}", own(name.name, triad), name.symbol);
            put!(text, "{what:38} {:>9}  not identifiable in this span", format!("< {most}"));
        }
        let fit = &identified.fit;
        let (chi, left) = (four(fit.chi_square), fit.left);
        let doubt =
            if fit.probability() < super::UNLIKELY { ": no such terms make it" } else { "" };
        let what = format!("{letter} what they leave");
        put!(text, "{what:38} χ² {chi} of {left}{doubt}");
    }
}
