//! `summary.json`: a run in numbers, for programs.

use super::head::{Head, Navigated};
use super::{Lockstep, Nine, norm};
use schuler_simulator::aided::report::Report;
use schuler_simulator::flight::{Edges, Ended, Flight, LinkReport, Planned};
use schuler_simulator::high::Neglected;
use serde::Serialize;

#[derive(Serialize)]
struct Summary<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    scene: &'a str,
    scene_sha256: &'a str,
    samples: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    ended: Option<&'a Ended>,
    duration_s: f64,
    rate_hz: f64,
    seed: u64,
    #[serde(flatten)]
    navigated: Navigated,
    gap: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    planned: Option<Planned>,
    edges: Option<Edges>,
    skipped: Vec<Skipped<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    gravity_neglected: Option<Neglected>,
    saturated: u64,
    lost: u64,
    digest: &'a str,
    error: Error,
    theory: Theory,
    time: Option<Time>,
    #[serde(skip_serializing_if = "Option::is_none")]
    measurements: Option<&'a Report>,
    #[serde(skip_serializing_if = "Option::is_none")]
    link: Option<&'a LinkReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    lockstep: Option<&'a Lockstep>,
}

#[derive(Serialize)]
struct Skipped<'a> {
    what: &'a str,
    why: &'a str,
    saved: &'a str,
}

#[derive(Serialize)]
struct Error {
    r#final: Components,
    max: Components,
}

#[derive(Serialize)]
struct Theory {
    final_mean: Components,
    final_sigma: Components,
}

/// Signed or largest components; the other three are norms.
#[derive(Serialize)]
pub struct Components {
    north_m: f64,
    east_m: f64,
    down_m: f64,
    position_m: f64,
    velocity_m_s: f64,
    attitude_arcsec: f64,
}

#[derive(Serialize)]
struct Time {
    trajectory_ns_per_sample: f64,
    emulate_ns_per_sample: f64,
    navigate_ns_per_sample: f64,
}

impl Components {
    /// Of components and norms.
    pub fn new(nine: &Nine, [position_m, velocity_m_s, attitude_arcsec]: [f64; 3]) -> Self {
        let [north_m, east_m, down_m] = nine.position_m;
        Self { north_m, east_m, down_m, position_m, velocity_m_s, attitude_arcsec }
    }

    /// Of standard deviations the norm is the root of the covariance's trace.
    pub fn with_norms(nine: &Nine) -> Self {
        let norms = [nine.position_m, nine.velocity_m_s, nine.attitude_arcsec].map(norm);
        Self::new(nine, norms)
    }
}

impl<'a> Summary<'a> {
    fn new(flight: &'a Flight, files: &'a [&'a str], lockstep: Option<&'a Lockstep>) -> Self {
        let scene = &flight.scene;
        Self {
            head: Head::new(if flight.link.is_some() { "hil" } else { "run" }, files),
            scene: &scene.name,
            scene_sha256: &scene.text_sha256,
            samples: flight.samples,
            ended: flight.ended.as_ref(),
            duration_s: if flight.ended.is_some() { flight.last.time_s } else { scene.duration_s },
            rate_hz: scene.rate_hz,
            seed: scene.seed,
            navigated: Navigated::new(&scene.navigator, flight.window),
            gap: scene.navigator.gap.name(),
            planned: flight.planned,
            edges: flight.edges,
            skipped: flight
                .skipped
                .iter()
                .map(|s| Skipped { what: &s.what, why: &s.why, saved: &s.saved })
                .collect(),
            gravity_neglected: flight.neglected,
            saturated: flight.saturated,
            lost: flight.lost,
            digest: &flight.digest,
            error: Error {
                r#final: Components::with_norms(&flight.last.drift),
                max: Components::new(&flight.max.components, flight.max.norms),
            },
            theory: Theory {
                final_mean: Components::with_norms(&flight.last.mean),
                final_sigma: Components::with_norms(&flight.last.sigma),
            },
            measurements: flight.aided.as_ref(),
            link: flight.link.as_ref(),
            lockstep,
            time: flight.time.map(|time| Time {
                trajectory_ns_per_sample: time.trajectory_ns,
                emulate_ns_per_sample: time.emulate_ns,
                navigate_ns_per_sample: time.navigate_ns,
            }),
        }
    }
}

/// The summary as JSON, which names the files that belong together. Numbers round-trip; one that is not
/// finite becomes `null`.
pub fn json(flight: &Flight, files: &[&str], lockstep: Option<&Lockstep>) -> String {
    text(&Summary::new(flight, files, lockstep))
}

/// Any summary as JSON.
pub fn text(summary: &impl Serialize) -> String {
    let mut text =
        serde_json::to_string_pretty(summary).expect("strings and numbers have a JSON form");
    text.push('\n');
    text
}

/// The file's name.
pub const NAME: &str = "summary.json";

#[cfg(test)]
mod tests {
    use super::super::sample;
    use super::*;
    use serde_json::Value;

