//! Drawing into an SVG that takes its colours from the page around it.

use crate::canvas::{Anchor, Canvas, Ink, Lettering, Point, Stroke};
use std::fmt::Write;

/// The inside of an `<svg>` element. Classes name the colours: `i-north` and so on.
#[derive(Clone, Debug, Default)]
pub struct Svg {
    body: String,
}

impl Svg {
    /// The element; `attributes` are added to it as they are.
    pub fn finish(self, width: f32, height: f32, attributes: &str) -> String {
        format!("<svg viewBox=\"0 0 {width} {height}\" {attributes}>{}</svg>\n", self.body)
    }

    /// Starts a path element. Writing to a String cannot fail.
    fn path(&mut self, name: &str, points: &[Point], ink: Ink) {
        let _ = write!(self.body, "<path class=\"i-{}\"", ink.name());
        if !name.is_empty() {
            let _ = write!(self.body, " data-name=\"{}\"", escape(name));
        }
        self.body.push_str(" d=\"");
        for (i, point) in points.iter().enumerate() {
            let [x, y] = point.map(|value| (value * 10.0).round() / 10.0);
            let _ = write!(self.body, "{}{x} {y}", if i == 0 { 'M' } else { 'L' });
        }
    }
}

impl Canvas for Svg {
    fn area(&mut self, name: &str, outline: &[Point], ink: Ink, opacity: f32) {
        self.path(name, outline, ink);
        let _ = write!(self.body, "Z\" fill=\"currentColor\" fill-opacity=\"{opacity}\"/>");
    }

    fn line(&mut self, name: &str, points: &[Point], ink: Ink, stroke: Stroke) {
        self.path(name, points, ink);
        let dashes = if stroke.dashed { " stroke-dasharray=\"5 3\"" } else { "" };
        let width = stroke.width;
        let _ = write!(
            self.body,
            "\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"{width}\"{dashes}/>"
        );
    }

    fn dot(&mut self, [x, y]: Point, radius: f32, ink: Ink) {
        let class = ink.name();
        let _ = write!(
            self.body,
            "<circle class=\"i-{class}\" fill=\"currentColor\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\"/>"
        );
    }

    fn text(&mut self, [x, y]: Point, text: &str, ink: Ink, lettering: Lettering) {
        let anchor = match lettering.anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let weight = if lettering.bold { " font-weight=\"600\"" } else { "" };
        let _ = write!(
            self.body,
            "<text class=\"i-{}\" fill=\"currentColor\" x=\"{x:.1}\" y=\"{y:.1}\" \
             font-size=\"{}\" text-anchor=\"{anchor}\"{weight}>{}</text>",
            ink.name(),
            lettering.size,
            escape(text)
        );
    }
}

/// A text with the characters replaced that mean something in HTML.
pub fn escape(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            _ => safe.push(character),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_cannot_become_markup() {
        let mut svg = Svg::default();
        let lettering = Lettering { size: 10.0, bold: false, anchor: Anchor::Start };
        svg.text([0.0, 0.0], "<script>&\"'", Ink::Text, lettering);
        let text = svg.finish(1.0, 1.0, "");
        assert!(text.contains("&lt;script&gt;&amp;&quot;&#39;</text>"), "{text}");
    }
}
