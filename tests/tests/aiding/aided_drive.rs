//! The drive against what theory allows: errors, their claimed size, and innovations.

use super::drive::{self, RATE_HZ, Run, Truth, fly, heard, receiver, run, settings};
use super::figures::{Figures, Flown, figures};
use super::riccati;
use schuler::aiding::aided::measured::Kind;
use schuler::aiding::aided::navigator::Aided15;
use schuler::aiding::aided::settings::Settings;
use schuler::prelude::*;
use schuler::sensor::aiding::fault::Outliers;
use schuler::sensor::aiding::gnss::Gnss;
use schuler::units::DEGREE;
use std::sync::OnceLock;

const RUNS: u64 = 10;
const HEADING: f64 = 2.0 * DEGREE;

pub fn truth() -> &'static Truth {
    static TRUTH: OnceLock<Truth> = OnceLock::new();
    TRUTH.get_or_init(|| drive::truth(drive::OUTAGE[1]))
}

fn runs() -> &'static [Run] {
    static RUNS_OF: OnceLock<Vec<Run>> = OnceLock::new();
    RUNS_OF.get_or_init(|| (0..RUNS).map(|number| run(truth(), number, HEADING)).collect())
}

fn flown(gnss: &Gnss<f64>, settings: Settings<f64>) -> Vec<Flown> {
    let navigator = Navigator4::<f64>::from_rate_hz(RATE_HZ).unwrap();
    let aided = Aided15::new(navigator, Pair::of(0.01), settings).unwrap();
    let one = |run: &Run| fly(&aided, run, truth(), &heard(gnss, run, truth())).0;
    runs().iter().map(one).collect()
}

/// Whether errors are as large as claimed, by the mean NEES at instants a minute apart.
fn consistent(flown: &[Flown]) {
    let seconds = [120.0, 180.0, 240.0, 300.0, 360.0, 440.0];
    let reads = flown.iter().flat_map(|run| {
        run.reads.iter().filter(|read| seconds.iter().any(|s| (s - read.second).abs() < 0.5))
    });
    let nees: Vec<f64> = reads.map(|read| read.nees([0, 1, 2, 3, 4, 5, 6, 7, 8])).collect();
    let degrees = 9.0 * nees.len() as f64;
    let mean = nees.iter().sum::<f64>() / degrees;
    // Three standard deviations of a χ² by its number of degrees.
    let bound = 3.0 * (2.0 / degrees).sqrt();
    assert!((mean - 1.0).abs() < bound, "NEES {mean}, within {bound} of 1");
}

fn innovations(figures: &Figures, flown: &[Flown]) {
    let degrees: u32 = flown.iter().flat_map(|run| &run.verdicts).map(|v| v.kind.degrees()).sum();
    let bound = 3.0 * (2.0 / f64::from(degrees)).sqrt();
    assert!((figures.nis - 1.0).abs() < bound, "NIS {}, within {bound} of 1", figures.nis);
}

/// Each within a fraction of the other.
fn alike<const K: usize>(a: [f64; K], b: [f64; K], fraction: f64, what: &str) {
    for (n, (a, b)) in a.into_iter().zip(b).enumerate() {
        assert!((a / b - 1.0).abs() < fraction, "{what} {n}: {a} for {b}");
    }
}

#[test]
fn with_positions_it_is_as_good_as_theory_allows() {
    let gnss = Gnss { kind: Kind::Position, ..receiver() };
    let flown = flown(&gnss, settings(HEADING));
    let f = figures(&flown);
    alike(f.claimed, riccati::optimum(false), 0.01, "σ");
    consistent(&flown);
    innovations(&f, &flown);
}

#[test]
fn with_positions_and_velocities_it_is_as_good_as_theory_allows() {
    let flown = flown(&receiver(), settings(HEADING));
    let f = figures(&flown);
    alike(f.claimed, riccati::optimum(true), 0.01, "σ");
    consistent(&flown);
    innovations(&f, &flown);
    // The errors of ten runs: a tenth of a thousand epochs is independent.
    let [position, velocity, ..] = [0, 1].map(|n| f.rms[n] / f.claimed[n]);
    assert!((0.85..1.15).contains(&position) && (0.85..1.15).contains(&velocity), "{f:?}");
}

