//! Charts as parts of an HTML page.

use super::{drift_charts, motion_charts};
use schuler_report::chart::Chart;
use schuler_report::grid::Frame;
use schuler_report::scatter;
use schuler_report::svg::{Svg, escape};
use schuler_simulator::flight::Instant;

/// Width and height of a chart in a column of three.
const CHART: (f32, f32) = (400.0, 250.0);
/// The same of the ground track, and of the height beside it, which takes two columns.
const MAP: (f32, f32) = (400.0, 320.0);
const WIDE: (f32, f32) = (812.0, 320.0);

/// Errors in three rows of three, with their legend.
pub fn errors(instants: &[Instant]) -> String {
    let charts = drift_charts::known(drift_charts::errors(instants));
    let has_bands = charts.iter().flatten().any(|chart| !chart.bands.is_empty());
    let has_mean = charts.iter().flatten().any(drift_charts::has_mean);
    let figures: String =
        charts.into_iter().flatten().map(|chart| figure(chart, CHART, "")).collect();
    let figures = format!("<div class=\"charts\">\n{figures}</div>\n");
    if !has_mean {
        return figures;
    }
    let mut legend = Svg::default();
    drift_charts::legend(&mut legend, [2.0, 11.0], has_bands);
    let legend = legend.finish(420.0, 22.0, "role=\"img\" aria-label=\"legend\"");
    format!("<div class=\"legend\">{legend}</div>\n{figures}")
}

/// Ground track and height, and the attitude below them.
pub fn motion(instants: &[Instant]) -> String {
    let track = figure(motion_charts::ground_track(instants), MAP, "");
    let height = figure(motion_charts::height(instants), WIDE, " class=\"wide\"");
    let is_known = instants.iter().any(|instant| instant.attitude_deg[0].is_finite());
    let attitude = motion_charts::attitude(instants).map(|chart| figure(chart, CHART, ""));
    let attitude = if is_known { attitude.concat() } else { String::new() };
    format!("<div class=\"charts\">\n{track}{height}{attitude}</div>\n")
}

/// A chart of a size, in an element of a class.
pub fn figure(chart: Chart, size: (f32, f32), class: &str) -> String {
    figure_with(chart, &[], size, class)
}

/// The same with dots under its curves.
pub fn figure_with(
    chart: Chart,
    dots: &[[f64; 2]],
    (width, height): (f32, f32),
    class: &str,
) -> String {
    let frame = Frame { left: 0.0, top: 0.0, width, height };
    let chart = chart.fitted(frame);
    let inner = chart.inner(frame);
    let mut svg = Svg::default();
    match dots {
        [] => chart.draw(&mut svg, frame),
        dots => scatter::draw(&chart, dots, &mut svg, frame),
    }
    let attributes = format!(
        "role=\"img\" aria-label=\"{}\" data-box=\"{} {} {} {}\" data-range=\"{} {} {} {}\" data-x=\"{}\"{}",
        escape(&chart.title),
        inner.left,
        inner.top,
        inner.width,
        inner.height,
        chart.x.from,
        chart.x.to,
        chart.y.from,
        chart.y.to,
        escape(&chart.x.label),
        if chart.is_map { " data-map" } else { "" }
    );
    format!("<figure{class}>{}</figure>\n", svg.finish(width, height, &attributes))
}
