//! Barometer, odometer, wheels, standing still; lever arm and latency that are estimated.

use super::drive::{self, LEVER, RATE_HZ, Truth, fly, heard, receiver, settings};
use super::figures::{Flown, Read, quadratic};
use schuler::aiding::aided::instant::Instant;
use schuler::aiding::aided::measured::{Measured, Sensor};
use schuler::aiding::aided::navigator::{Aided, Aided15, Aided21};
use schuler::aiding::aided::settings::Settings;
use schuler::aiding::aided::state::AidedState;
use schuler::aiding::states::Process;
use schuler::aiding::states::latency::Latency;
use schuler::aiding::states::lever_arm::LeverArm;
use schuler::aiding::states::scale::Scale;
use schuler::earth::Radii;
use schuler::prelude::*;
use schuler::sensor::aiding::barometer::Barometer;
use schuler::sensor::aiding::line::Line;
use schuler::sensor::aiding::odometer::Odometer;
use schuler::sensor::aiding::still::Still;
use schuler::sensor::aiding::wheels::Wheels;
use schuler::trajectory::harmonic::{Channel, Channels, Harmonic, HarmonicTrajectory};
use schuler::units::DEGREE;

const HEADING: f64 = 2.0 * DEGREE;

type All = Aided21<Navigator4<f64>>;
type AllState = AidedState<Navigator4<f64>, 21, 231, 6, 32, 16>;

fn aided(change: impl FnOnce(&mut Settings<f64>)) -> All {
    let mut settings = settings(HEADING);
    change(&mut settings);
    Aided::new(Navigator4::from_rate_hz(RATE_HZ).unwrap(), Pair::of(0.01), settings).unwrap()
}

/// To and fro along the meridian, at up to 21 m/s; the vehicle rolls and points along its way.
fn shuttle(seconds: f64) -> Truth {
    let latitude = 45.0 * DEGREE;
    let radii = Radii::at(latitude.sin(), latitude.cos());
    let wave = |amplitude: f64, period: f64| {
        [Harmonic { amplitude, angular_rate: core::f64::consts::TAU / period, phase: 0.3 }]
    };
    let (north, roll) = (wave(200.0 / radii.meridian, 60.0), wave(3.0 * DEGREE, 11.0));
    let flight = HarmonicTrajectory::<f64, 16>::new(Channels {
        roll: Channel { harmonics: &roll, ..Channel::constant(0.0) },
        pitch: Channel::constant(0.0),
        yaw: Channel::constant(0.0),
        latitude: Channel { harmonics: &north, ..Channel::constant(latitude) },
        longitude: Channel::constant(8.0 * DEGREE),
        altitude: Channel::constant(200.0),
    });
    drive::truth_of(&flight.unwrap(), seconds)
}

/// Samples at which a line of sensors measures.
fn epochs(every_s: f64, seconds: f64) -> impl Iterator<Item = u64> {
    let step = (every_s * RATE_HZ).round() as u64;
    (1..).map(move |k| k * step).take_while(move |k| *k as f64 <= seconds * RATE_HZ)
}

fn last(flown: &Flown) -> &Read {
    flown.reads.last().unwrap()
}

/// eᵀP⁻¹e summed over runs against a χ² at 99.9 %.
fn consistent(sum: f64, degrees: f64) {
    let bound = 3.3 * (2.0 * degrees).sqrt();
    assert!((sum - degrees).abs() < bound + 4.0, "{sum} for {degrees}");
}

