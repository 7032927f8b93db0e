//! What the benchmarks fly is what the built-in scenes of the same names fly.

use schuler::drift::compare::drift;
use schuler::trajectory::Trajectory as _;
use schuler_simulator::scene::builtin;
use schuler_simulator::source::Source;
use schuler_speed::flight::{Flight, Hard, Manoeuvre, Paper};

fn is_the_scene<F: Flight>(name: &str) {
    let scene = builtin::scene(name).unwrap();
    let source = Source::new(&scene, false).unwrap();
    let course = F::course().unwrap();
    assert_eq!(F::RATE_HZ, scene.rate_hz);
    for sample in [0, 1, 17, 999, 5000] {
        let benchmark = course.at(source.time_s(sample)).solution();
        let apart = drift(&benchmark, &source.truth(sample));
        // The radii of the Earth are rounded to 1e-12 of the distance flown.
        assert!(apart.position_ned.norm() < 1e-6, "{name} {sample}: {apart:?}");
        assert!(apart.velocity_ned.norm() < 1e-8, "{name} {sample}: {apart:?}");
        assert!(apart.attitude_ned.norm() < 1e-12, "{name} {sample}: {apart:?}");
    }
}

#[test]
fn flights_are_the_built_in_scenes() {
    is_the_scene::<Paper>("paper");
    is_the_scene::<Hard>("hard");
    is_the_scene::<Manoeuvre>("manoeuvre");
}
