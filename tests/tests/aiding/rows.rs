//! Rows of measurements times errors, against the errors of what is measured, written out in vectors.

use schuler::aiding::gate::Rows;
use schuler::aiding::measurement::{self, Turning};
use schuler::math::vector::Vector;
use schuler_tests::Numbers;

/// Errors in body axes: position, inertial velocity, attitude and gyro bias.
struct Errors {
    all: [f64; 15],
    position: Vector<f64>,
    velocity: Vector<f64>,
    attitude: Vector<f64>,
    gyro_bias: Vector<f64>,
}

impl Errors {
    fn new(numbers: &mut Numbers) -> Self {
        let all = [(); 15].map(|()| numbers.within(1.0));
        let three = |n: usize| Vector::new(all[n], all[n + 1], all[n + 2]);
        let (position, velocity) = (three(0), three(3));
        Self { all, position, velocity, attitude: three(6), gyro_bias: three(9) }
    }

    /// What rows make of them.
    fn times<const K: usize>(&self, rows: &Rows<f64, 15, K>) -> [f64; K] {
        rows.rows.map(|row| row.iter().zip(self.all).map(|(a, x)| a * x).sum())
    }
}

fn is_near(computed: [f64; 3], expected: Vector<f64>) -> bool {
    // Sums of up to fifteen products, each of a size of 30.
    (Vector::from(computed) - expected).norm() <= 15.0 * 30.0 * f64::EPSILON
}

#[test]
fn rows_say_what_errors_do_to_a_measurement() {
    let mut numbers = Numbers(91);
    for _ in 0..50 {
        let errors = Errors::new(&mut numbers);
        let Errors { position, velocity, attitude, gyro_bias, .. } = errors;
        let (lever, earth) = (numbers.vector(3.0), numbers.vector(1.0));
        let (rate, along) = (numbers.vector(2.0), numbers.vector(5.0));
        let none = Vector::ZERO;

        // The antenna is r + C l, and C is off by ψ: δr + ψ × l against C.
        let rows = measurement::position(none, lever, 1.0);
        assert!(is_near(errors.times(&rows), position - lever.cross(attitude)));

        // Relative to the Earth: δv − ω_ie × δr. The lever adds b_g × l, and turns with C.
        let at_earth = velocity - earth.cross(position);
        let turning = Turning { earth_rate_b: earth, rate_ib_b: rate };
        let rows = measurement::velocity(none, &turning, lever, 1.0);
        let swung = gyro_bias.cross(lever) - rate.cross(lever).cross(attitude)
            + earth.cross(lever.cross(attitude));
        assert!(is_near(errors.times(&rows), at_earth + swung));

        let rows = measurement::zero_velocity(none, earth, 1.0);
        assert!(is_near(errors.times(&rows), at_earth));

        // In body axes the velocity itself turns.
        let rows = measurement::along_body(none, along, earth, 1.0);
        assert!(is_near(errors.times(&rows), at_earth + along.cross(attitude)));
    }
}
