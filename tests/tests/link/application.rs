//! The target's application: what it flies is what a navigator flies without a link.

use super::damaged::words_of;
use super::line::{Flown, Line, noticed};
use super::session::{answers, frame, increments, initial, said, scalars, start};
use schuler::digest::Digest;
use schuler::flight::carried::Carried;
use schuler::flight::catalogue::Entry;
use schuler::link::bytes::Bytes;
use schuler::link::counters::Counters;
use schuler::link::fleet::Every;
use schuler::link::frame::{Header, MOST_ENCODED, encode};
use schuler::link::gap::Policy;
use schuler::link::kind::Kind;
use schuler::link::message::{Body, MOST_WORDS, Request};
use schuler::link::target::Target;
use schuler::math::compensated::Pair;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::block::window::{H0B4A0, H2B4A2, Parabola20};
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::reference::textbook::{LocalLevelTextbook, Textbook};
use schuler_tests::Course;

/// A whole flight through the target, every solution and digest against the mechanization itself.
fn flies_the_same_bits<M: Entry>() {
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

#[test]
fn nothing_is_flown_twice() {
    let mut line = Line::new(Policy::Refuse);
    let (one, two) = (line.sample(1, 2), line.sample(2, 3));
    assert_eq!(line.tell(&one), [(2, noticed(|_| ()), "at 0 of 1: 1".into())]);
    let twice = (2, noticed(|c| c.duplicated = 1), "at 0 of 1: 1".into());
    assert_eq!(line.tell(&one), [twice]);
    line.tell(&two);
    let late = noticed(|c| (c.duplicated, c.late) = (1, 1));
    assert_eq!(line.tell(&one), [(2, late, "at 0 of 2: 11".into())]);
    // Asked for again, in a new frame, with one lost before it.
    let again = line.sample(2, 5);
    let repeated = Counters { missing: 1, repeated: 1, ..late };
    assert_eq!(line.tell(&again), [(5, repeated, "at 0 of 2: 11".into())]);
}

#[test]
fn a_greeting_begins_the_counts_anew() {
    let mut line = Line::new(Policy::Refuse);
    let (one, three) = (line.sample(1, 2), line.sample(2, 4));
    line.tell(&one);
    line.tell(&one);
    line.tell(&[0, 7, 7, 0]);
    let before = noticed(|c| (c.duplicated, c.missing, c.dropped.stuffing) = (1, 1, 1));
    assert_eq!(line.tell(&three)[0].1, before);
    let greeting = frame(&Request::Greet, 1);
    assert_eq!(line.tell(&greeting), [(1, noticed(|_| ()), "hello".into())]);
    let again = line.sample(2, 2);
    let repeated = noticed(|c| c.repeated = 1);
    assert_eq!(line.tell(&again), [(2, repeated, "at 0 of 2: 11".into())]);
}

#[test]
fn a_gap_is_refused_or_bridged() {
    let mut line = Line::new(Policy::Refuse);
    let (one, four) = (line.sample(1, 2), line.sample(4, 3));
    line.tell(&one);
    assert_eq!(line.tell(&four), [(3, noticed(|_| ()), "Gap at 1".into())]);
    let two = line.sample(2, 4);
    assert_eq!(line.tell(&two), [(4, noticed(|_| ()), "at 0 of 2: 11".into())]);

    let mut line = Line::new(Policy::Bridge);
    line.tell(&one);
    let bridged = noticed(|c| c.bridged = 2);
    assert_eq!(line.tell(&four), [(3, bridged, "at 4 of 4: 1001".into())]);
    // More than are remembered.
    let far = line.sample(37, 5);
    let missing = noticed(|c| (c.bridged, c.missing) = (2, 1));
    assert_eq!(line.tell(&far), [(5, missing, "Gap at 4".into())]);
    let end = frame(&Request::Finish { samples: 6 }, 6);
    let held = noticed(|c| (c.bridged, c.missing) = (4, 1));
    assert_eq!(line.tell(&end), [(6, held, "at 6 of 6: 100100".into())]);
    let more = line.sample(7, 7);
    assert_eq!(line.tell(&more), [(7, held, "Finished at 6".into())]);
}

#[test]
fn a_gap_is_bridged_along_a_straight_line() {
    let course = Course::new("manoeuvre", 1.0, 0.5);
    let samples: Vec<Increment<f32>> = {
        let mut carried = Carried::default();
        course.samples[..8].iter().map(|sample| carried.narrow(sample)).collect()
    };
    let flown = Flown::configured(Pair::narrow(course.interval_s), 20).unwrap();
    let mut state = flown.start(&Solution::narrow(&course.initial())).unwrap();
    let mix = |a: f32, b: f32, part: f32| a + (b - a) * part;
    for n in 1..=8 {
        let (before, after) = (samples[1], samples[4]);
        let sample = match n {
            3 | 4 => {
                let part = (n - 2) as f32 / 3.0;
                Increment {
                    angle_b: before.angle_b.zip(after.angle_b, |a, b| mix(a, b, part)),
                    velocity_b: before.velocity_b.zip(after.velocity_b, |a, b| mix(a, b, part)),
                }
            }
            _ => samples[n - 1],
        };
        flown.push(&mut state, sample).unwrap();
    }
    let mut line = Line::new(Policy::Bridge);
    let mut solution = Vec::new();
    for (sequence, number) in (2..).zip([1, 2, 5, 6, 7, 8]) {
        let frame = line.sample(number, sequence);
        answers(&said(&mut line.target, &frame), |_, answer| {
            let Body::Solution(standing) = answer.body else { panic!("{answer:?}") };
            solution = standing.solution.0.to_vec();
        });
    }
    assert_eq!(solution, scalars::<f32>(flown.output(&state)));
}

#[test]
fn what_cannot_be_done_is_refused_by_name() {
    let mut target = Line::new(Policy::Refuse);
    let initial = initial::<Flown>(&Course::new("manoeuvre", 1.0, 0.1));
    let mut other = initial.clone();
    other[..8].fill(0);
    let nan = [f32::NAN.to_le_bytes(); 6].concat();
    let cases = [
        (Request::Sample { number: 1, increment: Bytes(&[0; 23]) }, "Malformed at 0"),
        (Request::Sample { number: 1, increment: Bytes(&[0; 25]) }, "Malformed at 0"),
        (Request::Sample { number: 1, increment: Bytes(&nan) }, "Rejected(Angle) at 0"),
        (Request::Restore { words: 3, offset: 0, piece: Bytes(&[0; 24]) }, "Malformed at 0"),
        (start::<Flown>(&other, Policy::Refuse), "Start(Interval) at 0"),
        // What flew before still does.
        (Request::Sample { number: 1, increment: Bytes(&[0; 24]) }, "at 0 of 1: 1"),
        (Request::Finish { samples: 0 }, "Count at 1"),
        (start::<Flown>(&initial[1..], Policy::Refuse), "Malformed at 1"),
        (
            start::<Strapdown<LocalLevel<Pair<f32>>, Parabola20>>(&initial, Policy::Refuse),
            "Configuration at 1",
        ),
        (start::<Flown>(&initial, Policy::Refuse), "at 0 of 0: 0"),
    ];
    for (sequence, (request, expected)) in (2..).zip(cases) {
        let heard = target.tell(&frame(&request, sequence));
        assert_eq!(heard, [(sequence, noticed(|_| ()), expected.into())]);
    }
    // What only targets say is no request.
    let header = Header { kind: Kind::Hello, sequence: 99, time_ns: 0 };
    let mut buffer = [0; MOST_ENCODED];
    assert_eq!(target.tell(encode(&header, &mut buffer, |_| ()).unwrap()), []);
}

#[test]
fn a_rebooted_target_goes_on_from_a_stored_state() {
    let course = Course::new("manoeuvre", 1.0, 0.5);
    let initial = initial::<Flown>(&course);
    let mut undisturbed = Line::new(Policy::Bridge);
    let mut stored = Vec::new();
    for number in 1..=40 {
        let frame = undisturbed.sample(number, number + 1);
        undisturbed.tell(&frame);
        if number == 14 {
            stored.extend(words_of(&undisturbed).into_iter().flat_map(u64::to_le_bytes));
        }
    }
    let words = (stored.len() / 8) as u16;
    let mut line = Line::new(Policy::Bridge);
    assert_eq!(line.tell(&frame(&Request::Reset, 0)), [(0, noticed(|_| ()), "hello".into())]);
    let sample = line.sample(15, 40);
    assert_eq!(line.tell(&sample), [(40, noticed(|_| ()), "NotStarted at 0".into())]);
    line.tell(&frame(&start::<Flown>(&initial, Policy::Bridge), 41));
    let mut sequence = 41;
    for (n, piece) in stored.chunks(8 * MOST_WORDS).enumerate() {
        sequence += 1;
        let offset = (n * MOST_WORDS) as u16;
        let request = Request::Restore { words, offset, piece: Bytes(piece) };
        let heard = line.tell(&frame(&request, sequence));
        let is_last = offset as usize * 8 + piece.len() == stored.len();
        let have = offset as usize + piece.len() / 8;
        let expected =
            if is_last { "at 12 of 14: 11111111111111" } else { &format!("{have} words") };
        assert_eq!(heard[0].2, expected);
        if n == 0 {
            // A piece may not leave out what stands before it.
            sequence += 1;
            let gap = Request::Restore { words, offset: have as u16 + 1, piece: Bytes(&[0; 8]) };
            assert!(line.tell(&frame(&gap, sequence))[0].2.starts_with("Malformed"));
        }
        if !is_last {
            // Half restored, it does not navigate.
            sequence += 1;
            let early = line.sample(15, sequence);
            assert!(line.tell(&early)[0].2.starts_with("NotStarted"));
        }
    }
    for number in 15..=40 {
        let frame = line.sample(number, sequence + number);
        line.tell(&frame);
    }
    assert_eq!(words_of(&line), words_of(&undisturbed));
}
