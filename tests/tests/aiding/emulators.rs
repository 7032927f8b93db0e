//! Emulators of aiding sensors: their statistics, their faults, and that runs repeat.

use super::drive::{receiver, three};
use schuler::aiding::aided::instant::Instant;
use schuler::aiding::aided::measured::{Kind, Measured};
use schuler::prelude::*;
use schuler::record::Record;
use schuler::sensor::aiding::barometer::Barometer;
use schuler::sensor::aiding::fault::{Outliers, Spoofing};
use schuler::sensor::aiding::gnss::Gnss;
use schuler::sensor::aiding::line::{Delivered, Line, Outage};
use schuler::sensor::aiding::noise::VectorNoise;
use schuler::sensor::aiding::odometer::Odometer;
use schuler::sensor::aiding::still::Still;
use schuler::sensor::aiding::truth::Truth;
use schuler::sensor::aiding::wheels::Wheels;
use schuler::sensor::parameter::{Fault, Parameter};

fn truth() -> Truth<f64> {
    let at = Geodetic { latitude: 0.8, longitude: 0.1, altitude: 100.0 };
    let attitude = Euler { roll: 0.1, pitch: -0.2, yaw: 1.0 };
    let solution = Solution::new(at, Vector::new(10.0, -3.0, 1.0), attitude);
    Truth::of(&solution, Vector::new(0.02, -0.1, 0.3))
}

/// What a receiver says in a number of epochs.
fn said(gnss: &Gnss<f64>, run: u64, epochs: u64) -> Vec<Option<Delivered<f64>>> {
    let gnss = gnss.checked().unwrap();
    let mut state = gnss.start(7, run);
    (1..=epochs).map(|k| gnss.measure(&mut state, &truth(), Instant::of_sample(100 * k))).collect()
}

/// How far from the antenna a position is, by small differences, m.
fn off(measured: &Measured<f64>, lever: Vector<f64>) -> Vector<f64> {
    let truth = truth();
    let antenna = truth.position_at(truth.body_to_ned * lever);
    let (p, a) = (measured.position, antenna);
    let radii = schuler::earth::Radii::at(a.latitude.hi.sin(), a.latitude.hi.cos());
    let h = a.altitude.hi;
    Vector::new(
        (p.latitude - a.latitude).hi * (radii.meridian + h),
        (p.longitude - a.longitude).hi * (radii.prime_vertical + h) * a.latitude.hi.cos(),
        (a.altitude - p.altitude).hi,
    )
}

#[test]
fn a_receiver_has_the_noise_it_is_told() {
    let mut gnss = receiver();
    gnss.position = VectorNoise {
        white: Vector::new(1.0, 2.0, 3.0),
        correlated: Vector::new(2.0, 1.0, 4.0),
        correlation_s: 10.0,
    };
    let epochs = 40_000;
    let said: Vec<_> = said(&gnss, 0, epochs).into_iter().flatten().collect();
    // Those in the outage are missing.
    assert_eq!(said.len() as u64, epochs - 60);
    let errors: Vec<_> = said.iter().map(|d| off(&d.measured, gnss.lever_b)).collect();
    let n = errors.len() as f64;
    let expected = [5.0, 5.0, 25.0];
    for (axis, expected) in expected.into_iter().enumerate() {
        let x = |k: usize| errors[k].into_array()[axis];
        let variance = (0..errors.len()).map(|k| x(k) * x(k)).sum::<f64>() / n;
        assert!((variance / expected - 1.0).abs() < 0.06, "{axis}: {variance}");
        // From epoch to epoch only the correlated part stays, by e^(−0.1).
        let next = (1..errors.len()).map(|k| x(k) * x(k - 1)).sum::<f64>() / n;
        let correlated = gnss.position.correlated.into_array()[axis].powi(2) * (-0.1_f64).exp();
        assert!((next / correlated - 1.0).abs() < 0.12, "{axis}: {next} for {correlated}");
    }
    let truth = truth();
    let velocity = truth.velocity_at(gnss.lever_b);
    let square: f64 = said
        .iter()
        .map(|d| (d.measured.velocity - velocity).dot(d.measured.velocity - velocity))
        .sum();
    assert!((square / n / (3.0 * 0.05 * 0.05) - 1.0).abs() < 0.03);
}

