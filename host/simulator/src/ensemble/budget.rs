//! The contribution of each error term to the drift: by theory, of the term alone; by the ensemble, of each run less the
//! same run without the term.
//!
//! A term's random numbers do not depend on the other terms, so a run without a term is the same run otherwise.
//! The difference has the mean and the variance of the term's own contribution, whatever the other terms do.

use super::batches::{self, Means};
use super::group::Ground;
use super::kept::Kept;
use super::part::block::Content as _;
use crate::flight::Nine;
use crate::navigator::Unavailable;
use crate::scene::terms::{Source as Kind, TERMS};
use crate::scene::values::Values;
use crate::scene::{InitialError, Scene, SensorErrors};
use crate::simulate::nine;
use crate::source::{Source, SourceError};
use crate::theory::Theory;

/// An error term of a scene.
pub struct Term {
    /// What people call it.
    pub name: String,
    /// Whether theory knows it.
    pub is_in_theory: bool,
    /// Whether it is noise, which has no mean, and which its sensor's bandwidth acts on.
    pub is_random: bool,
    /// The scene with no other.
    pub alone: Scene,
    /// The scene with all others.
    pub without: Scene,
}

/// What a term contributes to the nine numbers at one instant; m, m/s, arcsec. Not a number where it is not known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contribution {
    /// In the mean over the runs.
    pub mean: [f64; 9],
    /// Standard deviation.
    pub sigma: [f64; 9],
}

impl Contribution {
    const UNKNOWN: Self = Self { mean: [f64::NAN; 9], sigma: [f64::NAN; 9] };
}

/// The error terms of a scene: those of the gyros, of the accelerometers, of the start.
pub fn terms(scene: &Scene) -> Vec<Term> {
    let perfect = Scene {
        gyro: SensorErrors::default(),
        accelerometer: SensorErrors::default(),
        initial_error: InitialError::default(),
        ..scene.clone()
    };
    let mut terms = Vec::new();
    let triads: [(&str, usize, TriadOf, TriadMut); 2] = [
        ("gyro", 0, |scene| &scene.gyro, |scene| &mut scene.gyro),
        ("accelerometer", 1, |scene| &scene.accelerometer, |scene| &mut scene.accelerometer),
    ];
    for (sensor, place, of, of_mut) in triads {
        for term in TERMS {
            let values = (term.values)(of(scene));
            if values.is_none_or(Values::are_zero) {
                continue;
            }
            let (mut alone, mut without) = (perfect.clone(), scene.clone());
            (term.set)(of_mut(&mut alone), values);
            (term.set)(of_mut(&mut without), None);
            of_mut(&mut alone).temperature = of(scene).temperature;
            let name = format!("{sensor} {}", own_name(term.name, place));
            let is_in_theory = !matches!(term.source, Kind::LeftOut);
            let is_random = term.source.is_random();
            if is_random {
                of_mut(&mut alone).bandwidth = of(scene).bandwidth;
            }
            terms.push(Term { name, is_in_theory, is_random, alone, without });
        }
        if of(scene).gauss_markov.is_some_and(|process| process.rms != [0.0; 3]) {
            let (mut alone, mut without) = (perfect.clone(), scene.clone());
            of_mut(&mut alone).gauss_markov = of(scene).gauss_markov;
            of_mut(&mut alone).bandwidth = of(scene).bandwidth;
            of_mut(&mut without).gauss_markov = None;
            let name = format!("{sensor} Gauss-Markov bias");
            terms.push(Term { name, is_in_theory: true, is_random: true, alone, without });
        }
    }
    for (name, part) in ["position", "velocity", "attitude"].into_iter().zip(PARTS) {
        let of_start = part(&scene.initial_error, &InitialError::default());
        if of_start != InitialError::default() {
            let alone = Scene { initial_error: of_start, ..perfect.clone() };
            let rest = part(&InitialError::default(), &scene.initial_error);
            let without = Scene { initial_error: rest, ..scene.clone() };
            let (name, is_random) = (format!("start {name}"), false);
            terms.push(Term { name, is_in_theory: true, is_random, alone, without });
        }
    }
    terms
}

type TriadOf = fn(&Scene) -> &SensorErrors;
type TriadMut = fn(&mut Scene) -> &mut SensorErrors;

