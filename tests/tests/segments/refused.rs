//! What cannot be flown is refused with the segment's index and what would do.

use super::*;
use schuler::trajectory::segment::compile::SegmentError;
use schuler::trajectory::segment::control::{Control, Controls};
use schuler::trajectory::segment::fault::Fault;
use schuler::trajectory::segment::flow::Track;
use schuler::trajectory::segment::flyer::Flyer;
use schuler::trajectory::segment::state::State;
use schuler::trajectory::segment::step::Step;

fn refusal(speed: f64, segment: Segment) -> String {
    let from = start(45.0, 30.0, 300.0, speed);
    let segments = [straight_s(10.0), segment];
    match Compiler::new(from, AttitudeRule::Coordinated, &segments) {
        Err(error) => error.to_string(),
        Ok(mut compiler) => match compiler.find_map(Result::err) {
            Some(error) => error.to_string(),
            None => panic!("{segment:?} flies at {speed} m/s"),
        },
    }
}

#[test]
fn a_segment_that_cannot_be_flown_says_what_would_do() {
    let climb = |height, rate, blend_s| Segment::Climb { height, rate, blend_s };
    let nan = f64::NAN;
    for (speed, segment, expected) in [
        (0.0, turn(90.0, 30.0, 4.0), "segment 1 moves at speed 0: accelerate first, or rotate"),
        (0.0, straight_m(100.0, Line::Geodesic), "moves at speed 0"),
        (0.0, climb(100.0, 5.0, 4.0), "moves at speed 0"),
        (100.0, turn(90.0, 86.0, 4.0), "turns too tightly"),
        (100.0, turn(90.0, 0.0, 4.0), "a bank that is not positive"),
        (100.0, turn(90.0, -30.0, 4.0), "a bank that is not positive"),
        (100.0, turn(nan, 30.0, 4.0), "not finite"),
        (100.0, turn(90.0, 30.0, 0.0), "a time below 0.001 s"),
        (100.0, turn_to(721.0, Way::Shorter), "beyond ±2π"),
        (100.0, climb(100.0, 99.0, 4.0), "too steeply for its speed: at most 98.4807753012208 m/s"),
        (100.0, climb(100.0, -5.0, 4.0), "not positive"),
        (100.0, climb(2e7, 5.0, 4.0), "a height outside -100000 to 10000000 m"),
        (250.0, climb(-900.0, 100.0, 4.0), "a blend of at least 37.39"),
        (100.0, Segment::Hold { duration_s: -1.0 }, "a time below 0.001 s"),
        (100.0, straight_s(f64::INFINITY), "not finite"),
        (100.0, straight_m(-1.0, Line::Geodesic), "a distance, "),
        (100.0, accelerate(100_001.0, 60.0), "is faster than 100000 m/s"),
        (100.0, accelerate(nan, 60.0), "not finite"),
        (100.0, accelerate(120.0, 0.0), "not positive"),
        (100.0, Segment::Rotate { angles: [0.0, nan, 0.0], blend_s: 1.0 }, "not finite"),
    ] {
        let said = refusal(speed, segment);
        assert!(said.starts_with("segment 1 ") && said.contains(expected), "{said}");
    }
    let tight =
        Segment::Turn { amount: Amount::By(1.0), tightness: Tightness::Radius(10.0), blend_s: 1.0 };
    assert!(
        refusal(100.0, tight).contains("a radius of at least 89.4"),
        "{}",
        refusal(100.0, tight)
    );
}

#[test]
fn what_is_said_to_do_does() {
    let from = start(45.0, 30.0, 300.0, 250.0);
    let climb = |blend_s| [Segment::Climb { height: -900.0, rate: 100.0, blend_s }];
    let refused = Compiler::new(from, AttitudeRule::Coordinated, &climb(4.0)).unwrap_err();
    let Fault::PushesOver { least_blend_s } = refused.fault else { panic!("{refused}") };
    let pieces = pieces(from, AttitudeRule::Coordinated, &climb(least_blend_s));
    assert!(pieces.last().unwrap().end_s >= 2.0 * least_blend_s);
    // A vehicle has its own up.
    assert!(Compiler::new(from, AttitudeRule::Upright, &climb(4.0)).is_ok());
}

#[test]
fn a_start_that_cannot_be_is_refused() {
    let from = start(45.0, 30.0, 300.0, 0.0);
    for (start, expected) in [
        (Start { course: 30.0, ..from }, "the start has a latitude beyond ±π/2"),
        (Start { speed: f64::NAN, ..from }, "the start has a number that is not finite"),
        (Start { speed: -2e5, ..from }, "the start is faster"),
        (start(91.0, 0.0, 0.0, 0.0), "the start has a latitude"),
        (start(f64::NAN, 0.0, 0.0, 0.0), "the start has a latitude"),
        (start(0.0, 0.0, 2e7, 0.0), "the start has a height"),
    ] {
        let said = Compiler::new(start, AttitudeRule::Level, &[]).unwrap_err().to_string();
        assert!(said.starts_with(expected), "{said}");
    }
}

#[test]
fn a_course_at_a_pole_is_refused_in_flight() {
    let from = start(89.5, 0.0, 1000.0, 250.0);
    let rhumb = [straight_m(80_000.0, Line::Rhumb)];
    let mut compiler = Compiler::new(from, AttitudeRule::Upright, &rhumb).unwrap();
    let refused = Err(SegmentError { index: Some(0), fault: Fault::Pole });
    assert_eq!(compiler.find(Result::is_err), Some(refused.map(|()| Piece::new(0.0, 0.0))));
    assert!(compiler.next_piece().is_none());
    // A geodesic goes over it.
    let over = [straight_m(80_000.0, Line::Geodesic)];
    assert!(Compiler::new(from, AttitudeRule::Upright, &over).unwrap().all(|piece| piece.is_ok()));
    let at_the_pole = start(90.0, 0.0, 1000.0, 100.0);
    let turn = [turn_to(50.0, Way::Shorter)];
    let compiler = Compiler::new(at_the_pole, AttitudeRule::Upright, &turn).unwrap();
    assert_eq!(compiler.duration_s(), Err(SegmentError { index: Some(0), fault: Fault::Pole }));
}

#[test]
fn controls_that_jump_or_leave_no_weight_are_refused() {
    let position = start(45.0, 30.0, 300.0, 0.0).position;
    let state = State { speed: 100.0, ..State::at_rest(Track::new(position, 0.0)) };
    let mut flyer = Flyer::new(state, 0.0, AttitudeRule::Coordinated);
    assert_eq!(flyer.begin(Controls::steady(1.0, 99.0)), Err(Fault::Jump));
    assert_eq!(flyer.begin(Controls::steady(f64::NAN, 100.0)), Err(Fault::NotFinite));
    let push = Step { start_s: 0.0, duration_s: 1.0, change: -0.1 };
    let controls = Controls { climb: Control::stepping(0.0, [push]), ..state.steady(2.0) };
    flyer.begin(controls).unwrap();
    let fault = std::iter::from_fn(|| flyer.next_piece()).find_map(Result::err);
    assert_eq!(fault, Some(Fault::Weightless));
}