#[test]
fn runs_repeat_and_faults_leave_the_rest() {
    let gnss = receiver();
    let (first, again, other) = (said(&gnss, 3, 500), said(&gnss, 3, 500), said(&gnss, 4, 500));
    assert_eq!(first, again);
    assert_ne!(first, other);
    let outliers = Some(Outliers { probability: 0.05, size_m: 100.0 });
    let faulty = said(&Gnss { outliers, ..gnss }, 3, 500);
    let mut far = 0;
    for (a, b) in first.iter().flatten().zip(faulty.iter().flatten()) {
        assert_eq!(a.measured.velocity, b.measured.velocity);
        let apart = (off(&a.measured, gnss.lever_b) - off(&b.measured, gnss.lever_b)).norm();
        if apart > 1e-6 {
            far += 1;
            assert!((apart - 100.0).abs() < 0.01, "{apart}");
        }
    }
    assert!((8..42).contains(&far), "{far}");
    let spoofing = Spoofing {
        from_s: 100.0,
        until_s: 200.0,
        jump_ned: Vector::new(0.0, 5.0, 0.0),
        ramp_ned: Vector::new(0.5, 0.0, 0.0),
    };
    let forged = said(&Gnss { spoofing: Some(spoofing), ..gnss }, 3, 500);
    let moved = |k: usize| {
        let (a, b) = (first[k].unwrap().measured, forged[k].unwrap().measured);
        (off(&b, gnss.lever_b) - off(&a, gnss.lever_b), b.velocity - a.velocity)
    };
    assert_eq!(moved(98).0.norm(), 0.0);
    let (place, velocity) = moved(149);
    assert!((place - Vector::new(25.0, 5.0, 0.0)).norm() < 1e-3, "{place:?}");
    assert!((velocity.x - 0.5).abs() < 1e-12);
    assert_eq!(moved(205).0.norm(), 0.0);
}

#[test]
fn transport_delays_loses_and_repeats() {
    let mut gnss = receiver();
    gnss.line =
        Line { latency_s: 0.2, jitter_s: 0.3, loss: 0.1, repetition: 0.2, ..Line::every(1.0) };
    let all = said(&gnss, 1, 4000);
    let heard: Vec<_> = all.iter().flatten().collect();
    let lost = 4000 - heard.len();
    assert!((320..480).contains(&lost), "{lost}");
    let mut mean = 0.0;
    for d in &heard {
        let late = d.arrives_s - d.measured.at.samples as f64 / 100.0;
        assert!((0.2..0.5).contains(&late));
        assert!(d.again_s.is_none_or(|again| again > d.arrives_s && again < d.arrives_s + 0.6));
        mean += late / heard.len() as f64;
    }
    assert!((mean - 0.35).abs() < 0.01, "{mean}");
    let again = heard.iter().filter(|d| d.again_s.is_some()).count() as f64;
    assert!((again / heard.len() as f64 - 0.2).abs() < 0.03);
    // What is heard is what would have been heard without loss.
    let whole = said(&Gnss { line: Line::every(1.0), ..gnss }, 1, 4000);
    for (a, b) in all.iter().zip(whole) {
        assert!(a.is_none_or(|a| a.measured == b.unwrap().measured));
    }
}

#[test]
fn a_restored_receiver_goes_on() {
    let mut gnss = receiver();
    gnss.position.correlated = three(1.0);
    gnss.outliers = Some(Outliers { probability: 0.1, size_m: 50.0 });
    let mut state = gnss.start(7, 0);
    let truth = truth();
    let next = |state: &mut _| gnss.measure(state, &truth, Instant::of_sample(1));
    for _ in 0..20 {
        next(&mut state);
    }
    let mut words = Vec::new();
    state.record("", &mut |_, bits| words.push(bits));
    let mut back = gnss.start(1, 1);
    let mut kept = words.into_iter();
    back.restore("", &mut |_, _| kept.next().unwrap());
    assert!(kept.next().is_none());
    for _ in 0..20 {
        assert_eq!(next(&mut back), next(&mut state));
    }
}

