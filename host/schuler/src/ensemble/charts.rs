//! The charts of an ensemble: from its findings to axes, bands and curves.

use super::figures::{Measures, shares_of};
use super::findings::Findings;
use super::sentences::chi_square_interval;
use schuler_report::axis::Axis;
use schuler_report::canvas::{Ink, Stroke};
use schuler_report::chart::{Band, Chart, Curve};
use schuler_report::ellipse::outline;
use schuler_report::interactive::{Interactive, Scale, Width};
use schuler_report::layer::{Kind, Layer};
use schuler_simulator::ensemble::budget::Contribution;
use schuler_simulator::number::{Quantity, Unit};

const INKS: [Ink; 3] = [Ink::North, Ink::East, Ink::Down];
const DIRECTIONS: [&str; 3] = ["North", "East", "Down"];
const QUANTITIES: [(&str, Quantity); 3] = [
    ("position", Quantity::Position),
    ("velocity", Quantity::Velocity),
    ("attitude", Quantity::Attitude),
];
const RUNS: Stroke = Stroke::solid(1.8);
const THEORY: Stroke = Stroke { width: 1.4, dashed: true };
/// What is drawn beside circular and vertical errors.
const INTERVALS: [&str; 3] = ["CEP50, interval", "CEP95, interval", "vertical, interval"];
const THEORIES: [&str; 3] = ["CEP50, theory", "CEP95, theory", "vertical, theory"];
/// Dots of a scatter, at most.
const MOST_DOTS: usize = 2000;
/// Bars of a histogram: at least, at most.
const BARS: [f64; 2] = [8.0, 48.0];
/// Points of a smooth line.
const SMOOTH: usize = 96;

/// Where the runs end, east and north of the truth, with the ellipses of 50 % and 95 %: the runs' own and theory's; and
/// how many runs a dot stands for.
pub fn scatter(findings: &Findings) -> Option<(Interactive, usize)> {
    let (values, at) = (findings.end.as_ref()?, findings.instants.last()?);
    let each = values.numbers.len().div_ceil(MOST_DOTS).max(1);
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
    let square = |matrix: &super::spread::Matrix| [0, 1].map(|i| [0, 1].map(|j| matrix[i][j]));
    let spread = &at.spread;
    let own = ([spread.mean[0], spread.mean[1]], square(&spread.covariance));
    let end = findings.comparisons.len().saturating_sub(9);
    let expected = findings.comparisons.get(end..).unwrap_or_default();
    let mean = [0, 1].map(|i| expected.get(i).map_or(f64::NAN, |c| c.mean_theory));
    let theory = (mean, square(&at.covariance_theory));
    for (percent, share) in [(50, 0.5), (95, 0.95)] {
        let ellipse = |(mean, covariance)| outline(mean, covariance, share).map(place);
        let name = format!("{percent} % of the runs");
        chart = chart.with(Layer::line(&name, Ink::North, ellipse(own)));
        if mean[0].is_finite() {
            let name = format!("{percent} % by theory");
            chart = chart.with(Layer::dashes(&name, Ink::East, ellipse(theory)));
        }
    }
    Some((chart, each))
}

/// CEP50, CEP95 and the vertical error of 95 % over time, with their intervals; theory dashed.
pub fn accuracy(findings: &Findings) -> Chart {
    let instants = &findings.instants;
    let figures = |i: usize| {
        let a = &instants[i].accuracy;
        [a.cep50, a.cep95, a.vertical95]
    };
    let largest = (0..instants.len())
        .flat_map(figures)
        .map(|figure| figure.runs.interval.map_or(figure.runs.value, |[_, high]| high))
        .fold(0.0, f64::max);
    let Unit { name: unit, factor } = Quantity::Position.unit(largest);
    let (x, per_second) = Axis::time(instants.last().map_or(0.0, |at| at.time_s));
    let names = ["CEP50", "CEP95", "vertical 95 %"];
    let times = || instants.iter().map(|at| at.time_s * per_second).enumerate();
    let (mut bands, mut curves) = (Vec::new(), Vec::new());
    for (place, (name, ink)) in names.into_iter().zip(INKS).enumerate() {
        let edges = times().filter_map(|(i, t)| {
            let [low, high] = figures(i)[place].runs.interval?;
            Some([t, high * factor, low * factor])
        });
        bands.push(Band { name: INTERVALS[place], ink, opacity: 0.16, edges: edges.collect() });
        let theory = times().map(|(i, t)| [t, figures(i)[place].theory * factor]);
        let theory: Vec<_> = theory.filter(|point| point[1].is_finite()).collect();
        curves.push(Curve { name: THEORIES[place], ink, stroke: THEORY, points: theory });
        let runs = times().map(|(i, t)| [t, figures(i)[place].runs.value * factor]);
        curves.push(Curve { name, ink, stroke: RUNS, points: runs.collect() });
    }
    let values = curves.iter().flat_map(|curve| curve.points.iter().map(|p| p[1]));
    let edges = bands.iter().flat_map(|band| band.edges.iter().map(|e| e[1]));
    Chart {
        title: format!("Error about the truth, {unit}"),
        x,
        y: Axis::spanning(unit, values.chain(edges).chain([0.0]), false),
        is_map: false,
        bands,
        curves,
        marks: Vec::new(),
    }
}

