//! One chart: bands and curves over axes, drawn the same on every canvas.

use crate::axis::Axis;
use crate::canvas::{Anchor, Canvas, Ink, Lettering, Point, Stroke};
use crate::decimate::by_column;
use crate::grid::{Frame, Grid, SMALL};

/// A curve's points, right and up in the axes' units.
#[derive(Clone, Debug)]
pub struct Curve {
    /// What it is.
    pub name: &'static str,
    /// Its colour.
    pub ink: Ink,
    /// How it is drawn.
    pub stroke: Stroke,
    /// x and y.
    pub points: Vec<[f64; 2]>,
}

/// The space between two curves.
#[derive(Clone, Debug)]
pub struct Band {
    /// What it is.
    pub name: &'static str,
    /// Its colour.
    pub ink: Ink,
    /// 0 to 1.
    pub opacity: f32,
    /// x, and the upper and lower y.
    pub edges: Vec<[f64; 3]>,
}

/// A point with a name.
#[derive(Clone, Debug)]
pub struct Mark {
    /// What is there.
    pub name: String,
    /// x and y.
    pub at: [f64; 2],
}

/// A chart.
#[derive(Clone, Debug)]
pub struct Chart {
    /// Above it, with the unit of y.
    pub title: String,
    /// To the right.
    pub x: Axis,
    /// Upward.
    pub y: Axis,
    /// Whether a unit is to be as long upward as to the right.
    pub is_map: bool,
    /// Drawn first.
    pub bands: Vec<Band>,
    /// Drawn over the bands.
    pub curves: Vec<Curve>,
    /// Drawn last.
    pub marks: Vec<Mark>,
}

const MARGIN_LEFT: f32 = 50.0;
const MARGIN_RIGHT: f32 = 14.0;
const MARGIN_TOP: f32 = 26.0;
const MARGIN_BOTTOM: f32 = 36.0;
/// The width of a digit in that size, about.
const DIGIT: f32 = 6.4;

impl Chart {
    /// Where the axes span it: inside of titles and labels.
    pub fn inner(&self, frame: Frame) -> Frame {
        let height = frame.height - MARGIN_TOP - MARGIN_BOTTOM;
        let longest = self.y_ticks(height).iter().map(|(_, label)| label.chars().count()).max();
        let margin = MARGIN_LEFT.max(12.0 + DIGIT * longest.unwrap_or(0) as f32);
        Frame {
            left: frame.left + margin,
            top: frame.top + MARGIN_TOP,
            width: frame.width - margin - MARGIN_RIGHT,
            height,
        }
    }

    fn y_ticks(&self, height: f32) -> Vec<(f64, String)> {
        self.y.ticks((height / 34.0) as usize)
    }

    /// The chart with a map's ranges widened: to one scale in this frame, and for its marks.
    pub fn fitted(mut self, frame: Frame) -> Self {
        if self.is_map {
            let inner = self.inner(frame);
            let shape = f64::from(inner.width / inner.height);
            let (width, height) = (self.x.to - self.x.from, self.y.to - self.y.from);
            let room = 1.12 * height.max(width / shape);
            let (wider, higher) = ((room * shape - width) / 2.0, (room - height) / 2.0);
            (self.x.from, self.x.to) = (self.x.from - wider, self.x.to + wider);
            (self.y.from, self.y.to) = (self.y.from - higher, self.y.to + higher);
        }
        self
    }

