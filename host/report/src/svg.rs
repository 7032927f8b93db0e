//! Drawing into an SVG: a file of its own, or an element that takes its colours from the page around it.

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

    /// A file of its own, on light paper.
    pub fn document(self, width: u32, height: u32) -> String {
        let class = |ink: Ink| {
            let [r, g, b] = ink.light();
            format!(".i-{} {{ color: #{r:02x}{g:02x}{b:02x}; }}\n", ink.name())
        };
        let colours: String = Ink::ALL.map(class).concat();
        let sheet =
            "<rect class=\"i-paper\" width=\"100%\" height=\"100%\" fill=\"currentColor\"/>";
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"Noto Sans, Helvetica, Arial, sans-serif\">\n\
             <style>\n{colours}</style>\n{sheet}{}</svg>\n",
            self.body
        )
    }

    /// Starts a path element. Writing to a String cannot fail.
    fn path(&mut self, name: &str, points: &[Point], ink: Ink) {
        let _ = write!(self.body, "<path class=\"i-{}\"", ink.name());
        if !name.is_empty() {
            let _ = write!(self.body, " data-name=\"{}\"", escape(name));
        }
        self.body.push_str(" d=\"");
        let mut is_open = false;
        for point in points {
            let [x, y] = point.map(|value| (value * 10.0).round() / 10.0);
            // What is not known is left out.
            let is_known = x.is_finite() && y.is_finite();
            if is_known {
                let _ = write!(self.body, "{}{x} {y}", if is_open { 'L' } else { 'M' });
            }
            is_open = is_known;
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
    fn a_document_is_xml_with_its_own_colours() {
        let mut svg = Svg::default();
        let gap = [[0.0, 1.0], [f32::NAN, 2.0], [3.0, 4.0]];
        svg.line("a & b", &gap, Ink::North, Stroke::solid(1.0));
        let text = svg.document(20, 10);
        assert!(
            text.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\"")
                && text.ends_with("</svg>\n")
        );
        assert!(text.contains("d=\"M0 1M3 4\"") && text.contains("a &amp; b"), "{text}");
        assert!(text.contains(".i-north { color: #0067ad; }") && !text.contains("NaN"), "{text}");
    }

    #[test]
    fn text_cannot_become_markup() {
        let mut svg = Svg::default();
        let lettering = Lettering { size: 10.0, bold: false, anchor: Anchor::Start };
        svg.text([0.0, 0.0], "<script>&\"'", Ink::Text, lettering);
        let text = svg.finish(1.0, 1.0, "");
        assert!(text.contains("&lt;script&gt;&amp;&quot;&#39;</text>"), "{text}");
    }
}
