//! The scalar that rounds at random: its mean is exact, and its draws differ.

use schuler::math::real::Real;
use schuler_simulator::rounding::stochastic::{Stochastic, seed};

type Double = Stochastic<f64>;
const DRAWS: u32 = 200_000;

/// The mean of an operation less its nearest result, in ulps of that, and how often it moved.
fn statistics(mut operation: impl FnMut() -> f64, nearest: f64) -> (f64, f64) {
    let ulp = nearest.abs().next_up() - nearest.abs();
    let (mut sum, mut off) = (0.0, 0);
    for _ in 0..DRAWS {
        let moved = (operation() - nearest) / ulp;
        assert!(moved.abs() <= 1.0, "{moved}");
        sum += moved;
        off += u32::from(moved != 0.0);
    }
    (sum / f64::from(DRAWS), f64::from(off) / f64::from(DRAWS))
}

/// Exact errors in ulps: 1/3 and 2/3 of one, a third of one in a product, and by 50 digits
/// 1/3 = fl(1/3) + 1/3 ulp, √2 = fl(√2) − 0.4354 ulp.
#[test]
fn the_mean_is_exact_and_the_draws_differ() {
    seed(1);
    let (one, three) = (Stochastic(1.0), Stochastic(3.0));
    let third = Stochastic(f64::EPSILON / 3.0);
    // Five sigma of a mean of so many draws of ±1 at most.
    let near = |(mean, off): (f64, f64), expected: f64, what: &str| {
        assert!((mean - expected).abs() < 2.5 / f64::from(DRAWS).sqrt(), "{what}: {mean}");
        assert!((off - expected.abs()).abs() < 2.5 / f64::from(DRAWS).sqrt(), "{what}: {off}");
    };
    near(statistics(|| (one + third).0, 1.0), 1.0 / 3.0, "sum");
    near(statistics(|| (-one - third).0, -1.0), -1.0 / 3.0, "difference");
    near(statistics(|| (one / three).0, 1.0 / 3.0), 1.0 / 3.0, "quotient");
    let two = Stochastic(2.0);
    near(statistics(|| two.sqrt().0, std::f64::consts::SQRT_2), -0.435_376_7, "root");
    // (1 + 2⁻³⁰)² = 1 + 2⁻²⁹ + 2⁻⁶⁰, which is 2⁻⁸ of an ulp too long.
    let x = Stochastic(1.0 + 2.0_f64.powi(-30));
    near(statistics(|| (x * x).0, 1.0 + 2.0_f64.powi(-29)), 2.0_f64.powi(-8), "product");
}

#[test]
fn single_precision_too() {
    seed(2);
    let ulp = f64::from(f32::EPSILON);
    let third = Stochastic((ulp / 3.0) as f32);
    let sum = |_| (f64::from((Stochastic(1.0_f32) + third).0) - 1.0) / ulp;
    let mean = (0..DRAWS).map(sum).sum::<f64>() / f64::from(DRAWS);
    assert!((mean - 1.0 / 3.0).abs() < 2.5 / f64::from(DRAWS).sqrt(), "{mean}");
}

#[test]
fn what_is_exact_stays() {
    seed(3);
    for _ in 0..1000 {
        assert_eq!((Double::of(1.5) + Double::of(-0.25)).0, 1.25);
        assert_eq!((Double::of(1.5) * Double::of(3.0)).0, 4.5);
        assert_eq!((Double::of(4.5) / Double::of(3.0)).0, 1.5);
        assert_eq!(Double::of(2.25).sqrt().0, 1.5);
        assert_eq!((Double::of(0.0) - Double::of(0.0)).0, 0.0);
    }
}

#[test]
fn a_seed_repeats_its_draws() {
    let run = |s| {
        seed(s);
        (0..100).fold(Stochastic(0.0_f64), |x, _| x + Stochastic(0.1)).0
    };
    assert_eq!(run(5).to_bits(), run(5).to_bits());
    assert!((6..16).any(|s| run(s) != run(5)));
}
