//! What a manoeuvre ends as, by closed forms.

use super::*;
use schuler::earth::gravity;
use schuler::math::compensated::Pair;
use schuler::trajectory::segment::control::Controls;
use schuler::trajectory::segment::flow::Track;
use schuler::trajectory::segment::state::State;
use schuler::trajectory::segment::step::STEEPEST;
use schuler::trajectory::{Trajectory, wrap};
use std::f64::consts::{PI, TAU};

const RULES: [AttitudeRule; 3] =
    [AttitudeRule::Coordinated, AttitudeRule::Upright, AttitudeRule::Level];

#[test]
fn what_stands_is_constant_to_the_bit() {
    for rule in RULES {
        let yaw = [0.3, -0.2, 1.7];
        let segments = [
            Segment::Hold { duration_s: 45.0 },
            Segment::Rotate { angles: yaw, blend_s: 3.0 },
            Segment::Hold { duration_s: 1800.0 },
            accelerate(20.0, 8.0),
            turn(-100.0, 20.0, 1.5),
            accelerate(0.0, 7.0),
            Segment::Hold { duration_s: 30.0 },
            Segment::Rotate { angles: yaw.map(|angle| -angle), blend_s: 2.0 },
        ];
        let from = start(45.0, 80.0, 100.0, 0.0);
        let pieces = pieces(from, rule, &segments);
        let spans = spans(from, rule, &segments);
        let within = |index: usize| {
            let Span { start_s, end_s, .. } = spans[index];
            pieces.iter().filter(move |piece| start_s <= piece.start_s && piece.end_s <= end_s)
        };
        for hold in [0, 2, 6] {
            let [piece] = within(hold).collect::<Vec<_>>()[..] else { panic!("not one piece") };
            assert_eq!(&piece.coefficients[1..], &[[0.0; 8]; TERMS - 1]);
        }
        // Normal and height stand in rotations as well, at what they were.
        for (hold, rotation) in [(0, 1), (6, 7)] {
            let before = within(hold).next().unwrap().coefficients[0];
            assert!(within(rotation).count() > 1);
            for piece in within(rotation) {
                assert_eq!(piece.coefficients[0][..4], before[..4]);
                for row in &piece.coefficients[1..] {
                    assert_eq!(row[..4], [0.0; 4]);
                }
            }
        }
        let path = Piecewise::new(pieces, Attitude::Stored).unwrap();
        let rates = |time_s| path.rates_at(Pair::new(time_s));
        assert_eq!(rates(60.0), rates(1777.7));
    }
}

#[test]
fn a_climb_ends_exactly_that_much_higher() {
    // Long; so short that it does not reach its rate; steep; so little that it bends by microradians.
    for (height, rate, blend_s) in [
        (1000.0, 10.0, 6.0),
        (-730.5, 8.0, 5.0),
        (20.0, 30.0, 10.0),
        (2000.0, 70.0, 30.0),
        (1e-3, 5.0, 4.0),
    ] {
        for speed in [80.0, -80.0] {
            let climb = Segment::Climb { height, rate, blend_s };
            let from = start(45.0, 30.0, 300.0, speed);
            let path = path(from, AttitudeRule::Upright, &[climb, straight_s(1.0)]);
            let end = path.pieces().last().unwrap();
            let error = end.channel(3, end.start_s) - 300.0 - height;
            assert!(error.abs() < 1e-9, "{height} {speed} {error:e}");
            // At its rate in the middle, unless it is over before.
            let middle = path.at(0.5 * (path.end_s() - 1.0)).altitude.first;
            let reached = height.abs() > 2.0 * rate * blend_s;
            let expected = if reached { rate.copysign(height) } else { middle };
            assert!((middle - expected).abs() < 1e-9);
            assert!(middle.abs() <= rate * (1.0 + 1e-12) && middle * height > 0.0);
        }
    }
}

