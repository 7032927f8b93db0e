//! `allan.svg`: the deviation of each axis with its intervals, beside what is fitted and configured, for documents.

use super::Axis;
use super::page::{AXES, INKS};
use super::table::RATES;
use schuler_report::axis::printed;
use schuler_report::canvas::{Anchor, Canvas, Ink, Lettering, Stroke};
use schuler_report::decades::Decades;
use schuler_report::grid::{Frame, Grid, SMALL};
use schuler_report::svg::Svg;
use schuler_simulator::allan::TRIADS;
use schuler_simulator::number::parameter;

const WIDTH: u32 = 1100;
const HEIGHT: u32 = 520;
/// Around a drawing.
const LEFT: f32 = 84.0;
const TOP: f32 = 104.0;
const RIGHT: f32 = 20.0;
const BOTTOM: f32 = 52.0;
const FITTED: Stroke = Stroke::solid(1.4);
const CONFIGURED: Stroke = Stroke { width: 1.2, dashed: true };

/// The picture, a panel for each triad that shows something.
pub fn svg(title: &str, axes: &[Option<Axis>; 6]) -> String {
    let mut sheet = Svg::default();
    let letters = |size, bold| Lettering { size, bold, anchor: Anchor::Start };
    let about = "dots with 95 % intervals are measured; lines are fitted; dashes are configured";
    sheet.text([26.0, 32.0], &format!("{title}: Allan deviation"), Ink::Text, letters(20.0, true));
    sheet.text([26.0, 52.0], about, Ink::Muted, letters(12.5, false));
    let shown = axes.chunks(3).enumerate();
    let shown: Vec<_> = shown.filter(|(_, three)| three.iter().any(Option::is_some)).collect();
    let width = WIDTH as f32 / shown.len().max(1) as f32;
    for (place, (triad, three)) in shown.into_iter().enumerate() {
        let inner = Frame {
            left: place as f32 * width + LEFT,
            top: TOP,
            width: width - LEFT - RIGHT,
            height: HEIGHT as f32 - TOP - BOTTOM,
        };
        panel(&mut sheet, triad, three, inner);
    }
    sheet.document(WIDTH, HEIGHT)
}

fn panel(canvas: &mut impl Canvas, triad: usize, three: &[Option<Axis>], inner: Frame) {
    let (unit, symbol) = RATES[triad];
    let points = || three.iter().flatten().flat_map(|axis| &axis.points);
    let x_axis = Decades::spanning(points().map(|point| point.tau_s));
    let y_axis = Decades::spanning(three.iter().flatten().flat_map(|axis| {
        let measured = axis.points.iter().enumerate();
        measured.flat_map(|(i, point)| axis.beside(i, point)).map(|level| level / unit)
    }));
    let bottom = inner.top + inner.height;
    let at = |tau_s: f64, level: f64| {
        [
            inner.left + inner.width * x_axis.fraction(tau_s) as f32,
            bottom - inner.height * y_axis.fraction(level / unit) as f32,
        ]
    };
    let title = format!("{}: Allan deviation, {symbol}", TRIADS[triad]);
    let (across, up) = (x_axis.ticks(8).into_iter(), y_axis.ticks(8).into_iter());
    let grid = Grid {
        title: &title,
        x_label: "averaging time, s",
        x: across.map(|tau_s| (at(tau_s, unit)[0], parameter(tau_s))).collect(),
        y: up.map(|level| (at(1.0, level * unit)[1], printed(&format!("{level:e}")))).collect(),
    };
    grid.draw(canvas, inner);
    for (place, axis) in three.iter().enumerate() {
        let Some(axis) = axis else { continue };
        let (ink, name) = (INKS[place], AXES[place]);
        let levels =
            axis.points.iter().enumerate().map(|(i, point)| (point, axis.beside(i, point)));
        let line = |which: usize| -> Vec<_> {
            levels.clone().map(|(point, beside)| at(point.tau_s, beside[which])).collect()
        };
        if !axis.configured.is_empty() {
            canvas.line(&format!("{name}, configured"), &line(4), ink, CONFIGURED);
        }
        canvas.line(&format!("{name}, fitted"), &line(3), ink, FITTED);
        for (point, [deviation, low, high, ..]) in levels.clone() {
            let ends = [at(point.tau_s, low), at(point.tau_s, high)];
            canvas.line("", &ends, ink, Stroke::solid(1.0));
            canvas.dot(at(point.tau_s, deviation), 3.0, ink);
        }
        let swatch = [inner.left + inner.width - 120.0 + 40.0 * place as f32, inner.top - 9.0];
        canvas.dot([swatch[0], swatch[1] - 4.0], 3.5, ink);
        let lettering = Lettering { size: SMALL, bold: false, anchor: Anchor::Start };
        canvas.text([swatch[0] + 8.0, swatch[1]], name, Ink::Text, lettering);
    }
}
