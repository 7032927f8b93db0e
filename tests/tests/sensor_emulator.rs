//! The emulator: perfect sensors, rates, both precisions, and what its noise is a function of.

use schuler::math::quaternion::Matrix;
use schuler::math::vector::Vector;
use schuler::noise::{Deviate, Streams};
use schuler::record::Record;
use schuler::sample::{Increment, Rates};
use schuler::sensor::bandwidth::Bandwidth;
use schuler::sensor::constant::Constant;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::flicker::Flicker;
use schuler::sensor::g_sensitivity::GSensitivity;
use schuler::sensor::g_sensitivity_matrix::GSensitivityMatrix;
use schuler::sensor::gauss_markov::GaussMarkov;
use schuler::sensor::latency::Latency;
use schuler::sensor::misalignment::Misalignment;
use schuler::sensor::misalignment_matrix::MisalignmentMatrix;
use schuler::sensor::quantization::Quantization;
use schuler::sensor::random_walk::RandomWalk;
use schuler::sensor::saturation::Saturation;
use schuler::sensor::scale_factor::ScaleFactor;
use schuler::sensor::temperature::Ramp;
use schuler::sensor::temperature_bias::TemperatureBias;
use schuler::sensor::temperature_scale::TemperatureScale;
use schuler::sensor::triad::Triad;
use schuler::sensor::turn_on::TurnOn;
use schuler::sensor::white::White;
use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing};

fn timing() -> Timing<f64> {
    Timing::new(0.25, 1000).unwrap()
}

fn vector(x: f64, y: f64, z: f64) -> Vector<f64> {
    Vector::new(x, y, z)
}

/// What a term adds to the first sample of a sensor at rest.
fn error(term: &impl ErrorTerm<f64>) -> Vector<f64> {
    let mut state = term.start(Streams::new(1, 0));
    let mut reading = Reading::new(Vector::ZERO);
    let stimulus = Stimulus { sensed: Vector::ZERO, velocity_b: Vector::ZERO };
    term.apply(&mut state, &stimulus, &mut reading);
    reading.increment
}

const X: Vector<f64> = Vector::new(1.0, 2.0, 4.0);
const F: Vector<f64> = Vector::new(16.0, 32.0, -64.0);

#[test]
fn no_errors_leave_increments_bit_for_bit_and_draw_nothing() {
    let perfect =
        Increment { angle_b: vector(-0.0, 1e-300, 0.1), velocity_b: vector(0.3, -7.7, 0.0) };
    let bits =
        |i: Increment<f64>| [i.angle_b, i.velocity_b].map(|v| v.into_array().map(f64::to_bits));
    let emulator = Emulator::new((), ((), ()), timing());
    let mut state = emulator.start(1, 0);
    assert_eq!(bits(emulator.emulate(&mut state, &perfect)), bits(perfect));
    assert_eq!(size_of_val(&state), size_of::<u64>(), "nothing but the count of saturated samples");
    assert_eq!(size_of_val(&((), ())), 0);

    let emulator = Emulator::new(Triad::PERFECT, Triad::PERFECT, timing());
    let mut state = emulator.start(1, 0);
    let before = state.clone();
    assert_eq!(bits(emulator.emulate(&mut state, &perfect)), bits(perfect));
    assert_eq!(state, before);

    let rates =
        Rates { rate_ib_b: vector(0.1, -0.0, 0.03), specific_force_b: vector(0.3, 1.1, 9.8) };
    // 0.03·0.01/0.01 is not 0.03.
    let emulator = Emulator::new((), (), Timing::new(0.01, 1).unwrap());
    let read = emulator.emulate_rates(&mut emulator.start(1, 0), &rates);
    assert_eq!(read, rates);
}

