//! The grid of a drawing: lines at round values with their labels, two axes, a title.

use crate::canvas::{Anchor, Canvas, Ink, Lettering, Stroke};

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

/// The size of labels.
pub const SMALL: f32 = 11.0;

/// What stands around a drawing, and the lines through it.
#[derive(Clone, Debug)]
pub struct Grid<'a> {
    /// Above it.
    pub title: &'a str,
    /// Below it, with the unit.
    pub x_label: &'a str,
    /// The upright lines, each with its label.
    pub x: Vec<(f32, String)>,
    /// The level lines, each with its label.
    pub y: Vec<(f32, String)>,
}

impl Grid<'_> {
    /// Draws it about a rectangle.
    pub fn draw(&self, canvas: &mut impl Canvas, inner: Frame) {
        let Frame { left, top, .. } = inner;
        let (right, bottom) = (left + inner.width, top + inner.height);
        let small = |anchor| Lettering { size: SMALL, bold: false, anchor };
        let hairline = Stroke::solid(1.0);
        for &(x, ref label) in &self.x {
            canvas.line("", &[[x, top], [x, bottom]], Ink::Grid, hairline);
            canvas.text([x, bottom + 14.0], label, Ink::Muted, small(Anchor::Middle));
        }
        for &(y, ref label) in &self.y {
            let ink = if label == "0" { Ink::Muted } else { Ink::Grid };
            canvas.line("", &[[left, y], [right, y]], ink, hairline);
            canvas.text([left - 6.0, y + 4.0], label, Ink::Muted, small(Anchor::End));
        }
        canvas.line("", &[[left, top], [left, bottom], [right, bottom]], Ink::Muted, hairline);
        let middle = left + inner.width / 2.0;
        canvas.text([middle, bottom + 29.0], self.x_label, Ink::Muted, small(Anchor::Middle));
        let heading = Lettering { size: 13.0, bold: true, anchor: Anchor::Start };
        canvas.text([left, top - 9.0], self.title, Ink::Text, heading);
    }
}