/// The standard deviation of each of the nine over time with its interval of 95 %, beside theory's: a row for each
/// quantity.
pub fn sigma(findings: &Findings) -> [[Chart; 3]; 3] {
    let (x, per_second) = Axis::time(findings.instants.last().map_or(0.0, |at| at.time_s));
    let [low, high] = chi_square_interval(findings.ended as f64 - 1.0);
    let freedom = findings.ended as f64 - 1.0;
    let [upper, lower] = [low, high].map(|chi_square| (freedom / chi_square).sqrt());
    std::array::from_fn(|group| {
        let (quantity, of) = QUANTITIES[group];
        let own = |i: usize| {
            let of_it = findings.comparisons.iter().filter(move |c| c.component == i);
            of_it.map(|c| (c.time_s, c.sigma))
        };
        let theory = |i: usize| findings.drawn.iter().map(move |d| (d.time_s, d.sigma[i]));
        let all = (3 * group..3 * group + 3).flat_map(|i| own(i).chain(theory(i)));
        let Unit { name: unit, factor } = of.unit(all.map(|(_, sigma)| sigma).fold(0.0, f64::max));
        std::array::from_fn(|axis| {
            let (i, ink) = (3 * group + axis, INKS[axis]);
            let edges = own(i)
                .map(|(t, sigma)| [t * per_second, sigma * upper * factor, sigma * lower * factor]);
            let band = Band { name: "interval", ink, opacity: 0.2, edges: edges.collect() };
            let curve = |name, ink, stroke, points: Vec<(f64, f64)>| Curve {
                name,
                ink,
                stroke,
                points: points.iter().map(|(t, s)| [t * per_second, s * factor]).collect(),
            };
            let curves = vec![
                curve("theory", Ink::Text, THEORY, theory(i).collect()),
                curve("runs", ink, RUNS, own(i).collect()),
            ];
            let values = curves.iter().flat_map(|curve| curve.points.iter().map(|p| p[1]));
            let values: Vec<f64> = values.chain(band.edges.iter().map(|e| e[1])).collect();
            Chart {
                title: format!("{} {quantity}, σ, {unit}", DIRECTIONS[axis]),
                x: x.clone(),
                y: Axis::spanning(unit, values.into_iter().chain([0.0]), false),
                is_map: false,
                bands: vec![band],
                curves,
                marks: Vec::new(),
            }
        })
    })
}

