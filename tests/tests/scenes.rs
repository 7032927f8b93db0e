//! Scenes in source are those in the host's files, bit for bit.

use schuler::digest::Digest;
use schuler::imu::Quadrature;
use schuler::sensor::Timing;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::triad::Triad;
use schuler::trajectory::Trajectory as _;
use schuler::trajectory::harmonic::HarmonicTrajectory;
use schuler::trajectory::piecewise::piece::Piece;
use schuler::trajectory::piecewise::{Attitude, Piecewise};
use schuler::trajectory::spline::EXTRA;
use schuler_scenes::stretch::Stretch;
use schuler_scenes::target::{POINTS, STEEP, WHOLE, points, segments};
use schuler_scenes::{circuit, paper, waypoints};
use schuler_simulator::course::{Path, Spline};
use schuler_simulator::emulator;
use schuler_simulator::scene::{Scene, builtin};

#[test]
fn the_paper_in_source_is_the_papers_file() {
    let scene = builtin::scene("paper").unwrap();
    assert_eq!(scene.rate_hz, paper::RATE_HZ);
    assert_eq!(scene.samples(), paper::SAMPLES);
    assert_eq!(scene.seed, paper::SEED);

    let course = HarmonicTrajectory::<f64, 6>::new(paper::CHANNELS).unwrap();
    let of_file = scene.trajectory.build().unwrap();
    for sample in 0..=paper::SAMPLES {
        let time_s = sample as f64 / paper::RATE_HZ;
        assert_eq!(course.at(time_s), of_file.at(time_s), "{time_s} s");
    }

    let timing = Timing::new(1.0 / paper::RATE_HZ, paper::SAMPLES).unwrap();
    let gyro = paper::gyro(timing).unwrap();
    let accelerometer = paper::accelerometer(timing).unwrap();
    let all_terms: Emulator<f64, Triad<f64>, Triad<f64>> =
        Emulator::new(gyro.into(), accelerometer.into(), timing);
    let of_file = emulator::build(&scene).unwrap();
    assert_eq!(all_terms, of_file);

    let alone = Emulator::new(gyro, accelerometer, timing);
    let (mut one, mut other) = (alone.start(paper::SEED, 0), of_file.start(paper::SEED, 0));
    for sample in 0..1000 {
        let perfect = Default::default();
        let expected = of_file.emulate(&mut other, &perfect);
        assert_eq!(alone.emulate(&mut one, &perfect), expected, "{sample}");
    }
}

fn path_of(scene: &Scene) -> &Path {
    scene.trajectory.path.as_ref().unwrap()
}

#[test]
fn the_circuit_in_source_is_the_circuits_file() {
    let scene = builtin::scene("circuit").unwrap();
    assert_eq!(scene.rate_hz, circuit::RATE_HZ);
    assert_eq!(scene.duration_s, f64::from(circuit::DURATION_S));
    let Path::Blend(of_file) = path_of(&scene) else { panic!("not of segments") };
    let pieces: Vec<_> = circuit::compiler().unwrap().map(Result::unwrap).collect();
    assert_eq!(**of_file, Piecewise::new(pieces, Attitude::Stored).unwrap());
}

#[test]
fn the_way_points_in_source_are_those_of_the_file() {
    let scene = builtin::scene("waypoints").unwrap();
    assert_eq!(scene.rate_hz, waypoints::RATE_HZ);
    let Path::Spline(of_file) = path_of(&scene) else { panic!("not through points") };
    let mut control = [[0.0; 4]; waypoints::POINTS + EXTRA];
    let path = waypoints::path(&waypoints::TIMES_S, &mut control).unwrap();
    let pieces: Vec<Piece<8>> = (0..path.pieces()).filter_map(|n| path.piece(n)).collect();
    let in_source: Spline = Piecewise::new(pieces, waypoints::ATTITUDE).unwrap();
    assert_eq!(**of_file, in_source);
}

/// What a target flies piece by piece is what the host flies of the whole path: the same increments.
#[test]
fn a_targets_increments_are_those_of_the_whole_path() {
    let increments = |name: &str, Stretch { from_s, to_s, rate_hz, nodes }| {
        let course = builtin::scene(name).unwrap().trajectory.build().unwrap();
        let quadrature = Quadrature::of_nodes(nodes);
        let mut digest = Digest::default();
        for sample in u64::from(from_s * rate_hz) + 1..=u64::from(to_s * rate_hz) {
            digest.add(&course.sample(quadrature, sample, f64::from(rate_hz)));
        }
        digest.value()
    };
    let whole = segments(WHOLE).unwrap();
    assert_eq!(whole.increments, increments("circuit", WHOLE));
    let steep = segments(STEEP).unwrap();
    assert_eq!(steep.increments, increments("circuit", STEEP));
    let through = points(POINTS).unwrap();
    assert_eq!(through.increments, increments("waypoints", POINTS));
    // At 50 Hz a block is short enough for the steepest turn; at 4 Hz it is not.
    assert!(steep.final_m < 1e-8 && through.final_m < 1e-8, "{steep:?}, {through:?}");
    assert!(whole.final_m < 1.0, "{whole:?}");
}
