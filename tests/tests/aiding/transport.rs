//! Rows through steps and corrections, and the distribution of their innovations.

use super::factors::matrices;
use schuler::aiding::chi_square::{exceedance, quantile};
use schuler::aiding::transition::{Stretch, Transition};
use schuler::prelude::*;

#[test]
fn a_row_goes_through_a_step_by_the_inverse_of_its_transition() {
    let v = Vector::new(0.03_f64, -0.02, 0.05);
    let rotation = Quaternion::new((1.0 - v.dot(v)).sqrt() - 1.0, v);
    let stretch = Stretch {
        time_s: 0.3,
        rotation,
        velocity: Vector::new(0.6, -0.2, -2.9),
        position: Vector::new(0.1, -0.03, -0.44),
    };
    let gradient = [[-1.5e-6, 2e-7, 0.0], [2e-7, -1.5e-6, 1e-7], [0.0, 1e-7, 3e-6]].into();
    let uniform = Transition::new(&stretch);
    // Of the gradient the first order is taken: T²Γ is 1.4e-7.
    for (transition, bound) in [(uniform, 1e-12), (uniform.with_gradient(&gradient), 3e-7)] {
        let phi = matrices(&transition);
        let h: [f64; 15] = core::array::from_fn(|n| (n as f64 * 1.7).sin());
        let mut carried = h;
        transition.carry(&mut carried);
        for column in 0..15 {
            let back: f64 = (0..15).map(|row| carried[row] * phi[row][column]).sum();
            assert!((back - h[column]).abs() < bound, "{column}: {back} for {}", h[column]);
        }
    }
}

#[test]
fn limits_are_quantiles() {
    // Even numbers of degrees in closed form: Q = e^(−y)Σ yⁿ/n!
    for half in [1_u32, 2, 3, 5, 20, 150] {
        for x in [0.1, 1.0, 5.0, 16.0, 40.0, 320.0] {
            let y: f64 = x / 2.0;
            let (mut term, mut sum) = ((-y).exp(), 0.0);
            for n in 0..half {
                sum += term;
                term *= y / f64::from(n + 1);
            }
            let q: f64 = exceedance(x, 2 * half);
            assert!((q - sum).abs() < 1e-12 + 1e-9 * sum, "{half} {x}: {q} for {sum}");
        }
    }
    // Odd ones from tables.
    for (degrees, probability, x) in [
        (1, 0.05, 3.8415),
        (1, 1e-4, 15.1367),
        (3, 0.05, 7.8147),
        (3, 1e-3, 16.2662),
        (9, 0.01, 21.6660),
    ] {
        let found: f64 = quantile(probability, degrees);
        assert!((found - x).abs() < 1e-3, "{degrees}: {found} for {x}");
        let single: f32 = quantile(probability as f32, degrees);
        assert!((f64::from(single) - x).abs() < 1e-3 * x, "{degrees}: {single} for {x}");
    }
    // Wilson and Hilferty: (χ²/k)^⅓ is nearly normal.
    let (k, z) = (1194.0, 2.326_348);
    let a: f64 = 2.0 / (9.0 * k);
    let x = k * (1.0 - a + z * a.sqrt()).powi(3);
    assert!((quantile(0.01, 1194) / x - 1.0).abs() < 1e-5);
}
