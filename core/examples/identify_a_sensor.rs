//! A gyro that stands still for three hours tells its angle random walk and its bias's random walk.
//!
//! `cargo run -p schuler --features full --example identify_a_sensor`

use schuler::allan::octaves::Octaves;
use schuler::allan::term::Term;
use schuler::prelude::*;
use schuler::sensor::Timing;
use schuler::sensor::emulator::Emulator;
use schuler::sensor::random_walk::RandomWalk;
use schuler::sensor::white::White;
use schuler::units::{DEGREE_PER_HOUR, DEGREE_PER_HOUR_PER_ROOT_HOUR, DEGREE_PER_ROOT_HOUR};

const INTERVAL_S: f64 = 0.01;
const SAMPLES: u64 = 100 * 10_800;

fn main() -> Result<(), Box<dyn core::error::Error>> {
    let timing = Timing::new(INTERVAL_S, SAMPLES)?;
    let axes = |x| Vector::new(x, x, x);
    let (white, walk) = (0.05 * DEGREE_PER_ROOT_HOUR, 5.0 * DEGREE_PER_HOUR_PER_ROOT_HOUR);
    let gyros = (White::new(axes(white), timing)?, RandomWalk::new(axes(walk), timing)?);
    let unit = Emulator::new(gyros, (), timing);
    let mut sensors = unit.start(1, 0);

    // No sample is kept.
    let mut axis: Octaves<f64> = Octaves::new(INTERVAL_S)?;
    for _ in 0..SAMPLES {
        axis.add(unit.emulate(&mut sensors, &Increment::ZERO).angle_b.x)?;
    }
    println!("       τ, s   measured, °/h   expected   of itself");
    for point in axis.points() {
        let terms = [Term::White(white), Term::RandomWalk(walk)];
        let [first, second] = terms.map(|term| term.variance(point.tau_s));
        let expected = (first + second).sqrt() / DEGREE_PER_HOUR;
        let measured = point.deviation() / DEGREE_PER_HOUR;
        let dominant = if first > second { terms[0] } else { terms[1] };
        let sigma = (2.0 * point.freedom(dominant)).sqrt().recip();
        println!("{:11.2} {measured:15.4} {expected:10.4} {sigma:11.4}", point.tau_s);
        assert!((measured / expected - 1.0).abs() < 4.0 * sigma + 0.02);
    }
    Ok(())
}
