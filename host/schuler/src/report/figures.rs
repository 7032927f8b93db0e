//! Charts as parts of an HTML page.

use super::sensors::Sensors;
use super::traces::{ATTITUDE, EULER, FLOWN_S, HEIGHT, HORIZONTAL, RATE, Traces};
use super::{drift_charts, motion_charts};
use schuler_report::axis::Axis;
use schuler_report::canvas::Ink;
use schuler_report::ellipse::outline;
use schuler_report::interactive::{Interactive, Scale, Width};
use schuler_report::layer::{Kind, Layer};
use schuler_simulator::flight::Instant;
use schuler_simulator::number::{Quantity, Unit};

const INKS: [Ink; 3] = [Ink::North, Ink::East, Ink::Down];
const ANGLES: [&str; 3] = ["Roll", "Pitch", "Yaw"];
/// Points of a curve that theory draws, about: it is smooth.
const SMOOTH: usize = 300;

/// Charts in rows of three.
pub fn grid(charts: impl IntoIterator<Item = Interactive>) -> String {
    let figures: String = charts.into_iter().map(|chart| chart.html()).collect();
    if figures.is_empty() { figures } else { format!("<div class=\"charts\">\n{figures}</div>\n") }
}

/// The scale of time up to an end, s, and how many of its units make a second.
pub fn time(end_s: f64) -> (Scale, f64) {
    let (axis, per_second) = Axis::time(end_s);
    (Scale::new("time", axis.label.trim_start_matches("time, ")), per_second)
}

/// Errors in rows of three, each on a scale of its own; charts of the same cursor move together.
pub fn errors(instants: &[Instant], traces: &Traces, cursor: &'static str) -> String {
    let smooth = thinned(instants);
    let per_second = time(super::end_s(instants)).1;
    let rows = drift_charts::errors(&smooth).into_iter().enumerate();
    let charts = rows.flat_map(|(group, row)| {
        let unit = drift_charts::unit(&smooth, group);
        row.into_iter().enumerate().map(move |(axis, chart)| (3 * group + axis, unit, chart))
    });
    grid(charts.filter(|(series, ..)| traces.all.is_known(*series)).map(
        |(series, unit, mut chart)| {
            chart.curves.retain(|curve| curve.name != "error");
            let layer = trace(traces, series, "error", INKS[series % 3], (per_second, unit.factor));
            Interactive::of(chart).with(layer).sharing(cursor)
        },
    ))
}

/// What all measurements together say of a flight, with its heading; nothing where it is not smoothed.
pub fn smoothed(instants: &[Instant]) -> String {
    let figures = errors(instants, &Traces::of(instants), "time");
    if figures.is_empty() {
        return figures;
    }
    format!(
        "<h2>Smoothed</h2>\n<p class=\"quiet\">What all measurements, also later ones, say of each instant, less the truth, with \
         the standard deviation that the smoother claims.</p>\n{figures}"
    )
}

/// Some of the instants, the last included.
fn thinned(instants: &[Instant]) -> Vec<Instant> {
    let each = instants.len().div_ceil(SMOOTH).max(1);
    let last = instants.len().saturating_sub(1);
    let kept = instants.iter().enumerate().filter(|(i, _)| i % each == 0 || *i == last);
    kept.map(|(_, instant)| *instant).collect()
}

fn trace(traces: &Traces, series: usize, name: &str, ink: Ink, factors: (f64, f64)) -> Layer {
    let (per_second, factor) = factors;
    let edges = traces.all.edges(series);
    let points = edges.map(|[t, high, low]| [t * per_second, high * factor, low * factor]);
    Layer::new(name, ink, Kind::Envelope, points.collect())
}

/// A chart of one series, in the unit that suits it.
fn single(
    traces: &Traces,
    series: usize,
    title: &str,
    unit: Unit,
    ink: Ink,
    time: &(Scale, f64),
) -> Interactive {
    Interactive::new(&format!("{title}, {}", unit.name), time.0.clone(), Scale::new("", unit.name))
        .with(trace(traces, series, title, ink, (time.1, unit.factor)))
        .sharing("time")
}

/// The horizontal error, in metres and in nautical miles an hour, and theory's ellipse about its end.
pub fn horizontal(traces: &Traces, end_s: f64, end: Option<Interactive>) -> String {
    let time = time(end_s);
    let largest = traces.all.extremes(HORIZONTAL)[1];
    let unit = Quantity::Position.unit(largest);
    let mut distance = single(traces, HORIZONTAL, "Horizontal error", unit, Ink::North, &time);
    distance.y.zero = true;
    let per_hour = Unit { name: "nmi/h", factor: 1.0 };
    let mut rate = single(traces, RATE, "Horizontal error over time", per_hour, Ink::East, &time);
    rate.y.zero = true;
    // At the first time that it means something it is one point.
    let rate = (end_s >= 2.0 * FLOWN_S && traces.all.is_known(RATE)).then_some(rate);
    grid([distance].into_iter().chain(rate).chain(end))
}

