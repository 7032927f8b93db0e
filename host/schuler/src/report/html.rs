//! `report.html`: the run on one self-contained page that needs no network.

use super::{ended, figures, head, heading, link_table, norm, parameters, table};
use schuler_report::axis::printed;
use schuler_report::page::{self, panel};
use schuler_report::svg::escape;
use schuler_simulator::flight::Flight;
use schuler_simulator::number::{Quantity, parameter};

/// The page.
pub fn page(flight: &Flight) -> String {
    let title = escape(&flight.scene.title);
    let sections = [
        drift(flight),
        motion(flight),
        first_minute(flight),
        numbers(flight),
        link(flight),
        skipped(flight),
        scene(flight),
        provenance(flight),
    ];
    let body = format!(
        "<h1>{title}</h1>\n<p class=\"quiet\">{}</p>\n{}{}{}",
        escape(&heading(flight)),
        ended(flight).map_or(String::new(), |line| format!("<p><b>{}</b></p>\n", escape(&line))),
        headline(flight),
        sections.concat()
    );
    page::page(&format!("{title}: drift against theory"), &body)
}

/// The file's name.
pub const NAME: &str = "report.html";

fn headline(flight: &Flight) -> String {
    let last = &flight.last;
    let card = |value: String, what: &str| {
        format!("<div class=\"card\"><b>{}</b><span>{what}</span></div>\n", printed(&value))
    };
    let mut cards = vec![
        card(Quantity::Position.show(norm(last.drift.position_m)), "position error at the end"),
        card(Quantity::Position.show(flight.max.norms[0]), "largest position error"),
        card(Quantity::Velocity.show(norm(last.drift.velocity_m_s)), "velocity error at the end"),
        card(
            Quantity::Attitude.show(norm(last.drift.attitude_arcsec)),
            "attitude error at the end",
        ),
    ];
    if let Some(worst) =
        table::z_scores(last).into_iter().flatten().max_by(|a, b| a.abs().total_cmp(&b.abs()))
    {
        let what = "from theory’s mean: the farthest of north, east, down";
        cards.push(card(format!("{worst:+.2} σ"), what));
    }
    if let Some(time) = flight.time {
        cards.push(card(format!("{:.0} ns", time.navigate_ns), "to navigate a sample"));
    }
    let [_, theory] = table::verdict(flight);
    format!(
        "<div class=\"cards\">\n{}</div>\n<p>{}</p>\n",
        cards.concat(),
        printed(&escape(&theory))
    )
}

fn drift(flight: &Flight) -> String {
    let note = "Attitude errors are rotations about north, east and down.";
    let figures = figures::errors(&flight.overview);
    format!("<h2>Drift: computed minus true</h2>\n<p class=\"quiet\">{note}</p>\n{figures}")
}

fn first_minute(flight: &Flight) -> String {
    let end_s = flight.first_minute.last().map_or(0.0, |instant| instant.time_s);
    if end_s >= flight.last.time_s {
        return String::new();
    }
    format!("<h2>The first minute</h2>\n{}", figures::errors(&flight.first_minute))
}

fn motion(flight: &Flight) -> String {
    format!("<h2>The flight</h2>\n{}", figures::motion(&flight.overview))
}

/// The terminal's drift table.
fn numbers(flight: &Flight) -> String {
    let columns = table::columns(flight);
    let heads: String = columns
        .iter()
        .map(|c| {
            let bars = if c.is_norm { "|" } else { "" };
            let name = c.name;
            format!("<th class=\"group\" colspan=\"3\">{bars}{name}{bars} {}</th>", c.unit.name)
        })
        .collect();
    let below = "<th>error</th><th>mean</th><th>1σ</th>".repeat(columns.len());
    let rows: String = table::rows(flight)
        .into_iter()
        .map(|instant| {
            let cells = columns.iter().flat_map(|column| column.cells(instant));
            let cells: String = cells.map(|c| format!("<td>{}</td>", printed(&c))).collect();
            format!("<tr><td>{}</td>{cells}</tr>\n", parameter(instant.time_s))
        })
        .collect();
    format!(
        "<h2>In numbers</h2>\n<div class=\"panel\"><table class=\"numbers\">\n\
         <tr><th>time</th>{heads}</tr>\n<tr><th>s</th>{below}</tr>\n{rows}</table></div>\n\
         <p class=\"quiet\">|velocity| and |attitude| are norms: of the error, of theory’s mean, and \
         of its standard deviations (the root of the covariance’s trace). {}</p>\n",
        table::unit_note(&columns).unwrap_or_default()
    )
}

fn link(flight: &Flight) -> String {
    let Some(link) = &flight.link else { return String::new() };
    let faults = match link_table::faults(link) {
        faults if faults.is_empty() => String::new(),
        faults => panel(&["put in", "out", "back"], &faults),
    };
    format!(
        "<h2>The link to the target</h2>\n<p>{}</p>\n<div class=\"panels\">\n{}{faults}</div>\n",
        escape(&link_table::sentence(link)),
        panel(&link_table::TRACES, &link_table::traces(link))
    )
}

