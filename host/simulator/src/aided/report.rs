//! What became of a run's measurements.

use crate::quadratic::by_chance;
use schuler::aiding::aided::measured::{Kind, Sensor};
use schuler::aiding::aided::tally::Transport;
use serde::Serialize;

/// A measurement that was judged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judgement {
    /// When it was true, s.
    pub time_s: f64,
    /// What was measured.
    pub kind: Kind,
    /// How old it was, s.
    pub age_s: f64,
    /// Σ y²/α.
    pub nis: f64,
    /// The largest NIS that was accepted.
    pub limit: f64,
    /// Whether it was taken.
    pub accepted: bool,
    /// Whether it completed a lockout.
    pub locked_out: bool,
}

/// A sensor's measurements.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Count {
    /// What it is.
    pub sensor: &'static str,
    /// Vectors taken.
    pub accepted: u64,
    /// Vectors refused.
    pub refused: u64,
    /// Lockouts.
    pub lockouts: u64,
    /// Components of the vectors taken since the heading was found.
    pub degrees: u64,
    /// Σ NIS of them.
    pub nis: f64,
}

impl Count {
    /// Σ NIS by what it should be, and where 95 % of such sums lie; `None` without measurements.
    pub fn consistency(&self) -> Option<(f64, [f64; 2])> {
        let freedom = self.degrees as f64;
        (self.degrees > 0).then(|| (self.nis / freedom, by_chance(freedom)))
    }
}

/// What became of the measurements of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Report {
    /// By sensor; those without measurements are not there.
    pub sensors: Vec<Count>,
    /// Measurements that came again.
    pub again: u64,
    /// Measurements older than what is remembered, or than the horizon.
    pub late: u64,
    /// Measurements for which there was no room.
    pub dropped: u64,
    /// When lockouts were, s.
    pub lockouts_s: Vec<f64>,
    /// When the filter started again to look for the heading, s.
    pub restarts_s: Vec<f64>,
    /// What a smoother made of it, if there was one and the truth is known.
    pub smoothed: Option<Compared>,
}

/// Smoothed states beside the filter's, over all steps since the filter last started.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Compared {
    /// From and to, s.
    pub span_s: [f64; 2],
    /// How many.
    pub states: usize,
    /// Their error of position, and that of the filter's, m (root of the mean square).
    pub position_m: [f64; 2],
    /// Their standard deviation of position, north, east and down together: in the mean, and the largest, m.
    pub sigma_m: [f64; 2],
    /// Their error of velocity, m/s, and of attitude, rad.
    pub velocity_m_s: f64,
    /// See there.
    pub attitude_rad: f64,
    /// Mean of eᵀP⁻¹e of the position, by its three degrees of freedom: 1 is expected.
    pub nees: f64,
}

/// What a sensor is called.
pub fn name(sensor: Sensor) -> &'static str {
    match sensor {
        Sensor::Gnss => "gnss",
        Sensor::Barometer => "barometer",
        Sensor::Odometer => "odometer",
        Sensor::ZeroVelocity => "zero velocity",
        Sensor::NonHolonomic => "non-holonomic",
    }
}

impl Report {
    /// The same with times on a clock that shows so many seconds at the start.
    pub fn since(self, start_s: f64) -> Self {
        let on = |times: Vec<f64>| times.into_iter().map(|time_s| start_s + time_s).collect();
        Self { lockouts_s: on(self.lockouts_s), restarts_s: on(self.restarts_s), ..self }
    }

    /// Of all that was judged.
    pub fn new(
        judged: &[Judgement],
        restarts_s: &[f64],
        lockouts: [u32; 5],
        transport: Transport,
    ) -> Self {
        let settled_s = restarts_s.last().copied().unwrap_or(f64::NEG_INFINITY);
        let sensors = Sensor::ALL.into_iter().zip(lockouts).filter_map(|(sensor, lockouts)| {
            let lockouts = lockouts.into();
            let mut count = Count { sensor: name(sensor), lockouts, ..Count::default() };
            for one in judged.iter().filter(|one| one.kind.sensor() == sensor) {
                if one.accepted {
                    count.accepted += 1;
                    // While a heading is looked for, what is accepted need not fit.
                    if one.time_s > settled_s {
                        count.degrees += u64::from(one.kind.degrees());
                        count.nis += one.nis;
                    }
                } else {
                    count.refused += 1;
                }
            }
            (count.accepted + count.refused > 0).then_some(count)
        });
        let locked = judged.iter().filter(|one| one.locked_out).map(|one| one.time_s);
        Self {
            sensors: sensors.collect(),
            again: transport.again.into(),
            late: transport.late.into(),
            dropped: transport.dropped.into(),
            lockouts_s: locked.collect(),
            restarts_s: restarts_s.to_vec(),
            smoothed: None,
        }
    }
}
