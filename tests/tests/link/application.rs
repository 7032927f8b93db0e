//! The target's application: what it flies is what a navigator flies without a link.

use crate::session::{answers, frame, increments, initial, said, scalars, start};
use schuler::digest::Digest;
use schuler::link::bytes::Bytes;
use schuler::link::configuration::Linked;
use schuler::link::fleet::Every;
use schuler::link::gap::Policy;
use schuler::link::message::{Body, Request};
use schuler::link::target::Target;
use schuler::math::compensated::Pair;
use schuler::math::real::Scalar;
use schuler::sensor::carried::Carried;
use schuler::solution::Solution;
use schuler::strapdown::earth_fixed::EarthFixed;
use schuler::strapdown::local_level::LocalLevel;
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::textbook::{LocalLevelTextbook, Textbook};
use schuler::strapdown::window::{H0B4A0, H2B4A2};
use schuler_tests::Course;

/// A whole flight through the target, every solution and digest against the mechanization itself.
fn flies_the_same_bits<M: Linked>() {
    let course = Course::new("manoeuvre", 1.0, 0.5);
    let interval_s = Pair::<M::Real>::narrow(course.interval_s);
    let mechanization = M::configured(interval_s, 20).unwrap();
    let mut state = mechanization.start(&Solution::narrow(&course.initial())).unwrap();
    let (mut digest, mut carried) = (Digest::default(), Carried::default());

    let mut target = Target::<Every>::new(7);
    let mut sequence = 0;
    let mut ask = |request: &Request, check: &mut dyn FnMut(&Body)| {
        sequence += 1;
        let mut count = 0;
        answers(&said(&mut target, &frame(request, sequence)), |header, answer| {
            count += 1;
            assert_eq!((answer.answers, answer.boot, header.sequence), (sequence, 7, sequence));
            assert_eq!(answer.counters, Default::default());
            check(&answer.body);
        });
        assert_eq!(count, 1);
    };
    let initial = initial::<M>(&course);
    ask(&start::<M>(&initial, Policy::Refuse), &mut |_| ());
    let increments = increments::<M::Real>(&course);
    for (n, increment) in (1..).zip(&increments) {
        let before = M::integrated(&state);
        let sample = carried.narrow(&course.samples[n as usize - 1]);
        mechanization.push(&mut state, sample).unwrap();
        if M::integrated(&state) != before {
            digest.add(M::frame(&state));
        }
        ask(&Request::Sample { number: n, increment: Bytes(increment) }, &mut |body| {
            let Body::Solution(standing) = body else { panic!("{body:?}") };
            assert_eq!(standing.taken, n);
            assert_eq!(standing.integrated, M::integrated(&state));
            assert_eq!(standing.digest, digest.value());
            assert_eq!(standing.solution.0, scalars::<M::Real>(mechanization.output(&state)));
        });
    }
    mechanization.finish(&mut state);
    digest.add(M::frame(&state));
    ask(&Request::Finish { samples: increments.len() as u32 }, &mut |body| {
        let Body::Solution(standing) = body else { panic!("{body:?}") };
        assert_eq!(standing.integrated, increments.len() as u64);
        assert_eq!(standing.digest, digest.value());
        assert_eq!(standing.solution.0, scalars::<M::Real>(mechanization.output(&state)));
    });
}

#[test]
fn flies_what_a_navigator_flies() {
    flies_the_same_bits::<Strapdown<LocalLevel<Pair<f32>>, H0B4A0>>();
    flies_the_same_bits::<Strapdown<EarthFixed<Pair<f64>>, H2B4A2>>();
    flies_the_same_bits::<Textbook<LocalLevelTextbook<f32>>>();
}
