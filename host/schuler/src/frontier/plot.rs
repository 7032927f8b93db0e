//! `frontier.png`: a panel per scene, time against error, both logarithmic, with the front.

use super::Point;
use super::case::{Case, Method};
use super::table::{by_scene, front_of};
use schuler_report::axis::printed;
use schuler_report::canvas::{Anchor, Canvas, Ink, Lettering, Stroke};
use schuler_report::decades::Decades;
use schuler_report::grid::{Frame, Grid, SMALL};
use schuler_report::raster::Raster;
use schuler_simulator::navigator::compared::Arithmetic;
use schuler_simulator::number::parameter;
use schuler_simulator::scene::{self, Precision, WindowShape};
use std::io;

const WIDTH: f32 = 1100.0;
/// Where the names of the front stand, beside the drawing.
const NAMES_LEFT: f32 = 790.0;
const LEFT: f32 = 70.0;
const RIGHT: f32 = NAMES_LEFT - 40.0;
const TOP: f32 = 52.0;
/// Above and below a panel's drawing.
const HEAD: f32 = 34.0;
const FOOT: f32 = 48.0;
/// Height of a drawing, at least.
const LEAST_HEIGHT: f32 = 300.0;
/// From one name to the next.
const LINE: f32 = 14.0;

/// The picture.
pub fn png(points: &[Point]) -> io::Result<Vec<u8>> {
    let scenes = by_scene(points);
    let heights: Vec<f32> = scenes.iter().map(|scene| height(scene)).collect();
    let whole = TOP + heights.iter().map(|height| HEAD + height + FOOT).sum::<f32>();
    let mut sheet = Raster::new(WIDTH as u32, whole.ceil() as u32)
        .ok_or_else(|| io::Error::other("no picture of this size"))?;
    legend(&mut sheet);
    let mut top = TOP;
    for (scene, height) in scenes.iter().zip(heights) {
        let inner = Frame { left: LEFT, top: top + HEAD, width: RIGHT - LEFT, height };
        panel(&mut sheet, scene, inner);
        top += HEAD + height + FOOT;
    }
    sheet.png()
}

fn height(scene: &[&Point]) -> f32 {
    LEAST_HEIGHT.max(LINE * front_of(scene).len() as f32)
}

fn lettering(anchor: Anchor) -> Lettering {
    Lettering { size: SMALL, bold: false, anchor }
}

fn legend(canvas: &mut impl Canvas) {
    let title = Lettering { size: 15.0, bold: true, anchor: Anchor::Start };
    canvas.text([LEFT, 22.0], "Run time against error", Ink::Text, title);
    let named = |method, precision| Case {
        method,
        frame: scene::Axes::EarthFixed,
        arithmetic: Arithmetic::Named(precision),
    };
    let window = WindowShape { history: 0, block: 4, lookahead: 0 };
    let mut left = LEFT;
    for (name, case) in [
        ("taylor", named(Method::Taylor(window), Precision::F64)),
        ("textbook", named(Method::Textbook, Precision::F64)),
        ("rk4 on rates", named(Method::RungeKutta, Precision::F64)),
        ("in single precision", named(Method::Taylor(window), Precision::F32)),
    ] {
        mark(canvas, [left + 4.0, 38.0], 4.5, case);
        canvas.text([left + 13.0, 42.0], name, Ink::Muted, lettering(Anchor::Start));
        left += 45.0 + 6.0 * name.len() as f32;
    }
    canvas.line("", &[[left, 38.0], [left + 22.0, 38.0]], Ink::Text, Stroke::solid(1.5));
    let front = "the front: nothing is both cheaper and more accurate";
    canvas.text([left + 30.0, 42.0], front, Ink::Muted, lettering(Anchor::Start));
}

