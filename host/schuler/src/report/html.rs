//! `report.html`: the run on one self-contained page that needs no network.

use super::sensors::Sensors;
use super::traces::{NAUTICAL_MILE, Traces};
use super::{
    ended, figures, head, heading, link_table, lockstep, norm, parameters, table, verdict,
};
use figures::Known;
use lockstep::Lockstep;
use schuler_report::axis::printed;
use schuler_report::page::{self, framed, panel};
use schuler_report::svg::escape;
use schuler_simulator::flight::Flight;
use schuler_simulator::number::{Quantity, parameter, rounded};

/// What a page shows besides the flight.
#[derive(Debug, Default)]
pub struct Shown {
    /// Every row of it.
    pub traces: Traces,
    /// What its sensors put out, where that is known.
    pub sensors: Option<Sensors>,
    /// The covariance of north and east that theory expects at the end, m².
    pub covariance_m2: Option<[[f64; 2]; 2]>,
    /// How target and twin went along with each other, where there is a target.
    pub lockstep: Option<Lockstep>,
}

/// The page.
pub fn page(flight: &Flight, shown: &Shown) -> String {
    let title = escape(&flight.scene.title);
    let end_s = flight.last.time_s;
    let sections = [
        horizontal(flight, shown),
        drift(flight, shown),
        figures::smoothed(&flight.smoothed),
        section("Errors of roll, pitch and yaw", &figures::euler(&shown.traces, end_s)),
        section("The flight", &figures::motion(&flight.overview, &shown.traces)),
        shown.sensors.as_ref().map_or(String::new(), |s| figures::sensors(s, end_s)),
        first_minute(flight),
        numbers(flight),
        link(flight, shown),
        skipped(flight),
        scene(flight),
        provenance(flight),
    ];
    let body = format!(
        "<h1>{title}</h1>\n<p class=\"quiet\">{} · <code>{}</code></p>\n{}{}{}{}",
        escape(&heading(flight)),
        escape(&head::command_line()),
        shown.lockstep.as_ref().map_or(String::new(), Lockstep::verdict),
        ended(flight).map_or(String::new(), |line| format!("<p><b>{}</b></p>\n", escape(&line))),
        headline(flight),
        sections.concat()
    );
    page::page(&format!("{title}: drift against theory"), &body)
}

/// The file's name.
pub const NAME: &str = "report.html";

fn section(heading: &str, content: &str) -> String {
    if content.is_empty() { String::new() } else { format!("<h2>{heading}</h2>\n{content}") }
}

fn headline(flight: &Flight) -> String {
    let last = &flight.last;
    let card = |value: String, what: &str| (printed(&value), what.to_owned());
    let [north, east, _] = last.drift.position_m;
    let per_hour = north.hypot(east) / NAUTICAL_MILE / (last.time_s / 3600.0);
    let mut cards = vec![
        card(Quantity::Position.show(norm(last.drift.position_m)), "position error at the end"),
        card(Quantity::Position.show(flight.max.norms[0]), "largest position error"),
        card(format!("{} nmi/h", rounded(per_hour, 3)), "horizontal error over the time flown"),
        card(Quantity::Velocity.show(norm(last.drift.velocity_m_s)), "velocity error at the end"),
        card(
            Quantity::Attitude.show(norm(last.drift.attitude_arcsec)),
            "attitude error at the end",
        ),
    ];
    if let Some(worst) =
        verdict::z_scores(last).into_iter().flatten().max_by(|a, b| a.abs().total_cmp(&b.abs()))
    {
        let what = "from theory’s mean: the farthest of north, east, down";
        cards.push(card(format!("{worst:+.2} σ"), what));
    }
    if let Some(time) = flight.time {
        let filter = flight.aided.as_ref().map_or("", |_| ", without the filter");
        let what = &format!("to navigate a sample{filter}");
        cards.push(card(format!("{:.0} ns", time.navigate_ns), what));
    }
    let [_, theory] = verdict::verdict(flight);
    format!("{}<p>{}</p>\n", page::cards(&cards), printed(&escape(&theory)))
}

fn horizontal(flight: &Flight, shown: &Shown) -> String {
    let end = figures::end(
        &flight.last,
        shown.covariance_m2.map(|covariance| Known::by_theory(&flight.last, covariance)),
    );
    let content = figures::horizontal(&shown.traces, flight.last.time_s, Some(end));
    section("Horizontal error", &content)
}