#[test]
fn rates_carry_the_errors_of_a_sample_over_its_interval() {
    let half = vector(0.5, 0.5, 0.5);
    let gyro = (Constant::new(half, timing()).unwrap(), GSensitivity::new(half).unwrap());
    let accelerometer = Quantization::new(half).unwrap();
    let emulator = Emulator::new(gyro, accelerometer, timing());
    let rates = Rates { rate_ib_b: X, specific_force_b: vector(1.0, 9.0, -3.0) };
    let mut state = emulator.start(1, 0);
    let mut sum = Vector::ZERO;
    for _ in 0..16 {
        let read = emulator.emulate_rates(&mut state, &rates);
        assert_eq!(read.rate_ib_b, vector(2.0, 7.0, 3.0));
        // Steps of ½ m/s over ¼ s: 2 m/s²
        let steps = read.specific_force_b * 0.5;
        assert_eq!(steps, steps.map(f64::round));
        sum = sum + read.specific_force_b;
    }
    assert_eq!(sum * 0.0625, rates.specific_force_b);
}

/// Every random term at once, in either precision.
fn noisy<R: Deviate>() -> Emulator<R, Triad<R>, Triad<R>> {
    let timing = Timing::new(R::of(0.05), 1000).unwrap();
    let all = |x: f64| Vector::new(R::narrow(x), R::narrow(2.0 * x), R::narrow(3.0 * x));
    let matrix = Matrix { rows: [all(1e-3), all(-1e-3), all(2e-3)] };
    let ramp = Ramp::new(R::ONE, R::of(0.01), R::of(40.01), timing).unwrap();
    let triad = Triad {
        latency: Some(Latency::new(all(0.03), timing).unwrap()),
        constant: Some(Constant::new(all(1e-3), timing).unwrap()),
        turn_on: Some(TurnOn::new(all(1e-3), timing).unwrap()),
        gauss_markov: Some(GaussMarkov::new(all(1e-3), all(200.0), timing).unwrap()),
        white: Some(White::new(all(1e-4), timing).unwrap()),
        random_walk: Some(RandomWalk::new(all(1e-4), timing).unwrap()),
        flicker: Some(Flicker::new(all(1e-3), timing).unwrap()),
        scale_factor: Some(ScaleFactor::new(all(1e-3)).unwrap()),
        misalignment: Some(Misalignment::new(all(1e-3)).unwrap()),
        g_sensitivity: Some(GSensitivity::new(all(1e-5)).unwrap()),
        misalignment_matrix: Some(MisalignmentMatrix::new(matrix).unwrap()),
        g_sensitivity_matrix: Some(
            GSensitivityMatrix::new(matrix.map(|x| x * R::of(1e-2))).unwrap(),
        ),
        temperature_bias: Some(TemperatureBias::new(all(1e-5), ramp, timing).unwrap()),
        temperature_scale: Some(TemperatureScale::new(all(1e-5), ramp).unwrap()),
        bandwidth: Some(Bandwidth::new(all(4.0), timing).unwrap()),
        saturation: Some(Saturation::new(all(100.0), timing).unwrap()),
        quantization: None,
    };
    Emulator::new(triad, triad, timing)
}

#[test]
fn single_precision_emulates_the_same_sensors() {
    let (single, double) = (noisy::<f32>(), noisy::<f64>());
    let (mut s, mut d) = (single.start(4, 2), double.start(4, 2));
    let perfect = Increment { angle_b: X * 0.0078125, velocity_b: F * 0.03125 };
    let narrow = Increment {
        angle_b: perfect.angle_b.map(|x| x as f32),
        velocity_b: perfect.velocity_b.map(|x| x as f32),
    };
    for _ in 0..1000 {
        let a = single.emulate(&mut s, &narrow);
        let b = double.emulate(&mut d, &perfect);
        let off = a.angle_b.zip(b.angle_b, |a, b| f64::from(a) - b).norm();
        assert!(off < 2e-8, "{off:e} of {:e}", (b.angle_b - perfect.angle_b).norm());
        let off = a.velocity_b.zip(b.velocity_b, |a, b| f64::from(a) - b).norm();
        // Sixteen terms round a sum of 2 m/s by 1.2e-7 at most each, of either sign.
        assert!(off < 8e-7, "{off:e} of {:e}", (b.velocity_b - perfect.velocity_b).norm());
    }
}