/// What is known of a flight's end: a distribution north and east of the truth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known {
    /// Its mean, m.
    pub mean_m: [f64; 2],
    /// Its covariance, m².
    pub covariance_m2: [[f64; 2]; 2],
    /// The names of the ellipses of 95 % and 50 %.
    pub names: [&'static str; 2],
}

impl Known {
    /// What theory expects at an instant.
    pub fn by_theory(last: &Instant, covariance_m2: [[f64; 2]; 2]) -> Self {
        let [north, east, _] = last.mean.position_m;
        let names = ["95 % by theory", "50 % by theory"];
        Self { mean_m: [north, east], covariance_m2, names }
    }

    /// What a reference says of itself: σ north and east.
    pub fn by_reference([north, east]: [f64; 2]) -> Self {
        let names = ["95 % by the reference’s σ", "50 % by the reference’s σ"];
        let covariance_m2 = [[north * north, 0.0], [0.0, east * east]];
        Self { mean_m: [0.0; 2], covariance_m2, names }
    }
}

/// Where a flight ends, east and north of the truth, with the ellipses of 50 % and 95 %, where they are known.
pub fn end(last: &Instant, known: Option<Known>) -> Interactive {
    let [north, east, _] = last.drift.position_m;
    let is_one = |c: &[[f64; 2]; 2]| c.iter().flatten().all(|x| x.is_finite()) && c[0][0] > 0.0;
    let known = known.filter(|known| is_one(&known.covariance_m2));
    let names = known.map_or([""; 2], |known| known.names);
    let outlines = known.map(|known| {
        [0.95, 0.5].map(|share| outline(known.mean_m, known.covariance_m2, share).collect())
    });
    let outlines: Vec<Vec<[f64; 2]>> = outlines.into_iter().flatten().collect();
    let all = outlines.iter().flatten().flatten().chain([&north, &east]);
    let Unit { name, factor } = Quantity::Position.unit(super::largest(all.copied()));
    let place = |&[north, east]: &[f64; 2]| [east * factor, north * factor];
    let mut chart = Interactive::new(
        &format!("The end about the truth: north, {name}"),
        Scale::new("east", name),
        Scale::new("north", name),
    );
    chart.is_map = true;
    for (outline, name) in outlines.iter().zip(names) {
        chart = chart.with(Layer::dashes(name, Ink::Text, outline.iter().map(place)));
    }
    let truth = Layer::dots("truth", Ink::Down, 4.0, [[0.0; 2]]);
    let computed = Layer::dots("computed", Ink::East, 4.0, [place(&[north, east])]);
    chart.with(truth).with(computed)
}

/// The errors of roll, pitch and yaw.
pub fn euler(traces: &Traces, end_s: f64) -> String {
    let time = time(end_s);
    let known = (0..3).filter(|axis| traces.all.is_known(EULER + axis));
    grid(known.map(|axis| {
        let largest = super::largest(traces.all.extremes(EULER + axis));
        let (title, unit) = (format!("{} error", ANGLES[axis]), Quantity::Attitude.unit(largest));
        single(traces, EULER + axis, &title, unit, INKS[axis], &time)
    }))
}

/// The tracks and the height, and the attitude below them.
pub fn motion(instants: &[Instant], traces: &Traces) -> String {
    let time = time(super::end_s(instants));
    let track = Interactive::of(motion_charts::ground_track(instants));
    let metres = Unit { name: "m", factor: 1.0 };
    let degrees = Unit { name: "°", factor: 1.0 };
    let title = "True height above the ellipsoid";
    let height = single(traces, HEIGHT, title, metres, Ink::Down, &time)
        .sized(Width::TwoThirds, track.height);
    let known = (0..3).filter(|axis| traces.all.is_known(ATTITUDE + axis));
    let attitude = known.map(|axis| {
        let title = format!("True {}", ANGLES[axis].to_lowercase());
        single(traces, ATTITUDE + axis, &title, degrees, INKS[axis], &time)
    });
    grid([track, height].into_iter().chain(attitude))
}

/// What the sensors put out, under a heading each for that and for their errors.
pub fn sensors(sensors: &Sensors, end_s: f64) -> String {
    let (scale, per_second) = time(end_s);
    let [output, error] = sensors.charts((&scale, per_second));
    let section = |heading: &str, charts: Vec<Interactive>| match charts.is_empty() {
        true => String::new(),
        false => format!("<h2>{heading}</h2>\n{}", grid(charts)),
    };
    section("What the sensors put out", output) + &section("Their errors as emulated", error)
}