fn drift(flight: &Flight, shown: &Shown) -> String {
    let note = "Attitude errors are rotations about north, east and down. Drag to zoom, shift-drag to move, double-click \
                to see the whole; a click on a name hides it.";
    let figures = figures::errors(&flight.overview, &shown.traces, "time");
    format!("<h2>Drift: computed minus true</h2>\n<p class=\"quiet\">{note}</p>\n{figures}")
}

fn first_minute(flight: &Flight) -> String {
    let end_s = flight.first_minute.last().map_or(0.0, |instant| instant.time_s);
    if end_s >= flight.last.time_s {
        return String::new();
    }
    let traces = Traces::of(&flight.first_minute);
    section("The first minute", &figures::errors(&flight.first_minute, &traces, "minute"))
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
        "<h2>In numbers</h2>\n{}<p class=\"quiet\">|velocity| and |attitude| are norms: of the error, of theory’s mean, and \
         of its standard deviations (the root of the covariance’s trace). {}</p>\n",
        framed(&format!(
            "<table class=\"numbers\">\n<tr><th>time</th>{heads}</tr>\n<tr><th>s</th>{below}</tr>\n{rows}</table>"
        )),
        table::unit_note(&columns).unwrap_or_default()
    )
}

fn link(flight: &Flight, shown: &Shown) -> String {
    let Some(link) = &flight.link else { return String::new() };
    let charts = shown.lockstep.as_ref().map_or(String::new(), Lockstep::charts);
    let faults = match link_table::faults(link) {
        faults if faults.is_empty() => String::new(),
        faults => panel(&["put in", "out", "back"], &faults),
    };
    format!(
        "<h2>The link to the target</h2>\n<p>{}</p>\n{charts}<div class=\"panels\">\n{}{faults}</div>\n",
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

    fn shown(flight: &Flight) -> Shown {
        Shown {
            traces: Traces::of(&flight.overview),
            sensors: Some(Sensors::of(flight, 0).expect("a scene")),
            covariance_m2: Some([[400.0, 30.0], [30.0, 100.0]]),
            lockstep: None,
        }
    }

    #[test]
    fn stands_alone() {
        let page = page(&sample::flight(), &shown(&sample::flight()));
        // An address in a comment is no request: the library's own, and names of XML.
        for outside in
            ["src=\"", "href=\"", "url(\"", "url(h", "@import", "//cdn", "fetch(", "import("]
        {
            assert!(!page.contains(outside), "{outside}");
        }
    }

    #[test]
    fn holds_what_a_report_should() {
        let flight = sample::flight();
        let shown = shown(&flight);
        let page = page(&flight, &shown);
        // The horizontal error, drift, angles, the flight, sensors with their errors, the first minute.
        assert_eq!(page.matches("<figure").count(), 3 + 9 + 3 + 5 + 12 + 9);
        assert_eq!(page.matches("\"name\":\"±3σ\"").count(), 18);
        assert!(page.len() < 900_000, "{}", page.len());
        for part in [
            "The paper&#39;s flight",
            "Ground tracks",
            "True height above the ellipsoid, m",
            "True roll, °",
            "nmi/h",
            "95 % by theory",
            "Gyro x error, °/h",
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
    fn every_figure_is_closed_and_holds_json() {
        for flight in [sample::flight(), sample::perfect(), sample::scaled(1e9)] {
            let page = page(&flight, &shown(&flight));
            for figure in page.split("<figure").skip(1) {
                let figure = &figure[..figure.find("</figure>").expect("closed")];
                let (_, json) = figure.split_once("application/json\">").expect("numbers");
                let json = json.strip_suffix("</script>").expect("closed");
                let tree: serde_json::Value = serde_json::from_str(json).expect(json);
                assert!(!tree["layers"].as_array().expect("layers").is_empty());
            }
        }
    }

    #[test]
    fn a_run_within_a_minute_is_not_shown_twice() {
        let mut flight = sample::flight();
        flight.overview = flight.first_minute.clone();
        flight.last = *flight.overview.last().unwrap();
        assert!(!page(&flight, &Shown::default()).contains("The first minute"));
    }

    #[test]
    fn names_cannot_become_markup() {
        let mut flight = sample::flight();
        flight.scene.title = "<script>alert(1)</script>".to_owned();
        flight.scene.name = "<b>".to_owned();
        flight.skipped[0].what = "<i>".to_owned();
        let page = page(&flight, &shown(&flight));
        assert_eq!(page.matches("<script>").count(), 2);
        assert!(!page.contains("<i>") && !page.contains("<b> ·"));
    }
}
