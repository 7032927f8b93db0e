//! The terms that draw nothing, the order of terms, and the hand-over to single precision. All
//! numbers are exact in binary.

use schuler::flight::carried::Carried;
use schuler::math::vector::Vector;
use schuler::noise::{Deviate, Streams};
use schuler::sample::{Increment, Rates};
use schuler::sensor::constant::Constant;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::g_sensitivity::GSensitivity;
use schuler::sensor::misalignment::Misalignment;
use schuler::sensor::quantization::Quantization;
use schuler::sensor::saturation::Saturation;
use schuler::sensor::scale_factor::ScaleFactor;
use schuler::sensor::triad::Triad;
use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing};

fn timing() -> Timing<f64> {
    Timing::new(0.25, 1000).unwrap()
}

fn vector(x: f64, y: f64, z: f64) -> Vector<f64> {
    Vector::new(x, y, z)
}

/// What a term makes of one sample.
fn reading(
    term: &impl ErrorTerm<f64>,
    sensed: Vector<f64>,
    velocity_b: Vector<f64>,
) -> Reading<f64> {
    let mut state = term.start(Streams::new(1, 0));
    let mut reading = Reading::new(sensed);
    term.apply(&mut state, &Stimulus { sensed, velocity_b }, &mut reading);
    reading
}

fn increment(
    term: &impl ErrorTerm<f64>,
    sensed: Vector<f64>,
    velocity_b: Vector<f64>,
) -> Vector<f64> {
    reading(term, sensed, velocity_b).increment
}

const X: Vector<f64> = Vector::new(1.0, 2.0, 4.0);
const F: Vector<f64> = Vector::new(16.0, 32.0, -64.0);

#[test]
fn linear_terms_are_the_matrices_of_their_definitions() {
    let m = vector(0.5, 0.25, 0.125);
    // A bias over a quarter of a second.
    assert_eq!(
        increment(&Constant::new(m, timing()).unwrap(), X, F),
        vector(1.125, 2.0625, 4.03125)
    );
    // S = diag(½, ¼, ⅛)
    assert_eq!(increment(&ScaleFactor::new(m).unwrap(), X, F), vector(1.5, 2.5, 4.5));
    // G = diag(½, ¼, ⅛)
    assert_eq!(increment(&GSensitivity::new(m).unwrap(), X, F), vector(9.0, 10.0, -4.0));
    // M = −[m×] = (0 ⅛ −¼; −⅛ 0 ½; ¼ −½ 0)
    let turned = vector(1.0 + 0.25 - 1.0, 2.0 - 0.125 + 2.0, 4.0 + 0.25 - 1.0);
    assert_eq!(increment(&Misalignment::new(m).unwrap(), X, F), turned);
}

#[test]
fn a_triad_that_is_turned_to_the_right_feels_forward_on_its_left() {
    // Axes at an angle α to the right: forward reads (cosα, −sinα, 0).
    let alpha = 1e-4f64;
    let term = Misalignment::new(vector(0.0, 0.0, alpha)).unwrap();
    let read = increment(&term, vector(1.0, 0.0, 0.0), F);
    let exact = vector(alpha.cos(), -alpha.sin(), 0.0);
    assert!((read - exact).norm() < alpha * alpha, "{read:?}");
}

#[test]
fn terms_act_in_the_order_of_the_definition() {
    let one = vector(1.0, 1.0, 1.0);
    let full = Triad {
        constant: Some(Constant::new(one * 2.0, timing()).unwrap()),
        scale_factor: Some(ScaleFactor::new(one).unwrap()),
        saturation: Some(Saturation::new(one * 5.375 * 4.0, timing()).unwrap()),
        quantization: Some(Quantization::new(one * 0.5).unwrap()),
        ..Triad::PERFECT
    };
    // (I + S)x + bΔt = 2.5, 4.5, 8.5 (the bias is not scaled); limit 5.375; then steps of a half, of
    // which ten lie within the limit
    let read = reading(&full, X, F);
    assert_eq!(read.increment, vector(2.5, 4.5, 5.0));
    assert!(read.saturated);
    assert!(!reading(&full, one, F).saturated);

    // A tuple acts from left to right.
    let scale = ScaleFactor::new(one).unwrap();
    let limit = Saturation::new(one * 12.0, timing()).unwrap();
    assert_eq!(increment(&(scale, limit), X, F), vector(2.0, 3.0, 3.0));
    assert_eq!(increment(&(limit, scale), X, F), vector(2.0, 4.0, 7.0));
}

