//! Flights that go on after a correction.

use super::corrected::*;
use schuler::digest::Digest;
use schuler::drift::compare::drift;
use schuler::flight::carried::Carried;
use schuler::math::compensated::{Pair, TwoFloat};
use schuler::output::Output as _;
use schuler::record::Record;
use schuler::solution::Solution;
use schuler::strapdown::block::unequal::Unequal;
use schuler::strapdown::block::window::{H0B4A0, H2B4A2, H4B4A0};
use schuler::strapdown::correction::Correction;
use schuler::strapdown::frame::Frame;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::mechanization::Mechanization;
use schuler_tests::{Course, Numbers, bits};

/// Off from the start, told the error within a block of its wait, and on the true way from there.
fn follows<M: Mechanization<Real = f64, State: Record>>(mechanization: &M, most_m: f64) {
    let course = Course::new("manoeuvre", 1.0, 20.0);
    let free = course.miss_at_end(mechanization, |_, _| {});
    for at in [500, 501, 502, 503] {
        let mut told = false;
        let wrong = some_correction(&mut Numbers(at), 0.05);
        let end = course.miss_at_end(mechanization, |number, state| {
            if number == 0 {
                mechanization.correct(state, &wrong).unwrap();
            } else if number == at {
                let integrated = M::integrated(state);
                let row = mechanization.output(state).wide();
                assert!(course.miss(integrated, &row) > 10.0);
                let truth = course.source.truth(integrated);
                mechanization.correct(state, &drift(&truth, &row).into()).unwrap();
                assert_eq!(mechanization.check(state), Ok(()));
                told = true;
            }
        });
        println!("{at}: {end:e}, {free:e} without errors");
        assert!(told);
        assert!(end <= free + most_m, "{at}: {end:e}, {free:e} without errors");
    }
}

trait Ends {
    fn miss_at_end<M: Mechanization<Real = f64>>(
        &self,
        mechanization: &M,
        each: impl FnMut(u64, &mut M::State),
    ) -> f64;
}

impl Ends for Course {
    /// The distance from the truth at the end of a flight in which something is done after every sample.
    fn miss_at_end<M: Mechanization<Real = f64>>(
        &self,
        mechanization: &M,
        mut each: impl FnMut(u64, &mut M::State),
    ) -> f64 {
        let mut state = mechanization.start(&self.initial()).unwrap();
        each(0, &mut state);
        for (&sample, number) in self.samples.iter().zip(1..) {
            mechanization.push(&mut state, sample).unwrap();
            each(number, &mut state);
        }
        mechanization.finish(&mut state);
        self.miss(self.samples.len() as u64, &mechanization.output(&state).wide())
    }
}

#[test]
fn a_wrong_navigator_follows_the_truth_once_told() {
    follows(&strapdown::<Local, H0B4A0>(), 1e-8);
    follows(&strapdown::<Earth, H0B4A0>(), 1e-8);
    follows(&strapdown::<Local, H2B4A2>(), 1e-8);
    follows(&strapdown::<Earth, H2B4A2>(), 1e-8);
    follows(&strapdown::<Earth, H4B4A0>(), 1e-8);
    follows(&strapdown::<Local, Unequal<H2B4A2>>(), 1e-8);
    follows(&LocalTextbook::from_rate_hz(100.0).unwrap(), 1e-6);
    follows(&EarthTextbook::from_rate_hz(100.0).unwrap(), 1e-6);
}

