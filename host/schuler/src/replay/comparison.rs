//! A replay beside its reference: the drift at the reference's own times.

use crate::cli;
use schuler_simulator::flight::{Extremes, Instant, Nine};
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::recording::lag::{self, Lag};
use schuler_simulator::recording::reference::Reference;
use schuler_simulator::recording::track::Track;
use schuler_simulator::simulate::{Log, compared};

/// What came of it.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The reference's name.
    pub reference: String,
    /// Whether it has velocities and attitudes.
    pub has: Has,
    /// Names of its columns that were not compared.
    pub others: Vec<String>,
    /// How late its stamps were taken to be, s.
    pub lag_s: f64,
    /// How late they seem to be; none where the motion does not tell.
    pub estimated: Option<Lag>,
    /// Its rows that were compared.
    pub rows: u64,
    /// Its rows that are outside what was flown.
    pub outside: u64,
    /// Standard deviations of the reference's position at the last of them, north and east, m, where they are told.
    pub sigma_m: Option<[f64; 2]>,
    /// The last instant.
    pub last: Instant,
    /// Extremes over all rows.
    pub max: Extremes,
    /// Instants spread evenly over all.
    pub overview: Vec<Instant>,
}

/// What a reference has besides positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Has {
    /// Velocities.
    pub velocity: bool,
    /// Attitudes.
    pub attitude: bool,
}

impl Has {
    /// Which of the nine numbers are known.
    pub fn numbers(self) -> impl Iterator<Item = usize> {
        (0..9).filter(move |i| [true, self.velocity, self.attitude][i / 3])
    }
}

/// Refuses a reference that has no row within a flight, s.
pub fn check(reference: &Reference, from_s: f64, to_s: f64) -> Result<(), InputError> {
    let times = || reference.rows.iter().map(|(time_s, _)| *time_s);
    if times().any(|time_s| (from_s..=to_s).contains(&time_s)) {
        return Ok(());
    }
    let (first_s, last_s) = (times().next().unwrap_or(0.0), times().next_back().unwrap_or(0.0));
    let what = format!(
        "has no row from {from_s} to {to_s} s, which is flown: its own are from {first_s} to {last_s} s"
    );
    Err(InputError::option("--reference", Complaint::new(what, "the recording's own time")))
}

/// Compares a track with a reference, whose every row that is compared is shown to `observe`.
pub fn compare(
    track: &Track,
    reference: &Reference,
    asked: cli::Lag,
    observe: &mut dyn FnMut(&Instant) -> Result<(), InputError>,
) -> Result<Comparison, InputError> {
    let estimated = lag::of(track, reference);
    let lag_s = match (asked, estimated) {
        (cli::Lag::Seconds(lag_s), _) => lag_s,
        (cli::Lag::Auto, Some(lag)) => lag.lag_s,
        (cli::Lag::Auto, None) => {
            let what = "the motion does not tell how late the reference's stamps are";
            return Err(InputError::option("--lag", Complaint::new(what, "seconds")));
        }
    };
    let mut log = Log::new(reference.rows.len() as u64, 1.0);
    let (mut rows, mut outside, mut sigma_m) = (0, 0, None);
    for (place, (time_s, truth)) in reference.rows.iter().enumerate() {
        match track.at(time_s - lag_s) {
            Some(computed) => {
                let mut instant = compared(*time_s, &computed, truth);
                if let Some(sigma) = track.claimed(time_s - lag_s) {
                    (instant.mean, instant.sigma) = (Nine::default(), *sigma);
                }
                observe(&instant)?;
                log.add(rows, &instant);
                rows += 1;
                let sigma = reference.sigma_ned_m.as_ref().and_then(|sigma| sigma.get(place));
                sigma_m = sigma.map(|sigma| [sigma.x, sigma.y]);
            }
            None => outside += 1,
        }
    }
    if rows == 0 {
        let what = format!("no row of the reference is left with a lag of {lag_s} s");
        return Err(InputError::option("--lag", Complaint::new(what, "a smaller one")));
    }
    log.finish();
    Ok(Comparison {
        reference: reference.name.clone(),
        has: Has { velocity: reference.has_velocity, attitude: reference.has_attitude },
        others: reference.others.clone(),
        lag_s,
        estimated,
        rows,
        outside,
        sigma_m,
        last: log.last,
        max: log.max,
        overview: log.overview,
    })
}
