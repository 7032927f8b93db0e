//! The charts of a drift: position, velocity and attitude errors within theory's bands.

use super::largest;
use schuler_report::axis::Axis;
use schuler_report::canvas::{Anchor, Canvas, Ink, Lettering, Point, Stroke};
use schuler_report::chart::{Band, Chart, Curve};
use schuler_simulator::flight::{Instant, Nine};
use schuler_simulator::number::{Quantity, Unit};

const AXES: [(&str, Ink); 3] = [("North", Ink::North), ("East", Ink::East), ("Down", Ink::Down)];
const GROUPS: [(&str, Quantity); 3] = [
    ("position error", Quantity::Position),
    ("velocity error", Quantity::Velocity),
    ("attitude error", Quantity::Attitude),
];
const ERROR: Stroke = Stroke::solid(1.6);
const MEAN: Stroke = Stroke { width: 1.2, dashed: true };
/// The bands' names, widths in σ and opacities, the widest first.
const BANDS: [(&str, f64, f32); 2] = [("±3σ", 3.0, 0.11), ("±1σ", 1.0, 0.2)];

/// A row per group (position, velocity, attitude), a column per axis (north, east, down).
pub fn errors(instants: &[Instant]) -> [[Chart; 3]; 3] {
    std::array::from_fn(|group| error_row(instants, group))
}

fn error_row(instants: &[Instant], group: usize) -> [Chart; 3] {
    let part = |nine: &Nine, axis: usize| part(nine, group, axis);
    let name = GROUPS[group].0;
    let extent = |axis: usize| extent(instants, group, axis);
    let unit = unit(instants, group);
    let spans: [Axis; 3] = std::array::from_fn(|axis| {
        Axis::spanning(unit.name, extent(axis).map(|value| value * unit.factor), true)
    });
    let spans = alike(spans);
    let (time, per_second) = Axis::time(super::end_s(instants));
    std::array::from_fn(|axis| {
        let (direction, ink) = AXES[axis];
        let curve = |name, ink, stroke, pick: fn(&Instant) -> &Nine| Curve {
            name,
            ink,
            stroke,
            points: instants
                .iter()
                .map(|i| [i.time_s * per_second, part(pick(i), axis) * unit.factor])
                .collect(),
        };
        let band = |&(name, width, opacity): &(&'static str, f64, f32)| Band {
            name,
            ink,
            opacity,
            edges: instants
                .iter()
                .map(|i| {
                    let (mean, reach) = (part(&i.mean, axis), width * part(&i.sigma, axis));
                    let [upper, lower] = [mean + reach, mean - reach].map(|y| y * unit.factor);
                    [i.time_s * per_second, upper, lower]
                })
                .collect(),
        };
        let is_expected = instants.iter().any(|i| part(&i.mean, axis).is_finite());
        let mean = is_expected.then(|| curve("mean", Ink::Text, MEAN, |i| &i.mean));
        let error = curve("error", ink, ERROR, |i| &i.drift);
        let is_random = instants.iter().any(|i| part(&i.sigma, axis) > 0.0);
        Chart {
            title: format!("{direction} {name}, {}", unit.name),
            x: time.clone(),
            y: spans[axis].clone(),
            is_map: false,
            bands: if is_random { BANDS.iter().map(band).collect() } else { Vec::new() },
            curves: mean.into_iter().chain([error]).collect(),
            marks: Vec::new(),
        }
    })
}

fn part(nine: &Nine, group: usize, axis: usize) -> f64 {
    match group {
        0 => nine.position_m[axis],
        1 => nine.velocity_m_s[axis],
        _ => nine.attitude_arcsec[axis],
    }
}

/// What a chart has to have room for: the error and the widest band.
fn extent(instants: &[Instant], group: usize, axis: usize) -> impl Iterator<Item = f64> {
    instants.iter().flat_map(move |i| {
        let (mean, reach) = (part(&i.mean, group, axis), BANDS[0].1 * part(&i.sigma, group, axis));
        [part(&i.drift, group, axis), mean - reach, mean + reach]
    })
}

