//! Every bit: of refusals, of restored states, of measurements that come in any order.

use super::aided_drive::truth;
use super::drive::{Arriving, RATE_HZ, Run, heard, receiver, run, settings, three};
use schuler::aiding::aided::instant::Instant;
use schuler::aiding::aided::measured::{Measured, Sensor};
use schuler::aiding::aided::navigator::Aided15;
use schuler::aiding::aided::settings::Settings;
use schuler::noise::Streams;
use schuler::prelude::*;
use schuler::record::Record;
use schuler::trajectory::Trajectory as _;
use schuler::units::DEGREE;

const SECONDS: usize = 40;
const HEADING: f64 = 2.0 * DEGREE;

type Aided = Aided15<Navigator4<f32>>;
type State = schuler::aiding::aided::state::AidedState<Navigator4<f32>, 15, 120, 0, 32, 16>;

fn words(state: &impl Record) -> Vec<u64> {
    let mut words = Vec::new();
    state.record("", &mut |_, bits| words.push(bits));
    words
}

fn aided(change: impl FnOnce(&mut Settings<f32>)) -> Aided {
    let mut settings = settings(HEADING);
    change(&mut settings);
    let navigator = Navigator4::from_rate_hz(RATE_HZ).unwrap();
    Aided15::new(navigator, Pair::of(0.01), settings).unwrap()
}

fn one_run() -> Run {
    let mut run = run(truth(), 3, HEADING);
    run.samples.truncate(SECONDS * RATE_HZ as usize);
    run
}

fn start(aided: &Aided, run: &Run) -> State {
    aided.start(&Solution::narrow(&run.start)).unwrap()
}

/// Flies samples from one on, with measurements by the number of samples before which they come.
fn fly(
    aided: &Aided,
    state: &mut State,
    run: &Run,
    from: usize,
    arriving: &[(usize, Measured<f32>)],
) {
    for (k, sample) in run.samples.iter().enumerate().skip(from) {
        for (_, measured) in arriving.iter().filter(|(at, _)| *at == k) {
            aided.measure(state, measured).unwrap();
        }
        let narrow = |v: Vector<f64>| v.map(|x| x as f32);
        let sample =
            Increment { angle_b: narrow(sample.angle_b), velocity_b: narrow(sample.velocity_b) };
        aided.push(state, sample).unwrap();
    }
}

/// Each comes just before the sample at whose end it is true.
fn in_time(arriving: &[Arriving<f32>]) -> Vec<(usize, Measured<f32>)> {
    let before = |(_, m): &Arriving<f32>| (m.at.samples as usize - 1, *m);
    arriving.iter().map(before).collect()
}

#[test]
fn a_refused_vector_leaves_every_bit() {
    let (aided, run) = (aided(|_| {}), one_run());
    let mut all = in_time(&heard(&receiver(), &run, truth()));
    let mut without = start(&aided, &run);
    fly(&aided, &mut without, &run, 0, &all);
    // A kilometre off, within a step and within a block.
    for at in [
        Instant { samples: 1515, part: 0.25 },
        Instant::of_sample(2004),
        Instant { samples: 3017, part: 0.5 },
    ] {
        let place = truth().solutions[at.samples as usize].position;
        let mut place = place.map(Pair::narrow);
        place.latitude.hi += 1.6e-4;
        all.push((at.samples as usize, Measured::position(at, place, three(1.0))));
    }
    let mut with = start(&aided, &run);
    fly(&aided, &mut with, &run, 0, &all);
    assert_eq!(with.tally(Sensor::Gnss).refused(), 3);
    assert_eq!(words(with.navigator()), words(without.navigator()));
    assert_eq!(words(with.filter()), words(without.filter()));
}

#[test]
fn a_restored_state_flies_on() {
    let (aided, run) = (aided(|s| s.horizon_samples = Some(130)), one_run());
    let all = in_time(&heard(&receiver(), &run, truth()));
    let middle = 2022;
    let mut half = run.clone();
    half.samples.truncate(middle);
    let mut state = start(&aided, &run);
    fly(&aided, &mut state, &half, 0, &all);
    assert!(state.queue().first().is_some());
    let kept = words(&state);
    let mut back = start(&aided, &run);
    let mut next = kept.iter();
    back.restore("", &mut |_, _| *next.next().unwrap());
    assert!(next.next().is_none() && words(&back) == kept && aided.check(&back).is_ok());
    fly(&aided, &mut state, &run, middle, &all);
    fly(&aided, &mut back, &run, middle, &all);
    assert_eq!(words(&back), words(&state));
    // A damaged one is found out.
    for (field, bits) in [("ud", f32::NAN.to_bits().into()), ("count", 9999), ("integrated", 1)] {
        let mut damaged = back;
        damaged.restore("", &mut |name, old| if name == field { bits } else { old });
        assert!(aided.check(&damaged).is_err(), "{field}");
    }
}

