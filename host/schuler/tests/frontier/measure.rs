//! Every case is flown as a run flies it.

use schuler::trajectory::Trajectory as _;
use schuler_host::frontier::case::Case;
use schuler_host::frontier::measure::measure;
use schuler_host::frontier::pace;
use schuler_simulator::scene::{Algorithm, Axes, Precision, WindowShape, builtin};
use schuler_simulator::simulate;
use schuler_simulator::source::Source;
use std::collections::HashSet;

fn case(name: &str) -> Case {
    Case::all().into_iter().find(|case| case.to_string() == name).expect(name)
}

#[test]
fn errors_are_those_of_a_run() {
    let mut scene = builtin::scene("manoeuvre").unwrap();
    (scene.duration_s, scene.rate_hz) = (50.01, 100.0);
    let names = [
        "taylor 2,4,2 earth-fixed f64",
        "taylor 2,4,2 earth-fixed f32",
        "textbook earth-fixed f64",
        "taylor 2,4,2 local-level f32",
        "taylor 2,4,2 local-level f32-plain",
        "taylor 2,4,2 earth-fixed f64-plain",
        "rk4 earth-fixed f64",
    ];
    let cases = names.map(case);
    let mut heard = 0;
    let (points, left_out) = measure(&scene, &cases, 1, &mut |n| heard += n).unwrap();
    assert_eq!(left_out, []);
    assert_eq!(heard, (5001 + pace::SAMPLES) * cases.len() as u64);
    assert!(points.iter().all(|p| p.ns_per_sample > 0.0 && p.ns_spread == 0.0));
    assert!(points.iter().map(|p| p.case.to_string()).eq(names));
    scene.navigator.frame = Axes::EarthFixed;
    for (point, algorithm, precision) in [
        (&points[0], Algorithm::Taylor, Precision::F64),
        (&points[1], Algorithm::Taylor, Precision::F32),
        (&points[2], Algorithm::Textbook, Precision::F64),
    ] {
        (scene.navigator.algorithm, scene.navigator.precision) = (algorithm, precision);
        scene.navigator.window = Some(WindowShape { history: 2, block: 4, lookahead: 2 });
        let flight = simulate::fly(&scene, false, &mut |_| Ok(()), &|_| {}).unwrap();
        let errors = [point.max_position_m, point.max_velocity_m_s, point.max_attitude_arcsec];
        assert_eq!(errors, flight.max.norms, "{}", point.case);
    }
    let error = |n: usize| points[n].max_position_m;
    // Compensation is what keeps single precision from metres.
    assert!(error(4) > 5.0 * error(3), "{} {}", error(4), error(3));
    assert!(error(6) > error(5), "{} {}", error(6), error(5));
}

#[test]
fn what_cannot_be_flown_is_left_out_and_told() {
    let mut scene = builtin::scene("manoeuvre").unwrap();
    (scene.duration_s, scene.rate_hz) = (20.0, 10.0);
    let cases = ["taylor 0,2,0 earth-fixed f64", "taylor 0,20,0 earth-fixed f64"].map(case);
    let (points, left_out) = measure(&scene, &cases, 1, &mut |_| {}).unwrap();
    assert_eq!(points.len(), 1);
    assert_eq!(points[0].case, cases[0]);
    let [left] = &left_out[..] else { panic!("{left_out:?}") };
    assert_eq!((left.case, left.rate_hz), (cases[1], 10.0));
    assert!(left.why.contains("2 rad"), "{}", left.why);
}

#[test]
fn every_case_has_a_name_of_its_own_and_starts() {
    let all = Case::all();
    let names: HashSet<_> = all.iter().map(Case::to_string).collect();
    assert_eq!(names.len(), all.len());
    for name in [
        "rk4 earth-fixed f32",
        "textbook local-level f64",
        "textbook earth-fixed f32 micromath",
        "taylor 2,4,2 earth-fixed f64-plain",
        "taylor 0,4,0 local-level f32x2",
        "taylor 0,8,0 local-level f32 micromath",
        "taylor 0,20,0 local-level f32",
    ] {
        assert!(names.contains(name), "{name}: {names:?}");
    }
    let scene = builtin::scene("hard").unwrap();
    let source = Source::new(&scene, false).unwrap();
    let initial = source.initial(0);
    for case in all {
        let started = case.start(100.0, source.course.bound(), &initial);
        assert!(started.is_ok(), "{case}");
    }
}
