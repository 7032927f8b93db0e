//! Neither lanes nor threads show in a run: it has the bits of the same run flown alone.

use super::erring;
use schuler::drift::compare::{Drift, drift};
use schuler::math::compensated::Pair;
use schuler_simulator::ensemble::fleet::{self, Flown};
use schuler_simulator::ensemble::group::{Ground, Unit};
use schuler_simulator::lanes::Registers;
use schuler_simulator::navigator::{self, Navigate, Unavailable};
use schuler_simulator::scene::Vertical;
use schuler_simulator::scene::{self, Axes, Precision, Scene, WindowShape};
use schuler_simulator::simulate;
use schuler_simulator::source::Source;
use std::collections::HashMap;

/// Packs of eight, or of four, the last one with idle lanes.
const RUNS: u64 = 10;

fn bits(drift: &Drift) -> [u64; 9] {
    let Drift { position_ned: r, velocity_ned: v, attitude_ned: a } = drift;
    [r.x, r.y, r.z, v.x, v.y, v.z, a.x, a.y, a.z].map(f64::to_bits)
}

fn all_bits(flown: &Flown) -> Vec<(u64, Vec<[u64; 9]>)> {
    flown.readings.iter().map(|r| (r.samples, r.drifts.iter().map(bits).collect())).collect()
}

fn fly(scene: &Scene, unit: Unit, threads: usize) -> Result<Flown, Unavailable> {
    let source = Source::new(scene, false).unwrap();
    fleet::fly(&Ground::new(scene, &source), RUNS, unit, threads, 3, &|_| {})
}

/// The navigator of one run, before its first sample.
fn started(scene: &Scene, ground: &Ground, run: u64) -> Box<dyn Navigate> {
    let (plan, interval_s) = (ground.plan, Pair::new(scene.rate_hz).reciprocal());
    let (window, order, initial) = (plan.window, plan.order, ground.initial(run));
    navigator::start(&scene.navigator, window, order, interval_s, &initial).unwrap()
}

/// A run as `schuler run` flies one: every row is read, every increment worked out for it alone.
fn alone(scene: &Scene, run: u64) -> Vec<Drift> {
    let source = Source::new(scene, false).unwrap();
    let ground = Ground::new(scene, &source);
    let mut navigator = started(scene, &ground, run);
    let mut drifts = vec![drift(&ground.initial(run), &source.truth(0))];
    let mut read = |n: u64, row: &_| {
        assert_eq!(n, drifts.len() as u64);
        drifts.push(drift(row, &source.truth(n)));
    };
    let mut stream = source.start(run);
    for _ in 0..scene.samples() {
        navigator.push(&stream.advance().unwrap(), &mut read).unwrap();
    }
    navigator.finish(&mut read);
    drifts
}

#[test]
fn every_run_has_its_own_bits_in_every_unit() {
    // A second of turns, ending within a block; the last window is not compiled for lanes.
    let mut scene = erring("hard", 1.63);
    scene.initial_error.velocity_m_s = [1.0, -2.0, 0.5];
    for (history, block, lookahead) in
        [(0, 4, 0), (2, 4, 2), (4, 4, 4), (0, 8, 0), (0, 20, 0), (0, 12, 0)]
    {
        for frame in [Axes::LocalLevel, Axes::EarthFixed] {
            scene.navigator.window = Some(WindowShape { history, block, lookahead });
            scene.navigator.frame = frame;
            let expected: Vec<_> = (0..RUNS).map(|run| alone(&scene, run)).collect();
            assert_ne!(expected[0].last(), expected[1].last());
            for &unit in Unit::ALL {
                let what = format!("{history},{block},{lookahead} {frame:?} {unit:?}");
                let flown = fly(&scene, unit, 2).unwrap();
                assert!(flown.readings.len() >= 3, "{what}");
                assert_eq!(flown.readings.last().map(|r| r.samples), Some(163), "{what}");
                for (samples, drifts) in all_bits(&flown) {
                    let of_rows: Vec<_> =
                        expected.iter().map(|rows| bits(&rows[samples as usize])).collect();
                    assert_eq!(drifts, of_rows, "{what} at {samples}");
                }
            }
        }
    }
}