#[test]
fn with_a_horizon_bits_do_not_depend_on_transport() {
    let horizon = 150;
    let (aided, run) = (aided(|s| s.horizon_samples = Some(horizon)), one_run());
    let mut all = heard::<f32>(&receiver(), &run, truth());
    // A second sensor at the same times, and at others.
    for k in (50..run.samples.len()).step_by(50) {
        let altitude = Pair::narrow(truth().solutions[k].position.altitude);
        all.push((0.0, Measured::height(Instant::of_sample(k as u64), altitude, 2.0)));
    }
    let mut stream = Streams::new(11, 0).open();
    let mut flown = |most: f64| {
        let mut arriving: Vec<_> = all
            .iter()
            .map(|(_, m)| {
                let late = (stream.uniform::<f64>() * most) as usize;
                (m.at.samples as usize + late, *m)
            })
            .collect();
        // The last still wait in one case, and are on their way in the other.
        arriving.retain(|(_, m)| m.at.samples as usize + 2 * horizon as usize <= run.samples.len());
        if most > 0.0 {
            arriving.reverse();
        }
        let mut state = start(&aided, &run);
        fly(&aided, &mut state, &run, 0, &arriving);
        assert_eq!(state.transport().late, 0);
        words(&state)
    };
    let prompt = flown(0.0);
    for _ in 0..3 {
        assert_eq!(flown(f64::from(horizon)), prompt);
    }
}

#[test]
fn without_a_horizon_a_late_measurement_counts_as_in_time() {
    let (aided, run) = (aided(|_| {}), one_run());
    let all = heard::<f32>(&receiver(), &run, truth());
    let late = |samples: usize| {
        let mut state = start(&aided, &run);
        let arriving: Vec<_> = all
            .iter()
            .map(|(_, m)| (m.at.samples as usize - 1 + samples, *m))
            .filter(|(_, m)| m.at.samples as usize + 150 < run.samples.len())
            .collect();
        fly(&aided, &mut state, &run, 0, &arriving);
        (aided.solution(&state).position, aided.sigma_ned(&state))
    };
    let (prompt, sigma) = late(0);
    for samples in [3, 17, 60, 130] {
        let (position, other) = late(samples);
        let north = (position.latitude - prompt.latitude).hi * 6.37e6;
        assert!(north.abs() < 0.02 * sigma[0], "{samples} samples late: {north} m of {}", sigma[0]);
        assert!((other[0] / sigma[0] - 1.0).abs() < 0.01);
    }
}

#[test]
fn between_samples_the_navigator_knows_where_it_was() {
    // Perfect samples, and perfect fixes at odd times that come late: what is left is interpolation.
    let flight = super::drive::course();
    let mut settings = settings::<f64>(1e-4);
    settings.start.position_m = 1e-3;
    settings.start.velocity_m_s = 1e-4;
    settings.start.level_rad = 1e-6;
    settings.start.heading_rad = 1e-6;
    let navigator = Navigator4::<f64>::from_rate_hz(RATE_HZ).unwrap();
    let aided = Aided15::new(navigator, Pair::of(0.01), settings).unwrap();
    let mut state = aided.start(&truth().solutions[0]).unwrap();
    let mut verdicts = super::drive::Verdicts(Vec::new());
    let lever = super::drive::LEVER;
    let mut pending = Vec::new();
    for (k, sample) in truth().increments[..3000].iter().enumerate() {
        if k % 137 == 100 {
            let time_s = (k as f64 + 0.37) / RATE_HZ;
            let solution = flight.initial_at(Pair::new(time_s));
            let rate = flight.rates_at(Pair::new(time_s)).rate_ib_b;
            let motion = schuler::sensor::aiding::truth::Truth::of(&solution, rate);
            let place = motion.position_at(motion.body_to_ned * lever);
            let at = Instant::from_seconds(time_s, RATE_HZ).unwrap();
            let velocity = motion.velocity_at(lever);
            let fix = Measured::position_velocity(at, place, three(1e-3), velocity, three(1e-3));
            pending.push((k + (k % 53), fix));
        }
        for (_, fix) in pending.extract_if(.., |(when, _)| *when == k) {
            aided.measure(&mut state, &fix).unwrap();
        }
        aided.push_seen(&mut state, *sample, &mut verdicts).unwrap();
    }
    assert!(verdicts.0.len() > 18 && verdicts.0.iter().any(|v| v.age_s > 0.4));
    for verdict in &verdicts.0 {
        // Innovations of less than a tenth of a millimetre and of a millimetre per second.
        assert!(
            verdict.accepted && verdict.nis < 0.01,
            "{} s late: {}",
            verdict.age_s,
            verdict.nis
        );
    }
}
