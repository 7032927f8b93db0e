//! `drift.png`, `drift.svg`: position, velocity and attitude errors with theory's bands, in three rows.

use super::{drift_charts, heading};
use schuler_report::canvas::{Anchor, Canvas, Ink, Lettering};
use schuler_report::chart::Chart;
use schuler_report::grid::Frame;
use schuler_report::raster::Raster;
use schuler_report::svg::Svg;
use schuler_simulator::flight::{Flight, Instant};
use std::io;

const WIDTH: u32 = 1200;
const HEIGHT: u32 = 900;
const EDGE: f32 = 12.0;
const HEAD: f32 = 60.0;

/// The picture as a PNG.
pub fn png(flight: &Flight) -> io::Result<Vec<u8>> {
    sheet(&flight.scene.title, &heading(flight), &flight.overview)
}

/// The same for documents.
pub fn svg(flight: &Flight) -> String {
    document(&flight.scene.title, &heading(flight), &flight.overview)
}

/// The picture of any instants for documents.
pub fn document(title: &str, about: &str, instants: &[Instant]) -> String {
    let mut sheet = Svg::default();
    draw(&mut sheet, title, about, instants);
    sheet.document(WIDTH, HEIGHT)
}

/// The picture of any instants, below a title and a line about them.
pub fn sheet(title: &str, about: &str, instants: &[Instant]) -> io::Result<Vec<u8>> {
    let mut sheet = Raster::new(WIDTH, HEIGHT).ok_or_else(|| io::Error::other("no font"))?;
    draw(&mut sheet, title, about, instants);
    sheet.png()
}

/// Three rows of charts as an SVG for documents, below a title and a line about them.
pub fn svg_of(title: &str, about: &str, charts: &[[Chart; 3]]) -> String {
    let mut sheet = Svg::default();
    rows(&mut sheet, title, about, charts);
    sheet.document(WIDTH, HEIGHT)
}

fn draw(canvas: &mut impl Canvas, title: &str, about: &str, instants: &[Instant]) {
    let charts = drift_charts::known(drift_charts::errors(instants));
    rows(canvas, title, about, &charts);
    let has_bands = charts.iter().flatten().any(|chart| !chart.bands.is_empty());
    if charts.iter().flatten().any(drift_charts::has_mean) {
        drift_charts::legend(canvas, [if has_bands { 780.0 } else { 970.0 }, 26.0], has_bands);
    }
}

fn rows(canvas: &mut impl Canvas, title: &str, about: &str, charts: &[[Chart; 3]]) {
    let letters = |size, bold| Lettering { size, bold, anchor: Anchor::Start };
    let left = EDGE + 14.0;
    canvas.text([left, 30.0], title, Ink::Text, letters(20.0, true));
    canvas.text([left, 50.0], about, Ink::Muted, letters(12.5, false));
    let width = (WIDTH as f32 - 2.0 * EDGE) / 3.0;
    let height = (HEIGHT as f32 - HEAD - EDGE) / 3.0;
    for (row, charts) in charts.iter().enumerate() {
        for (column, chart) in charts.iter().enumerate() {
            let left = EDGE + column as f32 * width;
            let top = HEAD + row as f32 * height;
            chart.draw(canvas, Frame { left, top, width, height });
        }
    }
}

/// The files' names.
pub const NAME: &str = "drift.png";
/// For documents.
pub const SVG: &str = "drift.svg";

#[cfg(test)]
mod tests {
    use super::super::sample;
    use super::*;
    use std::collections::HashMap;

    fn decode(bytes: &[u8]) -> (u32, u32, Vec<[u8; 3]>) {
        let mut reader = png::Decoder::new(io::Cursor::new(bytes)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        assert_eq!(info.color_type, png::ColorType::Rgb);
        let pixels = pixels.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect();
        (info.width, info.height, pixels)
    }

    fn count(pixels: &[[u8; 3]]) -> HashMap<[u8; 3], usize> {
        let mut counts = HashMap::new();
        for &pixel in pixels {
            *counts.entry(pixel).or_default() += 1;
        }
        counts
    }

    #[test]
    fn shows_curves_bands_and_letters() {
        let (width, height, pixels) = decode(&png(&sample::flight()).unwrap());
        assert_eq!((width, height), (WIDTH, HEIGHT));
        let colours = count(&pixels);
        for ink in [Ink::North, Ink::East, Ink::Down] {
            assert!(colours.get(&ink.light()).is_some_and(|&n| n > 300), "{ink:?}");
        }
        // The bands: paler than their curves, over much of the sheet.
        let pale = colours.iter().filter(|(colour, _)| {
            let (low, high) = (colour.iter().min().unwrap(), colour.iter().max().unwrap());
            high - low > 12 && *low > 120
        });
        assert!(pale.map(|(_, n)| n).sum::<usize>() > 50_000);
        // Letters at the top left.
        let title = pixels.chunks(WIDTH as usize).take(32).flat_map(|row| &row[20..400]);
        assert!(title.filter(|&&pixel| pixel == Ink::Text.light()).count() > 100);
    }

    #[test]
    fn a_document_has_the_same_charts() {
        let text = svg(&sample::flight());
        for part in
            ["North position error, m", "data-name=\"±3σ\"", "data-name=\"error\"", "theory’s mean"]
        {
            assert!(text.contains(part), "{part}");
        }
        assert!(!text.contains("NaN") && !text.contains("var(--"));
    }

    #[test]
    fn an_empty_run_still_makes_a_sheet() {
        let mut flight = sample::perfect();
        flight.overview.clear();
        assert_eq!(decode(&png(&flight).unwrap()).0, WIDTH);
    }
}
