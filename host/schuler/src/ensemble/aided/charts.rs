//! The charts of aided runs: errors beside what filters say, and NEES.

use super::findings::Findings;
use schuler_report::axis::Axis;
use schuler_report::canvas::{Ink, Stroke};
use schuler_report::chart::{Band, Chart, Curve};
use schuler_report::ellipse::outline;
use schuler_report::interactive::{Interactive, Scale, Width};
use schuler_report::layer::{Kind, Layer};
use schuler_simulator::aided::runs::{GROUPS, Together};
use schuler_simulator::number::{Quantity, Unit};
use schuler_simulator::quadratic::by_chance;
use schuler_simulator::units::ARCSECOND;

const INKS: [Ink; 3] = [Ink::North, Ink::East, Ink::Down];
const DIRECTIONS: [&str; 3] = ["North", "East", "Down"];
const QUANTITIES: [(&str, Quantity, f64); 3] = [
    ("position", Quantity::Position, 1.0),
    ("velocity", Quantity::Velocity, 1.0),
    ("attitude", Quantity::Attitude, 1.0 / ARCSECOND),
];
const RUNS: Stroke = Stroke::solid(1.8);
const CLAIMED: Stroke = Stroke { width: 1.4, dashed: true };
/// Dots of a scatter, at most.
const MOST_DOTS: usize = 2000;

/// The rms of each of the nine over time beside the σ that the filters say, with the band in which 95 % of such rms
/// lie: a row for each quantity.
pub fn errors(instants: &[Together], ended: u64) -> [[Chart; 3]; 3] {
    let (x, per_second) = Axis::time(instants.last().map_or(0.0, |at| at.time_s));
    let [low, high] = by_chance(ended as f64).map(f64::sqrt);
    std::array::from_fn(|group| {
        let (quantity, of, unit) = QUANTITIES[group];
        let all = instants
            .iter()
            .flat_map(|at| (3 * group..3 * group + 3).flat_map(|i| [at.rms[i], at.sigma[i]]));
        let Unit { name, factor } = of.unit(all.map(|x| x * unit).fold(0.0, f64::max));
        let factor = factor * unit;
        std::array::from_fn(|axis| {
            let (i, ink) = (3 * group + axis, INKS[axis]);
            let points = |value: &dyn Fn(usize) -> f64| -> Vec<[f64; 2]> {
                let times = instants.iter().enumerate();
                times.map(|(k, at)| [at.time_s * per_second, value(k) * factor]).collect()
            };
            let (rms, sigma) = (points(&|k| instants[k].rms[i]), points(&|k| instants[k].sigma[i]));
            let edges: Vec<[f64; 3]> = sigma.iter().map(|[t, s]| [*t, s * high, s * low]).collect();
            let values = rms.iter().map(|p| p[1]).chain(edges.iter().map(|e| e[1]));
            let y = Axis::spanning(name, values.chain([0.0]), false);
            Chart {
                title: format!("{} {quantity}, {name}", DIRECTIONS[axis]),
                x: x.clone(),
                y,
                is_map: false,
                bands: vec![Band { name: "95 % of such rms", ink, opacity: 0.2, edges }],
                curves: vec![
                    Curve { name: "σ said", ink: Ink::Text, stroke: CLAIMED, points: sigma },
                    Curve { name: "rms", ink, stroke: RUNS, points: rms },
                ],
                marks: Vec::new(),
            }
        })
    })
}

/// NEES of each group over time, with the band of 95 %.
pub fn nees(findings: &Findings) -> Vec<Interactive> {
    let instants = &findings.instants;
    let (x, per_second) = Axis::time(instants.last().map_or(0.0, |at| at.time_s));
    let inks = [Ink::North, Ink::North, Ink::East, Ink::Down];
    let chart = |(group, name): (usize, &&str)| {
        let point = |value: f64, at: f64| [at * per_second, value];
        let points: Vec<_> = instants
            .iter()
            .map(|at| point(at.nees[group], at.time_s))
            .filter(|p| p[1].is_finite())
            .collect();
        let edges: Vec<[f64; 3]> = instants
            .iter()
            .map(|at| [at.time_s * per_second, at.expected[group][1], at.expected[group][0]])
            .collect();
        let values = points.iter().map(|p| p[1]).chain(edges.iter().map(|e| e[1]));
        let y = Axis::spanning("", values.chain([0.0]), false);
        let ink = inks[group];
        let chart = Chart {
            title: format!("NEES of {name}"),
            x: x.clone(),
            y,
            is_map: false,
            bands: vec![Band { name: "95 %", ink, opacity: 0.2, edges }],
            curves: vec![Curve { name: "runs", ink, stroke: RUNS, points }],
            marks: Vec::new(),
        };
        Interactive::of(chart).sharing("time").sized(Width::Half, 220)
    };
    GROUPS.iter().enumerate().map(chart).collect()
}

/// Where the runs end, east and north of the truth, with the ellipses of 50 % and 95 % that their spread gives; and how
/// many runs a dot stands for.
pub fn scatter(findings: &Findings) -> Option<(Interactive, usize)> {
    let values = findings.values.last()?;
    let n = values.numbers.len();
    let each = n.div_ceil(MOST_DOTS).max(1);
    let largest = values.numbers.iter().map(|x| x[0].hypot(x[1])).fold(0.0, f64::max);
    let Unit { name: unit, factor } = Quantity::Position.unit(largest);
    let place = |[north, east]: [f64; 2]| [east * factor, north * factor];
    let dots = values.numbers.iter().step_by(each).map(|x| place([x[0], x[1]]));
    let kind = Kind::Dots { radius: 1.6, ring: false, opacity: 0.55 };
    let dots = Layer { kind, ..Layer::line("runs", Ink::Muted, dots) };
    let title = format!("Where runs end: north, {unit}");
    let (east, north) = (Scale::new("east", unit), Scale::new("north", unit));
    let mut chart = Interactive::new(&title, east, north).with(dots);
    (chart.is_map, chart.height) = (true, 400);
    if n > 2 {
        let mean = |value: &dyn Fn(&[f64; 9]) -> f64| {
            values.numbers.iter().map(value).sum::<f64>() / n as f64
        };
        let centre = [0, 1].map(|i| mean(&|x| x[i]));
        let covariance =
            [0, 1].map(|i| [0, 1].map(|j| mean(&|x| (x[i] - centre[i]) * (x[j] - centre[j]))));
        for (percent, share) in [(50, 0.5), (95, 0.95)] {
            let name = format!("{percent} % of the runs");
            let ellipse = outline(centre, covariance, share).map(place);
            chart = chart.with(Layer::line(&name, Ink::North, ellipse));
        }
    }
    Some((chart, each))
}