#[test]
fn wheels_and_barometer_bridge_an_outage() {
    let truth = shuttle(160.0);
    let mut receiver = receiver();
    receiver.line = Line::every(1.0)
        .with_outage(schuler::sensor::aiding::line::Outage { from_s: 100.0, until_s: 160.0 })
        .unwrap();
    let odometer = Odometer { scale_rms: 0.01, ..Odometer::new(Line::every(0.1), 0.1) };
    let barometer = Barometer::new(Line::every(0.5), 0.3, 5.0, 300.0);
    let wheels = Wheels::new(Line::every(0.1), 0.05);
    let (mut sum, mut scales) = (0.0, 0.0);
    for number in 0..6 {
        let run = drive::run(&truth, number, HEADING);
        let free = fly(&aided(|_| {}), &run, &truth, &heard(&receiver, &run, &truth)).0;
        let mut all = heard::<f64>(&receiver, &run, &truth);
        let (mut o, mut b, mut w) =
            (odometer.start(1, number), barometer.start(1, number), wheels.start(1, number));
        for k in epochs(0.1, 160.0) {
            let (at, motion) = (Instant::of_sample(k), &truth.motions[k as usize]);
            let said = [
                odometer.measure(&mut o, motion, at),
                wheels.measure(&mut w, at),
                (k % 50 == 0).then(|| barometer.measure(&mut b, motion, at)).flatten(),
            ];
            all.extend(said.into_iter().flatten().map(|d| (d.arrives_s, d.measured)));
        }
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let aided = aided(|s| {
            s.states.barometer_bias = Some(Process::gauss_markov(5.0, 300.0));
            s.states.odometer_scale = Some(Scale { sigma: 0.01, per_root_s: 0.0 });
        });
        let (flown, state) = fly(&aided, &run, &truth, &all);
        let sigma = |flown: &Flown| {
            last(flown).covariance[0][0].sqrt().max(last(flown).covariance[2][2].sqrt())
        };
        assert!(sigma(&flown) < 0.4 * sigma(&free), "{} of {}", sigma(&flown), sigma(&free));
        sum += last(&flown).nees([0, 1, 2, 3, 4, 5, 6, 7, 8]);
        let [_, scale, ..] = *state.filter().extras();
        let error = (scale - o.scale) / state.filter().covariance().sigma(16);
        scales += error * error;
        assert_eq!(state.tally(Sensor::NonHolonomic).refused(), 0);
        for sensor in [Sensor::Odometer, Sensor::Barometer] {
            let tally = state.tally(sensor);
            let bound = 4.0 * (2.0 / f64::from(tally.degrees())).sqrt();
            assert!(
                (tally.consistency() - 1.0).abs() < bound,
                "{sensor:?}: {}",
                tally.consistency()
            );
        }
    }
    consistent(sum, 54.0);
    consistent(scales, 6.0);
}

#[test]
fn wheels_do_not_mislead_a_heading_that_is_looked_for() {
    let truth = shuttle(60.0);
    let receiver = receiver();
    let wheels = Wheels::new(Line::every(0.1), 0.05);
    for (number, heading) in (0..).zip([150.0, -100.0, 179.0]) {
        let mut run = drive::run(&truth, number, 0.0);
        let turn = Euler { yaw: heading * DEGREE, ..Euler::default() }.quaternion();
        run.start.attitude = turn.map(Pair::new) * run.start.attitude;
        let mut all = heard::<f64>(&receiver, &run, &truth);
        let mut state = wheels.start(1, number);
        let said =
            epochs(0.1, 60.0).filter_map(|k| wheels.measure(&mut state, Instant::of_sample(k)));
        all.extend(said.map(|d| (d.arrives_s, d.measured)));
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let aided = aided(|s| s.start.heading_rad = 1.8);
        let (flown, state) = fly(&aided, &run, &truth, &all);
        assert!(!state.looks_for_heading());
        let (error, variance) = (last(&flown).errors[8], last(&flown).covariance[8][8]);
        assert!(error * error < 16.0 * variance && variance.sqrt() < 0.1 * DEGREE, "{heading}°");
    }
}