/// Total change of the course, whole turns counted, and what the meridians converge: ∫ λ̇ sinφ dt.
fn turned(path: &Path) -> (f64, f64) {
    let (mut course, mut last, mut converged) = (0.0, None, 0.0);
    let steps = 40_000;
    for k in 0..=steps {
        let motion = path.at(path.end_s() * f64::from(k) / f64::from(steps));
        let v = motion.velocity_ned();
        let now = v.y.atan2(v.x);
        course += last.map_or(0.0, |last: f64| wrap(now - last));
        last = Some(now);
        // Simpson's rule.
        let weight = if k == 0 || k == steps {
            1.0
        } else if k % 2 == 1 {
            4.0
        } else {
            2.0
        };
        converged += weight * motion.longitude.first * motion.latitude.value.sin();
    }
    (course, converged * path.end_s() / f64::from(steps) / 3.0)
}

#[test]
fn a_turn_turns_by_its_angle_beside_what_the_meridians_converge() {
    for degrees in [90.0, -120.0, 360.0, -755.0, 3.0] {
        for latitude in [45.0, -80.0] {
            let from = start(latitude, 30.0, 1000.0, 150.0);
            let path = path(from, AttitudeRule::Coordinated, &[turn(degrees, 30.0, 4.0)]);
            let (course, converged) = turned(&path);
            let error = course - degrees.to_radians() - converged;
            assert!(error.abs() < 2e-12, "{degrees} {latitude} {error:e}");
        }
    }
    // A full turn returns the heading, but for the excess of its area, A/(R_M R_N), at the equator, where no
    // meridians converge between its ends.
    let full = [turn(360.0, 30.0, 4.0)];
    let full = path(start(0.0, 30.0, 1000.0, 150.0), AttitudeRule::Coordinated, &full);
    let radius = 150.0_f64.powi(2) / (9.8 * 30_f64.to_radians().tan());
    let excess = PI * radius * radius / 6.38e6_f64.powi(2);
    let (course, _) = turned(&full);
    assert!((course - TAU).abs() < 1.3 * excess, "{:e} {excess:e}", course - TAU);
}

#[test]
fn a_turn_to_a_course_ends_on_it() {
    for (from_deg, to_deg, way, sense) in [
        (30.0, 120.0, Way::Shorter, 1.0),
        (30.0, 120.0, Way::Left, -1.0),
        (350.0, 10.0, Way::Shorter, 1.0),
        (-170.0, 170.0, Way::Right, 1.0),
        (-170.0, 170.0, Way::Shorter, -1.0),
        (20.0, 25.0, Way::Shorter, 1.0),
    ] {
        for latitude in [0.0, 70.0] {
            let from = start(latitude, from_deg, 500.0, 90.0);
            let segments = [turn_to(to_deg, way)];
            let end = spans(from, AttitudeRule::Upright, &segments)[0].state;
            let course = end.track.course();
            assert!(wrap::<f64>(course - to_deg.to_radians()).abs() < 1e-11);
            assert_eq!((end.course_rate, end.speed), (0.0, 90.0));
            let path = path(from, AttitudeRule::Upright, &segments);
            let v = path.at(path.end_s()).velocity_ned();
            assert!(wrap::<f64>(v.y.atan2(v.x) - course).abs() < 1e-12);
            let (total, _) = turned(&path);
            assert!(total * sense > 0.0 && total.abs() < TAU, "{from_deg} {to_deg} {total}");
        }
    }
}

#[test]
fn a_turn_has_its_bank_and_its_radius() {
    let from = start(45.0, 30.0, 500.0, 100.0);
    let g = gravity(45_f64.to_radians().sin(), 500.0);
    for bank_deg in [10.0, 45.0, 60.0] {
        let bank = f64::to_radians(bank_deg);
        let path = path(from, AttitudeRule::Coordinated, &[turn(180.0, bank_deg, 4.0)]);
        let motion = path.at(0.5 * path.end_s());
        // Coriolis and the Earth's curvature change the bank by up to some milliradians.
        assert!((motion.roll.value - bank).abs() < 3e-3, "{bank_deg}");
        let rate = (path.end_s() - 4.0) / PI;
        assert!((rate * g * bank.tan() / 100.0 - 1.0).abs() < 1e-12);
    }
    let circle = Segment::Turn {
        amount: Amount::By(-PI),
        tightness: Tightness::Radius(1500.0),
        blend_s: 5.0,
    };
    let path = path(from, AttitudeRule::Upright, &[circle]);
    assert!((path.end_s() - 5.0 - PI * 15.0).abs() < 1e-12);
    assert!(path.at(0.5 * path.end_s()).roll.value.abs() < 1e-12);
}

