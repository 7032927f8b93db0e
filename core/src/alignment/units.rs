//! Units that recordings may have by mistake, and which of them would explain a reading.
//!
//! At rest specific force and angular rate are known, γ and ω_ie, and units differ by factors larger than
//! any sensor error. So a reading in a wrong unit identifies that unit.
//!
//! ```
//! use schuler::alignment::units::{ForceUnit, Kind, RateUnit};
//!
//! assert_eq!(ForceUnit::G.si(), 9.80665);
//! assert!((RateUnit::DegreePerSecond.si() - 0.0174533).abs() < 1e-6);
//! assert_eq!(Kind::Increments.other(), Kind::Rates);
//! ```

use crate::math::real::Scalar;
use crate::units::{DEGREE, DEGREE_PER_HOUR, MICRO_G, STANDARD_GRAVITY};

/// A unit of specific force; for velocity increments, the same unit times one second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ForceUnit {
    /// m/s².
    MetrePerSecondSquared,
    /// Standard gravity, 9.80665 m/s².
    G,
    /// mg.
    MilliG,
    /// µg.
    MicroG,
    /// ft/s².
    FootPerSecondSquared,
    /// cm/s² (Gal).
    CentimetrePerSecondSquared,
}

/// A unit of angular rate; for angle increments, the same unit times one second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum RateUnit {
    /// rad/s.
    RadianPerSecond,
    /// mrad/s.
    MilliradianPerSecond,
    /// µrad/s.
    MicroradianPerSecond,
    /// °/s.
    DegreePerSecond,
    /// °/min, which is also ′/s.
    DegreePerMinute,
    /// °/h, which is also ″/s.
    DegreePerHour,
    /// Turns per second.
    TurnPerSecond,
    /// Turns per minute.
    TurnPerMinute,
}

impl ForceUnit {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::MetrePerSecondSquared,
        Self::G,
        Self::MilliG,
        Self::MicroG,
        Self::FootPerSecondSquared,
        Self::CentimetrePerSecondSquared,
    ];

    /// One of it, m/s².
    pub const fn si(self) -> f64 {
        match self {
            Self::MetrePerSecondSquared => 1.0,
            Self::G => STANDARD_GRAVITY,
            Self::MilliG => 9.80665e-3,
            Self::MicroG => MICRO_G,
            Self::FootPerSecondSquared => 0.3048,
            Self::CentimetrePerSecondSquared => 0.01,
        }
    }
}

impl RateUnit {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::RadianPerSecond,
        Self::MilliradianPerSecond,
        Self::MicroradianPerSecond,
        Self::DegreePerSecond,
        Self::DegreePerMinute,
        Self::DegreePerHour,
        Self::TurnPerSecond,
        Self::TurnPerMinute,
    ];

    /// One of it, rad/s.
    pub const fn si(self) -> f64 {
        match self {
            Self::RadianPerSecond => 1.0,
            Self::MilliradianPerSecond => 1e-3,
            Self::MicroradianPerSecond => 1e-6,
            Self::DegreePerSecond => DEGREE,
            Self::DegreePerMinute => DEGREE / 60.0,
            Self::DegreePerHour => DEGREE_PER_HOUR,
            Self::TurnPerSecond => 360.0 * DEGREE,
            Self::TurnPerMinute => 6.0 * DEGREE,
        }
    }
}

/// What the samples of a recording are said to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Kind {
    /// Integrals over a sample.
    Increments,
    /// Instantaneous rates, which were integrated.
    Rates,
}

impl Kind {
    /// The other one.
    pub fn other(self) -> Self {
        match self {
            Self::Increments => Self::Rates,
            Self::Rates => Self::Increments,
        }
    }

    /// The factor by which rates are wrong if samples are said to be of this kind and are of the other:
    /// h for increments that are taken for rates, 1/h for rates that are taken for increments.
    pub fn mistaken<R: Scalar>(self, interval_s: R) -> R {
        match self {
            Self::Increments => R::ONE / interval_s,
            Self::Rates => interval_s,
        }
    }
}

/// A unit and a kind that would explain a reading.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Explanation<U, R> {
    /// The unit that the numbers are in.
    pub unit: U,
    /// What the samples are.
    pub kind: Kind,
    /// The relative error of the reading in this unit and kind.
    pub misfit: R,
}

/// The explanations of a reading, the best first; at most four.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Explanations<U, R> {
    found: [Option<Explanation<U, R>>; MOST],
}

/// Number of explanations kept.
const MOST: usize = 4;

impl<U: Copy, R: Scalar> Explanations<U, R> {
    /// None.
    pub const NONE: Self = Self { found: [None; MOST] };

    /// Of every unit in both kinds, except the first as it stands. `misfit` gives the error of the SI
    /// readings for a factor; units whose error exceeds `limit` are left out.
    pub fn from_units(
        units: &[(U, f64)],
        said: Kind,
        interval_s: R,
        limit: R,
        misfit: impl Fn(R) -> R,
    ) -> Self {
        let mut all = Self::NONE;
        for kind in [said, said.other()] {
            let mistaken = if kind == said { R::ONE } else { said.mistaken(interval_s) };
            for (unit, si) in units {
                let factor = mistaken / R::of(*si);
                let misfit = misfit(factor);
                if (kind != said || *si != 1.0) && misfit < limit {
                    all.insert(Explanation { unit: *unit, kind, misfit });
                }
            }
        }
        all
    }

    fn insert(&mut self, new: Explanation<U, R>) {
        let mut moving = Some(new);
        for place in &mut self.found {
            match (*place, moving) {
                (Some(here), Some(next)) if here.misfit <= next.misfit => {}
                _ => core::mem::swap(place, &mut moving),
            }
        }
    }

    /// The best first.
    pub fn iter(&self) -> impl Iterator<Item = &Explanation<U, R>> {
        self.found.iter().flatten()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.iter().next().is_none()
    }

    /// Keeps only those that hold.
    pub fn retain(&mut self, holds: impl Fn(&Explanation<U, R>) -> bool) {
        for place in &mut self.found {
            *place = place.filter(|explanation| holds(explanation));
        }
    }
}