fn panel(canvas: &mut impl Canvas, scene: &[&Point], inner: Frame) {
    let x_axis = Decades::spanning(scene.iter().map(|p| p.cost_us_per_s()));
    let y_axis = Decades::spanning(scene.iter().map(|p| p.max_position_m));
    let (right, bottom) = (inner.left + inner.width, inner.top + inner.height);
    let x = |cost: f64| inner.left + inner.width * x_axis.fraction(cost) as f32;
    let y = |error: f64| bottom - inner.height * y_axis.fraction(error) as f32;
    let title = scene.first().map_or(String::new(), |first| {
        format!("{}, {} s: largest position error, m", first.scene, parameter(first.duration_s))
    });
    let errors = y_axis.ticks((inner.height / 24.0) as usize).into_iter();
    let grid = Grid {
        title: &title,
        x_label: "time per second of flight, µs",
        x: x_axis.ticks(12).into_iter().map(|cost| (x(cost), parameter(cost))).collect(),
        y: errors.map(|error| (y(error), printed(&format!("{error:e}")))).collect(),
    };
    grid.draw(canvas, inner);

    let at = |point: &Point| [x(point.cost_us_per_s()), y(point.max_position_m)];
    let front = front_of(scene);
    let ideal: Vec<f32> = front.iter().map(|point| y(point.max_position_m)).collect();
    let levels = spread(&ideal, inner.top, bottom, LINE);
    for (point, &level) in front.iter().zip(&levels) {
        // Level as far as the margin, where all go to their names in the same order: no two cross.
        let [left, own] = at(point);
        let elbow = [[left, own], [right + 4.0, own], [NAMES_LEFT - 5.0, level]];
        canvas.line("", &elbow, Ink::Muted, Stroke::solid(0.6));
        let name = [NAMES_LEFT, level + 4.0];
        canvas.text(name, &point.name(), Ink::Text, lettering(Anchor::Start));
    }
    for point in scene.iter().filter(|p| !p.on_front && p.max_position_m.is_finite()) {
        mark(canvas, at(point), 2.0, point.case);
    }
    // What a given time buys: the error stays until the next point is affordable.
    let mut stairs: Vec<[f32; 2]> = Vec::new();
    for point in &front {
        let at = at(point);
        if let Some(&[_, level]) = stairs.last() {
            stairs.push([at[0], level]);
        }
        stairs.push(at);
    }
    canvas.line("front", &stairs, Ink::Text, Stroke::solid(1.5));
    for point in &front {
        mark(canvas, at(point), 4.5, point.case);
    }
}

/// A disc; a ring for single precision.
fn mark(canvas: &mut impl Canvas, at: [f32; 2], radius: f32, case: Case) {
    let ink = match case.method {
        Method::Taylor(_) => Ink::North,
        Method::Textbook => Ink::East,
        Method::RungeKutta => Ink::Down,
    };
    canvas.dot(at, radius, ink);
    if !case.arithmetic.is_double() {
        canvas.dot(at, 0.55 * radius, Ink::Paper);
    }
}

/// Levels from top to bottom, in order, at least `gap` apart and as near to their ideals as that allows
/// in the mean square.
fn spread(ideal: &[f32], top: f32, bottom: f32, gap: f32) -> Vec<f32> {
    // Less i·gap they only must not fall: neighbours that would are pooled at their mean.
    let mut pools: Vec<(f32, usize)> = Vec::new();
    for (i, &level) in ideal.iter().enumerate() {
        let mut pool = (level - gap * i as f32, 1);
        while let Some((mean, count)) = pools.pop_if(|(mean, _)| *mean > pool.0) {
            let all = count + pool.1;
            pool = ((mean * count as f32 + pool.0 * pool.1 as f32) / all as f32, all);
        }
        pools.push(pool);
    }
    let lowest = (bottom - gap * ideal.len().saturating_sub(1) as f32).max(top);
    let pooled = pools.into_iter().flat_map(|(mean, count)| std::iter::repeat_n(mean, count));
    pooled.enumerate().map(|(i, mean)| mean.clamp(top, lowest) + gap * i as f32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_never_overlap() {
        for ideal in [vec![10.0, 11.0, 12.0, 50.0], vec![95.0, 96.0, 97.0, 98.0], vec![0.0; 7]] {
            let levels = spread(&ideal, 0.0, 100.0, 14.0);
            assert_eq!(levels.len(), ideal.len());
            let apart = levels.windows(2).all(|pair| pair[1] - pair[0] >= 13.99);
            let inside = levels.iter().all(|level| (-0.01..=100.01).contains(level));
            assert!(apart && inside, "{levels:?}");
        }
        assert_eq!(spread(&[10.0, 30.0], 0.0, 100.0, 14.0), [10.0, 30.0]);
        // Crowded ones spread about their middle.
        assert_eq!(spread(&[50.0, 50.0, 50.0], 0.0, 100.0, 14.0), [36.0, 50.0, 64.0]);
        assert!(spread(&[], 0.0, 100.0, 14.0).is_empty());
    }

    #[test]
    fn the_picture_has_a_panel_for_each_scene() {
        let png = png(&super::super::sample::points()).expect("a picture");
        assert!(png.starts_with(b"\x89PNG"));
        let decoder = ::png::Decoder::new(io::Cursor::new(&png));
        let reader = decoder.read_info().expect("a picture");
        assert_eq!(reader.info().width, WIDTH as u32);
        assert_eq!(reader.info().height, (TOP + 2.0 * (HEAD + LEAST_HEIGHT + FOOT)) as u32);
    }
}
