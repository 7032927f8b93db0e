//! Charts that a reader works with in a page: zoom, values under the cursor, layers that can be hidden, files.

use crate::canvas::Ink;
use crate::chart::Chart;
use crate::layer::{Kind, Layer};
use crate::packed::quoted;
use crate::svg::escape;

/// One direction of a chart.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scale {
    /// What is shown.
    pub label: String,
    /// Its unit; empty without one.
    pub unit: String,
    /// In decades.
    pub log: bool,
    /// From zero on, at least.
    pub zero: bool,
    /// What is shown at first; unset, what the data span.
    pub range: Option<[f64; 2]>,
}

impl Scale {
    /// Of something in a unit.
    pub fn new(label: &str, unit: &str) -> Self {
        Self { label: label.to_owned(), unit: unit.to_owned(), ..Self::default() }
    }

    /// The same in decades.
    pub fn log(self) -> Self {
        Self { log: true, ..self }
    }

    /// The same with zero in sight.
    pub fn from_zero(self) -> Self {
        Self { zero: true, ..self }
    }

    /// By a label that ends with its unit, as in "time, s".
    fn labelled(text: &str) -> Self {
        let (label, unit) = text.rsplit_once(", ").unwrap_or(("", text));
        Self::new(label, unit)
    }

    fn json(&self) -> String {
        let Self { label, unit, log, zero, range } = self;
        let range = range.map_or("null".to_owned(), |[from, to]| format!("[{from:e},{to:e}]"));
        let [label, unit] = [label, unit].map(|text| quoted(text));
        format!(
            "{{\"label\":{label},\"unit\":{unit},\"log\":{log},\"zero\":{zero},\"range\":{range}}}"
        )
    }
}

/// A chart in a page.
#[derive(Clone, Debug, PartialEq)]
pub struct Interactive {
    /// Above it.
    pub title: String,
    /// To the right.
    pub x: Scale,
    /// Upward.
    pub y: Scale,
    /// Whether a unit is to be as long upward as to the right, under a scale bar, north up.
    pub is_map: bool,
    /// Drawn one over the other.
    pub layers: Vec<Layer>,
    /// Charts of the same one share their cursor and their zoom.
    pub cursor: Option<&'static str>,
    /// Whether the cursor tells the nearest point rather than all layers.
    pub is_nearest: bool,
    /// Pixels.
    pub height: u32,
    /// Of the page's width.
    pub width: Width,
}

/// How much of a page's width a chart takes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Width {
    /// A third.
    #[default]
    Third,
    /// A half.
    Half,
    /// Two thirds.
    TwoThirds,
    /// All of it.
    Whole,
}

impl Interactive {
    /// With nothing in it yet.
    pub fn new(title: &str, x: Scale, y: Scale) -> Self {
        Self {
            title: title.to_owned(),
            x,
            y,
            is_map: false,
            layers: Vec::new(),
            cursor: None,
            is_nearest: false,
            height: 250,
            width: Width::default(),
        }
    }

    /// What a chart for paper shows, on a scale of its own: from zero where the chart begins there.
    pub fn of(chart: Chart) -> Self {
        let Chart { title, x, y, is_map, bands, curves, marks } = chart;
        let mut layers = Vec::new();
        for band in bands {
            layers.push(Layer::new(band.name, band.ink, Kind::Band(band.opacity), band.edges));
        }
        for curve in curves {
            let kind = Kind::Line { width: curve.stroke.width, dashed: curve.stroke.dashed };
            layers.push(Layer { kind, ..Layer::line(curve.name, curve.ink, curve.points) });
        }
        if !marks.is_empty() {
            let mut layer = Layer::line("", Ink::Text, marks.iter().map(|mark| mark.at));
            layer.kind = Kind::Marks;
            layer.labels = marks.into_iter().map(|mark| mark.name).collect();
            layers.push(layer);
        }
        let zero = y.from == 0.0;
        let y = Scale { zero, ..Scale::labelled(&y.label) };
        let height = if is_map { 400 } else { 250 };
        Self { is_map, layers, height, ..Self::new(&title, Scale::labelled(&x.label), y) }
    }