#[test]
fn speeds_and_distances_are_those_asked_for() {
    let from = start(45.0, 30.0, 500.0, 40.0);
    let pull = Segment::Accelerate { speed: 100.0, pace: Pace::Acceleration(2.0) };
    let segments = [pull, straight_m(5000.0, Line::Geodesic), accelerate(25.5, 30.0)];
    let spans = spans(from, AttitudeRule::Upright, &segments);
    assert_eq!(spans[0].end_s, STEEPEST * 60.0 / 2.0);
    assert!((spans[1].end_s - spans[1].start_s - 50.0).abs() < 1e-12);
    let path = path(from, AttitudeRule::Upright, &segments);
    let speed = |time_s: f64| path.at(time_s).velocity_ned().norm();
    assert!((speed(spans[0].end_s) - 100.0).abs() < 1e-12);
    assert!((speed(spans[2].end_s) - 25.5).abs() < 1e-12);
    // The steepest point of the step is its middle.
    let rates = path.rates_at(Pair::new(0.5 * spans[0].end_s));
    let forward = rates.specific_force_b.x;
    assert!((forward - 2.0).abs() < 1e-9, "{forward}");
}

#[test]
fn a_yaw_at_rest_turns_the_course_and_a_yaw_in_motion_does_not() {
    let yaw = Segment::Rotate { angles: [0.0, 0.0, 0.5], blend_s: 4.0 };
    let at_rest = spans(start(10.0, 20.0, 0.0, 0.0), AttitudeRule::Upright, &[yaw])[0].state;
    assert!((at_rest.track.course() - 20_f64.to_radians() - 0.5).abs() < 1e-15);
    assert_eq!(at_rest.rotation, [0.0; 3]);
    let segments = [yaw, straight_s(1.0)];
    let from = start(0.0, 90.0, 0.0, 50.0);
    let path = path(from, AttitudeRule::Upright, &segments);
    let end = path.at(path.end_s());
    assert!((end.yaw.value - PI / 2.0 - 0.5).abs() < 1e-12);
    assert!(end.velocity_ned().x.abs() < 1e-9);
}

#[test]
fn the_state_at_the_end_is_that_of_the_pieces() {
    let (from, segments) = circuit();
    let spans = spans(from, AttitudeRule::Coordinated, &segments);
    let mut compiler = Compiler::new(from, AttitudeRule::Coordinated, &segments).unwrap();
    let mut last = 0.0;
    while let Some(piece) = compiler.next_piece() {
        let piece = piece.unwrap();
        assert_eq!(piece.start_s, last);
        last = piece.end_s;
        let span = &spans[compiler.segment().unwrap()];
        assert!(span.start_s <= piece.start_s && piece.end_s <= span.end_s);
        if piece.end_s == span.end_s {
            let Track { normal_e, altitude, .. } = span.state.track;
            for (channel, n) in normal_e.into_array().into_iter().enumerate() {
                assert!((piece.channel(channel, last) - n.hi).abs() < 3e-16);
            }
            assert!((piece.channel(3, last) - altitude.hi).abs() < 1e-12);
        }
    }
    assert_eq!(Ok(last), compiler.duration_s());
    assert_eq!(last, spans.last().unwrap().end_s);
}

#[test]
fn controls_of_one_s_own_go_on_where_others_end() {
    let at = Track::new(start(10.0, 20.0, 0.0, 0.0).position, 0.0);
    let state = State { speed: 30.0, ..State::at_rest(at) };
    assert!(state.goes_on(&state.steady(1.0)));
    assert!(!state.goes_on(&Controls::steady(1.0, 31.0)));
}
