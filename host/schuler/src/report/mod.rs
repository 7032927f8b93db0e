//! The output of a finished run: the drift table, `summary.json`, `drift.csv`, `drift.png`
//! and `report.html`.
//!
//! Every row goes through [`traces`] and [`drift_csv`]; [`sensors`] draws the samples once more. [`drift_charts`] and
//! [`motion_charts`] say what is drawn of it on paper, [`figures`] what is drawn in the page, [`html`] what stands around it;
//! the crate `schuler_report` draws it. [`lockstep`] is the part of a flight with a target.

pub mod drift_charts;
pub mod drift_csv;
pub mod every;
pub mod figures;
pub mod files;
pub mod head;
pub mod html;
pub mod link_table;
pub mod lockstep;
pub mod messages;
pub mod motion_charts;
pub mod parameters;
pub mod plot;
pub mod rows;
#[cfg(test)]
mod sample;
pub mod sensors;
pub mod summary;
pub mod table;
pub mod thinned;
pub mod traces;
pub mod verdict;

use schuler_simulator::flight::{Flight, Instant, Nine};

pub use drift_csv::DriftCsv;
pub use files::{FlightFiles, Wanted};
pub use lockstep::Lockstep;
pub use table::table;

/// The time of the last instant, s; 0 of none.
fn end_s(instants: &[Instant]) -> f64 {
    instants.last().map_or(0.0, |instant| instant.time_s)
}

/// That a flight did not reach its end, and why, in a line.
fn ended(flight: &Flight) -> Option<String> {
    flight.ended.as_ref().map(|ended| {
        let [flown_s, planned_s] = [flight.last.time_s, ended.planned_duration_s]
            .map(schuler_simulator::number::parameter);
        format!("Ended early, after {flown_s} s of {planned_s} s: {}", ended.reason)
    })
}

/// How the window was chosen, in a line.
pub fn planned(flight: &Flight) -> String {
    match (flight.window, flight.planned) {
        (Some(window), Some(planned)) if flight.scene.navigator.window.is_none() => format!(
            "window {window}: of {} tried on parts of the flight, expected to leave {} m where \
             rounding may leave {} m\n",
            planned.tried,
            short(planned.predicted_m),
            short(planned.most_m)
        ),
        _ => String::new(),
    }
}

/// Two digits.
fn short(x: f64) -> String {
    format!("{x:.1e}")
}

/// The run in one line: scene, length, navigator, seed.
fn heading(flight: &Flight) -> String {
    let scene = &flight.scene;
    let navigator = &scene.navigator;
    let window = flight.window.map(|w| format!(" H{}B{}A{}", w.history, w.block, w.lookahead));
    format!(
        "{} · {} s at {} Hz · {} {}{}, {} · seed {}",
        scene.name,
        schuler_simulator::number::parameter(flight.last.time_s),
        schuler_simulator::number::parameter(scene.rate_hz),
        navigator.precision.name(),
        navigator.algorithm.name(),
        window.unwrap_or_default(),
        navigator.frame.name(),
        scene.seed
    )
}

/// The length of a vector of any size.
pub fn norm(vector: [f64; 3]) -> f64 {
    // Scaled, so that no square under- or overflows.
    let scale = largest(vector);
    if scale == 0.0 || !scale.is_finite() {
        return vector.iter().map(|x| x.abs()).sum();
    }
    scale * vector.iter().map(|x| (x / scale).powi(2)).sum::<f64>().sqrt()
}

/// The largest magnitude; 0 of none.
fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().map(f64::abs).fold(0.0, f64::max)
}
