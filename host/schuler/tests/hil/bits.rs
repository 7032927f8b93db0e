//! What a target flies is what `run` flies, whatever happens on the line.

use super::{fly, manner, scene};
use schuler_host::hil::Manner;
use schuler_host::hil::in_process::InProcess;
use schuler_simulator::scene::{Algorithm, Axes, Gap, Precision, Scene, Vertical, WindowShape};
use schuler_simulator::simulate::{self, FlightError};

/// Scenes with every kind of navigator.
fn scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (precision, frame, algorithm, window) in [
        (Precision::F32, Axes::LocalLevel, Algorithm::Taylor, (0, 4, 0)),
        (Precision::F64, Axes::EarthFixed, Algorithm::Taylor, (2, 4, 2)),
        (Precision::F32x2, Axes::LocalLevel, Algorithm::Taylor, (2, 4, 2)),
        (Precision::F32x2, Axes::EarthFixed, Algorithm::Taylor, (0, 4, 0)),
        (Precision::F64, Axes::LocalLevel, Algorithm::Textbook, (0, 0, 0)),
        (Precision::F32, Axes::EarthFixed, Algorithm::Textbook, (0, 0, 0)),
    ] {
        let mut scene = scene("paper", 20.0);
        let (history, block, lookahead) = window;
        let shape = WindowShape { history, block, lookahead };
        scene.navigator.window = (algorithm == Algorithm::Taylor).then_some(shape);
        (scene.navigator.precision, scene.navigator.frame) = (precision, frame);
        scene.navigator.algorithm = algorithm;
        scenes.push(scene);
    }
    scenes[0].navigator.vertical = Vertical::Held;
    scenes
}

#[test]
fn a_target_flies_what_run_flies() {
    for scene in scenes() {
        let run = simulate::fly(&scene, false, &mut |_| Ok(()), &|_| ()).unwrap();
        let (flown, ended) = fly(&scene, InProcess::every(), &Manner::default());
        let flown = flown.unwrap();
        assert_eq!(flown.digest, run.digest);
        assert_eq!((flown.last, flown.max), (run.last, run.max));
        let tally = ended.tally;
        assert!(tally.sent > scene.samples() && tally.received == tally.sent + 1, "{tally:?}");
        assert_eq!((tally.resent, tally.worst_round_trips), (0, 1));
    }
}

#[test]
fn faults_change_no_bit_and_each_is_noticed() {
    for (seed, scene) in (1..).zip(scenes()) {
        let run = simulate::fly(&scene, false, &mut |_| Ok(()), &|_| ()).unwrap();
        let rates = "drop=0.03,duplicate=0.03,reorder=0.03,delay=0.03,truncate=0.03,flip=0.03,\
                     stall=0.02,reboot=0.03";
        let (flown, ended) = fly(&scene, InProcess::every(), &manner(rates, seed, 20));
        assert_eq!(flown.unwrap().digest, run.digest);
        let tally = ended.tally;
        for trace in tally.traces() {
            assert!(trace.is_explained(), "{trace:?} of {tally:?}");
            let injected = trace.injected_to_target + trace.injected_to_host;
            assert!(injected > 3, "{trace:?}");
        }
        assert_eq!((tally.lost, tally.not_understood), (0, 0));
        assert!(tally.recovered > 50 && tally.worst_round_trips > 2, "{tally:?}");
    }
}

#[test]
fn the_same_seed_brings_the_same_faults() {
    let scene = scene("paper", 10.0);
    let tally = |seed| fly(&scene, InProcess::every(), &manner("all=0.2", seed, 20)).1.tally;
    assert_eq!(tally(1), tally(1));
    assert_ne!(tally(1), tally(2));
}

#[test]
fn samples_that_are_given_up_are_bridged_alike_or_end_the_flight() {
    let mut scene = scene("paper", 20.0);
    scene.navigator.precision = Precision::F32;
    scene.navigator.gap = Gap::Bridge;
    let mut bridged = 0;
    for seed in 1..=5 {
        // Nothing is sent again but once: half of what is hit twice is lost.
        let faults = "drop=0.1,delay=0.1,reorder=0.1,flip=0.05,stall=0.02,reboot=0.02";
        let (flown, ended) = fly(&scene, InProcess::single(), &manner(faults, seed, 1));
        let tally = ended.tally;
        let (samples, flown) = (scene.samples(), flown.unwrap_or_else(|e| panic!("{seed}: {e}")));
        assert_eq!(flown.samples, samples);
        assert!(tally.lost > 5 && tally.bridged <= tally.lost, "{tally:?}");
        // It is told to who reads the report, and theory is not compared with what lines have filled in.
        assert_eq!(flown.lost, tally.bridged);
        // What was given up may have arrived all the same.
        bridged += tally.bridged;
        // A straight line over a sample or two of a slow motion is next to nothing.
        assert!(flown.max.norms[0] < 1.0, "{}", flown.max.norms[0]);
    }
    assert!(bridged > 10);

    scene.navigator.gap = Gap::Error;
    let (flown, _) = fly(&scene, InProcess::single(), &manner("drop=0.1", 1, 0));
    let Err(FlightError::Lost { sample, time_s, .. }) = flown else { panic!("{flown:?}") };
    assert_eq!(time_s, sample as f64 / 20.0);
}
