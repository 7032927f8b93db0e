//! What is refused, what is counted, and what a forged position does.

use super::aided_drive::truth;
use super::drive::{RATE_HZ, Run, fly, heard, receiver, run, settings, three};
use super::figures::Flown;
use schuler::aiding::aided::fault::AidedFault;
use schuler::aiding::aided::instant::Instant;
use schuler::aiding::aided::measured::{Measured, Sensor};
use schuler::aiding::aided::navigator::Aided15;
use schuler::aiding::aided::settings::{Lockout, Settings};
use schuler::aiding::states::scale::Scale;
use schuler::prelude::*;
use schuler::record::Record;
use schuler::sensor::aiding::fault::Spoofing;
use schuler::sensor::aiding::gnss::Gnss;
use schuler::units::DEGREE;

const HEADING: f64 = 2.0 * DEGREE;

type Aided = Aided15<Navigator4<f64>>;

fn aided(change: impl FnOnce(&mut Settings<f64>)) -> Result<Aided, AidedFault> {
    let mut settings = settings(HEADING);
    change(&mut settings);
    Aided15::new(Navigator4::from_rate_hz(RATE_HZ).unwrap(), Pair::of(0.01), settings)
}

fn words(state: &impl Record) -> Vec<u64> {
    let mut words = Vec::new();
    state.record("", &mut |_, bits| words.push(bits));
    words
}

/// Spoils settings.
type Change = fn(&mut Settings<f64>);

#[test]
fn settings_are_checked() {
    let faults: [(Change, AidedFault); 11] = [
        (|s| s.horizon_samples = Some(161), AidedFault::Horizon),
        (|s| s.start.heading_rad = 0.0, AidedFault::Settings),
        (|s| s.start.position_m = f64::NAN, AidedFault::Settings),
        (|s| s.states.gyro_noise = -1e-5, AidedFault::Settings),
        (|s| s.patience = 0, AidedFault::Settings),
        (|s| s.false_refusal = 0.7, AidedFault::Settings),
        (|s| s.step_s = f64::INFINITY, AidedFault::Settings),
        // One state more than the filter has.
        (
            |s| s.states.odometer_scale = Some(Scale { sigma: 0.1, per_root_s: 0.0 }),
            AidedFault::Settings,
        ),
        (|s| s.lever_b = Vector::new(0.0, 101.0, 0.0), AidedFault::Lever),
        (|s| s.odometer_lever_b.z = f64::NAN, AidedFault::Lever),
        (|s| s.barometer_lever_b.y = 101.0, AidedFault::Lever),
    ];
    for (n, (change, fault)) in faults.into_iter().enumerate() {
        assert_eq!(aided(change).err(), Some(fault), "{n}");
    }
    assert!(aided(|_| {}).is_ok());
}

/// A state after a second, and the aided navigator.
fn flying(
    horizon_samples: Option<u32>,
) -> (Aided, schuler::aiding::aided::state::AidedState<Navigator4<f64>, 15, 120, 0, 32, 16>, Run) {
    let aided = aided(|s| s.horizon_samples = horizon_samples).unwrap();
    let run = run(truth(), 1, HEADING);
    let mut state = aided.start(&run.start).unwrap();
    for sample in &run.samples[..1000] {
        aided.push(&mut state, *sample).unwrap();
    }
    (aided, state, run)
}

#[test]
fn measurements_that_can_be_none_leave_every_bit() {
    let (aided, mut state, _) = flying(None);
    let before = words(&state);
    let at = Instant::of_sample(1000);
    let place = truth().solutions[1000].position;
    let put = |change: fn(&mut Geodetic<Pair<f64>>)| {
        let mut place = place;
        change(&mut place);
        Measured::position(at, place, three(1.0))
    };
    let sigma = |x: f64| Measured::position(at, place, Vector::new(1.0, x, 1.0));
    let when =
        |samples: u64, part: f64| Measured::position(Instant { samples, part }, place, three(1.0));
    let cases = [
        (sigma(0.0), AidedFault::Sigma),
        (sigma(-1.0), AidedFault::Sigma),
        (sigma(f64::NAN), AidedFault::Sigma),
        (sigma(f64::INFINITY), AidedFault::Sigma),
        (Measured::zero_velocity(at, 0.0), AidedFault::Sigma),
        (put(|p| p.latitude.hi = 1.6), AidedFault::Place),
        (put(|p| p.latitude.hi = f64::NAN), AidedFault::Place),
        (put(|p| p.longitude.hi = -7.0), AidedFault::Place),
        (put(|p| p.altitude.hi = 1.1e6), AidedFault::Place),
        (Measured::velocity(at, three(f64::NAN), three(0.1)), AidedFault::Velocity),
        (Measured::velocity(at, three(1e6), three(0.1)), AidedFault::Velocity),
        (Measured::speed(at, f64::INFINITY, 0.1), AidedFault::Velocity),
        (when(1000, -0.1), AidedFault::Time),
        (when(1000, 1.0), AidedFault::Time),
        (when(1000, f64::NAN), AidedFault::Time),
        (when(9000, 0.0), AidedFault::Future),
    ];
    for (measured, fault) in cases {
        assert_eq!(aided.measure(&mut state, &measured), Err(fault));
        assert_eq!(words(&state), before, "{fault:?}");
    }
    let broken = Increment { angle_b: three(f64::NAN), velocity_b: Vector::ZERO };
    assert!(matches!(aided.push(&mut state, broken), Err(AidedFault::Rejected(_))));
    assert_eq!(words(&state), before);
}