#[test]
fn saturation_cuts_both_signs_and_counts_samples() {
    let limit = Saturation::new(vector(4.0, 8.0, 16.0), timing()).unwrap();
    let read = reading(&limit, vector(-1.5, 2.0, -4.0), F);
    assert_eq!((read.increment, read.saturated), (vector(-1.0, 2.0, -4.0), true));
    let read = reading(&limit, vector(-1.0, 2.0, 4.0), F);
    assert_eq!((read.increment, read.saturated), (vector(-1.0, 2.0, 4.0), false));

    let emulator = Emulator::new(limit, limit, timing());
    let mut state = emulator.start(1, 0);
    let small = vector(0.5, 0.5, 0.5);
    let big = X * 9.0;
    for (angle_b, velocity_b) in [(small, small), (-X, X), (big, small), (small, -big), (big, big)]
    {
        emulator.emulate(&mut state, &Increment { angle_b, velocity_b });
    }
    assert_eq!(state.saturated, 3, "samples, not axes or triads");
}

/// At its limit a quantized axis reads the largest whole number of steps within it, always the same,
/// and forgets what it could not put out: half a step at most comes later.
fn at_the_limit<R: Deviate>(sign: R) {
    let of = |x: f64| R::of(x);
    let same = |x: R| Vector::new(x, x, x);
    let timing = Timing::new(of(0.01), 1000).unwrap();
    // 10 °/s for 0.01 s are 3.6 steps of 100″; 12 m/s² 4 steps of 0.03 m/s; 0.5 less than one step.
    let limit = Vector::new(of(10.0), of(12.0), of(0.5));
    let step = Vector::new(of(100.0 / 3600.0), of(0.03), of(0.01));
    let most = Vector::new(of(300.0 / 3600.0), of(0.12), R::ZERO);
    let terms = (Saturation::new(limit, timing).unwrap(), Quantization::new(step).unwrap());
    let mut state = terms.start(Streams::new(1, 0));
    let mut read = |sensed: Vector<R>| {
        let mut reading = Reading::new(sensed);
        terms.apply(&mut state, &Stimulus { sensed, velocity_b: sensed }, &mut reading);
        reading
    };
    let near = |a: Vector<R>, b: Vector<R>| (a - b).norm() <= R::entry(1e-7, 1e-15);
    for _ in 0..200 {
        let reading = read(same(sign * of(0.5)));
        assert!(near(reading.increment, most * sign) && R::any(reading.saturated));
        let limit = limit * of(0.01);
        assert!(
            reading.increment.zip(limit, |x, limit| x.abs() <= limit)
                == Vector::new(true, true, true)
        );
    }
    // Nothing has wound up: what follows is off by half a step.
    let mut sum = Vector::ZERO;
    for _ in 0..10 {
        sum = sum + read(same(-sign * of(0.004))).increment;
    }
    let off = sum + same(sign * of(0.04));
    let half = step * of(0.5001);
    assert!(off.x.abs() <= half.x + half.x && off.y.abs() <= half.y + half.y);
}

#[test]
fn a_limit_holds_for_whole_steps() {
    at_the_limit::<f64>(1.0);
    at_the_limit::<f64>(-1.0);
    at_the_limit::<f32>(1.0);
    at_the_limit::<f32>(-1.0);
}

/// Below its limit, but not by a step: the remainder must not lift the reading over it.
#[test]
fn a_remainder_does_not_lift_a_reading_over_the_limit() {
    let one = vector(1.0, 1.0, 1.0);
    let timing = Timing::new(1.0, 100).unwrap();
    let terms = (Saturation::new(one * 3.6, timing).unwrap(), Quantization::new(one).unwrap());
    let mut state = terms.start(Streams::new(1, 0));
    for n in 0..100 {
        let sensed = one * 3.4;
        let mut reading = Reading::new(sensed);
        terms.apply(&mut state, &Stimulus { sensed, velocity_b: F }, &mut reading);
        assert_eq!(reading.increment, one * 3.0);
        // Cut as soon as what is left over would make four steps.
        assert_eq!(reading.saturated, n > 0, "{n}");
    }
}

