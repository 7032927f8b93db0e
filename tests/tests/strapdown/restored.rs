//! States written back with something wrong in them: refused, or flown on to an end.

use schuler::flight::carried::Carried;
use schuler::math::compensated::{Pair, TwoFloat};
use schuler::math::real::Scalar;
use schuler::output::Output as _;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::block::window::{H0B4A0, H2B4A2, H4B4A4, Line8, Parabola40};
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::plausible::Damaged;
use schuler::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};
use schuler_tests::{Course, Numbers, bits};

/// A course in the digits of a mechanization.
struct Narrow<R> {
    initial: Solution<R>,
    samples: Vec<Increment<R>>,
}

impl<R: Scalar> Narrow<R> {
    fn new(course: &Course) -> Self {
        let mut carried = Carried::default();
        Self {
            initial: Solution::narrow(&course.initial()),
            samples: course.samples.iter().map(|sample| carried.narrow(sample)).collect(),
        }
    }
}

/// A state that carries the given words.
fn restored<S: Record + Copy>(state: &S, words: &[u64]) -> S {
    let (mut state, mut rest) = (*state, words.iter());
    state.restore("", &mut |_, _| *rest.next().unwrap());
    state
}

fn shows_numbers(row: &Solution<f64>) -> bool {
    let (p, v, q) = (row.position, row.velocity_ned, row.attitude);
    let numbers = [p.latitude, p.longitude, p.altitude, v.x, v.y, v.z, q.w, q.v.x, q.v.y, q.v.z];
    numbers.iter().all(|x| x.hi.is_finite())
}

/// What can be done with a state that was accepted: it comes to an end, and what it shows are numbers; or,
/// where the samples kept in it lead out of this world, the next one is refused.
fn flies_on<M: Mechanization<Real: Scalar>>(
    mechanization: &M,
    mut state: M::State,
    samples: &[Increment<M::Real>],
    what: &dyn Fn() -> String,
) {
    mechanization.finish_rows(&mut { state }, |_, row| {
        row.wide();
    });
    let before = M::integrated(&state);
    let mut lost = false;
    for &sample in samples {
        let waits = M::integrated(&state);
        let pushed = mechanization.push_rows(&mut state, sample, |_, row| {
            lost |= !shows_numbers(&row.wide());
        });
        if pushed.is_err() {
            assert_eq!(M::integrated(&state), waits, "{}", what());
            return;
        }
    }
    // It is asked for between blocks: two dozen samples have more than one.
    assert!(!lost, "{}", what());
    mechanization.finish_rows(&mut state, |_, row| {
        row.wide();
    });
    assert!(M::integrated(&state) >= before, "{}", what());
}

/// Every bit of every field, and fields of random bits; how many were accepted, of how many.
fn mutated<M: Mechanization<Real: Scalar, State: Record>>(mechanization: &M, at: &[usize]) {
    let course = Narrow::new(&Course::new("manoeuvre", 1.0, 1.5));
    let mut numbers = Numbers(81);
    for &at in at {
        let mut state = mechanization.start(&course.initial).unwrap();
        for &sample in &course.samples[..at] {
            mechanization.push(&mut state, sample).unwrap();
        }
        assert_eq!(mechanization.check(&state), Ok(()));
        let words = bits(&state);
        let next = &course.samples[at..(at + 24).min(course.samples.len())];
        let tried = |words: &[u64], what: &dyn Fn() -> String| {
            let state = restored(&state, words);
            if mechanization.check(&state) == Ok(()) {
                flies_on(mechanization, state, next, what);
            }
        };
        for field in 0..words.len() {
            for bit in 0..64 {
                let mut words = words.clone();
                words[field] ^= 1 << bit;
                tried(&words, &|| format!("after {at}, field {field}, bit {bit}"));
            }
            for _ in 0..8 {
                let mut words = words.clone();
                words[field] = match numbers.word() % 4 {
                    0 => numbers.word(),
                    1 => numbers.word() % 2000,
                    2 => f64::to_bits(f64::NAN),
                    _ => f64::to_bits(numbers.within(1e7)),
                };
                let other = (numbers.word() % words.len() as u64) as usize;
                let field_word = words[field];
                tried(&words, &|| format!("after {at}, field {field} is {field_word:x}"));
                words[other] = numbers.word();
                tried(&words, &|| format!("after {at}, fields {field} and {other}"));
            }
        }
    }
}

const EARLY_AND_LATE: [usize; 4] = [0, 3, 14, 57];

