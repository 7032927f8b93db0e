//! Drawing into an image, with a built-in font.

use crate::canvas::{Anchor, Canvas, Ink, Lettering, Point, Stroke};
use std::io;
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, StrokeDash, Transform,
};
use ttf_parser::{Face, OutlineBuilder};

/// A picture on light paper.
pub struct Raster {
    pixels: Pixmap,
    regular: Face<'static>,
    bold: Face<'static>,
}

impl Raster {
    /// An empty sheet. `None` without any pixels.
    pub fn new(width: u32, height: u32) -> Option<Self> {
        let mut pixels = Pixmap::new(width, height)?;
        let [r, g, b] = Ink::Paper.light();
        pixels.fill(Color::from_rgba8(r, g, b, 255));
        let face = |bytes| Face::parse(bytes, 0).ok();
        Some(Self {
            pixels,
            regular: face(notosans::REGULAR_TTF)?,
            bold: face(notosans::BOLD_TTF)?,
        })
    }

    /// The picture as a PNG.
    pub fn png(&self) -> io::Result<Vec<u8>> {
        // The sheet is opaque, so that premultiplied colours are the colours themselves.
        let rgb: Vec<u8> =
            self.pixels.pixels().iter().flat_map(|p| [p.red(), p.green(), p.blue()]).collect();
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.pixels.width(), self.pixels.height());
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_compression(png::Compression::Fast);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&rgb)?;
        writer.finish()?;
        Ok(file)
    }

    fn fill(&mut self, path: Option<Path>, ink: Ink, opacity: f32) {
        if let Some(path) = path {
            let paint = paint(ink, opacity);
            self.pixels.fill_path(&path, &paint, FillRule::Winding, Transform::identity(), None);
        }
    }
}

fn paint(ink: Ink, opacity: f32) -> Paint<'static> {
    let [r, g, b] = ink.light();
    let mut paint = Paint::default();
    paint.set_color_rgba8(r, g, b, (opacity * 255.0).round() as u8);
    paint
}

fn path(points: &[Point], closed: bool) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for (i, &[x, y]) in points.iter().enumerate() {
        if i == 0 { builder.move_to(x, y) } else { builder.line_to(x, y) }
    }
    if closed {
        builder.close();
    }
    builder.finish()
}

impl Canvas for Raster {
    fn area(&mut self, _: &str, outline: &[Point], ink: Ink, opacity: f32) {
        self.fill(path(outline, true), ink, opacity);
    }

    fn line(&mut self, _: &str, points: &[Point], ink: Ink, stroke: Stroke) {
        let Some(path) = path(points, false) else { return };
        let stroke = tiny_skia::Stroke {
            width: stroke.width,
            line_cap: LineCap::Butt,
            line_join: LineJoin::Round,
            dash: if stroke.dashed { StrokeDash::new(vec![5.0, 3.0], 0.0) } else { None },
            ..Default::default()
        };
        self.pixels.stroke_path(&path, &paint(ink, 1.0), &stroke, Transform::identity(), None);
    }

    fn dot(&mut self, [x, y]: Point, radius: f32, ink: Ink) {
        self.fill(PathBuilder::from_circle(x, y, radius), ink, 1.0);
    }

    fn text(&mut self, [x, y]: Point, text: &str, ink: Ink, lettering: Lettering) {
        let face = if lettering.bold { &self.bold } else { &self.regular };
        let scale = lettering.size / f32::from(face.units_per_em());
        let glyphs: Vec<_> =
            text.chars().map(|c| face.glyph_index(c).unwrap_or_default()).collect();
        let advance = |glyph| scale * f32::from(face.glyph_hor_advance(glyph).unwrap_or(0));
        let width: f32 = glyphs.iter().map(|&glyph| advance(glyph)).sum();
        let left = match lettering.anchor {
            Anchor::Start => x,
            Anchor::Middle => x - width / 2.0,
            Anchor::End => x - width,
        };
        let mut pen = Pen { path: PathBuilder::new(), x: left, y, scale };
        for glyph in glyphs {
            face.outline_glyph(glyph, &mut pen);
            pen.x += advance(glyph);
        }
        self.fill(pen.path.finish(), ink, 1.0);
    }
}

/// Places glyphs, which are given in font units with y up.
struct Pen {
    path: PathBuilder,
    x: f32,
    y: f32,
    scale: f32,
}

impl Pen {
    fn at(&self, x: f32, y: f32) -> (f32, f32) {
        (self.x + x * self.scale, self.y - y * self.scale)
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.at(x1, y1), self.at(x, y));
        self.path.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = (self.at(x1, y1), self.at(x2, y2), self.at(x, y));
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}