/// The ends of a held run's blocks, as `schuler run` flies one.
fn held_alone(scene: &Scene, run: u64) -> HashMap<u64, [u64; 9]> {
    let source = Source::new(scene, false).unwrap();
    let ground = Ground::new(scene, &source);
    let mut navigator = started(scene, &ground, run);
    let mut ends = HashMap::new();
    let mut stream = source.start(run);
    for _ in 0..scene.samples() {
        let before = navigator.integrated();
        navigator.push(&stream.advance().unwrap(), &mut |_, _| {}).unwrap();
        let reached = navigator.integrated();
        if reached != before {
            let truth = source.truth(reached);
            navigator.hold_vertical(truth.position.altitude.hi, truth.velocity_ned.z.hi).unwrap();
            ends.insert(reached, bits(&drift(&navigator.solution(), &truth)));
        }
    }
    navigator.finish(&mut |_, _| {});
    let samples = scene.samples();
    ends.insert(samples, bits(&drift(&navigator.solution(), &source.truth(samples))));
    ends
}

#[test]
fn a_held_run_has_its_own_bits_in_every_unit() {
    let mut scene = erring("hard", 1.63);
    scene.navigator.vertical = Vertical::Held;
    for (precision, (history, block, lookahead)) in [
        (Precision::F64, (2, 4, 2)),
        (Precision::F64, (0, 20, 0)),
        (Precision::F64, (0, 12, 0)),
        (Precision::F32, (2, 4, 2)),
    ] {
        for frame in [Axes::LocalLevel, Axes::EarthFixed] {
            scene.navigator.window = Some(WindowShape { history, block, lookahead });
            (scene.navigator.frame, scene.navigator.precision) = (frame, precision);
            let expected: Vec<_> = (0..RUNS).map(|run| held_alone(&scene, run)).collect();
            for &unit in Unit::ALL {
                let what = format!("{history},{block},{lookahead} {frame:?} {unit:?}");
                let flown = all_bits(&fly(&scene, unit, 2).unwrap());
                assert_eq!(flown.last().map(|(samples, _)| *samples), Some(163), "{what}");
                for (samples, drifts) in flown {
                    let alone: Vec<_> = expected.iter().map(|ends| ends[&samples]).collect();
                    assert_eq!(drifts, alone, "{what} at {samples}");
                }
            }
        }
    }
}

#[test]
fn lanes_are_used_where_the_window_has_them() {
    let mut scene = erring("hard", 1.0);
    scene.navigator.window = Some(WindowShape { history: 2, block: 4, lookahead: 2 });
    let widest = |scene: &Scene, runs| {
        let source = Source::new(scene, false).unwrap();
        Ground::new(scene, &source).widest(runs)
    };
    let or = |registers: Registers, slower| {
        if registers.are_there() { Unit::In(registers) } else { slower }
    };
    let four = or(Registers::Avx2, Unit::Alone);
    let eight = or(Registers::Avx512, four);
    assert_eq!(widest(&scene, 4), four);
    assert_eq!(widest(&scene, 8), eight);
    scene.navigator.window = Some(WindowShape { history: 0, block: 12, lookahead: 0 });
    assert_eq!(widest(&scene, 8), Unit::Alone);
}

#[test]
fn threads_do_not_show() {
    // Long enough for more than one stretch of shared increments.
    let scene = erring("paper", 300.0);
    for &unit in Unit::ALL {
        let one = fly(&scene, unit, 1).unwrap();
        assert_eq!(one.readings.iter().map(|r| r.samples).collect::<Vec<_>>(), [2000, 4000, 6000]);
        for threads in [2, 3, 7] {
            let many = fly(&scene, unit, threads).unwrap();
            assert_eq!(all_bits(&many), all_bits(&one), "{unit:?} {threads}");
        }
    }
}