#[test]
fn what_comes_late_or_again_is_counted() {
    let (aided, mut state, run) = flying(None);
    let still = |sample: u64| Measured::height(Instant::of_sample(sample), Pair::new(200.0), 5.0);
    // The ring has 32 steps of 0.12 s.
    assert_eq!(aided.measure(&mut state, &still(500)), Err(AidedFault::Late));
    // The last step ends with sample 996, the first of the ring with 996 − 31·12.
    assert_eq!(aided.measure(&mut state, &still(623)), Err(AidedFault::Late));
    let mut other = state;
    assert_eq!(aided.measure(&mut other, &still(624)), Ok(()));
    assert_eq!(aided.measure(&mut state, &still(900)), Ok(()));
    assert_eq!(aided.measure(&mut state, &still(900)), Err(AidedFault::Again));
    for sample in &run.samples[1000..1004] {
        aided.push(&mut state, *sample).unwrap();
    }
    assert!(state.queue().first().is_none());
    assert_eq!(aided.measure(&mut state, &still(900)), Err(AidedFault::Again));
    for k in 0..16 {
        assert_eq!(aided.measure(&mut state, &still(1100 + k)), Ok(()));
    }
    assert_eq!(aided.measure(&mut state, &still(1200)), Err(AidedFault::Full));
    let counts = *state.transport();
    assert_eq!((counts.late, counts.again, counts.dropped), (2, 2, 1));
    assert_eq!(state.tally(Sensor::Barometer).accepted(), 1);

    let (aided, mut state, _) = flying(Some(20));
    assert_eq!(aided.measure(&mut state, &still(980)), Err(AidedFault::Late));
    assert_eq!(aided.measure(&mut state, &still(981)), Ok(()));
}

/// A run with a position forged from 200 to 300 s, and a fix each second.
fn spoofed(jump: f64, ramp: f64, lockout: Lockout) -> Flown {
    let north = |x: f64| Vector::new(x, 0.0, 0.0);
    let spoofing = Some(Spoofing {
        from_s: 200.0,
        until_s: 300.0,
        jump_ned: north(jump),
        ramp_ned: north(ramp),
    });
    let gnss = Gnss { spoofing, ..receiver() };
    let mut run = run(truth(), 5, HEADING);
    run.samples.truncate((310.0 * RATE_HZ) as usize);
    let aided = aided(|s| s.lockout = lockout).unwrap();
    fly(&aided, &run, truth(), &heard(&gnss, &run, truth())).0
}

#[test]
fn a_position_that_jumps_is_refused_at_once_and_locks_out() {
    for lockout in [Lockout::Keep, Lockout::Inflate] {
        let flown = spoofed(30.0, 0.0, lockout);
        let at =
            |second: u64| flown.verdicts.iter().find(|v| v.at.samples == second * 100).unwrap();
        assert!(at(199).accepted && !at(200).accepted && at(204).locked_out);
        let worst = |until: f64| {
            let reads = flown.reads.iter().filter(|r| (200.0..=until).contains(&r.second));
            reads.map(|r| r.errors[0].abs()).fold(0.0, f64::max)
        };
        // Free for as long as it refuses.
        assert!(worst(204.0) < 1.0);
        if lockout == Lockout::Keep {
            assert!(flown.verdicts.iter().filter(|v| !v.accepted).count() > 100);
            assert!(worst(300.0) < 20.0);
        } else {
            // It then believes the receiver, and says so.
            assert!(at(205).accepted && worst(300.0) > 25.0);
        }
    }
}

#[test]
fn a_position_that_creeps_is_followed() {
    // Too slow for the gate: what a filter is exposed to.
    let flown = spoofed(0.0, 0.1, Lockout::Inflate);
    let end = flown.reads.iter().find(|r| (r.second - 300.0).abs() < 0.5).unwrap();
    assert!((end.errors[0] - 10.0).abs() < 1.5, "{}", end.errors[0]);
    // Ten times as fast it does not get far without being seen.
    let flown = spoofed(0.0, 1.0, Lockout::Keep);
    let first = flown.verdicts.iter().find(|v| !v.accepted && v.at.samples >= 20_000).unwrap();
    assert!(first.at.samples <= 20_200);
}