/// Rates, too: multiplied by the interval and divided again, a limit does not move up.
#[test]
fn rates_stay_within_the_limit() {
    for rate_hz in [20.0, 60.0, 100.0, 128.0, 299.7, 1000.0] {
        for limit in [10.0, 0.1, 300.0 / 7.0, 1e-3] {
            let timing = Timing::new(1.0 / rate_hz, 10).unwrap();
            let axes = vector(limit, limit, limit);
            let limited = Saturation::new(axes, timing).unwrap();
            let step = limit / rate_hz / 8.0;
            let stepped = Quantization::new(vector(step, step, 0.0)).unwrap();
            let emulator = Emulator::new((limited, stepped), (limited, ()), timing);
            let mut state = emulator.start(1, 0);
            for sign in [1.0, -1.0, 1.0] {
                let huge = axes * (3.0 * sign);
                let perfect = Rates { rate_ib_b: huge, specific_force_b: huge };
                let read = emulator.emulate_rates(&mut state, &perfect);
                for x in read
                    .rate_ib_b
                    .into_array()
                    .into_iter()
                    .chain(read.specific_force_b.into_array())
                {
                    assert!(
                        x.abs() <= limit && x.abs() >= limit * (1.0 - 1e-14),
                        "{rate_hz} {x} {limit}"
                    );
                }
            }
        }
    }
}

#[test]
fn quantization_emits_whole_steps_and_loses_nothing() {
    // Steps that are powers of two keep every sum exact; a step of 0 leaves z continuous.
    let step = vector(0.25, 0.0078125, 0.0);
    let term = Quantization::new(step).unwrap();
    let mut state = term.start(Streams::new(1, 0));
    let mut noise = Streams::new(2, 0).axes();
    let (mut taken, mut given) = (Vector::ZERO, Vector::ZERO);
    for _ in 0..10_000 {
        let [x, y, z] = noise.each_mut().map(|s| (s.normal::<f64>() * 4096.0).round() / 65536.0);
        let sensed = vector(x, y, z);
        let mut reading = Reading::new(sensed);
        term.apply(&mut state, &Stimulus { sensed, velocity_b: F }, &mut reading);
        taken = taken + sensed;
        given = given + reading.increment;
        for (step, out) in [(step.x, reading.increment.x), (step.y, reading.increment.y)] {
            assert_eq!(out / step, (out / step).round(), "whole steps");
        }
        assert_eq!(reading.increment.z, z);
        assert_eq!(taken - given, state, "what is left over is kept");
        for (step, left) in [(step.x, state.x), (step.y, state.y)] {
            assert!(left.abs() <= step / 2.0, "the output is the rounded cumulative sum");
        }
    }
}

#[test]
fn carried_rounding_loses_nothing_of_a_sum() {
    let mut noise = Streams::new(3, 0).axes();
    let mut carried = Carried::default();
    let (mut error, mut plain) = (Vector::ZERO, Vector::ZERO);
    for _ in 0..100_000 {
        let [x, y, z] = noise.each_mut().map(|s| 1e-3 * (3.0 + s.normal::<f64>()));
        let exact = Increment { angle_b: vector(x, y, z), velocity_b: vector(z, x, y) * 100.0 };
        let out: Increment<f32> = carried.narrow(&exact);
        // Differences of single and double precision numbers this close are exact.
        error = error + (exact.angle_b - out.angle_b.map(f64::from));
        plain = plain + exact.angle_b.map(|x| x - f64::from(x as f32));
        let ulp = f64::from(f32::EPSILON) * 2f64.powi(-7);
        assert!(error.is_within(ulp), "{error:?}");
        assert!((error - carried.angle_b).is_within(1e-15));
        assert!(carried.velocity_b.is_within(ulp * 128.0));
    }
    assert!(plain.norm() > 1e-8, "rounding each sample for itself would: {plain:?}");
    let wide: Increment<f64> = Carried::default().narrow(&Increment { angle_b: X, velocity_b: F });
    assert_eq!((wide.angle_b, wide.velocity_b), (X, F));
}
