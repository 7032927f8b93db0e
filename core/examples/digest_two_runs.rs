//! Two runs with equal digests had equal bits in every field after every block; a run with one bit changed
//! has another digest, and the chain says from which checkpoint on.
//!
//! `cargo run -p schuler --example digest_two_runs`

use schuler::digest::{Chain, Checkpoint};
use schuler::prelude::*;

const SAMPLES: u64 = 4000;
const EVERY: u64 = 500;

/// A chain of digests over a minute or so at 64 Hz, with one bit of one sample changed.
fn fly(changed: Option<u64>) -> Result<Vec<Checkpoint>, Box<dyn core::error::Error>> {
    let level = Euler { roll: 0.0, pitch: 0.0, yaw: 0.5 };
    let start = Solution::new(Geodetic::default(), Vector::new(20.0, 0.0, 0.0), level);
    let navigator = Navigator4::<f32>::from_rate_hz(64.0)?;
    let mut state = navigator.start(&start)?;
    let (mut chain, mut checkpoints) = (Chain::new(EVERY), Vec::new());
    for number in 1..=SAMPLES {
        // Turning steadily.
        let mut force = -0.1525_f32;
        if changed == Some(number) {
            force = f32::from_bits(force.to_bits() ^ 8);
        }
        let sample = Increment {
            angle_b: Vector::new(0.0, 0.0, 0.001),
            velocity_b: Vector::new(0.0, 0.0003, force),
        };
        navigator.push_blocks(&mut state, sample, |sample, _, frame| {
            checkpoints.extend(chain.add(sample, frame));
        })?;
    }
    Ok(checkpoints)
}

fn main() -> Result<(), Box<dyn core::error::Error>> {
    let (first, again, other) = (fly(None)?, fly(None)?, fly(Some(2750))?);
    for (a, b) in first.iter().zip(&other) {
        let word = if a == b { "same" } else { "other" };
        println!("{:5} samples  {:016x}  {:016x}  {word}", a.sample, a.digest, b.digest);
    }
    assert_eq!(first, again);
    let same = first.iter().zip(&other).take_while(|(a, b)| a == b).count();
    assert_eq!(same as u64, 2750 / EVERY);
    Ok(())
}
