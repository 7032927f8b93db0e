//! What an interactive chart is made of.

use crate::canvas::Ink;
use crate::packed::{packed, quoted};

/// How a layer is drawn.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// Through its points.
    Line {
        /// Pixels.
        width: f32,
        /// In dashes.
        dashed: bool,
    },
    /// The space between two edges, of an opacity.
    Band(f32),
    /// The area that a dense line fills.
    Envelope,
    /// Discs; rings where `ring` is set.
    Dots {
        /// Pixels.
        radius: f32,
        /// Hollow.
        ring: bool,
        /// 0 to 1.
        opacity: f32,
    },
    /// Upright strokes.
    Bars,
    /// Discs with their names beside them.
    Marks,
}

/// One thing of a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// What it is; empty for what needs no mention.
    pub name: String,
    /// Its colour.
    pub ink: Ink,
    /// How it is drawn.
    pub kind: Kind,
    /// x, and the greatest and the least y.
    pub points: Vec<[f64; 3]>,
    /// A name for each point, or nothing.
    pub labels: Vec<String>,
}

impl Layer {
    /// Of edges, or of points that are high as they are low.
    pub fn new(name: &str, ink: Ink, kind: Kind, points: Vec<[f64; 3]>) -> Self {
        Self { name: name.to_owned(), ink, kind, points, labels: Vec::new() }
    }

    /// Through points.
    pub fn line(name: &str, ink: Ink, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        let points = points.into_iter().map(|[x, y]| [x, y, y]).collect();
        Self::new(name, ink, Kind::Line { width: 1.6, dashed: false }, points)
    }

    /// The same in dashes.
    pub fn dashes(name: &str, ink: Ink, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self { kind: Kind::Line { width: 1.3, dashed: true }, ..Self::line(name, ink, points) }
    }

    /// Discs at points.
    pub fn dots(
        name: &str,
        ink: Ink,
        radius: f32,
        points: impl IntoIterator<Item = [f64; 2]>,
    ) -> Self {
        let kind = Kind::Dots { radius, ring: false, opacity: 1.0 };
        Self { kind, ..Self::line(name, ink, points) }
    }

    /// As a page's script reads it.
    pub fn json(&self) -> String {
        let column =
            |i: usize| packed(&self.points.iter().map(|point| point[i]).collect::<Vec<_>>());
        let kind = match self.kind {
            Kind::Line { width, dashed } => {
                format!("\"kind\":\"line\",\"width\":{width},\"dashed\":{dashed}")
            }
            Kind::Band(opacity) => format!("\"kind\":\"band\",\"opacity\":{opacity}"),
            Kind::Envelope => "\"kind\":\"envelope\"".to_owned(),
            Kind::Dots { radius, ring, opacity } => {
                format!(
                    "\"kind\":\"dots\",\"radius\":{radius},\"ring\":{ring},\"opacity\":{opacity}"
                )
            }
            Kind::Bars => "\"kind\":\"bars\"".to_owned(),
            Kind::Marks => "\"kind\":\"marks\",\"radius\":3.5".to_owned(),
        };
        let is_flat = self.points.iter().all(|[_, high, low]| high == low || high.is_nan());
        let low = if is_flat { String::new() } else { format!(",\"low\":{}", column(2)) };
        let labels = self.labels.iter().map(|label| quoted(label)).collect::<Vec<_>>().join(",");
        let labels = if labels.is_empty() { labels } else { format!(",\"labels\":[{labels}]") };
        format!(
            "{{\"name\":{},\"ink\":\"{}\",{kind},\"x\":{},\"high\":{}{low}{labels}}}",
            quoted(&self.name),
            self.ink.name(),
            column(0),
            column(1)
        )
    }
}
