//! `report.html` and `drift.png` of a replay beside its reference.

use super::comparison::Comparison;
use super::fly::Flight;
use super::summary::About;
use super::table;
use crate::report::figures::Known;
use crate::report::sensors::Sensors;
use crate::report::table::{rows_of, unit_note};
use crate::report::traces::{NAUTICAL_MILE, Traces};
use crate::report::{figures, head, norm, plot};
use schuler_report::axis::printed;
use schuler_report::page::{self, panel};
use schuler_report::svg::escape;
use schuler_simulator::flight::Instant;
use schuler_simulator::number::{Quantity, parameter, rounded};
use schuler_simulator::scene::Algorithm;
use std::io;

/// The replay in one line.
fn heading(about: &About, flight: &Flight) -> String {
    let About { options, shape, spans, .. } = about;
    let window = match options.algorithm {
        Algorithm::Taylor => format!(" H{}B{}A{}", shape.history, shape.block, shape.lookahead),
        Algorithm::Textbook => String::new(),
    };
    format!(
        "{} to {} s at {} Hz · {} {}{window}, {} · vertical {}",
        parameter(spans.navigate_s),
        parameter(flight.last.0),
        parameter(about.rate_hz),
        options.precision.name(),
        options.algorithm.name(),
        options.frame.name(),
        options.vertical.name(),
    )
}

/// What charts show: time from the start of the flight.
fn charted(comparison: &Comparison, about: &About) -> Vec<Instant> {
    let from_start =
        |instant: &Instant| Instant { time_s: instant.time_s - about.spans.navigate_s, ..*instant };
    comparison.overview.iter().map(from_start).collect()
}

fn title(about: &About) -> String {
    format!("Replay of {}", about.imu)
}

/// The picture as a PNG.
pub fn png(flight: &Flight, comparison: &Comparison, about: &About) -> io::Result<Vec<u8>> {
    plot::sheet(&title(about), &heading(about, flight), &charted(comparison, about))
}

/// The same for documents.
pub fn svg(flight: &Flight, comparison: &Comparison, about: &About) -> String {
    plot::document(&title(about), &heading(about, flight), &charted(comparison, about))
}

/// The page. Traces and sensors are over the time from the start of the flight.
pub fn page(
    flight: &Flight,
    comparison: &Comparison,
    about: &About,
    (traces, sensors): (&Traces, &Sensors),
) -> String {
    let title = escape(&title(about));
    let charted = charted(comparison, about);
    let since = parameter(about.spans.navigate_s);
    let end_s = charted.last().map_or(0.0, |instant| instant.time_s);
    let end = figures::end(&comparison.last, comparison.sigma_m.map(Known::by_reference));
    let euler = match figures::euler(traces, end_s) {
        charts if charts.is_empty() => charts,
        charts => format!("<h2>Errors of roll, pitch and yaw</h2>\n{charts}"),
    };
    let body = format!(
        "<h1>{title}</h1>\n<p class=\"quiet\">{} · <code>{}</code></p>\n{}\
         <h2>Horizontal error</h2>\n{}\
         <h2>Drift: computed minus reference</h2>\n\
         <p class=\"quiet\">Over the time since {since} s of the recording. Attitude errors are rotations about \
         north, east and down. Drag to zoom, shift-drag to move, double-click to see the whole; a click on a name \
         hides it.</p>\n{}{euler}\
         <h2>The reference’s motion</h2>\n{}{}{}{}",
        escape(&heading(about, flight)),
        escape(&head::command_line()),
        headline(comparison, about),
        figures::horizontal(traces, end_s, Some(end)),
        figures::errors(&charted, traces, "time"),
        figures::motion(&charted, traces),
        figures::sensors(sensors, end_s),
        numbers(comparison),
        provenance(flight, comparison, about),
    );
    page::page(&format!("{title}: drift from its reference"), &body)
}

fn headline(comparison: &Comparison, about: &About) -> String {
    let Comparison { last, max, has, .. } = comparison;
    let card = |value: String, what: &str| (printed(&value), what.to_owned());
    let [north, east, _] = last.drift.position_m;
    let flown_s = last.time_s - about.spans.navigate_s;
    let per_hour = north.hypot(east) / NAUTICAL_MILE / (flown_s / 3600.0);
    let position = |metres: f64| Quantity::Position.show(metres);
    let mut cards = vec![
        card(position(norm(last.drift.position_m)), "position error at the end"),
        card(position(max.norms[0]), "largest position error"),
        card(format!("{} nmi/h", rounded(per_hour, 3)), "horizontal error over the time flown"),
    ];
    if has.velocity {
        let error = Quantity::Velocity.show(norm(last.drift.velocity_m_s));
        cards.push(card(error, "velocity error at the end"));
    }
    if has.attitude {
        let error = Quantity::Attitude.show(norm(last.drift.attitude_arcsec));
        cards.push(card(error, "attitude error at the end"));
    }
    let lines = [table::compared(comparison), table::lag(comparison)];
    let lines = lines.into_iter().chain(table::claimed(comparison));
    let lines: String = lines.map(|line| format!("<p>{}</p>\n", escape(&line))).collect();
    page::cards(&cards) + &lines
}

/// The terminal's table.
fn numbers(comparison: &Comparison) -> String {
    let columns = table::columns(comparison);
    let heads: Vec<String> = columns
        .iter()
        .map(|column| {
            let bars = if column.is_norm { "|" } else { "" };
            format!("{bars}{}{bars} {}", column.name, column.unit.name)
        })
        .collect();
    let heads: Vec<&str> = ["time s"].into_iter().chain(heads.iter().map(String::as_str)).collect();
    let row = |instant: &Instant| {
        let cells = columns.iter().map(|column| {
            let [error, ..] = column.cells(instant);
            printed(&error)
        });
        [table::time(instant)].into_iter().chain(cells).collect()
    };
    let rows = rows_of(&comparison.overview, &comparison.last);
    let rows: Vec<Vec<String>> = rows.into_iter().map(row).collect();
    format!(
        "<h2>In numbers</h2>\n{}<p class=\"quiet\">{}</p>\n",
        panel(&heads, &rows),
        unit_note(&columns).unwrap_or_default()
    )
}

fn provenance(flight: &Flight, comparison: &Comparison, about: &About) -> String {
    let row = |name: &str, value: String| vec![name.to_owned(), value];
    let bridged = flight.bridged;
    let rows = [
        row("recording", about.imu.to_owned()),
        row("reference", comparison.reference.clone()),
        row("samples", flight.samples.to_string()),
        row("missing, bridged", format!("{} in {} gaps", bridged.samples, bridged.gaps)),
        row("digest of every state", format!("{:016x}", flight.digest)),
        row("versions", head::versions()),
    ];
    format!("<h2>Origin</h2>\n{}", panel(&[], &rows))
}
