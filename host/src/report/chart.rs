//! One chart: bands and curves over axes, drawn the same on every canvas.

use super::axis::Axis;
use super::canvas::{Anchor, Canvas, Ink, Lettering, Point, Stroke};
use super::decimate::by_column;

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

/// A rectangle of a canvas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Left edge.
    pub left: f32,
    /// Upper edge.
    pub top: f32,
    /// To the right.
    pub width: f32,
    /// Downward.
    pub height: f32,
}

const MARGIN_LEFT: f32 = 50.0;
const MARGIN_RIGHT: f32 = 14.0;
const MARGIN_TOP: f32 = 26.0;
const MARGIN_BOTTOM: f32 = 36.0;
const SMALL: f32 = 11.0;

impl Chart {
    /// Where the axes span it: inside of titles and labels.
    pub fn inner(frame: Frame) -> Frame {
        Frame {
            left: frame.left + MARGIN_LEFT,
            top: frame.top + MARGIN_TOP,
            width: frame.width - MARGIN_LEFT - MARGIN_RIGHT,
            height: frame.height - MARGIN_TOP - MARGIN_BOTTOM,
        }
    }

    /// The chart with a map's ranges widened: to one scale in this frame, and for its marks.
    pub fn fitted(mut self, frame: Frame) -> Self {
        if self.is_map {
            let inner = Self::inner(frame);
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
        let inner = Self::inner(frame);
        let place = |[x, y]: [f64; 2]| -> Point {
            [
                inner.left + inner.width * self.x.fraction(x) as f32,
                inner.top + inner.height * (1.0 - self.y.fraction(y) as f32),
            ]
        };
        self.draw_axes(canvas, frame, &place);
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

    fn draw_axes(
        &self,
        canvas: &mut impl Canvas,
        frame: Frame,
        place: &impl Fn([f64; 2]) -> Point,
    ) {
        let inner = Self::inner(frame);
        let (right, bottom) = (inner.left + inner.width, inner.top + inner.height);
        let label = |anchor| Lettering { size: SMALL, bold: false, anchor };
        let hairline = Stroke::solid(1.0);
        for (value, text) in self.x.ticks((inner.width / 60.0) as usize) {
            let x = place([value, self.y.from])[0];
            canvas.line("", &[[x, inner.top], [x, bottom]], Ink::Grid, hairline);
            canvas.text([x, bottom + 14.0], &text, Ink::Muted, label(Anchor::Middle));
        }
        for (value, text) in self.y.ticks((inner.height / 34.0) as usize) {
            let y = place([self.x.from, value])[1];
            let ink = if value == 0.0 { Ink::Muted } else { Ink::Grid };
            canvas.line("", &[[inner.left, y], [right, y]], ink, hairline);
            canvas.text([inner.left - 6.0, y + 4.0], &text, Ink::Muted, label(Anchor::End));
        }
        let corner = [[inner.left, inner.top], [inner.left, bottom], [right, bottom]];
        canvas.line("", &corner, Ink::Muted, hairline);
        let middle = inner.left + inner.width / 2.0;
        canvas.text([middle, bottom + 29.0], &self.x.label, Ink::Muted, label(Anchor::Middle));
        let heading = Lettering { size: 13.0, bold: true, anchor: Anchor::Start };
        canvas.text([inner.left, inner.top - 9.0], &self.title, Ink::Text, heading);
    }
}
