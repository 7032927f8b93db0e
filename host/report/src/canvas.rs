//! The canvas of charts. An SVG and an image implement it, so that both show the same.

/// A point, right and down in pixels.
pub type Point = [f32; 2];

/// A colour by its role.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// The background.
    Paper,
    /// Titles, and what theory expects.
    Text,
    /// Axes and their labels.
    Muted,
    /// Grid lines.
    Grid,
    /// North, or roll.
    North,
    /// East, or pitch.
    East,
    /// Down, or yaw.
    Down,
}

impl Ink {
    /// Every role.
    pub const ALL: [Self; 7] =
        [Self::Paper, Self::Text, Self::Muted, Self::Grid, Self::North, Self::East, Self::Down];

    /// Its name in the report's style sheet.
    pub fn name(self) -> &'static str {
        match self {
            Self::Paper => "paper",
            Self::Text => "text",
            Self::Muted => "muted",
            Self::Grid => "grid",
            Self::North => "north",
            Self::East => "east",
            Self::Down => "down",
        }
    }

    /// Red, green, blue on light paper.
    pub fn light(self) -> [u8; 3] {
        match self {
            Self::Paper => [255, 255, 255],
            Self::Text => [28, 32, 38],
            Self::Muted => [98, 106, 117],
            Self::Grid => [226, 229, 233],
            Self::North => [0, 103, 173],
            Self::East => [201, 82, 0],
            Self::Down => [0, 132, 96],
        }
    }

    /// Red, green, blue on dark paper.
    pub fn dark(self) -> [u8; 3] {
        match self {
            Self::Paper => [24, 27, 32],
            Self::Text => [228, 231, 235],
            Self::Muted => [150, 158, 168],
            Self::Grid => [52, 57, 65],
            Self::North => [96, 178, 240],
            Self::East => [246, 150, 78],
            Self::Down => [72, 200, 158],
        }
    }
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Pixels.
    pub width: f32,
    /// In dashes rather than through.
    pub dashed: bool,
}

impl Stroke {
    /// A line without dashes.
    pub const fn solid(width: f32) -> Self {
        Self { width, dashed: false }
    }
}

/// Which part of a text its point marks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// Its left end.
    Start,
    /// Its middle.
    Middle,
    /// Its right end.
    End,
}

/// How a text is set; its point lies on the baseline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lettering {
    /// Pixels per em.
    pub size: f32,
    /// Bold rather than regular.
    pub bold: bool,
    /// Where its point is.
    pub anchor: Anchor,
}

/// A surface to draw on. A `name` that is not empty makes a shape's values readable where the
/// surface is interactive.
pub trait Canvas {
    /// Fills what the points enclose.
    fn area(&mut self, name: &str, outline: &[Point], ink: Ink, opacity: f32);
    /// Draws a line through the points.
    fn line(&mut self, name: &str, points: &[Point], ink: Ink, stroke: Stroke);
    /// Fills a circle.
    fn dot(&mut self, centre: Point, radius: f32, ink: Ink);
    /// Writes a text on one line.
    fn text(&mut self, at: Point, text: &str, ink: Ink, lettering: Lettering);
}
