//! Records of frames, and digests over them.

use schuler::digest::Digest;
use schuler::math::compensated::{Pair, Plain, TwoFloat};
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::strapdown::block::window::{H0B4A0, H2B4A2, Parabola20, Window};
use schuler::strapdown::frame::Frame;
use schuler::strapdown::frame::block_time::BlockTime;
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::reference::textbook::{EarthFixedTextbook, LocalLevelTextbook, Textbook};
use schuler_tests::{Course, bits};

/// A state that carries the given words.
fn restored<S: Record>(mut other: S, words: &[u64]) -> S {
    let mut rest = words.iter();
    other.restore("", &mut |_, _| *rest.next().unwrap());
    assert_eq!(rest.next(), None);
    other
}

/// The words and their names, in flight.
fn names<S: Record>(state: &S) -> Vec<&'static str> {
    let mut names = Vec::new();
    state.record("state", &mut |name, _| names.push(name));
    names
}

fn course() -> Course {
    Course::new("manoeuvre", 1.0, 2.0)
}

/// Steps a frame over the blocks of the samples from one on.
fn steps<F: Frame<Real = f64>>(frame: &mut F, course: &Course, from: usize) {
    let time = BlockTime::new(course.interval_s, H0B4A0::BLOCK);
    for block in course.samples[from..].as_chunks::<4>().0 {
        let (body, _) = H0B4A0::integrate(block, time.half, H0B4A0::TERMS, F::TWO_FLOAT).unwrap();
        frame.step(&time, &body);
    }
}

/// In flight after a hundred samples.
fn flying<F: Frame<Real = f64>>(course: &Course) -> F {
    let strapdown = Strapdown::<F, H0B4A0>::new(course.interval_s).unwrap();
    let mut state = strapdown.start(&course.initial()).unwrap();
    for &sample in &course.samples[..100] {
        strapdown.push(&mut state, sample).unwrap();
    }
    *Strapdown::<F, H0B4A0>::frame(&state)
}

fn goes_on<F: Frame<Real = f64> + Record>() {
    let course = course();
    let mut frame = flying::<F>(&course);
    let words = bits(&frame);
    // Somewhere else altogether, until it is written over.
    let other = F::start(&Course::new("paper-perfect", 1.0, 1.0).initial());
    assert_ne!(bits(&other), words);
    let mut copy = restored(other, &words);
    assert_eq!(bits(&copy), words);
    steps(&mut frame, &course, 100);
    steps(&mut copy, &course, 100);
    assert_ne!(bits(&frame), words);
    assert_eq!(bits(&copy), bits(&frame));
}

#[test]
fn a_frame_goes_on_from_its_words_bit_for_bit() {
    goes_on::<LocalLevel<Pair<f64>>>();
    goes_on::<EarthFixed<Pair<f64>>>();
    goes_on::<LocalLevel<Plain<f64>>>();
    goes_on::<EarthFixed<Plain<f64>>>();
    goes_on::<LocalLevel<TwoFloat<f64>>>();
    goes_on::<EarthFixed<TwoFloat<f64>>>();
}

/// Wherever in a block the stream is interrupted: samples that wait are part of the state.
fn state_goes_on<M: Mechanization<Real = f64, State: Record>>(mechanization: &M) {
    let course = course();
    let other = mechanization.start(&Course::new("hard", 1.0, 1.0).initial()).unwrap();
    let mut state = mechanization.start(&course.initial()).unwrap();
    for (n, &sample) in course.samples.iter().enumerate() {
        if n < 30 || n % 17 == 0 {
            let words = bits(&state);
            let (mut copy, mut original) = (restored(other, &words), state);
            assert_eq!(bits(&copy), words);
            for &sample in &course.samples[n..] {
                mechanization.push(&mut copy, sample).unwrap();
                mechanization.push(&mut original, sample).unwrap();
            }
            mechanization.finish_rows(&mut copy, |_, _| ());
            mechanization.finish_rows(&mut original, |_, _| ());
            assert_eq!(M::integrated(&copy), course.samples.len() as u64);
            assert_eq!(bits(&copy), bits(&original), "from {n}");
        }
        mechanization.push(&mut state, sample).unwrap();
    }
}

#[test]
fn a_navigator_goes_on_from_its_words_bit_for_bit() {
    let interval = course().interval_s;
    state_goes_on(&Strapdown::<LocalLevel<Pair<f64>>, H2B4A2>::new(interval).unwrap());
    state_goes_on(&Strapdown::<EarthFixed<Pair<f64>>, H0B4A0>::new(interval).unwrap());
    state_goes_on(&Strapdown::<LocalLevel<TwoFloat<f64>>, Parabola20>::new(interval).unwrap());
    state_goes_on(&Textbook::<LocalLevelTextbook<f64>>::new(0.01).unwrap());
    state_goes_on(&Textbook::<EarthFixedTextbook<f64>>::new(0.01).unwrap());
}