#[test]
fn a_barometer_wanders() {
    let barometer = Barometer {
        lever_b: Vector::new(0.0, 0.0, -1.0),
        ..Barometer::new(Line::every(1.0), 0.3, 5.0, 50.0)
    };
    let truth = truth();
    let below = (truth.body_to_ned * barometer.lever_b).z;
    let (mut square, mut change, mut n) = (0.0, 0.0, 0.0);
    for run in 0..40 {
        let mut state = barometer.checked().unwrap().start(9, run);
        let mut last: Option<f64> = None;
        for k in 0..2000 {
            let d = barometer.measure(&mut state, &truth, Instant::of_sample(k)).unwrap();
            let error = d.measured.position.altitude.hi - (100.0 - below);
            square += error * error;
            change += last.map_or(0.0, |last| (error - last) * (error - last));
            (last, n) = (Some(error), n + 1.0);
        }
    }
    let expected = 25.0 + 0.09;
    assert!((square / n / expected - 1.0).abs() < 0.1, "{}", square / n);
    // 2·0.3² + 2·5²(1 − e^(−1/50))
    let expected = 0.18 + 50.0 * (1.0 - (-0.02_f64).exp());
    assert!((change / n / expected - 1.0).abs() < 0.05, "{}", change / n);
}

#[test]
fn an_odometer_scales_and_counts() {
    let lever = Vector::new(-1.0, 0.0, 0.5);
    let odometer = Odometer {
        lever_b: lever,
        scale: 0.02,
        quantum: 0.1,
        ..Odometer::new(Line::every(0.1), 0.05)
    };
    let truth = truth();
    let speed = truth.velocity_b_at(lever).x * 1.02;
    let mut state = odometer.checked().unwrap().start(9, 0);
    let (mut sum, mut square) = (0.0, 0.0);
    let n = 20_000;
    for k in 0..n {
        let d = odometer.measure(&mut state, &truth, Instant::of_sample(k)).unwrap();
        assert_eq!((d.measured.kind, d.measured.degrees()), (Kind::Speed, 1));
        let read = d.measured.velocity.x;
        assert!((read / 0.1 - (read / 0.1).round()).abs() < 1e-9);
        sum += (read - speed) / n as f64;
        square += (read - speed).powi(2) / n as f64;
    }
    assert!(sum.abs() < 2e-3, "{sum}");
    // Noise, and a step's own q²/12.
    assert!((square / (0.0025 + 0.01 / 12.0) - 1.0).abs() < 0.05, "{square}");
    let spread = Odometer { scale_rms: 0.01, ..odometer };
    let scales: Vec<f64> = (0..400).map(|run| spread.start(9, run).scale - 0.02).collect();
    let rms = (scales.iter().map(|x| x * x).sum::<f64>() / 400.0).sqrt();
    assert!((rms / 0.01 - 1.0).abs() < 0.15, "{rms}");
}

#[test]
fn parameters_out_of_range_are_named() {
    let line = Line::every(1.0_f64);
    let gnss = receiver();
    let backwards = Outage { from_s: 5.0, until_s: 4.0 };
    let faults = [
        (Line { interval_s: 0.0, ..line }.checked().err(), Parameter::Interval, Fault::NotPositive),
        (Line { latency_s: -0.1, ..line }.checked().err(), Parameter::Latency, Fault::Negative),
        (Line { jitter_s: f64::NAN, ..line }.checked().err(), Parameter::Jitter, Fault::NotFinite),
        (Line { loss: 1.5, ..line }.checked().err(), Parameter::Probability, Fault::OutOfRange),
        (
            line.with_outage(backwards).unwrap().checked().err(),
            Parameter::FaultTimes,
            Fault::OutOfRange,
        ),
        (
            Gnss { position_sigma: three(0.0), ..gnss }.checked().err(),
            Parameter::ClaimedSigma,
            Fault::NotPositive,
        ),
        (
            Gnss { lever_b: three(f64::NAN), ..gnss }.checked().err(),
            Parameter::LeverArm,
            Fault::NotFinite,
        ),
        (
            Barometer::new(line, -1.0, 1.0, 1.0).checked().err(),
            Parameter::MeasurementNoise,
            Fault::Negative,
        ),
        (
            Barometer::new(line, 1.0, 1.0, 0.0).checked().err(),
            Parameter::CorrelationTime,
            Fault::NotPositive,
        ),
        (Odometer::new(line, 0.0).checked().err(), Parameter::ClaimedSigma, Fault::NotPositive),
        (Still::new(line, -1.0).checked().err(), Parameter::ClaimedSigma, Fault::NotPositive),
        (
            Wheels::new(line, f64::INFINITY).checked().err(),
            Parameter::ClaimedSigma,
            Fault::NotFinite,
        ),
    ];
    for (n, (error, parameter, fault)) in faults.into_iter().enumerate() {
        let error = error.unwrap();
        assert_eq!((error.parameter, error.fault), (parameter, fault), "{n}");
    }
}
