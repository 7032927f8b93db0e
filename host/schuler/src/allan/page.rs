//! `allan.html`: the deviation of each axis with its intervals, beside what is fitted and configured.

use super::Axis;
use super::table::{RATES, bounds};
use schuler_report::canvas::{Anchor, Canvas, Ink, Lettering, Stroke};
use schuler_report::decades::Decades;
use schuler_report::grid::{Frame, Grid, SMALL};
use schuler_report::page;
use schuler_report::svg::{Svg, escape};
use schuler_simulator::allan::TRIADS;
use schuler_simulator::number::parameter;

const WIDTH: f32 = 760.0;
const HEIGHT: f32 = 460.0;
const INNER: Frame = Frame { left: 70.0, top: 40.0, width: 670.0, height: 360.0 };
const INKS: [Ink; 3] = [Ink::North, Ink::East, Ink::Down];

/// The page; the text is that of the terminal.
pub fn page(title: &str, text: &str, axes: &[Option<Axis>; 6]) -> String {
    let charts: String = axes
        .chunks(3)
        .enumerate()
        .filter(|(_, three)| three.iter().any(Option::is_some))
        .map(|(triad, three)| format!("<figure>{}</figure>\n", chart(triad, three)))
        .collect();
    let title = escape(title);
    let body = format!(
        "<h1>{title}: Allan deviation</h1>\n<p class=\"quiet\">Dots with 95 % intervals are measured; lines are \
         fitted; dashes are configured. Blue x, orange y, green z.</p>\n{charts}<h2>In numbers</h2>\n\
         <div class=\"panel\"><pre>{}</pre></div>\n",
        escape(text)
    );
    page::page(&format!("{title}: Allan deviation"), &body)
}

fn chart(triad: usize, three: &[Option<Axis>]) -> String {
    let (unit, symbol) = RATES[triad];
    let axes = || three.iter().zip(INKS).filter_map(|(axis, ink)| Some((axis.as_ref()?, ink)));
    let times = || axes().flat_map(|(axis, _)| axis.points.iter().map(|point| point.tau_s));
    let levels = axes().flat_map(|(axis, _)| {
        let fit = axis.identified.fit.expected.iter().map(|variance| variance.sqrt() / unit);
        axis.points.iter().map(|point| point.deviation() / unit).chain(fit)
    });
    let (x_axis, y_axis) = (Decades::spanning(times()), Decades::spanning(levels));
    let bottom = INNER.top + INNER.height;
    let x = |tau_s: f64| INNER.left + INNER.width * x_axis.fraction(tau_s) as f32;
    let y = |level: f64| bottom - INNER.height * y_axis.fraction(level) as f32;
    let mut svg = Svg::default();
    let title = format!("{}: Allan deviation, {symbol}", TRIADS[triad]);
    let grid = Grid {
        title: &title,
        x_label: "averaging time τ, s",
        x: x_axis.ticks(12).into_iter().map(|t| (x(t), parameter(t))).collect(),
        y: y_axis.ticks(12).into_iter().map(|level| (y(level), parameter(level))).collect(),
    };
    grid.draw(&mut svg, INNER);
    for (axis, ink) in axes() {
        let fit = &axis.identified.fit;
        let line = |values: &mut dyn Iterator<Item = (f64, f64)>| -> Vec<[f32; 2]> {
            values.map(|(tau_s, variance)| [x(tau_s), y(variance.sqrt() / unit)]).collect()
        };
        let taus = || axis.points.iter().map(|point| point.tau_s);
        let fitted = line(&mut taus().zip(fit.expected.iter().copied()));
        svg.line("", &fitted, ink, Stroke::solid(1.2));
        if !axis.configured.is_empty() {
            let expected = line(&mut taus().map(|tau_s| (tau_s, axis.expected(tau_s))));
            svg.line("", &expected, ink, Stroke { width: 1.2, dashed: true });
        }
        for (point, freedom) in axis.points.iter().zip(&fit.freedom) {
            let level = point.deviation() / unit;
            let [lower, upper] = bounds(*freedom);
            let at = x(point.tau_s);
            svg.line(
                "",
                &[[at, y(level * lower)], [at, y(level * upper)]],
                ink,
                Stroke::solid(1.0),
            );
            svg.dot([at, y(level)], 3.0, ink);
        }
    }
    let letters = Lettering { size: SMALL, bold: false, anchor: Anchor::End };
    svg.text([INNER.left + INNER.width, INNER.top - 9.0], "x y z", Ink::Muted, letters);
    svg.finish(WIDTH, HEIGHT, "role=\"img\"")
}
