//! Terms that act on the motion: matrices, bandwidth, latency, temperature, each against its closed form.

use schuler::math::quaternion::Matrix;
use schuler::math::vector::Vector;
use schuler::noise::Streams;
use schuler::sample::Increment;
use schuler::sensor::bandwidth::Bandwidth;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::g_sensitivity_matrix::GSensitivityMatrix;
use schuler::sensor::latency::{LONGEST, Latency};
use schuler::sensor::misalignment::Misalignment;
use schuler::sensor::misalignment_matrix::MisalignmentMatrix;
use schuler::sensor::parameter::{Fault, Parameter, ParameterError};
use schuler::sensor::temperature::Ramp;
use schuler::sensor::temperature_bias::TemperatureBias;
use schuler::sensor::temperature_scale::TemperatureScale;
use schuler::sensor::white::White;
use schuler::sensor::{ErrorTerm, Reading, Stimulus, Timing};
use std::f64::consts::{PI, TAU};

const INTERVAL_S: f64 = 0.01;

fn timing() -> Timing<f64> {
    Timing::new(INTERVAL_S, 10_000).unwrap()
}

fn axes(x: f64) -> Vector<f64> {
    Vector::new(x, x, x)
}

/// What a term reads of increments, on the x axis.
fn read(
    term: &impl ErrorTerm<f64>,
    sensed: impl IntoIterator<Item = Vector<f64>>,
) -> Vec<Vector<f64>> {
    let mut state = term.start(Streams::new(1, 0));
    let one = |sensed| {
        let mut reading = Reading::new(sensed);
        let velocity_b = Vector::new(1.0, -2.0, 4.0);
        term.apply(&mut state, &Stimulus { sensed, velocity_b }, &mut reading);
        reading.increment
    };
    sensed.into_iter().map(one).collect()
}

#[test]
fn matrices_are_full() {
    let rows = [[0.5, 0.25, 0.125], [1.0, 2.0, 4.0], [-8.0, 16.0, 32.0]];
    let x = Vector::new(1.0, 2.0, 4.0);
    let term = MisalignmentMatrix::new(Matrix::from(rows)).unwrap();
    assert_eq!(read(&term, [x])[0] - x, Vector::new(1.5, 21.0, 152.0));
    let term = GSensitivityMatrix::new(Matrix::from(rows)).unwrap();
    assert_eq!(read(&term, [x])[0] - x, Vector::new(0.5, 13.0, 88.0));
    // A rotation is the skew matrix of it.
    let m = Vector::new(0.5, 0.25, 0.125);
    let rotation = Misalignment::new(m).unwrap();
    let skew = [[0.0, m.z, -m.y], [-m.z, 0.0, m.x], [m.y, -m.x, 0.0]];
    let matrix = MisalignmentMatrix::new(Matrix::from(skew)).unwrap();
    assert_eq!(read(&rotation, [x]), read(&matrix, [x]));
    let mut bad = rows;
    bad[1][2] = f64::NAN;
    let refused = |parameter| ParameterError { parameter, axis: Some(1), fault: Fault::NotFinite };
    assert_eq!(
        MisalignmentMatrix::new(Matrix::from(bad)),
        Err(refused(Parameter::MisalignmentMatrix))
    );
    assert_eq!(
        GSensitivityMatrix::new(Matrix::from(bad)),
        Err(refused(Parameter::GSensitivityMatrix))
    );
}

#[test]
fn a_step_is_followed_exponentially() {
    let frequencies = Vector::new(2.0, 20.0, 200.0);
    let term = Bandwidth::new(frequencies, timing()).unwrap();
    let samples = 40;
    let step = (0..samples).map(|n| axes(if n == 0 { 0.0 } else { INTERVAL_S }));
    let outputs = read(&term, step);
    let lag = frequencies.map(|f| 1.0 / (TAU * f));
    // The rate 1 from 0 on: ∫(1 − e^{−t/T}) = Δt − T(e^{−t/T} − e^{−(t + Δt)/T})
    for (n, output) in outputs.iter().enumerate().skip(1) {
        let from_s = (n - 1) as f64 * INTERVAL_S;
        let expected =
            lag.map(|t| INTERVAL_S + t * (-from_s / t).exp() * (-INTERVAL_S / t).exp_m1());
        let off = (*output - expected).norm();
        assert!(off < 1e-16, "{n}: {off:e}");
    }
    // From the start on a constant rate is read as it is.
    assert!(read(&term, [axes(0.3); 5]).iter().all(|output| *output == axes(0.3)));
}

