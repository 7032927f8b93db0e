//! Scenes in source are those in the host's files, bit for bit.

use schuler::sensor::Timing;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::triad::Triad;
use schuler::trajectory::Trajectory as _;
use schuler::trajectory::harmonic::HarmonicTrajectory;
use schuler_scenes::paper;
use schuler_simulator::emulator;
use schuler_simulator::scene::builtin;

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