    /// The same with another layer on top.
    pub fn with(mut self, layer: Layer) -> Self {
        self.layers.push(layer);
        self
    }

    /// The same that shares its cursor.
    pub fn sharing(self, cursor: &'static str) -> Self {
        Self { cursor: Some(cursor), ..self }
    }

    /// The same of a width, and so high.
    pub fn sized(self, width: Width, height: u32) -> Self {
        Self { width, height, ..self }
    }

    /// A figure of a page.
    pub fn html(&self) -> String {
        let Self { title, x, y, is_map, layers, cursor, is_nearest, height, width } = self;
        let layers = layers.iter().filter(|layer| !layer.points.is_empty());
        let layers: Vec<String> = layers.map(Layer::json).collect();
        let cursor = cursor.map_or("null".to_owned(), quoted);
        let class = match width {
            Width::Third => "plot",
            Width::Half => "plot half",
            Width::TwoThirds => "plot wide",
            Width::Whole => "plot whole",
        };
        format!(
            "<figure class=\"{class}\"><figcaption>{0}</figcaption>\
             <div class=\"draw\" role=\"img\" tabindex=\"0\" style=\"min-height:{height}px\" \
             aria-label=\"{0}. Keys: plus and minus zoom, arrows move, 0 shows the whole\"></div>\
             <script type=\"application/json\">{{\"title\":{1},\"x\":{2},\"y\":{3},\"map\":{is_map},\
             \"near\":{is_nearest},\"cursor\":{cursor},\"height\":{height},\"layers\":[{4}]}}</script></figure>\n",
            escape(title),
            quoted(title),
            x.json(),
            y.json(),
            layers.join(",")
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::axis::Axis;
    use crate::canvas::Stroke;
    use crate::chart::{Band, Curve, Mark};

    #[test]
    fn a_chart_for_paper_keeps_what_it_shows() {
        let chart = Chart {
            title: "Height <of> it, m".to_owned(),
            x: Axis::spanning("time, min", [0.0, 2.0], false),
            y: Axis::spanning("m", [0.0, 4.0], false),
            is_map: false,
            bands: vec![Band {
                name: "±3σ",
                ink: Ink::North,
                opacity: 0.2,
                edges: vec![[0.0, 1.0, -1.0]; 2],
            }],
            curves: vec![Curve {
                name: "error",
                ink: Ink::East,
                stroke: Stroke::solid(2.0),
                points: vec![[0.0, 1.0], [1.0, 5.0], [2.0, 4.0]],
            }],
            marks: vec![Mark { name: "end".to_owned(), at: [2.0, 4.0] }],
        };
        let html = Interactive::of(chart).sharing("time").html();
        for part in [
            "<figcaption>Height &lt;of&gt; it, m</figcaption>",
            "\"title\":\"Height \\u003cof\\u003e it, m\"",
            "\"x\":{\"label\":\"time\",\"unit\":\"min\",\"log\":false,\"zero\":false,\"range\":null}",
            "\"y\":{\"label\":\"\",\"unit\":\"m\",\"log\":false,\"zero\":true,\"range\":null}",
            "\"cursor\":\"time\"",
            "{\"name\":\"±3σ\",\"ink\":\"north\",\"kind\":\"band\",\"opacity\":0.2,\"x\":[0e0,0e0,2],\
             \"high\":[1e0,1e0,2],\"low\":[-1e0,-1e0,2]}",
            "{\"name\":\"error\",\"ink\":\"east\",\"kind\":\"line\",\"width\":2,\"dashed\":false,\
             \"x\":[0e0,2e0,3],\"high\":\"AACAPwAAoEAAAIBA\"}",
            "\"kind\":\"marks\",\"radius\":3.5,\"x\":\"AAAAQA==\",\"high\":\"AACAQA==\",\"labels\":[\"end\"]",
        ] {
            assert!(html.contains(part), "{part} in {html}");
        }
    }
}
