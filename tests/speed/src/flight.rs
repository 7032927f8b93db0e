//! Flights that navigators are measured on, as in the built-in scenes of the same names.

use schuler::trajectory::harmonic::{Channel, Channels, CourseError, Harmonic, HarmonicTrajectory};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const DEGREE: f64 = PI / 180.0;

/// With the room for harmonics that the program's scenes have.
pub type Course = HarmonicTrajectory<f64, 64>;

/// A motion and how often it is sampled.
pub trait Flight {
    /// Samples per second.
    const RATE_HZ: f64;
    /// The true motion.
    fn course() -> Result<Course, CourseError>;
}

/// Slow swings.
pub struct Paper;
/// Coning and sculling at 2 Hz.
pub struct Hard;
/// Rolls of 300 °/s and pulls of 10 g.
pub struct Manoeuvre;

fn channel(offset: f64, rate: f64, harmonics: &[Harmonic<f64>]) -> Channel<'_, f64> {
    Channel { offset, rate, harmonics }
}

fn cosine(amplitude: f64, angular_rate: f64) -> [Harmonic<f64>; 1] {
    [Harmonic { amplitude, angular_rate, phase: 0.0 }]
}

/// amplitude · sin(angular_rate · t + phase).
fn sine(amplitude: f64, angular_rate: f64, phase: f64) -> [Harmonic<f64>; 1] {
    [Harmonic { amplitude, angular_rate, phase: phase - FRAC_PI_2 }]
}

impl Flight for Paper {
    const RATE_HZ: f64 = 20.0;
    fn course() -> Result<Course, CourseError> {
        let angle = cosine(5.0 * DEGREE, TAU / 7200.0);
        HarmonicTrajectory::new(Channels {
            roll: channel(0.0, 0.0, &angle),
            pitch: channel(0.0, 0.0, &angle),
            yaw: channel(0.0, 0.0, &angle),
            latitude: channel(45.0 * DEGREE, 0.0, &angle),
            longitude: channel(100.0 * DEGREE, 0.0, &angle),
            altitude: channel(3500.0, 0.0, &cosine(2000.0, TAU / 7200.0)),
        })
    }
}

impl Flight for Hard {
    const RATE_HZ: f64 = 100.0;
    fn course() -> Result<Course, CourseError> {
        let (angle, turn) = (5.0 * DEGREE, 2.0 * TAU);
        HarmonicTrajectory::new(Channels {
            roll: channel(0.0, 0.0, &sine(angle, turn, 0.0)),
            pitch: channel(0.0, 0.0, &cosine(angle, turn)),
            yaw: channel(0.0, 0.0, &cosine(angle, TAU / 7200.0)),
            // 0.1 m
            latitude: channel(45.0 * DEGREE, 0.0, &cosine(8.993_382_889_8e-7 * DEGREE, turn)),
            longitude: channel(100.0 * DEGREE, 0.0, &[]),
            altitude: channel(3500.0, 0.0, &cosine(0.1, turn)),
        })
    }
}

impl Flight for Manoeuvre {
    const RATE_HZ: f64 = 100.0;
    fn course() -> Result<Course, CourseError> {
        // Radians to a metre north and east.
        let (north, east) = (8.994_088_764_4e-6 * DEGREE, 1.267_686_458_52e-5 * DEGREE);
        HarmonicTrajectory::new(Channels {
            roll: channel(0.0, 0.0, &sine(375.0 * DEGREE, 0.8, 0.0)),
            pitch: channel(0.0, 0.0, &sine(0.5, 1.3, 0.4)),
            yaw: channel(0.3, 0.0, &sine(0.8, 0.9, 0.0)),
            latitude: channel(
                45.0 * DEGREE,
                200.0 * north,
                &sine(98.0665 / 1.44 * north, 1.2, 0.0),
            ),
            longitude: channel(100.0 * DEGREE, 300.0 * east, &sine(60.0 * east, 0.7, 0.0)),
            altitude: channel(3000.0, 0.0, &sine(50.0, 0.9, 0.0)),
        })
    }
}