#[test]
fn the_first_run_is_that_of_schuler_run() {
    let scene = erring("paper", 60.0);
    let flown = fly(&scene, Unit::ALL[0], 2).unwrap();
    let flight = simulate::fly(&scene, false, &mut |_| Ok(()), &|_| {}).unwrap();
    let last = flown.readings.last().unwrap();
    assert_eq!(simulate::nine(&last.drifts[0]), flight.last.drift);
}

#[test]
fn where_all_runs_fail_each_says_where() {
    // Toward the pole, where the local-level frame ends.
    let mut scene = erring("polar", 600.0);
    scene.navigator.frame = Axes::LocalLevel;
    let failed = |unit, threads| {
        let flown = fly(&scene, unit, threads).unwrap();
        assert!(flown.readings.iter().all(|reading| reading.drifts.is_empty()));
        flown.failed
    };
    let alone = failed(Unit::Alone, 1);
    assert!(alone.iter().map(|failure| failure.run).eq(0..RUNS), "{alone:?}");
    assert!(alone.iter().all(|failure| failure.sample > 1000), "{alone:?}");
    for &unit in Unit::ALL {
        assert_eq!([failed(unit, 1), failed(unit, 2)], [alone.clone(), alone.clone()], "{unit:?}");
    }
}

#[test]
fn runs_that_fail_do_not_show_in_the_others() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("turns.toml");
    std::fs::write(&file, super::TURNS).unwrap();
    let scene = scene::load(file.to_str().unwrap()).unwrap();
    let source = Source::new(&scene, false).unwrap();
    let ground = Ground::new(&scene, &source);
    // The last pack of each width has idle lanes.
    let flown = |unit| fleet::fly(&ground, 37, unit, 2, 3, &|_| {}).unwrap();
    let alone = flown(Unit::Alone);
    let failed: Vec<_> = alone.failed.iter().map(|failure| failure.run).collect();
    assert!(failed.len() > 1 && failed.len() < 20, "{failed:?}");
    assert!(alone.failed.iter().any(|failure| failure.sample > 8), "{:?}", alone.failed);
    assert_eq!(alone.readings.last().unwrap().drifts.len(), 37 - failed.len());
    for &unit in Unit::ALL {
        let flown = flown(unit);
        assert_eq!(flown.failed, alone.failed, "{unit:?}");
        assert_eq!(all_bits(&flown), all_bits(&alone), "{unit:?}");
    }
}

#[test]
fn saturated_samples_are_counted_over_all_runs() {
    let mut scene = erring("hard", 2.0);
    scene.accelerometer.saturation = Some([0.1; 3]);
    for &unit in Unit::ALL {
        // Gravity alone is beyond it.
        assert_eq!(fly(&scene, unit, 2).unwrap().saturated, 200 * RUNS, "{unit:?}");
    }
}

#[test]
fn saturated_samples_of_runs_that_fail_are_counted_alike_in_every_unit() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("turns.toml");
    // Gravity alone is beyond the limit, in every sample.
    let text =
        super::TURNS.replace("[navigator]", "[accelerometer]\nsaturation_g = 0.1\n[navigator]");
    std::fs::write(&file, text).unwrap();
    let scene = scene::load(file.to_str().unwrap()).unwrap();
    let source = Source::new(&scene, false).unwrap();
    let ground = Ground::new(&scene, &source);
    for &unit in Unit::ALL {
        let flown = fleet::fly(&ground, 37, unit, 2, 3, &|_| {}).unwrap();
        let failed = flown.failed.len() as u64;
        assert!(failed > 1, "{unit:?}");
        let taken: u64 = flown.failed.iter().map(|failure| failure.sample).sum();
        assert_eq!(flown.saturated, (37 - failed) * scene.samples() + taken, "{unit:?}");
    }
}
