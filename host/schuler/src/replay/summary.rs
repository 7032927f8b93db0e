//! `summary.json` of a replay.

use super::comparison::Comparison;
use super::fly::{Bridged, Flight};
use super::spans::Spans;
use crate::report::head::{Head, Navigated};
use crate::report::summary::Components;
use schuler_simulator::aided::report::Report;
use schuler_simulator::high::Neglected;
use schuler_simulator::scene::{Algorithm, Navigator, WindowShape};
use serde::Serialize;

/// A replay in numbers.
#[derive(Serialize)]
struct Summary<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    imu: &'a str,
    reference: &'a str,
    start_s: f64,
    end_s: f64,
    samples: u64,
    duration_s: f64,
    rate_hz: f64,
    #[serde(flatten)]
    navigated: Navigated,
    gap: &'static str,
    bridged: Gaps,
    #[serde(skip_serializing_if = "Option::is_none")]
    gravity_neglected: Option<Neglected>,
    digest: String,
    compared: Compared,
    error: Error,
    /// What an aided flight's filter says of the last error.
    #[serde(skip_serializing_if = "Option::is_none")]
    claimed: Option<Components>,
    #[serde(skip_serializing_if = "Option::is_none")]
    measurements: Option<&'a Report>,
}

#[derive(Serialize)]
struct Gaps {
    gaps: u64,
    samples: u64,
    time_s: f64,
}

#[derive(Serialize)]
struct Compared {
    rows: u64,
    outside: u64,
    velocity: bool,
    attitude: bool,
    lag_s: f64,
    estimated_lag_s: Option<f64>,
    estimated_lag_sigma_s: Option<f64>,
}

#[derive(Serialize)]
struct Error {
    r#final: Components,
    max: Components,
}

/// What is told besides the flight.
pub struct About<'a> {
    /// The stream.
    pub imu: &'a str,
    /// Samples per second.
    pub rate_hz: f64,
    /// How it was navigated.
    pub options: &'a Navigator,
    /// The window.
    pub shape: WindowShape,
    /// The spans of the recording.
    pub spans: &'a Spans,
}

/// The summary as JSON, which names the files that belong together.
pub fn json(flight: &Flight, comparison: &Comparison, about: &About, files: &[&str]) -> String {
    let About { imu, rate_hz, options, shape, spans } = *about;
    let Bridged { gaps, samples, time_s, .. } = flight.bridged;
    let summary = Summary {
        head: Head::new("replay", files),
        imu,
        reference: &comparison.reference,
        start_s: spans.navigate_s,
        end_s: flight.last.0,
        samples: flight.samples,
        duration_s: flight.last.0 - spans.navigate_s,
        rate_hz,
        navigated: Navigated::new(
            options,
            (options.algorithm == Algorithm::Taylor).then_some(shape),
        ),
        gap: options.gap.name(),
        bridged: Gaps { gaps, samples, time_s },
        gravity_neglected: flight.neglected,
        digest: format!("{:016x}", flight.digest),
        compared: Compared {
            rows: comparison.rows,
            outside: comparison.outside,
            velocity: comparison.has.velocity,
            attitude: comparison.has.attitude,
            lag_s: comparison.lag_s,
            estimated_lag_s: comparison.estimated.map(|lag| lag.lag_s),
            estimated_lag_sigma_s: comparison.estimated.map(|lag| lag.sigma_s),
        },
        error: Error {
            r#final: Components::with_norms(&comparison.last.drift),
            max: Components::new(&comparison.max.components, comparison.max.norms),
        },
        claimed: flight
            .measurements
            .as_ref()
            .map(|_| Components::with_norms(&comparison.last.sigma)),
        measurements: flight.measurements.as_ref(),
    };
    crate::report::summary::text(&summary)
}
