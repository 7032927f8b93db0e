//! A million frames, one in a hundred of them hit.

use super::manner;
use schuler::flight::configuration::{Algorithm, Axes, Configuration, Precision};
use schuler::link::gap::Policy;
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::solution::{Euler, Solution};
use schuler_host::hil::conversation::Conversation;
use schuler_host::hil::in_process::InProcess;
use schuler_host::hil::injector::Injector;
use schuler_host::hil::lockstep::{Boarded, Lockstep, Log, Parts};
use schuler_simulator::navigator;
use schuler_simulator::scene::{Navigator, WindowShape};
use schuler_simulator::simulate::Vehicle;
use schuler_simulator::twin::{Beginning, Twin};

const FRAMES: u64 = 1_000_000;
const RATE_HZ: f64 = 100.0;
/// Samples from one end of a swing to the other.
const SWING: u64 = 400;

#[test]
fn of_a_million_frames_nothing_wrong_is_accepted_and_nothing_right_is_lost() {
    let scene = Navigator {
        precision: Precision::F32,
        algorithm: Algorithm::Textbook,
        ..Navigator::default()
    };
    let (interval_s, initial) = (
        Pair::new(RATE_HZ).reciprocal(),
        Solution::<f64>::new(
            schuler::earth::Geodetic { latitude: 0.8, longitude: 0.2, altitude: 1000.0 },
            Vector::new(0.0, 0.0, 0.0),
            Euler { roll: 0.1, pitch: 0.05, yaw: 1.0 },
        ),
    );
    let configuration = Configuration {
        precision: Precision::F32,
        axes: Axes::LocalLevel,
        algorithm: Algorithm::Textbook,
        window: Configuration::ONE_SAMPLE,
    };
    let beginning = Beginning::new(configuration, 8, Policy::Refuse, interval_s, &initial);
    let twin = Twin::start(&beginning).unwrap();
    let shape = WindowShape { history: 0, block: 1, lookahead: 0 };
    let start = || navigator::start(&scene, shape, 8, interval_s, &initial).unwrap();
    let (rates, seed) = manner("all=0.01", 1, 20).faults.unwrap();
    let mut target = Conversation::new(Box::new(InProcess::single()), 20);
    // The first word of a target is unasked.
    target.greet().unwrap();
    let conversation = target.wrap(|target| Box::new(Injector::new(target, rates, seed)));
    let log = Log::default();
    let (pace, aiding) = (None, None);
    let parts = Parts { conversation, beginning, twin, rate_hz: RATE_HZ, pace, aiding };
    let mut lockstep = Boarded::new(Lockstep::start(parts, log.clone()).unwrap(), start());
    // A navigator that no link lies before.
    let mut alone = start();
    let samples = FRAMES / 2;
    for n in 0..samples {
        let swing = 2.0 * (n % SWING) as f64 / SWING as f64 - 1.0;
        let sample = Increment {
            angle_b: Vector::new(1e-5 * swing, -2e-5 * swing, 1e-6),
            velocity_b: Vector::new(0.005, -0.01 * swing, -0.0978),
        };
        lockstep.push(&sample, &mut |_, _| ()).unwrap_or_else(|why| panic!("{n}: {why:?}"));
        alone.push(&sample, &mut |_, _| ()).unwrap();
        // So that over an hour and more it stays where navigation goes on.
        if n % SWING == 0 {
            lockstep.hold_vertical(1000.0, 0.0).unwrap();
            alone.hold_vertical(1000.0, 0.0).unwrap();
        }
    }
    lockstep.finish(&mut |_, _| ()).unwrap();
    alone.finish(&mut |_, _| ()).unwrap();
    assert_eq!((lockstep.integrated(), lockstep.digest()), (samples, alone.digest()));
    drop(lockstep);
    let tally = &log.lock().unwrap().tally;
    assert!(tally.sent + tally.received > FRAMES, "{tally:?}");
    assert_eq!((tally.lost, tally.not_understood, tally.target.bridged), (0, 0, 0));
    for trace in tally.traces() {
        assert!(trace.is_explained(), "{trace:?} of {tally:?}");
        assert!(trace.injected_to_target + trace.injected_to_host > 400, "{trace:?}");
    }
}