#[test]
fn a_run_is_a_function_of_its_seed_and_number_and_goes_on_from_its_record() {
    let emulator = noisy::<f64>();
    let perfect = Increment { angle_b: X, velocity_b: F };
    let run = |seed, run| {
        let mut state = emulator.start(seed, run);
        (0..20).map(|_| emulator.emulate(&mut state, &perfect)).collect::<Vec<_>>()
    };
    assert_eq!(run(1, 5), run(1, 5));
    assert_ne!(run(1, 5)[19], run(1, 6)[19]);
    assert_ne!(run(1, 5)[19], run(2, 5)[19]);

    let mut state = emulator.start(1, 5);
    for _ in 0..10 {
        emulator.emulate(&mut state, &perfect);
    }
    let mut words = Vec::new();
    state.record("", &mut |_, word| words.push(word));
    let mut saved = words.into_iter();
    let mut restored = emulator.start(77, 0);
    restored.restore("", &mut |_, _| saved.next().unwrap());
    assert_eq!(saved.next(), None);
    assert_eq!(restored, state);
    assert_eq!(emulator.emulate(&mut restored, &perfect), run(1, 5)[10]);
}

#[test]
fn a_terms_noise_does_not_depend_on_the_other_terms() {
    let one = vector(1.0, 1.0, 1.0);
    let white = Triad { white: Some(White::new(one, timing()).unwrap()), ..Triad::PERFECT };
    let markov = Triad {
        gauss_markov: Some(GaussMarkov::new(one, one, timing()).unwrap()),
        ..Triad::PERFECT
    };
    let both = Triad { white: white.white, ..markov };
    assert!((error(&both) - error(&white) - error(&markov)).norm() < 1e-15);

    // Nor do two terms of a kind, two axes, or the two triads, share theirs.
    let [x, y, z] = error(&(white, ())).into_array();
    assert!(error(&(white, white)).x != 2.0 * x && x != y && y != z);
    let emulator = Emulator::new(white, white, timing());
    let read = emulator.emulate(&mut emulator.start(1, 0), &Increment::default());
    assert_ne!(read.angle_b, read.velocity_b);
}

/// A term's part in a triad draws from the branch of this number.
fn check_branch(number: u64, term: impl ErrorTerm<f64>, triad: Triad<f64>) {
    let mut state = term.start(Streams::new(1, 0).branch(number));
    let mut reading = Reading::new(Vector::ZERO);
    let stimulus = Stimulus { sensed: Vector::ZERO, velocity_b: Vector::ZERO };
    term.apply(&mut state, &stimulus, &mut reading);
    assert_eq!(reading.increment, error(&triad), "branch {number}");
}

#[test]
fn the_terms_of_a_triad_have_a_branch_of_streams_each() {
    let one = vector(1.0, 1.0, 1.0);
    let term = TurnOn::new(one, timing()).unwrap();
    check_branch(1, term, Triad { turn_on: Some(term), ..Triad::PERFECT });
    let term = GaussMarkov::new(one, one, timing()).unwrap();
    check_branch(2, term, Triad { gauss_markov: Some(term), ..Triad::PERFECT });
    let term = White::new(one, timing()).unwrap();
    check_branch(3, term, Triad { white: Some(term), ..Triad::PERFECT });
    let term = RandomWalk::new(one, timing()).unwrap();
    check_branch(4, term, Triad { random_walk: Some(term), ..Triad::PERFECT });
    let term = Flicker::new(one, timing()).unwrap();
    check_branch(5, term, Triad { flicker: Some(term), ..Triad::PERFECT });
}
