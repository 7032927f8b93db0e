//! A chart with many small dots under its curves.

use crate::canvas::{Canvas, Ink};
use crate::chart::Chart;
use crate::grid::Frame;

/// The radius of a dot.
const DOT: f32 = 1.3;

/// Draws the chart with dots at x, y between its grid and its curves; a map is to be
/// [fitted](Chart::fitted) before.
pub fn draw(chart: &Chart, dots: &[[f64; 2]], canvas: &mut impl Canvas, frame: Frame) {
    let inner = chart.inner(frame);
    let place = |[x, y]: [f64; 2]| {
        [
            inner.left + inner.width * chart.x.fraction(x) as f32,
            inner.top + inner.height * (1.0 - chart.y.fraction(y) as f32),
        ]
    };
    let ground = Chart { curves: Vec::new(), marks: Vec::new(), ..chart.clone() };
    ground.draw(canvas, frame);
    for &dot in dots {
        canvas.dot(place(dot), DOT, Ink::Muted);
    }
    for curve in &chart.curves {
        let points: Vec<_> = curve.points.iter().map(|&point| place(point)).collect();
        canvas.line(curve.name, &points, curve.ink, curve.stroke);
    }
}
