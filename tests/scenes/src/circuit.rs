//! A flight of segments: `host/simulator/scenes/circuit.toml`.

use crate::segment::{accelerate, by, climb, hold, radius, straight, to, turn};
use crate::units::DEGREE;
use schuler::earth::Geodetic;
use schuler::trajectory::segment::attitude::AttitudeRule;
use schuler::trajectory::segment::compile::segment::{Length, Segment};
use schuler::trajectory::segment::compile::{Compiler, SegmentError, Start};

/// Samples per second.
pub const RATE_HZ: f64 = 100.0;
/// Length of the flight, s: its last segment goes on beyond.
pub const DURATION_S: u32 = 1800;

/// Where it begins.
pub const START: Start = Start {
    position: Geodetic { latitude: 45.0 * DEGREE, longitude: 100.0 * DEGREE, altitude: 300.0 },
    course: 30.0 * DEGREE,
    speed: 0.0,
};
/// How the body lies along the path.
pub const RULE: AttitudeRule = AttitudeRule::Coordinated;

/// One after the other.
pub const SEGMENTS: &[Segment] = &[
    hold(60.0),
    accelerate(80.0, 40.0),
    climb(900.0, 11.0, 6.0),
    accelerate(150.0, 60.0),
    climb(1500.0, 15.0, 8.0),
    turn(by(90.0), 25.0, 4.0),
    straight(Length::Time(30.0)),
    turn(by(-120.0), 30.0, 4.0),
    straight(Length::Time(30.0)),
    turn(by(180.0), 45.0, 3.0),
    straight(Length::Distance(4500.0)),
    turn(by(-60.0), 20.0, 5.0),
    straight(Length::Time(30.0)),
    turn(to(150.0), 25.0, 4.0),
    straight(Length::Time(30.0)),
    radius(by(360.0), 4000.0, 4.0),
    straight(Length::Time(30.0)),
    turn(by(-200.0), 35.0, 3.0),
    straight(Length::Time(30.0)),
    turn(by(75.0), 60.0, 4.0),
    straight(Length::Time(30.0)),
    climb(-1800.0, 8.0, 8.0),
    accelerate(80.0, 60.0),
    climb(-600.0, 4.0, 8.0),
    accelerate(0.0, 60.0),
    hold(200.0),
];

/// Its pieces, one after the other.
pub fn compiler() -> Result<Compiler<'static>, SegmentError> {
    Compiler::new(START, RULE, SEGMENTS)
}