/// One quantity of an initial error, and the other two of another.
const PARTS: [fn(&InitialError, &InitialError) -> InitialError; 3] = [
    |one, rest| InitialError {
        position_m: one.position_m,
        position_sigma_m: one.position_sigma_m,
        ..*rest
    },
    |one, rest| InitialError {
        velocity_m_s: one.velocity_m_s,
        velocity_sigma_m_s: one.velocity_sigma_m_s,
        ..*rest
    },
    |one, rest| InitialError {
        attitude_rad: one.attitude_rad,
        attitude_sigma_rad: one.attitude_sigma_rad,
        ..*rest
    },
];

/// A term's name for one kind of sensors: "angle, velocity random walk" is two.
fn own_name(name: &str, place: usize) -> String {
    let name = name.trim_end_matches(", rms");
    match name.split_once(", ") {
        Some((of_gyros, of_accelerometers)) if place == 0 => {
            let rest = of_accelerometers.split_once(' ').map_or("", |(_, rest)| rest);
            format!("{of_gyros} {rest}")
        }
        Some((_, of_accelerometers)) => of_accelerometers.to_owned(),
        None => name.to_owned(),
    }
}

/// What theory expects of a term at times in s, which increase.
pub fn by_theory(term: &Term, times_s: &[f64]) -> Result<Vec<Contribution>, SourceError> {
    let mut theory = Theory::new(&term.alone).map_err(SourceError::Trajectory)?;
    let contribution = |&time_s: &f64| {
        if !term.is_in_theory || theory.outside(time_s).is_some() {
            return Contribution::UNKNOWN;
        }
        let expected = theory.at(time_s);
        let [mean, sigma] = [&expected.mean, &expected.sigma].map(|drift| nine(drift).numbers());
        let mean = if term.is_random { [0.0; 9] } else { mean };
        Contribution { mean, sigma }
    };
    Ok(times_s.iter().map(contribution).collect())
}

/// What the first runs of an ensemble owe to a term at each of its instants: those of them that reach their end
/// with the term and without.
pub fn by_switching_off<E: From<Unavailable> + From<SourceError>>(
    ground: &Ground,
    term: &Term,
    kept: &Kept,
    runs: u64,
    means: Means,
) -> Result<Vec<Contribution>, E> {
    let source = Source::new(&term.without, false)?;
    // With the same plan, blocks end at the same instants.
    let other =
        Ground { scene: &term.without, source: &source, plan: ground.plan, truth: ground.truth };
    let first = kept.runs.start;
    let mut flown = Kept::none(first);
    let runs = first..kept.runs.end.min(first + runs);
    batches::fly(&other, runs, means, &|_| {}, &mut |batch| -> Result<(), E> {
        // Batches of one flight follow one another.
        let _ = flown.join(batch);
        Ok(())
    })?;
    let (with, without) = (kept.numbers(), flown.numbers());
    let pairs: Vec<(usize, usize)> = with
        .iter()
        .enumerate()
        .filter_map(|(place, run)| Some((place, without.binary_search(run).ok()?)))
        .collect();
    let readings = kept.flown.readings.iter().zip(&flown.flown.readings);
    let contribution = readings.map(|(with, without)| {
        let differences = pairs.iter().map(|&(a, b)| {
            let [with, without] =
                [&with.drifts[a], &without.drifts[b]].map(|drift| nine(drift).numbers());
            std::array::from_fn(|i| with[i] - without[i])
        });
        moments(&differences.collect::<Vec<_>>())
    });
    Ok(contribution.collect())
}

/// Mean and standard deviation.
pub fn moments(differences: &[[f64; Nine::NAMES.len()]]) -> Contribution {
    let n = differences.len() as f64;
    if n < 2.0 {
        return Contribution::UNKNOWN;
    }
    let mean: [f64; 9] = std::array::from_fn(|i| differences.iter().map(|x| x[i]).sum::<f64>() / n);
    let sigma = std::array::from_fn(|i| {
        let squares: f64 = differences.iter().map(|x| (x[i] - mean[i]) * (x[i] - mean[i])).sum();
        (squares / (n - 1.0)).sqrt()
    });
    Contribution { mean, sigma }
}