#[test]
fn fields_have_their_names_and_their_order() {
    let local = names(&flying::<LocalLevel<Pair<f64>>>(&course()));
    let runs = |names: &[&'static str]| {
        names.chunk_by(|a, b| a == b).map(|run| (run[0], run.len())).collect::<Vec<_>>()
    };
    assert_eq!(
        runs(&local),
        [
            ("position", 6),
            ("sine", 2),
            ("cosine", 2),
            ("velocity", 6),
            ("attitude", 8),
            ("curvature", 1),
            ("gravity_excess", 1),
            ("gravity_excess_low", 1),
            ("longitude_rest", 1),
            ("difference", 3),
            ("second_difference", 3),
            ("third_difference", 3),
            ("fourth_difference", 3)
        ]
    );
    let earth = names(&flying::<EarthFixed<Plain<f64>>>(&course()));
    assert_eq!(
        runs(&earth),
        [
            ("position", 3),
            ("velocity", 3),
            ("attitude", 4),
            ("gravitation", 3),
            ("gravitation_low", 3),
            ("difference", 3),
            ("second_difference", 3),
            ("third_difference", 3),
            ("fourth_difference", 3),
            ("sine", 1),
            ("cosine", 1),
            ("change", 1)
        ]
    );
}

#[test]
fn numbers_keep_their_bits() {
    fn check<T: Record + Copy>(words: &[u64], any: T) {
        assert_eq!(bits(&restored(any, words)), words);
    }
    let negative_zero = (-0.0_f64).to_bits();
    check(&[negative_zero], 1.0_f64);
    check(&[1], 1.0_f64);
    check(&[f64::MAX.to_bits()], 0.0_f64);
    check(&[u64::from((-0.0_f32).to_bits())], 1.0_f32);
    check(&[u64::from(f32::MIN_POSITIVE.to_bits()) - 1], 1.0_f32);
    check(&[u64::MAX], 0_u64);
    check(&[u64::from(u32::MAX)], 0_u32);
    check(&[7, negative_zero], Pair::new(0.5_f64));
}

fn digest<S: Record>(states: &[S]) -> u64 {
    let mut digest = Digest::default();
    states.iter().for_each(|state| digest.add(state));
    digest.value()
}

/// Any one bit of any field, in any of several states, changes the digest; so does every exchange.
fn notices<F: Frame<Real = f64> + Record>() {
    let course = course();
    let frame = flying::<F>(&course);
    let mut later = frame;
    steps(&mut later, &course, 100);
    let (words, expected) = (bits(&frame), digest(&[frame, later]));
    for field in 0..words.len() {
        for bit in 0..64 {
            let mut flipped = words.clone();
            flipped[field] ^= 1 << bit;
            let flipped = restored(frame, &flipped);
            assert_ne!(digest(&[flipped, later]), expected, "bit {bit} of field {field}");
        }
        for other in 0..field {
            let mut exchanged = words.clone();
            exchanged.swap(field, other);
            let same = words[field] == words[other];
            let exchanged = restored(frame, &exchanged);
            assert_eq!(digest(&[exchanged, later]) == expected, same, "fields {field}, {other}");
        }
    }
    assert_ne!(digest(&[later, frame]), expected);
    assert_ne!(digest(&[frame]), expected);
    assert_ne!(digest(&[frame, later, later]), expected);
    assert_eq!(digest(&[frame, later]), expected);
}

#[test]
fn digests_notice_every_bit_and_the_order() {
    notices::<LocalLevel<Pair<f64>>>();
    notices::<EarthFixed<Pair<f64>>>();
    assert_ne!(digest(&[0.0_f64]), digest(&[-0.0_f64]));
    assert_ne!(digest::<u64>(&[]), digest(&[0_u64]));
    assert_ne!(digest(&[0_u64]), digest(&[0_u64, 0]));
}

/// Equal streams have equal digests; one sample's last bit shows in all that follow.
#[test]
fn digests_of_flights() {
    let course = course();
    let strapdown = Strapdown::<LocalLevel<Pair<f64>>, H2B4A2>::new(course.interval_s).unwrap();
    let fly = |samples: &[Increment<f64>]| {
        let mut state = strapdown.start(&course.initial()).unwrap();
        let mut digest = Digest::default();
        let mut values = Vec::new();
        for &sample in samples {
            strapdown.push(&mut state, sample).unwrap();
            digest.add(Strapdown::<_, H2B4A2>::frame(&state));
            values.push(digest.value());
        }
        values
    };
    let (first, second) = (fly(&course.samples), fly(&course.samples));
    assert_eq!(first, second);
    let mut samples = course.samples.clone();
    let x = &mut samples[100].angle_b.x;
    // Enough ulps of one sample to be seen in the sum of four.
    *x = f64::from_bits(x.to_bits() ^ 16);
    let changed = fly(&samples);
    let parting = first.iter().zip(&changed).position(|(a, b)| a != b).unwrap();
    assert!((100..108).contains(&parting), "{parting}");
    assert!(first[parting..].iter().zip(&changed[parting..]).all(|(a, b)| a != b));
}