/// The unit of a group.
pub fn unit(instants: &[Instant], group: usize) -> Unit {
    GROUPS[group].1.unit(largest((0..3).flat_map(|axis| extent(instants, group, axis))))
}

/// One range for a row, so that its charts can be compared, unless it flattens one of them.
fn alike(spans: [Axis; 3]) -> [Axis; 3] {
    let from = spans.iter().map(|axis| axis.from).fold(f64::MAX, f64::min);
    let to = spans.iter().map(|axis| axis.to).fold(f64::MIN, f64::max);
    if spans.iter().any(|axis| axis.to - axis.from < (to - from) / 6.0) {
        return spans;
    }
    spans.map(|axis| Axis { from, to, ..axis })
}

/// The rows of [`errors`] of which something is known.
pub fn known(charts: [[Chart; 3]; 3]) -> Vec<[Chart; 3]> {
    let is_known = |chart: &Chart| {
        let error = chart.curves.last();
        error.is_some_and(|curve| curve.points.iter().any(|point| point[1].is_finite()))
    };
    charts.into_iter().filter(|row| row.iter().any(is_known)).collect()
}

/// Whether a chart has theory's mean.
pub fn has_mean(chart: &Chart) -> bool {
    chart.curves.len() > 1
}

/// What lines and areas of [`errors`] mean, from a point to the right.
pub fn legend(canvas: &mut impl Canvas, [x, y]: Point, has_bands: bool) {
    let lettering = Lettering { size: 12.0, bold: false, anchor: Anchor::Start };
    let mut sample = |left: f32, text: &str, stroke: Option<Stroke>, opacity: f32| {
        let (left, right) = (x + left, x + left + 26.0);
        match stroke {
            Some(stroke) => canvas.line("", &[[left, y], [right, y]], Ink::Text, stroke),
            None => {
                let (top, bottom) = (y - 6.0, y + 6.0);
                let outline = [[left, top], [right, top], [right, bottom], [left, bottom]];
                canvas.area("", &outline, Ink::Text, opacity);
            }
        }
        canvas.text([right + 7.0, y + 4.0], text, Ink::Text, lettering);
    };
    sample(0.0, "error", Some(Stroke::solid(2.2)), 1.0);
    sample(84.0, "theory’s mean", Some(MEAN), 1.0);
    if has_bands {
        sample(220.0, "±1σ", None, 0.3);
        sample(294.0, "±3σ about it", None, 0.11);
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample;
    use super::*;

    #[test]
    fn bands_enclose_mean_by_their_width() {
        let flight = sample::flight();
        let charts = errors(&flight.overview);
        let down = &charts[0][2];
        assert_eq!(down.title, "Down position error, m");
        let [wide, narrow] = [&down.bands[0], &down.bands[1]];
        let i = flight.overview.len() / 2;
        let instant = &flight.overview[i];
        let (mean, sigma) = (instant.mean.position_m[2], instant.sigma.position_m[2]);
        assert_eq!(narrow.edges[i], [instant.time_s / 60.0, mean + sigma, mean - sigma]);
        assert_eq!(wide.edges[i][1..], [mean + 3.0 * sigma, mean - 3.0 * sigma]);
        for chart in charts.iter().flatten() {
            let inside = |y: f64| (chart.y.from..=chart.y.to).contains(&y);
            assert!(chart.curves.iter().flat_map(|c| &c.points).all(|p| inside(p[1])));
            assert!(
                chart.bands.iter().flat_map(|b| &b.edges).all(|e| inside(e[1]) && inside(e[2]))
            );
        }
    }

    #[test]
    fn perfect_sensors_have_no_bands_and_small_units() {
        let charts = errors(&sample::perfect().overview);
        assert!(charts.iter().flatten().all(|chart| chart.bands.is_empty()));
        assert_eq!(charts[0][0].title, "North position error, nm");
    }
}