#[test]
fn late_measurements_lose_nothing_but_their_lateness() {
    let prompt = figures(&flown(&receiver(), settings(HEADING)));
    for (latency_s, jitter_s, horizon_samples) in
        [(0.2, 0.0, None), (1.0, 0.0, None), (0.2, 0.3, Some(55))]
    {
        let mut gnss = receiver();
        (gnss.line.latency_s, gnss.line.jitter_s) = (latency_s, jitter_s);
        let flown = flown(&gnss, Settings { horizon_samples, ..settings(HEADING) });
        consistent(&flown);
        let f = figures(&flown);
        innovations(&f, &flown);
        // When a second is read, the last fix is still on its way.
        assert!(f.rms[0] < 1.05 * f.claimed[0].max(prompt.rms[0]), "{latency_s} s: {f:?}");
        assert!((f.rms[0] / f.claimed[0] / (prompt.rms[0] / prompt.claimed[0]) - 1.0).abs() < 0.01);
    }
}

#[test]
fn single_precision_flies_as_double() {
    let run = &runs()[0];
    let double = &flown(&receiver(), settings(HEADING))[0];
    let local = Aided15::new(
        Navigator4::<f32>::from_rate_hz(RATE_HZ).unwrap(),
        Pair::of(0.01),
        settings(HEADING),
    );
    let fixed = Aided15::new(
        EarthFixedNavigator4::<f32>::from_rate_hz(RATE_HZ).unwrap(),
        Pair::of(0.01),
        settings(HEADING),
    );
    let single = [
        fly(&local.unwrap(), run, truth(), &heard(&receiver(), run, truth())).0,
        fly(&fixed.unwrap(), run, truth(), &heard(&receiver(), run, truth())).0,
    ];
    for single in &single {
        for (a, b) in single.reads.iter().zip(&double.reads) {
            for n in 0..9 {
                let (claimed, sigma) = (a.covariance[n][n].sqrt(), b.covariance[n][n].sqrt());
                assert!((claimed / sigma - 1.0).abs() < 1e-3, "{} s: σ {n}", a.second);
                let apart = (a.errors[n] - b.errors[n]).abs() / sigma;
                assert!(apart < 0.02, "{} s: component {n} by {apart} σ", a.second);
            }
        }
    }
}

#[test]
fn look_ahead_costs_nothing_but_its_delay() {
    let gnss = receiver();
    let navigator = Navigator8::<f64>::from_rate_hz(RATE_HZ).unwrap();
    let aided = Aided15::new(navigator, Pair::of(0.01), settings(HEADING)).unwrap();
    let one = |run: &Run| fly(&aided, run, truth(), &heard(&gnss, run, truth())).0;
    consistent(&runs().iter().map(one).collect::<Vec<_>>());
}

#[test]
fn outliers_are_refused_and_cost_nothing() {
    let clean = figures(&flown(&receiver(), settings(HEADING)));
    let outliers = Some(Outliers { probability: 0.01, size_m: 100.0 });
    let flown = flown(&Gnss { outliers, ..receiver() }, settings(HEADING));
    let f = figures(&flown);
    assert!(f.rms[0] < 1.05 * clean.rms[0], "{} m for {} m", f.rms[0], clean.rms[0]);
    // Of 4100 fixes about 41 are outliers, and 0.4 are refused though they fit.
    assert!((20..70).contains(&f.refused), "{}", f.refused);
    for verdict in flown.iter().flat_map(|run| &run.verdicts).filter(|v| !v.accepted) {
        assert!(verdict.nis > verdict.limit && !verdict.locked_out);
    }
    consistent(&flown);
}

#[test]
fn any_first_heading_will_do() {
    let sigma = 103.0 * DEGREE;
    let mut late = receiver();
    late.line.latency_s = 0.2;
    let headings = [180.0, -179.0, 150.0, -120.0, 91.0, -60.0, 20.0, 0.0];
    let mut sum = 0.0;
    for (number, heading) in (0..).zip(headings) {
        let mut run = run(truth(), number, 0.0);
        let turn = Euler { yaw: heading * DEGREE, ..Euler::default() }.quaternion();
        run.start.attitude = turn.map(Pair::new) * run.start.attitude;
        run.samples.truncate((60.0 * RATE_HZ) as usize);
        let navigator = Navigator4::<f64>::from_rate_hz(RATE_HZ).unwrap();
        let aided = Aided15::new(navigator, Pair::of(0.01), settings(sigma)).unwrap();
        let gnss = if number % 2 == 0 { receiver() } else { late };
        let (flown, state) = fly(&aided, &run, truth(), &heard(&gnss, &run, truth()));
        assert!(!state.looks_for_heading());
        let last = flown.reads.last().unwrap();
        sum += last.nees([6, 7, 8]);
        assert!(last.errors[8].abs() < 0.35 * DEGREE, "{heading}°: {}°", last.errors[8] / DEGREE);
    }
    // χ² of 24 degrees of freedom: 9.9 and 45.6 at 99 %.
    assert!((9.9..45.6).contains(&sum), "{sum}");
}