    /// Draws it; a map is to be [fitted](Self::fitted) before.
    pub fn draw(&self, canvas: &mut impl Canvas, frame: Frame) {
        let inner = self.inner(frame);
        let place = |[x, y]: [f64; 2]| -> Point {
            [
                inner.left + inner.width * self.x.fraction(x) as f32,
                inner.top + inner.height * (1.0 - self.y.fraction(y) as f32),
            ]
        };
        let xs = self.x.ticks((inner.width / 60.0) as usize).into_iter();
        let ys = self.y_ticks(inner.height).into_iter();
        let grid = Grid {
            title: &self.title,
            x_label: &self.x.label,
            x: xs.map(|(value, label)| (place([value, self.y.from])[0], label)).collect(),
            y: ys.map(|(value, label)| (place([self.x.from, value])[1], label)).collect(),
        };
        grid.draw(canvas, inner);
        for band in &self.bands {
            let edge = |side: usize| by_column(band.edges.iter().map(|e| place([e[0], e[side]])));
            let mut outline = edge(1);
            outline.extend(edge(2).into_iter().rev());
            canvas.area(band.name, &outline, band.ink, band.opacity);
        }
        for curve in &self.curves {
            let points = by_column(curve.points.iter().map(|&point| place(point)));
            canvas.line(curve.name, &points, curve.ink, curve.stroke);
        }
        for mark in &self.marks {
            let [x, y] = place(mark.at);
            canvas.dot([x, y], 3.5, Ink::Text);
            // Above or below the drawing, toward the middle.
            let is_right = x > inner.left + inner.width / 2.0;
            let anchor = if is_right { Anchor::End } else { Anchor::Start };
            let drop = if y > inner.top + inner.height / 2.0 { 14.0 } else { -7.0 };
            let lettering = Lettering { size: SMALL, bold: false, anchor };
            canvas.text([x, y + drop], &mark.name, Ink::Text, lettering);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where the labels that end at a point begin, at 6 pixels a character.
    #[derive(Default)]
    struct Labels(Vec<f32>);

    impl Canvas for Labels {
        fn area(&mut self, _: &str, _: &[Point], _: Ink, _: f32) {}
        fn line(&mut self, _: &str, _: &[Point], _: Ink, _: Stroke) {}
        fn dot(&mut self, _: Point, _: f32, _: Ink) {}
        fn text(&mut self, at: Point, text: &str, _: Ink, lettering: Lettering) {
            if lettering.anchor == Anchor::End {
                self.0.push(at[0] - 6.0 * text.chars().count() as f32);
            }
        }
    }

    #[test]
    fn labels_of_any_length_stay_inside() {
        let frame = Frame { left: 30.0, top: 0.0, width: 400.0, height: 250.0 };
        for (low, high) in [(0.0, 1.0), (-1e-4, 1e-4), (9999.998, 10_000.003), (-5e6, 5e6)] {
            let chart = Chart {
                title: String::new(),
                x: Axis::spanning("", [0.0, 1.0], false),
                y: Axis::spanning("", [low, high], true),
                is_map: false,
                bands: Vec::new(),
                curves: Vec::new(),
                marks: Vec::new(),
            };
            let mut labels = Labels::default();
            chart.draw(&mut labels, frame);
            assert!(labels.0.len() >= 3);
            assert!(labels.0.iter().all(|&x| x >= frame.left), "{low} to {high}: {:?}", labels.0);
        }
    }

    #[test]
    fn a_map_has_one_scale() {
        let frame = Frame { left: 0.0, top: 0.0, width: 400.0, height: 320.0 };
        for (width, height) in [(100.0, 1.0), (1.0, 100.0), (50.0, 50.0)] {
            let chart = Chart {
                title: String::new(),
                x: Axis::spanning("", [0.0, width], true),
                y: Axis::spanning("", [0.0, height], true),
                is_map: true,
                bands: Vec::new(),
                curves: Vec::new(),
                marks: Vec::new(),
            }
            .fitted(frame);
            let inner = chart.inner(frame);
            let right = f64::from(inner.width) / (chart.x.to - chart.x.from);
            let up = f64::from(inner.height) / (chart.y.to - chart.y.from);
            assert!((right / up - 1.0).abs() < 1e-6, "{right} {up}");
            assert!(chart.x.from < 0.0 && chart.x.to > width && chart.y.to > height);
        }
    }
}
