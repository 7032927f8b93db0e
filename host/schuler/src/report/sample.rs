//! Artificial runs for the tests of the report: smooth errors of a plausible size.

use schuler::trajectory::harmonic::Harmonic;
use schuler_simulator::flight::{
    Edges, Extremes, Flight, Instant, Nine, Skipped, StageTimes, Used,
};
use schuler_simulator::scene::{
    Channel, GaussMarkov, Link, Navigator, Scene, SensorErrors, Trajectory, WindowShape,
};
use schuler_simulator::units::{DEGREE, DEGREE_PER_HOUR, DEGREE_PER_ROOT_HOUR, MICRO_G};
use std::f64::consts::{FRAC_PI_6, TAU};

fn instant(time_s: f64, scale: f64) -> Instant {
    let s = time_s / 1800.0;
    let wave = |period_s: f64| (TAU * time_s / period_s).sin();
    let nine = |position: f64, velocity: f64, attitude: f64| Nine {
        position_m: [1.0, -0.8, 1.6].map(|share| scale * share * position),
        velocity_m_s: [1.0, 0.7, -1.4].map(|share| scale * share * velocity),
        attitude_arcsec: [1.0, -1.1, 0.9].map(|share| scale * share * attitude),
    };
    let mut sigma = nine(1100.0 * s.powi(3), 2.2 * s.powi(2), 95.0 * s.sqrt());
    let Nine { position_m, velocity_m_s, attitude_arcsec } = &mut sigma;
    for value in position_m.iter_mut().chain(velocity_m_s).chain(attitude_arcsec) {
        *value = value.abs();
    }
    let drift = nine(
        -850.0 * s.powi(3) * (1.0 + 0.2 * wave(700.0)),
        -1.9 * s.powi(2) + 0.1 * wave(430.0),
        -60.0 * s + 4.0 * wave(97.0) + wave(3.1),
    );
    let swing = (TAU * time_s / 7200.0).cos();
    Instant {
        time_s,
        drift,
        mean: nine(420.0 * s.powi(3), 0.7 * s.powi(2), 40.0 * s),
        sigma,
        position: [45.0 + 5.0 * swing, 100.0 + 5.0 * swing, 3500.0 + 2000.0 * swing],
        attitude_deg: [5.0 * swing, 5.0 * swing, 5.0 * swing],
        ..Instant::default()
    }
}

fn channel(offset: f64, amplitude: f64, phase: f64) -> Channel {
    let harmonic = Harmonic { amplitude, angular_rate: TAU / 7200.0, phase };
    Channel { offset, rate: 0.0, harmonics: vec![harmonic] }
}

/// A run like the paper's.
pub fn flight() -> Flight {
    scaled(1.0)
}

/// A run like the paper's with errors so many times larger.
pub fn scaled(scale: f64) -> Flight {
    let times = |step_s: f64, count: u32| (1..=count).map(move |k| f64::from(k) * step_s);
    let overview: Vec<Instant> = times(0.9, 2000).map(|time_s| instant(time_s, scale)).collect();
    let last = *overview.last().unwrap();
    let mut components = last.drift;
    components.position_m = components.position_m.map(f64::abs);
    let norms = overview.iter().map(|Instant { drift, .. }| {
        [drift.position_m, drift.velocity_m_s, drift.attitude_arcsec].map(super::norm)
    });
    let norms = norms.fold([0.0; 3], |a: [f64; 3], b| std::array::from_fn(|k| a[k].max(b[k])));
    let angle = 5.0 * DEGREE;
    let markov = |rms: f64| Some(GaussMarkov { rms: [rms; 3], correlation_s: [720.0; 3] });
    let scene = Scene {
        name: "paper".to_owned(),
        title: "The paper's flight".to_owned(),
        text_sha256: "00".repeat(32),
        duration_s: 1800.0,
        rate_hz: 20.0,
        seed: 1,
        trajectory: Trajectory {
            roll: channel(0.0, angle, 0.0),
            pitch: channel(0.0, angle, 0.0),
            yaw: channel(0.0, angle, 0.0),
            latitude: channel(45.0 * DEGREE, angle, 0.0),
            longitude: channel(100.0 * DEGREE, angle, 0.0),
            altitude: channel(3500.0, 2000.0, FRAC_PI_6),
            ..Trajectory::default()
        },
        gyro: SensorErrors {
            constant: Some([0.1 * DEGREE_PER_HOUR; 3]),
            gauss_markov: markov(0.1 * DEGREE_PER_HOUR),
            white: Some([0.01 * DEGREE_PER_ROOT_HOUR; 3]),
            ..Default::default()
        },
        accelerometer: SensorErrors { gauss_markov: markov(100.0 * MICRO_G), ..Default::default() },
        initial_error: Default::default(),
        aiding: Default::default(),
        alignment: None,
        navigator: Navigator::default(),
        link: Link::default(),
    };
    Flight {
        scene,
        samples: 36_000,
        ended: None,
        aligned: None,
        window: Some(WindowShape { history: 2, block: 4, lookahead: 2 }),
        planned: None,
        edges: Some(Edges {
            first: Some(Used { gyro: 6, accelerometer: 14 }),
            last: Some(Used { gyro: 5, accelerometer: 8 }),
        }),
        skipped: vec![Skipped {
            what: "accelerometer white noise".to_owned(),
            why: "the scene has none".to_owned(),
            saved: "31 ns per sample".to_owned(),
        }],
        digest: "0123456789abcdef".to_owned(),
        last,
        max: Extremes { components, norms },
        overview,
        first_minute: times(0.05, 1200).map(|time_s| instant(time_s, scale)).collect(),
        neglected: None,
        saturated: 0,
        outside: None,
        lost: 0,
        link: None,
        aided: None,
        smoothed: Vec::new(),
        time: Some(StageTimes { trajectory_ns: 210.0, emulate_ns: 145.0, navigate_ns: 96.0 }),
    }
}

/// A run with perfect sensors: nanometres, and a theory that expects nothing.
pub fn perfect() -> Flight {
    let mut flight = scaled(5e-12);
    for instant in flight.overview.iter_mut().chain(&mut flight.first_minute) {
        (instant.mean, instant.sigma) = (Nine::default(), Nine::default());
    }
    (flight.last.mean, flight.last.sigma) = (Nine::default(), Nine::default());
    flight.scene.gyro = SensorErrors::default();
    flight.scene.accelerometer = SensorErrors::default();
    flight
}
