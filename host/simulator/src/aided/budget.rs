//! What each error term contributes to the errors of aided runs: each run less the same run without the term, whose filter
//! still expects it.
//!
//! A term's random numbers do not depend on the other terms, so a run without a term is the same run otherwise. Where a
//! measurement is refused in one of the two and not in the other, that is part of the difference.

use super::batches::{Means, fly_range};
use super::kept::AidedRuns;
use super::runs::Scenes;
use crate::ensemble::budget::{Contribution, moments, terms};
use crate::ensemble::part::block::Content as _;
use crate::input::InputError;
use crate::scene::Scene;
use crate::source::{Source, SourceError};
use crate::units::ARCSECOND;
use schuler::math::vector::Vector;
use schuler::sensor::aiding::noise::VectorNoise;

/// An error term that can be switched off.
pub struct Term {
    /// What people call it.
    pub name: String,
    /// The scene with all others.
    pub without: Scene,
}

/// The error terms of a scene: of its inertial sensors, of the start, of its measurements.
pub fn of_scene(scene: &Scene) -> Vec<Term> {
    let inertial = terms(scene).into_iter();
    let mut all: Vec<Term> =
        inertial.map(|term| Term { name: term.name, without: term.without }).collect();
    let mut add = |name: &str, switch_off: &dyn Fn(&mut Scene)| {
        let mut without = scene.clone();
        switch_off(&mut without);
        if without.aiding != scene.aiding {
            all.push(Term { name: name.to_owned(), without });
        }
    };
    let none = VectorNoise::white(Vector::ZERO);
    add("gnss position noise", &|scene| {
        scene.aiding.gnss.iter_mut().for_each(|gnss| gnss.position = none);
    });
    add("gnss velocity noise", &|scene| {
        scene.aiding.gnss.iter_mut().for_each(|gnss| gnss.velocity = none);
    });
    add("gnss outliers", &|scene| {
        scene.aiding.gnss.iter_mut().for_each(|gnss| gnss.outliers = None);
    });
    add("gnss spoofing", &|scene| {
        scene.aiding.gnss.iter_mut().for_each(|gnss| gnss.spoofing = None);
    });
    all
}

/// What the first runs owe to a term at each of their instants: those of them that reach their end with the term and
/// without. m, m/s, arcsec.
pub fn by_switching_off<E: From<InputError> + From<SourceError>>(
    scene: &Scene,
    term: &Term,
    kept: &AidedRuns,
    runs: u64,
    means: Means,
) -> Result<Vec<Contribution>, E> {
    let source = Source::new(&term.without, false)?;
    let scenes = Scenes { flown: &term.without, believed: scene, source: &source };
    let first = kept.numbers.start;
    let mut flown = AidedRuns::none(first);
    let range = first..kept.numbers.end.min(first.saturating_add(runs));
    fly_range(scenes, range, means, &|_| {}, &mut |batch| -> Result<(), E> {
        // Batches of one flight follow one another.
        let _ = flown.join(batch);
        Ok(())
    })?;
    let others = flown.of_ended();
    let place_of = |run: &u64| others.binary_search(run).ok();
    let ended = kept.of_ended();
    let pairs = || {
        let with = ended.iter().zip(&kept.ended);
        with.filter_map(|(run, with)| Some((with, flown.ended.get(place_of(run)?)?)))
    };
    let at = |instant: usize| {
        let differences = pairs().filter_map(|(with, without)| {
            let [with, without] = [with.reads.get(instant)?, without.reads.get(instant)?];
            Some(std::array::from_fn(|i| {
                let difference = with.error[i] - without.error[i];
                if i < 6 { difference } else { difference / ARCSECOND }
            }))
        });
        moments(&differences.collect::<Vec<_>>())
    };
    Ok((0..kept.instants().len()).map(at).collect())
}