fn skipped(flight: &Flight) -> String {
    let rows: Vec<_> = flight
        .skipped
        .iter()
        .map(|s| vec![s.what.clone(), s.why.clone(), s.saved.clone()])
        .collect();
    let content = match rows.is_empty() {
        true => {
            "<p>Nothing: the scene needed all of it, or skipping was turned off.</p>\n".to_owned()
        }
        false => panel(&["what", "why", "saved"], &rows),
    };
    format!("<h2>What was skipped</h2>\n{content}")
}

fn scene(flight: &Flight) -> String {
    let scene = &flight.scene;
    let sensors = parameters::sensors(scene);
    let sensors = match sensors.is_empty() {
        true => "<p>The sensors are perfect.</p>\n".to_owned(),
        false => panel(&["sensor error", "gyro", "accelerometer"], &sensors),
    };
    format!(
        "<h2>The scene</h2>\n{sensors}<div class=\"panels\">\n{}{}</div>\n",
        panel(&["channel", "truth"], &parameters::trajectory(scene)),
        panel(&["navigation", ""], &parameters::navigation(scene))
    )
}

fn provenance(flight: &Flight) -> String {
    let row = |name: &str, value: String| vec![name.to_owned(), value];
    let mut rows = vec![
        row("seed", flight.scene.seed.to_string()),
        row("samples", flight.samples.to_string()),
        row("saturated, lost", format!("{}, {}", flight.saturated, flight.lost)),
    ];
    if let Some(time) = flight.time {
        let [trajectory, emulate, navigate] =
            [time.trajectory_ns, time.emulate_ns, time.navigate_ns].map(|ns| format!("{ns:.0} ns"));
        let value = format!("{trajectory} truth, {emulate} sensor errors, {navigate} navigation");
        rows.push(row("time per sample", value));
    }
    rows.push(row("versions", head::versions()));
    let digest = format!("<p>Digest of every state: <code>{}</code></p>\n", escape(&flight.digest));
    format!("<h2>Seed, versions, digest</h2>\n{}{digest}", panel(&[], &rows))
}

#[cfg(test)]
mod tests {
    use super::super::sample;
    use super::*;

    #[test]
    fn stands_alone() {
        let page = page(&sample::flight());
        for outside in ["http:", "https:", "src=", "href=", "url(", "@import", "//cdn"] {
            assert!(!page.contains(outside), "{outside}");
        }
    }

    #[test]
    fn holds_what_a_report_should() {
        let flight = sample::flight();
        let page = page(&flight);
        assert_eq!(page.matches("<figure").count(), 9 + 5 + 9);
        assert_eq!(page.matches("data-name=\"+3σ\"").count(), 18);
        for path in page.split(" d=\"").skip(1) {
            let points = path.split('"').next().unwrap().matches('L').count() + 1;
            // A band's outline has two edges.
            assert!(points <= 2 * 1500, "{points}");
        }
        for part in [
            "The paper&#39;s flight",
            "Ground track",
            "Height above the ellipsoid",
            "Roll, °",
            "The first minute",
            "What was skipped",
            "31 ns per sample",
            "0.1 °/h rms, 720 s",
            "45° + 5° cos(2πt/7200 s)",
            &flight.digest,
            concat!("schuler ", env!("CARGO_PKG_VERSION")),
        ] {
            assert!(page.contains(part), "{part}");
        }
        let version = env!("SCHULER_LIBM_VERSION");
        assert!(version.split('.').count() == 3, "{version}");
    }

    #[test]
    fn every_figure_is_closed_and_finite() {
        for flight in [sample::flight(), sample::perfect(), sample::scaled(1e9)] {
            let page = page(&flight);
            for figure in page.split("<figure").skip(1) {
                let svg = &figure[..figure.find("</figure>").expect("closed")];
                assert!(!svg.contains("NaN") && !svg.contains("inf"), "{}", &svg[..300]);
            }
        }
    }

    #[test]
    fn a_run_within_a_minute_is_not_shown_twice() {
        let mut flight = sample::flight();
        flight.overview = flight.first_minute.clone();
        flight.last = *flight.overview.last().unwrap();
        assert!(!page(&flight).contains("The first minute"));
    }

    #[test]
    fn names_cannot_become_markup() {
        let mut flight = sample::flight();
        flight.scene.title = "<script>alert(1)</script>".to_owned();
        flight.scene.name = "<b>".to_owned();
        flight.skipped[0].what = "<i>".to_owned();
        let page = page(&flight);
        assert_eq!(page.matches("<script>").count(), 1);
        assert!(!page.contains("<i>") && !page.contains("<b> ·"));
    }
}
