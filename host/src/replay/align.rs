//! Level and north from a stretch at rest, and what that stretch was like.

use crate::input::{Complaint, InputError};
use crate::recording::Kind;
use crate::recording::navigation::NavigationRow;
use crate::recording::samples::Sample;
use crate::units::{DEGREE, DEGREE_PER_HOUR};
use schuler::alignment::{Alignment, AlignmentError};
use schuler::math::vector::Vector;
use schuler::sample::{Increment, Rates};

/// A stretch at rest: sums, and their scatter from second to second.
#[derive(Clone, Debug)]
pub struct Still {
    /// What the recording's rows hold, by its header.
    pub kind: Kind,
    /// Samples that were there.
    pub samples: u64,
    /// Samples that were missing.
    pub lost: u64,
    /// Length of those that were there, s.
    pub time_s: f64,
    /// Means over whole seconds.
    pub seconds: Scatter,
    alignment: Alignment<f64>,
    /// The second under way.
    second: Increment<f64>,
    second_s: f64,
}

/// Mean and scatter of means over a second: of angular rate (rad/s) and specific force (m/s²).
#[derive(Clone, Copy, Debug, Default)]
pub struct Scatter {
    /// How many seconds.
    pub count: u64,
    /// Their mean.
    pub mean: Rates<f64>,
    /// Sums of squares of what each axis is off the mean.
    squares: [Vector<f64>; 2],
}

impl Scatter {
    fn add(&mut self, rates: Rates<f64>) {
        self.count += 1;
        let part = 1.0 / self.count as f64;
        let grown = |mean: &mut Vector<f64>, squares: &mut Vector<f64>, value: Vector<f64>| {
            let off = value - *mean;
            *mean = *mean + off * part;
            let still_off = value - *mean;
            *squares = *squares
                + Vector::new(off.x * still_off.x, off.y * still_off.y, off.z * still_off.z);
        };
        let Self { mean, squares: [rate, force], .. } = self;
        grown(&mut mean.rate_ib_b, rate, rates.rate_ib_b);
        grown(&mut mean.specific_force_b, force, rates.specific_force_b);
    }

    /// Standard deviation from second to second of rate (rad/s) and force (m/s²), axis by axis; none from
    /// fewer than two.
    pub fn deviation(&self) -> Option<Rates<f64>> {
        let freedom = self.count.checked_sub(1).filter(|&freedom| freedom > 0)? as f64;
        let [rate, force] = self.squares.map(|sum| sum.map(|square| (square / freedom).sqrt()));
        Some(Rates { rate_ib_b: rate, specific_force_b: force })
    }
}

impl Still {
    /// Of no samples.
    pub fn new(kind: Kind) -> Self {
        Self {
            kind,
            samples: 0,
            lost: 0,
            time_s: 0.0,
            seconds: Scatter::default(),
            alignment: Alignment::default(),
            second: Increment::ZERO,
            second_s: 0.0,
        }
    }

    /// Takes a sample; one that is filled from its neighbours only counts as lost.
    pub fn add(&mut self, sample: &Sample) {
        if sample.filled {
            self.lost += 1;
            return;
        }
        self.samples += 1;
        self.time_s += sample.interval_s;
        self.alignment.add(&sample.increment);
        self.second.angle_b = self.second.angle_b + sample.increment.angle_b;
        self.second.velocity_b = self.second.velocity_b + sample.increment.velocity_b;
        self.second_s += sample.interval_s;
        if self.second_s >= 1.0 - 0.5 * sample.interval_s {
            let per_second = 1.0 / self.second_s;
            self.seconds.add(Rates {
                rate_ib_b: self.second.angle_b * per_second,
                specific_force_b: self.second.velocity_b * per_second,
            });
            (self.second, self.second_s) = (Increment::ZERO, 0.0);
        }
    }

    /// Mean angular rate (rad/s) and specific force (m/s²).
    pub fn mean(&self) -> Rates<f64> {
        let (rate_ib_b, specific_force_b) =
            self.alignment.mean(self.time_s / self.samples.max(1) as f64);
        Rates { rate_ib_b, specific_force_b }
    }

    /// The state at its end, at rest: attitude from the stretch, all else as it was given.
    pub fn state(&self, file: &str, initial: &NavigationRow) -> Result<NavigationRow, InputError> {
        let attitude = self.alignment.attitude().map_err(|error: AlignmentError| {
            InputError::file(file, Complaint::new(error.to_string(), ""))
        })?;
        Ok(NavigationRow { attitude, velocity_ned: Vector::ZERO, ..*initial })
    }

    /// What was found, for people.
    pub fn said(&self, state: &NavigationRow) -> String {
        let mean = self.mean();
        let attitude = state.attitude;
        let [roll, pitch, yaw] = [attitude.roll, attitude.pitch, attitude.yaw].map(|a| a / DEGREE);
        let lost = if self.lost > 0 { format!(", {} missing", self.lost) } else { String::new() };
        format!(
            "aligned on {} samples{lost}: roll {roll:.4}°, pitch {pitch:.4}°, heading {:.4}°\n\
             mean rate {:.3} °/h, mean specific force {:.6} m/s²\n",
            self.samples,
            yaw.rem_euclid(360.0),
            mean.rate_ib_b.norm() / DEGREE_PER_HOUR,
            mean.specific_force_b.norm()
        )
    }
}
