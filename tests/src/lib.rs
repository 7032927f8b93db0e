//! What the tests share: scenes as streams of perfect samples, the bits of states, numbers to try.

pub mod baseline;
mod numbers;

pub use numbers::{Numbers, bits, largest, near, reader};

/// The code of the repository's front page.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct FrontPage;

use schuler::drift::compare::drift;
use schuler::math::compensated::Pair;
use schuler::output::Output as _;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::mechanization::Mechanization;
use schuler_simulator::scene::{
    Channel, InitialError, Link, Navigator, Scene, SensorErrors, Trajectory, builtin,
};
use schuler_simulator::source::Source;
use std::f64::consts::FRAC_PI_4;

/// A built-in scene's motion with its perfect samples.
pub struct Course {
    /// Truth and quadrature.
    pub source: Source,
    /// Sampling interval, s.
    pub interval_s: Pair<f64>,
    /// Perfect increments, from the first.
    pub samples: Vec<Increment<f64>>,
}

impl Course {
    /// Of a built-in scene, at its own rate times `faster`, over so many seconds at most.
    pub fn new(scene: &str, faster: f64, seconds: f64) -> Self {
        let mut scene = builtin::scene(scene).unwrap();
        (scene.gyro, scene.accelerometer) = Default::default();
        scene.rate_hz *= faster;
        scene.duration_s = scene.duration_s.min(seconds);
        Self::of(&scene)
    }

    /// Of a scene, with perfect sensors.
    pub fn of(scene: &Scene) -> Self {
        let source = Source::new(scene, false).unwrap();
        let sample = |n| source.perfect_sample(n);
        let samples = (1..=scene.samples()).map(sample).collect();
        Self { source, interval_s: Pair::new(scene.rate_hz).reciprocal(), samples }
    }

    /// The true state at the start, to twice the digits.
    pub fn initial(&self) -> Solution<f64> {
        self.source.initial(0)
    }

    /// Distance of a computed position from the truth at the end of a sample, m.
    pub fn miss(&self, sample: u64, computed: &Solution<f64>) -> f64 {
        drift(computed, &self.source.truth(sample)).position_ned.norm()
    }

    /// Every row of a flight over all samples; each sample has one, in order.
    pub fn fly<M: Mechanization<Real = f64>>(&self, mechanization: &M) -> Vec<Solution<f64>> {
        let mut rows = Vec::with_capacity(self.samples.len());
        let mut read = |n: u64, row: M::Output| {
            rows.push(row.wide());
            assert_eq!(n, rows.len() as u64);
        };
        let mut state = mechanization.start(&self.initial()).unwrap();
        for &sample in &self.samples {
            mechanization.push_rows(&mut state, sample, reader(&mut read)).unwrap();
        }
        mechanization.finish_rows(&mut state, reader(&mut read));
        assert_eq!(rows.len(), self.samples.len());
        rows
    }

    /// The largest distance from the truth over every row of a flight, m.
    pub fn largest_miss<M: Mechanization<Real = f64>>(&self, mechanization: &M) -> f64 {
        let rows = self.fly(mechanization);
        largest(rows.iter().zip(1..).map(|(row, n)| self.miss(n, row)))
    }
}

/// Perfect sensors at rest: level, heading north, at 45° and 1000 m.
pub fn at_rest(duration_s: f64) -> Scene {
    let still = |offset| Channel { offset, ..Channel::default() };
    Scene {
        name: "at rest".into(),
        title: String::new(),
        text_sha256: String::new(),
        duration_s,
        rate_hz: 20.0,
        seed: 1,
        trajectory: Trajectory {
            latitude: still(FRAC_PI_4),
            altitude: still(1000.0),
            ..Trajectory::default()
        },
        gyro: SensorErrors::default(),
        accelerometer: SensorErrors::default(),
        initial_error: InitialError::default(),
        aiding: Default::default(),
        alignment: None,
        navigator: Navigator::default(),
        link: Link::default(),
    }
}