/// Amplitude and phase of what is read of an oscillation of a rate, over its own.
fn response(term: &impl ErrorTerm<f64>, frequency_hz: f64) -> [f64; 2] {
    let turns = TAU * frequency_hz;
    let angle = |n: f64| (turns * n * INTERVAL_S).sin() / turns;
    let samples = 4000;
    let motion = (0..samples).map(|n| axes(angle(f64::from(n) + 1.0) - angle(f64::from(n))));
    let outputs = read(term, motion.clone());
    // Whole periods, long after the start.
    let project = |values: &mut dyn Iterator<Item = f64>| {
        values.enumerate().fold([0.0; 2], |[a, b], (n, x)| {
            let phase = turns * (n as f64 + 0.5) * INTERVAL_S;
            [a + x * phase.cos(), b + x * phase.sin()]
        })
    };
    let [a, b] = project(&mut outputs.iter().skip(2000).map(|output| output.x));
    let [c, d] = project(&mut motion.skip(2000).map(|input| input.x));
    [a.hypot(b) / c.hypot(d), b.atan2(a) - d.atan2(c)]
}

#[test]
fn an_oscillation_is_damped_and_late() {
    // 1/(1 + jf/f₀); the rate within a sample is taken as constant, which is off by (πf Δt)²/3 at most.
    for (frequency_hz, cutoff_hz) in [(0.5, 1.0), (1.0, 1.0), (1.0, 5.0), (2.0, 5.0), (5.0, 5.0)] {
        let term = Bandwidth::new(axes(cutoff_hz), timing()).unwrap();
        let [amplitude, late] = response(&term, frequency_hz);
        let ratio: f64 = frequency_hz / cutoff_hz;
        let within = (PI * frequency_hz * INTERVAL_S).powi(2) / 3.0 + 1e-9;
        assert!(
            (amplitude * ratio.hypot(1.0) - 1.0).abs() < within,
            "{frequency_hz} {cutoff_hz}: {amplitude}"
        );
        assert!((late - ratio.atan()).abs() < within, "{frequency_hz} {cutoff_hz}: {late}");
    }
    // A delay turns by 2πfD, whole samples exactly; a fraction φ damps by (2πfΔt)²φ(1 − φ)/2.
    for delay_s in [0.03, 0.08, 0.0125] {
        let term = Latency::new(axes(delay_s), timing()).unwrap();
        let [amplitude, late] = response(&term, 2.0);
        let turn = TAU * 2.0 * delay_s;
        let part = delay_s / INTERVAL_S - (delay_s / INTERVAL_S + 1e-9).floor();
        let damped = (TAU * 2.0 * INTERVAL_S).powi(2) * part * (1.0 - part) / 2.0;
        assert!(
            (amplitude - 1.0 + damped).abs() < 0.1 * damped.abs() + 1e-9,
            "{delay_s}: {amplitude}"
        );
        assert!((late - turn).abs() < 0.1 * damped.abs() + 1e-9, "{delay_s}: {late}");
    }
}