/// The distribution of each of the nine at the end, beside theory's normal density: a row for each quantity.
pub fn histograms(findings: &Findings) -> Option<[[Chart; 3]; 3]> {
    let values = findings.end.as_ref()?;
    let end = findings.comparisons.len().saturating_sub(9);
    let compared = findings.comparisons.get(end..)?;
    Some(std::array::from_fn(|group| {
        std::array::from_fn(|axis| {
            let i = 3 * group + axis;
            let (quantity, of) = QUANTITIES[group];
            let x = values.component(i);
            let [least, greatest] = [f64::min, f64::max].map(|f| x.iter().copied().reduce(f));
            let (least, greatest) = (least.unwrap_or(0.0), greatest.unwrap_or(0.0));
            let Unit { name: unit, factor } = of.unit(least.abs().max(greatest.abs()));
            // 2∛n bars (Rice's rule).
            let bars = (2.0 * (x.len() as f64).cbrt()).clamp(BARS[0], BARS[1]).round();
            let width = ((greatest - least) / bars).max(f64::MIN_POSITIVE);
            let mut counts = vec![0u64; bars as usize];
            let last = counts.len() - 1;
            for x in &x {
                counts[(((x - least) / width) as usize).min(last)] += 1;
            }
            let density = |count: u64| count as f64 / (x.len() as f64 * width * factor);
            let edges = counts.iter().enumerate().flat_map(|(bar, &count)| {
                let from = least + bar as f64 * width;
                [from, from + width].map(|x| [x * factor, density(count), 0.0])
            });
            let edges: Vec<[f64; 3]> = edges.collect();
            let c = compared.get(i);
            let (mean, sigma) = c.map_or((f64::NAN, f64::NAN), |c| (c.mean_theory, c.sigma_theory));
            let normal = |x: f64| {
                let z = (x - mean) / sigma;
                (-0.5 * z * z).exp() / (sigma * factor * std::f64::consts::TAU.sqrt())
            };
            let scatters = c.is_some_and(|c| c.tests.is_some());
            let points = (0..=SMOOTH).map(|step| {
                let x = least + (greatest - least) * step as f64 / SMOOTH as f64;
                [x * factor, normal(x)]
            });
            let points: Vec<[f64; 2]> = if scatters { points.collect() } else { Vec::new() };
            let heights = edges.iter().map(|e| e[1]).chain(points.iter().map(|p| p[1]));
            Chart {
                title: format!("{} {quantity} at the end, density", DIRECTIONS[axis]),
                y: Axis::spanning("", heights.chain([0.0]), false),
                x: Axis::spanning(unit, [least * factor, greatest * factor], true),
                is_map: false,
                bands: vec![Band { name: "runs", ink: INKS[axis], opacity: 0.4, edges }],
                curves: vec![Curve { name: "theory", ink: Ink::Text, stroke: THEORY, points }],
                marks: Vec::new(),
            }
        })
    }))
}

/// The colour of a term in a stack, and how strong it is.
pub fn paint(term: usize) -> (Ink, f32) {
    (INKS[term % 3], [0.85, 0.45, 0.2][term / 3 % 3])
}

/// Each term's share of the mean square of the horizontal error over time, stacked: by theory, or by switching terms
/// off. The terms are in the order of `names`.
pub fn stack(findings: &Findings, names: &[&str], by_runs: bool) -> Option<Interactive> {
    let (x, per_second) = Axis::time(findings.instants.last()?.time_s);
    let of = |name: &&str| findings.budget.iter().find(|share| share.name == **name);
    let terms: Vec<&[Contribution]> = names
        .iter()
        .filter_map(of)
        .map(|share| if by_runs { share.runs.as_slice() } else { share.theory.as_slice() })
        .collect();
    let mut bands: Vec<Band> = (0..terms.len())
        .map(|term| {
            let (ink, opacity) = paint(term);
            Band { name: "", ink, opacity, edges: Vec::new() }
        })
        .collect();
    for (place, at) in findings.instants.iter().enumerate() {
        let size = |term: &&[Contribution]| {
            term.get(place).map_or(f64::NAN, |c| Measures::new(c).horizontal)
        };
        let shares = shares_of(&terms.iter().map(size).collect::<Vec<_>>());
        let mut below = 0.0;
        for (band, share) in bands.iter_mut().zip(shares) {
            let share = if share.is_nan() { 0.0 } else { 100.0 * share };
            band.edges.push([at.time_s * per_second, below + share, below]);
            below += share;
        }
    }
    let is_known = bands.last()?.edges.iter().any(|edge| edge[1] > 0.0);
    let by = if by_runs { "by switching off" } else { "by theory" };
    is_known.then(|| {
        let chart = Chart {
            title: format!("Shares of the horizontal error, %, {by}"),
            x,
            y: Axis { label: "%".to_owned(), from: 0.0, to: 100.0 },
            is_map: false,
            bands,
            curves: Vec::new(),
            marks: Vec::new(),
        };
        let mut chart = Interactive::of(chart).sharing("time").sized(Width::Half, 320);
        chart.y.range = Some([0.0, 100.0]);
        for (layer, name) in chart.layers.iter_mut().zip(names) {
            layer.name = (*name).to_owned();
        }
        chart
    })
}