#[test]
fn the_end_of_a_stream_is_not_lost() {
    let truth = shuttle(5.0);
    let run = drive::run(&truth, 0, 0.0);
    let navigator = Navigator8::<f64>::from_rate_hz(RATE_HZ).unwrap();
    let aided = Aided15::new(navigator, Pair::of(0.01), settings(HEADING)).unwrap();
    let (_, mut state) = fly(&aided, &run, &truth, &heard(&receiver(), &run, &truth));
    // The last fix waits for samples that no longer come.
    assert_eq!((state.integrated(), state.tally(Sensor::Gnss).accepted()), (496, 4));
    aided.finish(&mut state, &mut ());
    assert_eq!((state.integrated(), state.tally(Sensor::Gnss).accepted()), (500, 5));
}

#[test]
fn standing_still_stops_the_drift() {
    let truth = drive::truth_of(
        &HarmonicTrajectory::<f64, 16>::new(Channels {
            roll: Channel::constant(0.05),
            pitch: Channel::constant(-0.02),
            yaw: Channel::constant(1.0),
            latitude: Channel::constant(45.0 * DEGREE),
            longitude: Channel::constant(8.0 * DEGREE),
            altitude: Channel::constant(200.0),
        })
        .unwrap(),
        60.0,
    );
    let still = Still::new(Line::every(1.0), 0.01);
    let mut sum = 0.0;
    for number in 0..8 {
        let run = drive::run(&truth, number, HEADING);
        let mut state = still.start(1, number);
        let said = |k: u64| {
            let motion = &truth.motions[k as usize];
            still
                .measure(&mut state, motion, Instant::of_sample(k))
                .map(|d| (d.arrives_s, d.measured))
        };
        let all: Vec<_> = epochs(1.0, 60.0).filter_map(said).collect();
        assert_eq!(all.len(), 60);
        let flown = fly(&aided(|_| {}), &run, &truth, &all).0;
        let read = last(&flown);
        // A metre at the start, and some centimetres since.
        assert!(read.covariance[0][0].sqrt() < 1.1 && read.covariance[3][3].sqrt() < 0.01);
        sum += read.nees([0, 1, 2, 3, 4, 5, 6, 7, 8]);
    }
    consistent(sum, 72.0);
}

#[test]
fn a_lever_arm_and_a_latency_are_found() {
    let truth = drive::truth(200.0);
    let receiver = receiver();
    let mut sums = [0.0; 2];
    for number in 0..4 {
        let run = drive::run(&truth, number, HEADING);
        // Its stamps are 0.12 s late.
        let late = 12;
        let stamped = |(_, m): (f64, Measured<f64>)| {
            let at = Instant::of_sample(m.at.samples + late);
            (at.samples as f64 / RATE_HZ, Measured { at, ..m })
        };
        let all: Vec<_> = heard(&receiver, &run, &truth).into_iter().map(stamped).collect();
        let aided = aided(|s| {
            s.lever_b = Vector::ZERO;
            s.states.lever_arm = Some(LeverArm { sigma: 1.0 });
            s.states.latency = Some(Latency { sigma_s: 0.2 });
        });
        let (flown, state): (Flown, AllState) = fly(&aided, &run, &truth, &all);
        let [x, y, z, latency, ..] = *state.filter().extras();
        let ud = state.filter().covariance();
        let lever = Vector::new(x, y, z) - LEVER;
        let p = [0, 1, 2].map(|i| [0, 1, 2].map(|j| ud.covariance(15 + i, 15 + j)));
        sums[0] += quadratic(p, lever.into_array());
        sums[1] += ((latency - 0.12) / ud.sigma(18)).powi(2);
        assert!(ud.sigma(18) < 0.01 && ud.sigma(15) < 0.5, "{} {}", ud.sigma(18), ud.sigma(15));
        assert!(last(&flown).nees([0, 1, 2]) < 20.0);
        let refused = state.tally(Sensor::Gnss).refused();
        assert!(refused <= 1, "{refused}");
    }
    consistent(sums[0], 12.0);
    consistent(sums[1], 4.0);
}
