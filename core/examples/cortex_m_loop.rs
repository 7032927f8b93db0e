//! The loop of a firmware: single precision, registers of a chip, no allocation, nothing that panics.
//!
//! `firmware` is `core` alone, and goes into a crate with `#![no_std]` as it is. What stands around it
//! plays the chip: at rest, level, at 200 Hz.
//!
//! `cargo run -p schuler --example cortex_m_loop`

mod firmware {
    use schuler::prelude::*;

    type Navigator = Navigator4<f32>;

    /// The interval of a sample, s: 200 Hz.
    const RATE_HZ: f64 = 200.0;
    /// Angle and velocity of one bit of the chip's increments, rad and m/s.
    pub const ANGLE_BIT: f32 = 1.0 / (1 << 26) as f32;
    pub const VELOCITY_BIT: f32 = 1.0 / (1 << 19) as f32;

    /// What lives in a static: configuration, state, and samples that were refused.
    pub struct Inertial {
        navigator: Navigator,
        state: StateOf<Navigator>,
        refused: u32,
    }

    impl Inertial {
        /// Once, after alignment.
        pub fn new(start: &Solution<f32>) -> Result<Self, StartError> {
            let navigator = Navigator::from_rate_hz(RATE_HZ)?;
            let state = navigator.start(start)?;
            Ok(Self { navigator, state, refused: 0 })
        }

        /// In the interrupt of a new sample: Δθ and Δv in bits, forward, right and down.
        pub fn on_sample(&mut self, angle: [i32; 3], velocity: [i32; 3]) {
            let sample = Increment {
                angle_b: Vector::from(angle).map(|bits| bits as f32 * ANGLE_BIT),
                velocity_b: Vector::from(velocity).map(|bits| bits as f32 * VELOCITY_BIT),
            };
            // A reading that cannot be right leaves the state as it was.
            if self.navigator.push(&mut self.state, sample).is_err() {
                self.refused = self.refused.saturating_add(1);
            }
        }

        /// In the main loop: navigation at the newest sample, and how many were refused.
        pub fn read(&self) -> (Readout<f32>, u32) {
            (self.navigator.predict(&self.state).readout(), self.refused)
        }
    }
}

use schuler::earth::{gravity, rotation_ned};
use schuler::math::real::Real;
use schuler::prelude::*;

fn main() -> Result<(), Box<dyn core::error::Error>> {
    let place =
        Geodetic { latitude: core::f32::consts::FRAC_PI_4, longitude: 0.3, altitude: 430.0 };
    let level = Euler { roll: 0.0, pitch: 0.0, yaw: 0.0 };
    let start = Solution::new(place, Vector::ZERO, level);
    let mut inertial = firmware::Inertial::new(&start)?;

    // The chip: integrals of the true rates, of which each sample has the whole bits that are new.
    let (sine, cosine) = Real::sin_cos(f64::from(place.latitude));
    let turned = rotation_ned(sine, cosine).into_array();
    let felt = [0.0, 0.0, -gravity(sine, f64::from(place.altitude))];
    let bits = |rate: f64, bit: f32, sample: i32| {
        (rate * f64::from(sample) / (200.0 * f64::from(bit))).round() as i64
    };
    let new_bits = |rate: f64, bit: f32, sample: i32| {
        (bits(rate, bit, sample) - bits(rate, bit, sample - 1)) as i32
    };
    for sample in 1..=200 * 60 {
        inertial.on_sample(
            turned.map(|rate| new_bits(rate, firmware::ANGLE_BIT, sample)),
            felt.map(|force| new_bits(force, firmware::VELOCITY_BIT, sample)),
        );
        if sample == 5000 {
            // A glitch on the bus.
            inertial.on_sample([i32::MAX; 3], [0; 3]);
        }
    }
    let (shown, refused) = inertial.read();
    println!("after a minute at rest: {shown}");
    println!("samples refused: {refused}");
    assert!(shown.velocity_ned_m_s.norm() < 0.01);
    assert_eq!(refused, 1);
    Ok(())
}
