//! From the numbers of a file to rad and m/s, forward, right, down, without the errors that are known.
//!
//! A sensor that reads (1 + S)·x + b over its own axes is corrected to x = (reading − b)/(1 + S), and then
//! turned into the vehicle's axes. What a bias takes from an increment depends on its interval, so it is left
//! to who knows that.

use super::Kind;
use super::mounting::Mounting;
use crate::rest::units::Units;
use schuler::math::vector::Vector;
use schuler::sample::Increment;

/// What is known of a sensor's errors, over its own axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known {
    /// What it reads too much, rad/s or m/s².
    pub bias: Vector<f64>,
    /// By which part it reads too much.
    pub scale_factor: Vector<f64>,
}

impl Default for Known {
    fn default() -> Self {
        Self { bias: Vector::ZERO, scale_factor: Vector::ZERO }
    }
}

/// What is done with the numbers of every row.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reduction {
    /// Their units.
    pub units: Units,
    /// How the unit sits; absent where axes are forward, right, down.
    pub mounting: Option<Mounting>,
    /// Errors of gyros and accelerometers; absent where none are known.
    pub known: Option<[Known; 2]>,
    /// Whether accelerometers read gravity itself, down at rest.
    pub reversed: bool,
}

impl Reduction {
    /// A row's numbers, turned and scaled; of rates, the bias is taken away.
    pub fn apply(&self, sample: &Increment<f64>, kind: Kind) -> Increment<f64> {
        let mut sample = self.units.apply(sample);
        if self.reversed {
            sample.velocity_b = -sample.velocity_b;
        }
        if let Some([gyro, accelerometer]) = &self.known {
            let parts = [(&mut sample.angle_b, gyro), (&mut sample.velocity_b, accelerometer)];
            for (value, known) in parts {
                let bias = if kind == Kind::Rates { known.bias } else { Vector::ZERO };
                *value = corrected(*value - bias, known);
            }
        }
        self.turned(sample)
    }

    /// What the biases add to increments, per second of their interval; rates have lost theirs.
    pub fn per_second(&self, kind: Kind) -> Option<Increment<f64>> {
        let [gyro, accelerometer] = self.known.as_ref().filter(|_| kind == Kind::Increments)?;
        let [angle_b, velocity_b] = [gyro, accelerometer].map(|known| corrected(known.bias, known));
        Some(self.turned(Increment { angle_b, velocity_b }))
    }

    fn turned(&self, sample: Increment<f64>) -> Increment<f64> {
        match &self.mounting {
            None => sample,
            Some(mounting) => Increment {
                angle_b: mounting.turn(sample.angle_b),
                velocity_b: mounting.turn(sample.velocity_b),
            },
        }
    }
}

fn corrected(reading: Vector<f64>, known: &Known) -> Vector<f64> {
    reading.zip(known.scale_factor, |reading, scale| reading / (1.0 + scale))
}