#[test]
fn no_bit_holds_a_navigator_or_makes_it_nonsense() {
    let interval = Course::new("manoeuvre", 1.0, 0.1).interval_s;
    let single = Pair::narrow(interval);
    mutated(&Strapdown::<LocalLevel<Pair<f64>>, H0B4A0>::new(interval).unwrap(), &EARLY_AND_LATE);
    mutated(&Strapdown::<LocalLevel<Pair<f64>>, H2B4A2>::new(interval).unwrap(), &EARLY_AND_LATE);
    mutated(&Strapdown::<EarthFixed<Pair<f64>>, H2B4A2>::new(interval).unwrap(), &EARLY_AND_LATE);
    mutated(&Strapdown::<EarthFixed<Pair<f64>>, H4B4A4>::new(interval).unwrap(), &[9, 58]);
    mutated(&Strapdown::<EarthFixed<Pair<f32>>, H0B4A0>::new(single).unwrap(), &EARLY_AND_LATE);
    mutated(&Strapdown::<LocalLevel<TwoFloat<f32>>, H2B4A2>::new(single).unwrap(), &EARLY_AND_LATE);
    mutated(&Strapdown::<LocalLevel<Pair<f32>>, Line8>::new(single).unwrap(), &[5, 60]);
    mutated(&Textbook::<LocalLevelTextbook<f64>>::new(interval.hi).unwrap(), &EARLY_AND_LATE);
    mutated(&Textbook::<EarthFixedTextbook<f64>>::new(interval.hi).unwrap(), &EARLY_AND_LATE);
    mutated(&Textbook::<LocalLevelTextbook<f32>>::new(single.hi).unwrap(), &[57]);
    mutated(&Textbook::<EarthFixedTextbook<f32>>::new(single.hi).unwrap(), &[57]);
}

/// What navigation leaves is never taken for damaged: after every sample, at an early end, and after it.
fn accepted<M: Mechanization<Real: Scalar, State: Record>>(mechanization: &M, scene: &str) {
    let course = Narrow::new(&Course::new(scene, 1.0, 400.0));
    let mut state = mechanization.start(&course.initial).unwrap();
    for (n, &sample) in course.samples.iter().enumerate() {
        assert_eq!(mechanization.check(&state), Ok(()), "{scene} {n}");
        mechanization.push(&mut state, sample).unwrap();
        if n % 97 == 3 {
            let mut ended = state;
            mechanization.finish(&mut ended);
            assert_eq!(mechanization.check(&ended), Ok(()), "{scene} {n}, ended");
            for &sample in course.samples[n + 1..].iter().take(40) {
                mechanization.push(&mut ended, sample).unwrap();
                assert_eq!(mechanization.check(&ended), Ok(()), "{scene} {n}, ended, and on");
            }
        }
    }
}

#[test]
fn what_navigation_leaves_is_accepted() {
    for scene in ["manoeuvre", "paper-perfect", "cruise-180"] {
        let interval = Course::new(scene, 1.0, 0.1).interval_s;
        let single = Pair::narrow(interval);
        accepted(&Strapdown::<LocalLevel<Pair<f64>>, H2B4A2>::new(interval).unwrap(), scene);
        accepted(&Strapdown::<LocalLevel<TwoFloat<f32>>, H0B4A0>::new(single).unwrap(), scene);
        accepted(&Strapdown::<EarthFixed<Pair<f32>>, H4B4A4>::new(single).unwrap(), scene);
        accepted(&Textbook::<LocalLevelTextbook<f32>>::new(single.hi).unwrap(), scene);
        accepted(&Textbook::<EarthFixedTextbook<f64>>::new(interval.hi).unwrap(), scene);
    }
    let cruise = Course::new("cruise-180", 1.0, 0.1).interval_s;
    accepted(&Strapdown::<EarthFixed<Pair<f64>>, Parabola40>::new(cruise).unwrap(), "cruise-180");
    let polar = Course::new("polar", 1.0, 0.1).interval_s;
    accepted(&Strapdown::<EarthFixed<Pair<f64>>, H2B4A2>::new(polar).unwrap(), "polar");
    accepted(&Textbook::<EarthFixedTextbook<f64>>::new(polar.hi).unwrap(), "polar");
}

/// Nothing but one field is wrong, and that could be anything.
#[test]
fn what_cannot_be_is_refused() {
    let course = Course::new("manoeuvre", 1.0, 0.5);
    let strapdown = Strapdown::<LocalLevel<Pair<f64>>, H2B4A2>::new(course.interval_s).unwrap();
    let mut state = strapdown.start(&course.initial()).unwrap();
    for &sample in &course.samples[..20] {
        strapdown.push(&mut state, sample).unwrap();
    }
    let mut names = Vec::new();
    state.record("", &mut |name, _| names.push(name));
    let words = bits(&state);
    let refused = |name: &str, word: u64| {
        let field = names.iter().position(|&n| n == name).unwrap();
        let mut words = words.clone();
        words[field] = word;
        let state = restored(&state, &words);
        assert_eq!(strapdown.check(&state), Err(Damaged), "{name} {word:x}");
    };
    for name in ["filled", "pending", "integrated", "seeded"] {
        refused(name, 1000 << 50);
    }
    refused("pending", 1000);
    refused("filled", 0);
    refused("seeded", 5);
    // As a correction leaves it: the gravity history is set up anew.
    let seeded = names.iter().position(|&n| n == "seeded").unwrap();
    let mut anew = words.clone();
    anew[seeded] = 0;
    assert_eq!(strapdown.check(&restored(&state, &anew)), Ok(()));
    for name in ["x", "latitude", "sine", "cosine", "w", "curvature", "gravity_excess"] {
        let Some(_) = names.iter().position(|&n| n == name) else { continue };
        for wrong in [f64::NAN, f64::INFINITY, 1e300, -0.999] {
            refused(name, wrong.to_bits());
        }
    }
}
