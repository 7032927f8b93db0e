//! Starts in the wrong place, is told its error after a quarter of a minute, and follows the truth from
//! there. A filter does the same with its estimate of the error.
//!
//! `cargo run -p schuler --features full --example correct_a_state`

use schuler::drift::compare::drift;
use schuler::imu::Quadrature;
use schuler::prelude::*;
use schuler::trajectory::Trajectory as _;
use schuler::trajectory::harmonic::{Channel, Channels, Harmonic, HarmonicTrajectory};

const RATE_HZ: f64 = 100.0;
const FIX: u64 = 1500;

fn main() -> Result<(), Box<dyn core::error::Error>> {
    let roll = [Harmonic { amplitude: 0.3, angular_rate: 1.1, phase: 0.0 }];
    let course = HarmonicTrajectory::<f64, 1>::new(Channels {
        roll: Channel { harmonics: &roll, ..Channel::constant(0.0) },
        pitch: Channel::constant(0.05),
        yaw: Channel::steady(0.8, 0.02),
        latitude: Channel::steady(0.8, 3e-5),
        longitude: Channel::steady(0.2, 4e-5),
        altitude: Channel::constant(3000.0),
    })?;
    let perfect = Quadrature::plan(course.bound().bandwidth, 1.0 / RATE_HZ);
    let truth = |sample: u64| course.at(sample as f64 / RATE_HZ).initial();
    let miss = |row: &Solution<f64>, sample| drift(row, &truth(sample)).position_ned.norm();

    // 300 m, 2 m/s and 0.01 rad off.
    let off = Vector::new(200.0, -200.0, 100.0);
    let wrong =
        Correction { position_ned: off, velocity_ned: off * 0.0067, attitude_ned: off * 33e-6 };
    let navigator = Navigator4::<f64>::from_rate_hz(RATE_HZ)?;
    let mut state = navigator.start(&truth(0))?;
    navigator.correct(&mut state, &wrong)?;

    for number in 1..=4 * FIX {
        navigator.push(&mut state, perfect.sample(&course, number, RATE_HZ))?;
        if number == FIX {
            let row = navigator.output(&state);
            println!("before the correction: {:9.3} m off", miss(&row, number));
            // What leads from the computed solution to the truth.
            navigator.correct(&mut state, &drift(&truth(number), &row).into())?;
            println!("after it:              {:9.1e} m", miss(&navigator.output(&state), number));
        }
    }
    let end = miss(&navigator.output(&state), 4 * FIX);
    println!("three quarters of a minute later: {end:.1e} m");
    assert!(end < 1e-6);

    // What cannot be right is refused and changes nothing.
    let before = navigator.output(&state);
    let nonsense = Correction { position_ned: off * f64::NAN, ..Correction::ZERO };
    assert_eq!(navigator.correct(&mut state, &nonsense), Err(CorrectionError::Size));
    assert_eq!(navigator.output(&state), before);
    Ok(())
}
