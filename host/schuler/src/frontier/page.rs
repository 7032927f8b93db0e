//! `frontier.html`: time against error, to be searched, and the cheapest way within an error of one's own.

use super::Point;
use super::case::{Case, Method};
use super::table::{by_scene, front_of};
use crate::report::{figures, head};
use schuler_report::canvas::Ink;
use schuler_report::interactive::{Interactive, Scale, Width};
use schuler_report::layer::{Kind, Layer};
use schuler_report::page::{framed, page_with};
use schuler_report::svg::escape;
use schuler_simulator::number::parameter;

/// The file's name.
pub const NAME: &str = "frontier.html";

const SCRIPT: &str = include_str!("page.js");

/// The page; the text is that of the terminal.
pub fn page(points: &[Point], text: &str) -> String {
    let charts = by_scene(points).into_iter().map(|scene| chart(&scene));
    let body = format!(
        "<h1>Run time against error</h1>\n<p class=\"quiet\"><code>{}</code></p>\n\
         <p class=\"quiet\">Time is that of navigation per second of flight; errors are the largest over every row, with \
         perfect sensors. Discs are in double precision, rings in single; along the front nothing is both cheaper and more \
         accurate. Micromath’s functions are never named as the cheapest: their attitude is wrong by tenths of a degree.</p>\n\
         <div class=\"filters\" id=\"filters\">\
         <label>my error budget <input type=\"range\" id=\"budget\" min=\"-12\" max=\"6\" step=\"0.1\" value=\"0\"> \
         <output id=\"within\">1 m</output></label>\
         <label>only with these words <input type=\"search\" id=\"words\" placeholder=\"taylor earth-fixed 20 Hz\"></label>\
         </div>\n<div id=\"cheapest\" aria-live=\"polite\"></div>\n{}\
         <h2>What to pick</h2>\n{}",
        escape(&head::command_line()),
        figures::grid(charts),
        framed(&format!("<pre>{}</pre>", escape(text)))
    );
    page_with("Run time against error", &body, SCRIPT)
}

/// A kind of points: its name, its colour, and whether a case is one.
type Family = (&'static str, Ink, fn(&Case) -> bool);

const FAMILIES: [Family; 3] = [
    ("taylor", Ink::North, |case| matches!(case.method, Method::Taylor(_))),
    ("textbook", Ink::East, |case| case.method == Method::Textbook),
    ("rk4 on rates", Ink::Down, |case| case.method == Method::RungeKutta),
];

fn chart(scene: &[&Point]) -> Interactive {
    let title = scene.first().map_or(String::new(), |first| {
        format!("{}, {} s: largest position error, m", first.scene, parameter(first.duration_s))
    });
    let x = Scale::new("time per second of flight", "µs").log();
    let mut chart = Interactive::new(&title, x, Scale::new("position error", "m").log());
    chart = chart.sized(Width::Whole, 460);
    (chart.is_nearest, chart.cursor) = (true, None);
    let at = |point: &Point| [point.cost_us_per_s(), point.max_position_m];
    // What a given time buys: the error stays until the next point is affordable.
    let mut stairs: Vec<[f64; 2]> = Vec::new();
    for point in front_of(scene) {
        let [cost, error] = at(point);
        if let Some(&[_, before]) = stairs.last() {
            stairs.push([cost, before]);
        }
        stairs.push([cost, error]);
    }
    chart = chart.with(Layer::line("front", Ink::Text, stairs));
    for (name, ink, is_one) in FAMILIES {
        for (precision, ring) in [("double", false), ("single", true)] {
            let of_kind = |point: &&&Point| {
                is_one(&point.case)
                    && point.case.arithmetic.is_double() != ring
                    && point.max_position_m.is_finite()
            };
            let points: Vec<&&Point> = scene.iter().filter(of_kind).collect();
            let kind = Kind::Dots { radius: 3.0, ring, opacity: 0.85 };
            let name = format!("{name}, {precision}");
            let layer = Layer::line(&name, ink, points.iter().map(|point| at(point)));
            let labels = points.iter().map(|point| point.name()).collect();
            chart = chart.with(Layer { kind, labels, ..layer });
        }
    }
    chart
}

#[cfg(test)]
mod tests {
    use super::super::sample::points;
    use super::*;

    #[test]
    fn every_scene_has_a_chart_with_every_point_that_flew() {
        let page = page(&points(), "<table>");
        assert_eq!(page.matches("<figure").count(), 2);
        for point in points() {
            let name = format!("\"{}\"", point.name());
            assert_eq!(page.contains(&name), point.max_position_m.is_finite(), "{name}");
        }
        assert!(page.contains("my error budget") && page.contains("&lt;table&gt;"));
    }
}
