//! A flight in words.

use super::fidelity::{fidelity, misfit};
use crate::report::parameters::made_from;
use schuler::earth::Geodetic;
use schuler_simulator::course::Path;
use schuler_simulator::number::{self, Quantity};
use schuler_simulator::portrait::{Extremes, Portrait};
use schuler_simulator::scene::Scene;
use schuler_simulator::scene::route::{Origin, Route};
use schuler_simulator::units::DEGREE;
use std::fmt::Write as _;

/// Everything about it, a line each.
pub fn describe(scene: &Scene, portrait: &Portrait) -> String {
    let mut text = format!("{}: {}\n", scene.name, scene.title);
    let mut line = |name: &str, value: String| {
        // A String takes all that is written.
        let _ = writeln!(text, "{name:17} {value}");
    };
    line("duration", format!("{} s", number::parameter(scene.duration_s)));
    line("length", length(portrait.length_m));
    line("from", place(&portrait.start));
    line("to", place(&portrait.end));
    line("speed", range(&portrait.speed, 1.0, " m/s"));
    line("vertical speed", range(&portrait.climb, 1.0, " m/s"));
    line("height", range(&portrait.altitude, 1.0, " m"));
    line("acceleration", range(&portrait.acceleration, 1.0, " m/s²"));
    line("load factor", range(&portrait.load, 1.0, " g"));
    line("bank", range(&portrait.roll, DEGREE, "°"));
    line("pitch", range(&portrait.pitch, DEGREE, "°"));
    for (name, rate) in ["roll rate", "pitch rate", "yaw rate"].into_iter().zip(&portrait.rates) {
        line(name, range(rate, DEGREE, "°/s"));
    }
    if let (Some(path), Some(route)) = (&scene.trajectory.path, &scene.trajectory.route) {
        line("path", pieces(path, route));
        if route.attitude == "coordinated" && scene.trajectory.mounting == Default::default() {
            line(
                "lateral force",
                format!("at most {} m/s²", number::short(portrait.lateral.size())),
            );
        }
        for (name, value) in asked(path, route) {
            line(name, value);
        }
    }
    text
}

/// What was asked for, and how well it is done.
fn asked(path: &Path, route: &Route) -> Vec<(&'static str, String)> {
    let metres = |value: f64| Quantity::Position.show(value);
    let mut lines = Vec::new();
    // They were compiled before, so that they can be followed.
    if let Some(Ok(off)) = route.from.manoeuvres().map(|flown| fidelity(path, flown)) {
        lines.push(("fidelity", format!("{} off the manoeuvres at most", metres(off))));
    }
    match &route.from {
        Origin::Segments(_) => {}
        Origin::Waypoints { points, past } => {
            let off = metres(misfit(path, points));
            let name = if past.is_some() { "passes by at" } else { "misfit" };
            lines.push((name, format!("{off} at most of {} way-points", points.len())));
        }
        Origin::Log { outcome, .. } => {
            let parts = [
                ("smoothed level", outcome.horizontal),
                ("smoothed height", outcome.vertical),
                ("smoothed angles", outcome.attitude),
            ];
            for (name, smoothing) in parts {
                if let Some(smoothing) = smoothing {
                    let over = number::short(smoothing.time_constant_s);
                    let limit = if smoothing.at_limit {
                        ", as smooth as its rows allow: they scatter less than stated"
                    } else {
                        ""
                    };
                    lines.push((name, format!("with a time constant of {over} s{limit}")));
                }
            }
        }
    }
    lines
}

fn pieces(path: &Path, route: &Route) -> String {
    let attitude = match route.attitude {
        "log" => "attitude of the log".to_owned(),
        other => format!("{other} attitude"),
    };
    format!("{}, {attitude}", made_from(path, route))
}

fn range(of: &Extremes, unit: f64, symbol: &str) -> String {
    // What rounds to nothing is nothing, with no sign.
    let [least, most] = [of.least, of.most].map(|x| {
        let value = x / unit;
        if value.abs() < 5e-5 { "0".to_owned() } else { number::short(value) }
    });
    if least == most { format!("{least}{symbol}") } else { format!("{least} to {most}{symbol}") }
}

fn length(metres: f64) -> String {
    if metres < 10_000.0 {
        format!("{} m", number::short(metres))
    } else {
        format!("{:.3} km", metres / 1000.0)
    }
}

fn place(at: &Geodetic<f64>) -> String {
    let [latitude, longitude] = [at.latitude, at.longitude].map(|angle| angle / DEGREE);
    let longitude = longitude - 360.0 * (longitude / 360.0).round();
    format!("{latitude:.6}°, {longitude:.6}°, {:.2} m", at.altitude)
}
