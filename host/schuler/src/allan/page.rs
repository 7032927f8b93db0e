//! `allan.html`: the deviation of each axis with its intervals, beside what is fitted and configured.

use super::Axis;
use super::table::{RATES, bounds};
use crate::report::{figures, head};
use schuler_report::canvas::Ink;
use schuler_report::interactive::{Interactive, Scale, Width};
use schuler_report::layer::{Kind, Layer};
use schuler_report::page;
use schuler_report::svg::escape;
use schuler_simulator::allan::TRIADS;
use schuler_simulator::allan::verdict::Verdict;

/// The colours of x, y, z.
pub const INKS: [Ink; 3] = [Ink::North, Ink::East, Ink::Down];
/// Their names.
pub const AXES: [&str; 3] = ["x", "y", "z"];

/// The page; the text is that of the terminal.
pub fn page(title: &str, text: &str, axes: &[Option<Axis>; 6]) -> String {
    let triads = axes.chunks(3).enumerate();
    let shown = triads.filter(|(_, three)| three.iter().any(Option::is_some));
    let charts = figures::grid(shown.map(|(triad, three)| chart(triad, three)));
    let verdicts: Vec<Verdict> = axes.iter().flatten().flat_map(Axis::verdicts).collect();
    let differ = verdicts.iter().filter(|verdict| **verdict == Verdict::Differs).count();
    let verdict = match (verdicts.len(), differ) {
        (0, _) => String::new(),
        (all, 0) => page::verdict(true, &format!("As configured: {all} verdicts, none differs")),
        (all, differ) => {
            page::verdict(false, &format!("Not as configured: {differ} of {all} verdicts differ"))
        }
    };
    let title = escape(title);
    let body = format!(
        "<h1>{title}: Allan deviation</h1>\n<p class=\"quiet\"><code>{}</code></p>\n{verdict}\
         <p class=\"quiet\">Dots with 95 % intervals are measured; lines are fitted; dashes are \
         configured.</p>\n{charts}<h2>In numbers</h2>\n{}",
        escape(&head::command_line()),
        page::framed(&format!("<pre>{}</pre>", escape(text)))
    );
    page::page(&format!("{title}: Allan deviation"), &body)
}

fn chart(triad: usize, three: &[Option<Axis>]) -> Interactive {
    let (unit, symbol) = RATES[triad];
    let title = format!("{}: Allan deviation, {symbol}", TRIADS[triad]);
    let (x, y) = (Scale::new("averaging time", "s"), Scale::new("deviation", symbol));
    let mut chart =
        Interactive::new(&title, x.log(), y.log()).sharing("averaging").sized(Width::Half, 420);
    for (place, axis) in three.iter().enumerate() {
        let Some(axis) = axis else { continue };
        let (ink, name) = (INKS[place], AXES[place]);
        let fit = &axis.identified.fit;
        let levels = |variance: &dyn Fn(usize) -> f64| -> Vec<[f64; 2]> {
            let points = axis.points.iter().enumerate();
            points.map(|(i, point)| [point.tau_s, variance(i).sqrt() / unit]).collect()
        };
        let measured = axis.points.iter().zip(&fit.freedom);
        let intervals = measured.map(|(point, freedom)| {
            let [lower, upper] = bounds(*freedom);
            let level = point.deviation() / unit;
            [point.tau_s, level * upper, level * lower]
        });
        let intervals = intervals.collect();
        let bars = Layer::new(&format!("{name}, interval"), ink, Kind::Bars, intervals);
        let fitted = levels(&|i| fit.expected[i]);
        chart = chart.with(Layer::line(&format!("{name}, fitted"), ink, fitted)).with(bars);
        if !axis.configured.is_empty() {
            let expected = levels(&|i| axis.expected(axis.points[i].tau_s));
            chart = chart.with(Layer::dashes(&format!("{name}, configured"), ink, expected));
        }
        let dots = levels(&|i| axis.points[i].variance);
        chart = chart.with(Layer::dots(&format!("{name}, measured"), ink, 3.0, dots));
    }
    chart
}