    fn at<'a>(tree: &'a Value, path: &str) -> &'a Value {
        path.split('.').fold(tree, |node, key| &node[key])
    }

    #[test]
    fn has_every_key() {
        let tree: Value = serde_json::from_str(&json(&sample::flight(), &[NAME], None)).unwrap();
        let plain = "schema_version kind version command files scene_sha256 vertical gap scene samples duration_s rate_hz seed precision frame algorithm window.history \
                     window.block window.lookahead edges.first.gyro edges.first.accelerometer \
                     edges.last.gyro edges.last.accelerometer skipped saturated lost digest \
                     time.trajectory_ns_per_sample time.emulate_ns_per_sample time.navigate_ns_per_sample";
        let components = "north_m east_m down_m position_m velocity_m_s attitude_arcsec";
        let mut keys: Vec<String> = plain.split_whitespace().map(str::to_owned).collect();
        for group in ["error.final", "error.max", "theory.final_mean", "theory.final_sigma"] {
            keys.extend(components.split_whitespace().map(|key| format!("{group}.{key}")));
        }
        for key in keys {
            assert!(!at(&tree, &key).is_null(), "{key}");
        }
        for key in ["what", "why", "saved"] {
            assert!(tree["skipped"][0][key].is_string(), "{key}");
        }
    }

    #[test]
    fn numbers_round_trip_and_norms_are_norms() {
        let flight = sample::flight();
        let tree: Value = serde_json::from_str(&json(&flight, &[NAME], None)).unwrap();
        let number = |path| at(&tree, path).as_f64().unwrap();
        let last = &flight.last;
        assert_eq!(number("error.final.north_m").to_bits(), last.drift.position_m[0].to_bits());
        assert_eq!(number("error.final.down_m").to_bits(), last.drift.position_m[2].to_bits());
        let [n, e, d] = last.drift.velocity_m_s;
        assert!((number("error.final.velocity_m_s") - n.hypot(e).hypot(d)).abs() < 1e-12);
        let trace: f64 = last.sigma.attitude_arcsec.iter().map(|s| s * s).sum();
        assert!(
            (number("theory.final_sigma.attitude_arcsec").powi(2) - trace).abs() < 1e-9 * trace
        );
        assert_eq!(number("error.max.position_m"), flight.max.norms[0]);
        assert!(number("error.final.north_m") < 0.0 && number("error.max.north_m") > 0.0);
        assert_eq!(number("error.max.east_m"), flight.max.components.position_m[1]);
    }

    #[test]
    fn a_flight_that_ended_early_says_where_and_why() {
        let mut flight = sample::flight();
        let whole: Value = serde_json::from_str(&json(&flight, &[NAME], None)).unwrap();
        assert_eq!(whole.get("ended"), None);
        let reason = "sample 36001 at 1800.05 s: it is lost".to_owned();
        flight.ended = Some(Ended {
            sample: 36_001,
            time_s: 1800.05,
            reason: reason.clone(),
            planned_samples: 40_000,
            planned_duration_s: 2000.0,
        });
        flight.scene.duration_s = 2000.0;
        let tree: Value = serde_json::from_str(&json(&flight, &[NAME], None)).unwrap();
        assert_eq!(at(&tree, "ended.sample"), 36_001);
        assert_eq!(at(&tree, "ended.reason"), &Value::from(reason));
        assert_eq!(at(&tree, "ended.planned_duration_s"), 2000.0);
        assert_eq!((&tree["samples"], &tree["duration_s"]), (&36_000.into(), &1800.0.into()));
    }

    #[test]
    fn what_is_absent_is_null() {
        let mut flight = sample::flight();
        (flight.window, flight.time) = (None, None);
        flight.last.drift.position_m[0] = f64::NAN;
        let tree: Value = serde_json::from_str(&json(&flight, &[NAME], None)).unwrap();
        for key in ["window", "time", "error.final.north_m"] {
            assert!(at(&tree, key).is_null(), "{key}");
        }
    }
}