#[test]
fn noise_passes_a_bandwidth_by_its_closed_form() {
    let density = 1.0;
    let cutoff_hz = 10.0;
    let white = White::new(axes(density), timing()).unwrap();
    let term = (white, Bandwidth::new(axes(cutoff_hz), timing()).unwrap());
    let unit = Emulator::new(term, (), timing());
    let mut state = unit.start(3, 0);
    let samples = 200_000;
    let (mut squares, mut sum, mut ends) = (0.0, 0.0, 0.0);
    for n in 0..samples {
        let x = unit.emulate(&mut state, &Increment::ZERO).angle_b.x;
        squares += x * x;
        sum += x;
        if n % 1000 == 999 {
            ends += sum * sum;
            sum = 0.0;
        }
    }
    let h = TAU * cutoff_hz * INTERVAL_S;
    let u = -(-h).exp_m1();
    let share = u / h;
    let expected =
        density * density * INTERVAL_S * ((1.0 - share).powi(2) + share * share * u / (2.0 - u));
    // Neighbours are correlated by less than 0.7: the mean square is known to √(2·4/n) or better; five of these.
    let ratio = squares / f64::from(samples) / expected;
    assert!((ratio - 1.0).abs() < 5.0 * (8.0 / f64::from(samples)).sqrt(), "{ratio}");
    // In the long run the density is what it was, less the lag: N²(t − T) at most, here 1.6 ms of 10 s.
    let ratio = ends / 200.0 / (density * density * 10.0);
    assert!((ratio - 1.0).abs() < 5.0 * (2.0_f64 / 200.0).sqrt(), "{ratio}");
}

#[test]
fn a_delay_keeps_what_was_read() {
    let delays = Vector::new(0.0, 0.03, 0.0125);
    let term = Latency::new(delays, timing()).unwrap();
    let motion: Vec<_> = (0..30).map(|n| axes(f64::from(n * n))).collect();
    let outputs = read(&term, motion.iter().copied());
    for (n, output) in outputs.iter().enumerate() {
        let at = |back: usize| motion[n.saturating_sub(back)].x;
        let expected = Vector::new(at(0), at(3), 0.75 * at(1) + 0.25 * at(2));
        assert!((*output - expected).norm() < 1e-12, "{n}: {output:?}");
    }
    let longest = f64::from(LONGEST) * INTERVAL_S;
    assert!(Latency::new(axes(longest), timing()).is_ok());
    let refused = Latency::new(Vector::new(0.0, 1.01 * longest, 0.0), timing()).unwrap_err();
    assert_eq!((refused.axis, refused.fault), (Some(1), Fault::OutOfRange));
    assert_eq!(Latency::new(axes(-0.01), timing()).unwrap_err().fault, Fault::Negative);
    assert_eq!(Bandwidth::new(axes(0.0), timing()).unwrap_err().fault, Fault::NotPositive);
}

#[test]
fn a_bias_follows_a_ramp_that_ends() {
    // 5 K above, 0.2 K/s for 0.125 s: it ends in the middle of a sample.
    let (start_k, rate_k_s, until_s) = (5.0, 0.2, 0.125);
    let ramp = Ramp::new(start_k, rate_k_s, until_s, timing()).unwrap();
    let coefficient = Vector::new(1e-3, -2e-3, 0.0);
    let bias = TemperatureBias::new(coefficient, ramp, timing()).unwrap();
    let scale = TemperatureScale::new(coefficient, ramp).unwrap();
    // ∫T dt
    let integral = |t: f64| {
        let inside = t.min(until_s);
        start_k * t + rate_k_s * (0.5 * inside * inside + until_s * (t - inside))
    };
    let x = axes(0.5);
    let biased = read(&bias, [x; 30]);
    let scaled = read(&scale, [x; 30]);
    for (n, (biased, scaled)) in biased.iter().zip(&scaled).enumerate() {
        let [from, to] = [n as f64, n as f64 + 1.0].map(|n| n * INTERVAL_S);
        let area = integral(to) - integral(from);
        let expected = coefficient * area;
        assert!((*biased - x - expected).norm() < 1e-15, "{n}");
        let expected = coefficient * (area / INTERVAL_S * 0.5);
        assert!((*scaled - x - expected).norm() < 1e-15, "{n}");
    }
    let refused = Ramp::new(0.0, 1.0, 0.0, timing()).unwrap_err();
    assert_eq!((refused.parameter, refused.fault), (Parameter::RampTime, Fault::NotPositive));
    let refused = Ramp::new(0.0, f64::NAN, 1.0, timing()).unwrap_err();
    assert_eq!((refused.parameter, refused.fault), (Parameter::Temperature, Fault::NotFinite));
}