/// After the same correction in flight, both frames, and a start at the corrected state, fly the same way.
#[test]
fn frames_agree_after_a_correction() {
    let course = Course::new("manoeuvre", 1.0, 20.0);
    let correction = some_correction(&mut Numbers(7), 0.1);
    let mut ends = Vec::new();
    fn fly<F: Frame<Real = f64>>(
        course: &Course,
        correction: &Correction<f64>,
    ) -> [Solution<f64>; 2] {
        let navigator = strapdown::<F, H0B4A0>();
        let mut state = navigator.start(&course.initial()).unwrap();
        let (before, after) = course.samples.split_at(1000);
        before.iter().for_each(|&sample| navigator.push(&mut state, sample).unwrap());
        navigator.correct(&mut state, correction).unwrap();
        let mut fresh = navigator.start(&state.output().wide()).unwrap();
        for &sample in after {
            navigator.push(&mut state, sample).unwrap();
            navigator.push(&mut fresh, sample).unwrap();
        }
        [state, fresh].map(|state| state.output().wide())
    }
    ends.extend(fly::<Local>(&course, &correction));
    ends.extend(fly::<Earth>(&course, &correction));
    let first = ends[0];
    for other in &ends {
        within("frames", apart(other, &first), [1e-8, 1e-9, 1e-13]);
    }
}

/// In single precision the corrected flight is as good as any.
#[test]
fn single_precision_follows_the_truth_once_told() {
    fn check<F: Frame<Real = f32>>(most_m: f64) {
        let course = Course::new("manoeuvre", 1.0, 20.0);
        let navigator = strapdown::<F, H0B4A0>();
        let mut state = navigator.start(&Solution::narrow(&course.initial())).unwrap();
        let wrong = some_correction(&mut Numbers(8), 0.02);
        navigator.correct(&mut state, &narrow(&wrong)).unwrap();
        let mut carried = Carried::default();
        for (sample, number) in course.samples.iter().zip(1..) {
            navigator.push(&mut state, carried.narrow(sample)).unwrap();
            if number == 500 {
                let row = state.output().wide();
                assert!(course.miss(number, &row) > 10.0);
                let correction = drift(&course.source.truth(number), &row).into();
                navigator.correct(&mut state, &narrow(&correction)).unwrap();
            }
        }
        let end = course.miss(course.samples.len() as u64, &state.output().wide());
        println!("{end:e}");
        assert!(end <= most_m, "{end:e}");
    }
    check::<LocalLevel<Pair<f32>>>(0.01);
    check::<LocalLevel<TwoFloat<f32>>>(1e-3);
    check::<EarthFixed<Pair<f32>>>(0.1);
    check::<EarthFixed<TwoFloat<f32>>>(1e-3);
}

/// A corrected state goes on from its words bit for bit, with samples pending, and digests tell it from
/// one that was not corrected.
#[test]
fn a_corrected_state_is_stored_and_digested_as_any() {
    fn check<M: Mechanization<Real = f64, State: Record>>(mechanization: &M) {
        let course = Course::new("manoeuvre", 1.0, 1.0);
        let mut states = [0; 3].map(|_| mechanization.start(&course.initial()).unwrap());
        let correction = some_correction(&mut Numbers(3), 0.01);
        for (number, &sample) in course.samples.iter().enumerate() {
            if number == 43 {
                let [free, corrected, copy] = &mut states;
                mechanization.correct(corrected, &correction).unwrap();
                assert_eq!(M::integrated(corrected), M::integrated(free));
                assert_ne!(bits(corrected), bits(free));
                let mut words = bits(corrected).into_iter();
                copy.restore("", &mut |_, _| words.next().unwrap());
                assert_eq!(mechanization.check(copy), Ok(()));
            }
            for state in &mut states {
                mechanization.push(state, sample).unwrap();
            }
        }
        let [free, corrected, copy] = states.map(|state| {
            let mut digest = Digest::default();
            digest.add(&state);
            digest.value()
        });
        assert_eq!(corrected, copy);
        assert_ne!(corrected, free);
    }
    check(&strapdown::<Local, H2B4A2>());
    check(&strapdown::<Earth, H2B4A2>());
    check(&strapdown::<Local, Unequal<H2B4A2>>());
    check(&LocalTextbook::from_rate_hz(100.0).unwrap());
    check(&EarthTextbook::from_rate_hz(100.0).unwrap());
}
