//! Rates turned into increments: the trapezoid and its error.

use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::sample::{Increment, RateIntegrator, Rates};
use schuler_tests::{Numbers, near};

/// Rates that oscillate, and their integral up to a time.
fn at(time_s: f64) -> (Rates<f64>, Increment<f64>) {
    let rate = |w: f64| (w * time_s).cos();
    let integral = |w: f64| (w * time_s).sin() / w;
    let frequencies = Vector::new(1.0, 2.0, 3.0);
    let rates = Rates {
        rate_ib_b: frequencies.map(rate),
        specific_force_b: frequencies.map(|w| 9.8 * rate(0.5 * w)),
    };
    let increment = Increment {
        angle_b: frequencies.map(integral),
        velocity_b: frequencies.map(|w| 9.8 * integral(0.5 * w)),
    };
    (rates, increment)
}

fn numbers(increment: Increment<f64>) -> [f64; 6] {
    let ([a, b, c], [d, e, f]) =
        (increment.angle_b.into_array(), increment.velocity_b.into_array());
    [a, b, c, d, e, f]
}

/// (ωh)²/12 too little of an oscillation, whichever its frequency.
#[test]
fn the_trapezoid_reads_too_little_by_the_square_of_the_interval() {
    for interval_s in [0.02, 0.01] {
        let samples = (1.0 / interval_s) as u32;
        let mut rates = RateIntegrator::new(at(0.0).0);
        let mut sums = [0.0; 6];
        for n in 1..=samples {
            let sample = rates.increment(at(f64::from(n) * interval_s).0, Pair::new(interval_s));
            sums.iter_mut().zip(numbers(sample)).for_each(|(sum, x)| *sum += x);
        }
        let exact = numbers(at(1.0).1);
        for ((sum, exact), frequency) in sums.iter().zip(exact).zip([1.0, 2.0, 3.0, 0.5, 1.0, 1.5])
        {
            let missing = (exact - sum) / exact;
            near(missing, (frequency * interval_s).powi(2) / 12.0, 1e-3, "what is missing");
        }
    }
}

/// h³/12 times the second derivative in the middle, sample by sample, whatever the intervals.
#[test]
fn unequal_intervals_each_have_their_own_error() {
    let mut random = Numbers(5);
    let mut time_s = 0.3;
    let mut rates = RateIntegrator::new(at(time_s).0);
    for _ in 0..200 {
        let interval_s = 0.02 + random.within(0.01);
        let sample = numbers(rates.increment(at(time_s + interval_s).0, Pair::new(interval_s)));
        let (before, after) = (numbers(at(time_s).1), numbers(at(time_s + interval_s).1));
        let middle = at(time_s + 0.5 * interval_s).0;
        let frequencies = [1.0_f64, 2.0, 3.0, 0.5, 1.0, 1.5];
        let middle =
            numbers(Increment { angle_b: middle.rate_ib_b, velocity_b: middle.specific_force_b });
        for axis in 0..6 {
            let error = sample[axis] - (after[axis] - before[axis]);
            let second = -frequencies[axis].powi(2) * middle[axis];
            let expected = interval_s.powi(3) / 12.0 * second;
            // Of the next order in (ωh)², beside the largest that the derivative gets.
            let most = interval_s.powi(3) / 12.0 * frequencies[axis].powi(2) * 10.0 * 2e-3;
            assert!((error - expected).abs() <= most, "{error:e} {expected:e}");
        }
        time_s += interval_s;
    }
}

/// The mean over an interval loses nothing, and an interval's remainder counts in single precision.
#[test]
fn mean_rates_are_increments() {
    let mean = Rates {
        rate_ib_b: Vector::new(0.5_f32, -0.25, 1.0),
        specific_force_b: Vector::new(1.0, -2.0, -9.75),
    };
    let interval_s = Pair::new(100.0_f32).reciprocal();
    let mut sum = [0.0_f64; 6];
    for _ in 0..100 {
        let Increment { angle_b, velocity_b } = Increment::from_mean_rates(&mean, interval_s);
        let sample = [angle_b, velocity_b].map(|v| v.map(f64::from).into_array());
        sum.iter_mut().zip(sample.as_flattened()).for_each(|(sum, x)| *sum += x);
    }
    for (sum, rate) in sum.iter().zip([0.5, -0.25, 1.0, 1.0, -2.0, -9.75]) {
        near(*sum, rate, 6e-8, "a second");
    }
    // The same rates at both ends.
    let sample = Increment::from_rates(&mean, &mean, interval_s);
    assert_eq!(sample, Increment::from_mean_rates(&mean, interval_s));
}
