//! What a path was made from, and its extremes, found once when it was made.

use crate::course::{Path, Reference};
use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
use schuler::trajectory::Trajectory;
use schuler::trajectory::log::Outcome;
use schuler::trajectory::segment::attitude::AttitudeRule;
use schuler::trajectory::segment::compile::Start;
use schuler::trajectory::segment::compile::segment::Segment;

/// Looks at a piece, over its length.
const LOOKS: u32 = 4;

/// What a path was made from.
#[derive(Clone, Debug, PartialEq)]
pub struct Route {
    /// What it was made from.
    pub from: Origin,
    /// Where its attitude comes from, as a scene calls it.
    pub attitude: &'static str,
    /// Its extremes.
    pub peaks: Peaks,
}

/// The kinds of paths.
#[derive(Clone, Debug, PartialEq)]
pub enum Origin {
    /// What a pilot or a driver does.
    Segments(Manoeuvres),
    /// Way-points.
    Waypoints {
        /// What is flown past them; through them it is a curve.
        past: Option<Manoeuvres>,
        /// Each, and when it is passed or nearest, s.
        points: Vec<(f64, Geodetic<f64>)>,
    },
    /// A log.
    Log {
        /// Its file.
        file: String,
        /// Its rows.
        rows: usize,
        /// How it was smoothed.
        outcome: Outcome,
    },
}

/// Segments of a path.
#[derive(Clone, Debug, PartialEq)]
pub struct Manoeuvres {
    /// Where it begins.
    pub start: Start,
    /// How the body lies along it.
    pub rule: AttitudeRule,
    /// One after the other.
    pub segments: Vec<Segment>,
}

impl Origin {
    /// The segments that are flown, if any are.
    pub fn manoeuvres(&self) -> Option<&Manoeuvres> {
        match self {
            Self::Segments(manoeuvres) => Some(manoeuvres),
            Self::Waypoints { past, .. } => past.as_ref(),
            Self::Log { .. } => None,
        }
    }

    /// The file that it was read from, beside the scene's.
    pub fn file(&self) -> Option<&str> {
        match self {
            Self::Log { file, .. } => Some(file),
            _ => None,
        }
    }

    /// The key of a scene that it stands under.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Segments(_) => "trajectory.segment",
            Self::Waypoints { .. } => "trajectory.waypoints",
            Self::Log { .. } => "trajectory.log",
        }
    }
}

/// A greatest magnitude, and when it was seen, s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peak {
    /// The magnitude.
    pub size: f64,
    /// When.
    pub time_s: f64,
}

impl Peak {
    fn see(&mut self, size: f64, time_s: f64) {
        // Not a number is beyond everything.
        if size > self.size || size.is_nan() && !self.size.is_nan() {
            *self = Self { size, time_s };
        }
    }
}

/// The extremes of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peaks {
    /// The least height, m.
    pub lowest: f64,
    /// The greatest height, m.
    pub highest: f64,
    /// Speed, m/s.
    pub speed: Peak,
    /// Acceleration relative to the Earth, m/s².
    pub acceleration: Peak,
    /// Angular rate relative to the Earth, rad/s.
    pub rate: Peak,
}

impl Peaks {
    /// Of a path.
    pub fn new(path: &Path) -> Self {
        let none = Peak::default();
        let mut this = Self {
            lowest: f64::INFINITY,
            highest: f64::NEG_INFINITY,
            speed: none,
            acceleration: none,
            rate: none,
        };
        let spans = path.spans();
        let motion = Reference::Path(path.clone());
        for [from_s, to_s] in spans {
            for look in 0..=LOOKS {
                // A joint belongs to the piece behind it; nearly there is this one's.
                let part = f64::from(look) / f64::from(LOOKS) * (1.0 - f64::EPSILON);
                let time_s = from_s + part * (to_s - from_s);
                let at = motion.kinematics_at(Pair::new(time_s));
                this.lowest = this.lowest.min(at.altitude);
                this.highest = this.highest.max(at.altitude);
                this.speed.see(at.velocity_e.norm(), time_s);
                this.acceleration.see(at.acceleration_e.norm(), time_s);
                this.rate.see(at.rate_eb_b.norm(), time_s);
            }
        }
        this
    }
}
