//! The result of a run, from which the summary and the report are made.

use crate::aided::report::Report;
use crate::alignment::outcome::Outcome;
use crate::high::Neglected;
pub use crate::nine::Nine;
use crate::scene::{Scene, WindowShape};
use crate::theory::Outside;
use schuler::solution::Solution;
use serde::Serialize;

/// One instant of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Instant {
    /// End of the sample, s.
    pub time_s: f64,
    /// Computed minus true.
    pub drift: Nine,
    /// What the linear error model expects of it on average; not a number where that has ended.
    pub mean: Nine,
    /// Its standard deviation by the linear error model.
    pub sigma: Nine,
    /// True latitude and longitude in degrees, altitude in m.
    pub position: [f64; 3],
    /// True roll, pitch, yaw, degrees.
    pub attitude_deg: [f64; 3],
    /// What was computed.
    pub computed: Solution<f64>,
    /// What is true.
    pub truth: Solution<f64>,
}

/// How a window was chosen.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Planned {
    /// Windows tried on parts of the flight.
    pub tried: usize,
    /// The largest position error that is expected of it in double precision, m.
    pub predicted_m: f64,
    /// What it may leave, as much as some roundings do: the cheapest window within this is flown, or else the
    /// best, m.
    pub most_m: f64,
}

/// Work that a run did not have to do.
#[derive(Clone, Debug, PartialEq)]
pub struct Skipped {
    /// What was skipped.
    pub what: String,
    /// Why it could be.
    pub why: String,
    /// What it saved, measured: for people, with its unit.
    pub saved: String,
}

/// Samples that a block was fitted through.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Used {
    /// Of the gyros.
    pub gyro: u32,
    /// Of the accelerometers.
    pub accelerometer: u32,
}

/// How long a window the samples supported where a window is one-sided.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Edges {
    /// In the first block; `None` where its window is like any other.
    pub first: Option<Used>,
    /// In the last such block; `None` where there was none.
    pub last: Option<Used>,
}

/// Extremes of the drift.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extremes {
    /// The largest magnitude of each component, over every sample.
    pub components: Nine,
    /// The largest norms of position (m), velocity (m/s), attitude (arcsec).
    pub norms: [f64; 3],
}

/// Nanoseconds per sample of each stage alone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StageTimes {
    /// Truth and perfect increments.
    pub trajectory_ns: f64,
    /// Sensor errors.
    pub emulate_ns: f64,
    /// Navigation at block ends, no row read.
    pub navigate_ns: f64,
}

/// A kind of fault that was put in on purpose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct FaultCount {
    /// Its name.
    pub fault: &'static str,
    /// In frames to the target.
    pub to_target: u64,
    /// In frames to the host.
    pub to_host: u64,
}

/// What faults are noticed by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct TraceCount {
    /// What it is.
    pub trace: &'static str,
    /// Faults put in that leave this trace, in frames to the target.
    pub injected_to_target: u64,
    /// In frames to the host.
    pub injected_to_host: u64,
    /// How often the target noticed it; absent where it cannot.
    pub noticed_by_target: Option<u64>,
    /// How often the host noticed it.
    pub noticed_by_host: u64,
}

impl TraceCount {
    /// Whether it was noticed as often as it was put in. The host alone notices what keeps it waiting.
    pub fn is_explained(&self) -> bool {
        match self.noticed_by_target {
            Some(by_target) => {
                by_target == self.injected_to_target
                    && self.noticed_by_host == self.injected_to_host
            }
            None => self.noticed_by_host == self.injected_to_target + self.injected_to_host,
        }
    }
}

/// What happened on the link to a target. No clock has a say in it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct LinkReport {
    /// What the target was.
    pub device: String,
    /// Frames sent to it.
    pub frames_sent: u64,
    /// Whole frames received from it.
    pub frames_received: u64,
    /// Pieces between two frames' ends that were no frame, at the target.
    pub broken_at_target: u64,
    /// The same at the host.
    pub broken_at_host: u64,
    /// Whole frames that no target of this version sends.
    pub not_understood: u64,
    /// Faults put in, by kind.
    pub faults: Vec<FaultCount>,
    /// What was noticed.
    pub traces: Vec<TraceCount>,
    /// Frames sent again, because no answer came.
    pub resent: u64,
    /// Requests that were answered in the end, though not at once.
    pub recovered: u64,
    /// Samples given up.
    pub lost: u64,
    /// Samples that the target bridged.
    pub bridged: u64,
    /// How often a request was sent until it was answered, at most.
    pub worst_round_trips: u32,
    /// The window that was planned, where the target does not have it.
    #[serde(with = "crate::scene::window")]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub planned_window: Option<WindowShape>,
}

/// Where a run ended that did not reach its end.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Ended {
    /// The sample that could not be flown, from 1.
    pub sample: u64,
    /// Its end, s.
    pub time_s: f64,
    /// Why it could not.
    pub reason: String,
    /// Samples that were to be flown.
    pub planned_samples: u64,
    /// Seconds that were to be flown.
    pub planned_duration_s: f64,
}

/// A finished run, or what was flown of one.
#[derive(Clone, Debug)]
pub struct Flight {
    /// The scene as flown, with every override applied.
    pub scene: Scene,
    /// Samples navigated.
    pub samples: u64,
    /// Where it ended, if early.
    pub ended: Option<Ended>,
    /// The window flown; `None` for textbook.
    pub window: Option<WindowShape>,
    /// How it was chosen.
    pub planned: Option<Planned>,
    /// How long the windows at the edges were; `None` for textbook.
    pub edges: Option<Edges>,
    /// What was skipped.
    pub skipped: Vec<Skipped>,
    /// Digest of every state, hex.
    pub digest: String,
    /// The last instant.
    pub last: Instant,
    /// Extremes over every sample.
    pub max: Extremes,
    /// Instants spread evenly over the run, first and last included, for curves (a few thousand).
    pub overview: Vec<Instant>,
    /// Instants of the first minute, for the enlarged view (at most a few thousand).
    pub first_minute: Vec<Instant>,
    /// What the series of gravity neglects at the height reached; absent below 20 km.
    pub neglected: Option<Neglected>,
    /// Samples in which a sensor was at its limit.
    pub saturated: u64,
    /// Samples lost on the way to the navigator, and filled in.
    pub lost: u64,
    /// What ended the linear error model before the last instant.
    pub outside: Option<Outside>,
    /// What happened on the link to a target; absent when there was none.
    pub link: Option<LinkReport>,
    /// The alignment that it began with, if any.
    pub aligned: Option<Outcome>,
    /// What became of the measurements that aided it, if any.
    pub aided: Option<Report>,
    /// What all measurements together say of it, with the standard deviation of that; none where it is not smoothed.
    pub smoothed: Vec<Instant>,
    /// Stage times; absent when not measured.
    pub time: Option<StageTimes>,
}

impl Flight {
    /// Takes theory away from a flight whose samples were not the scene's.
    pub fn forget_theory(&mut self) {
        self.outside = Some(Outside::Samples);
        let kept = self.overview.iter_mut().chain(&mut self.first_minute);
        for instant in kept.chain([&mut self.last]) {
            (instant.mean, instant.sigma) = (Nine::UNKNOWN, Nine::UNKNOWN);
        }
    }
}
