//! The tables of the windows against the inverse of their matrix in rational numbers.

use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::strapdown::block::fit::{Fit, MOST_SAMPLES, table_f32, table_f64};
use schuler::strapdown::block::least_squares::least_squares;
use schuler::strapdown::block::shape::WindowShape;
use schuler::strapdown::block::window::NAMED;
use std::ops::{Mul, Sub};

/// A ratio in lowest terms, over a positive denominator.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Ratio(i128, i128);

impl Ratio {
    fn new(n: i128, d: i128) -> Self {
        let (mut a, mut b) = (n.unsigned_abs(), d.unsigned_abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        let g = a.max(1) as i128 * d.signum();
        Self(n / g, d / g)
    }

    fn float(self) -> f64 {
        self.0 as f64 / self.1 as f64
    }
}

impl Mul for Ratio {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        let (one, other) = (Self::new(self.0, b.1), Self::new(b.0, self.1));
        let product = |a: i128, b: i128| a.checked_mul(b).unwrap();
        Self(product(one.0, other.0), product(one.1, other.1))
    }
}

impl Sub for Ratio {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        let common = Self::new(self.1, b.1);
        let product = |a: i128, b: i128| a.checked_mul(b).unwrap();
        let numerator = product(self.0, common.1) - product(b.0, common.0);
        Self::new(numerator, product(self.1, common.1))
    }
}

/// B_jk = (b_jᵏ⁺¹ − a_jᵏ⁺¹)/(k + 1), [a_j, b_j] = −1 + 2[j − H, j − H + 1]/B.
fn matrix(history: usize, block: usize, samples: usize, coefficients: usize) -> Vec<Vec<Ratio>> {
    let edge = |j: usize| 2 * (j as i128 - history as i128) - block as i128;
    let entry = |j: usize, k: usize| {
        let power = k as u32 + 1;
        let difference = edge(j + 1).pow(power) - edge(j).pow(power);
        Ratio::new(difference, i128::from(power) * (block as i128).pow(power))
    };
    (0..samples).map(|j| (0..coefficients).map(|k| entry(j, k)).collect()).collect()
}

/// Gauss and Jordan's elimination.
fn inverse(mut m: Vec<Vec<Ratio>>) -> Vec<Vec<Ratio>> {
    let n = m.len();
    for (i, row) in m.iter_mut().enumerate() {
        row.extend((0..n).map(|j| Ratio((i == j).into(), 1)));
    }
    for i in 0..n {
        let pivot = (i..n).find(|&r| m[r][i].0 != 0).unwrap();
        m.swap(i, pivot);
        let head = m[i][i];
        for x in &mut m[i] {
            *x = *x * Ratio::new(head.1, head.0);
        }
        let pivot_row = m[i].clone();
        for (r, row) in m.iter_mut().enumerate() {
            let factor = row[i];
            if r != i && factor.0 != 0 {
                for (x, &p) in row.iter_mut().zip(&pivot_row) {
                    *x = *x - factor * p;
                }
            }
        }
    }
    m.into_iter().map(|row| row[n..].to_vec()).collect()
}

/// To the last bit: a quotient of integers above 2⁵³ may miss the nearest by one.
fn assert_rounded(computed: f64, exact: Ratio, what: &str) {
    let gap = (computed - exact.float()).abs();
    assert!(gap <= f64::EPSILON * exact.float().abs(), "{what}: {computed} {exact:?}");
}

fn check<const P: usize>(history: usize, block: usize, exact: &[Vec<Ratio>]) {
    let double = table_f64::<P>(history, block);
    let single = table_f32::<P>(history, block);
    for k in 0..P {
        for j in 0..P {
            let what = format!("H{history} B{block} P{P}, entry {k} {j}");
            assert_rounded(double[k][j], exact[k][j], &what);
            assert_eq!(single[k][j], double[k][j] as f32, "{what}");
        }
    }
}

#[test]
fn interpolating_tables_are_inverses() {
    for &WindowShape { history, block, lookahead } in NAMED {
        let samples = history + block + lookahead;
        if samples > MOST_SAMPLES {
            continue;
        }
        let exact = inverse(matrix(history, block, samples, samples));
        match samples {
            2 => check::<2>(history, block, &exact),
            3 => check::<3>(history, block, &exact),
            4 => check::<4>(history, block, &exact),
            6 => check::<6>(history, block, &exact),
            8 => check::<8>(history, block, &exact),
            12 => check::<12>(history, block, &exact),
            _ => unreachable!("{samples}"),
        }
    }
}

#[test]
fn four_samples_give_the_rate_at_their_middle() {
    let [first, ..] = table_f64::<4>(0, 4);
    assert_eq!(first, [-1.0 / 6.0, 7.0 / 6.0, 7.0 / 6.0, -1.0 / 6.0]);
}

/// (BᵀB)⁻¹Bᵀ
fn normal_equations(block: usize, coefficients: usize) -> Vec<Vec<Ratio>> {
    let b = matrix(0, block, block, coefficients);
    let zero = Ratio(0, 1);
    let sum = |terms: &mut dyn Iterator<Item = Ratio>| terms.fold(zero, |sum, x| sum - (zero - x));
    let dot = |i: usize, j: usize| sum(&mut b.iter().map(|row| row[i] * row[j]));
    let all = 0..coefficients;
    let m = inverse(all.clone().map(|i| all.clone().map(|j| dot(i, j)).collect()).collect());
    let entry = |k: usize, row: &[Ratio]| sum(&mut all.clone().map(|i| m[k][i] * row[i]));
    all.clone().map(|k| b.iter().map(|row| entry(k, row)).collect()).collect()
}

fn check_least_squares<const K: usize>(block: usize) {
    let exact = normal_equations(block, K);
    for j in 0..block {
        let (fit, sum) = least_squares::<f64, K>(&unit(block, j));
        assert_eq!(sum, unit(1, 0)[0]);
        for (k, row) in exact.iter().enumerate() {
            let largest = row.iter().map(|a| a.float().abs()).fold(0.0, f64::max);
            let entries = fit.rate[k].into_array().into_iter().chain(fit.force[k].into_array());
            for (n, x) in (1..).zip(entries) {
                // The running totals are as large as B² and cancel.
                let bound = 16.0 * f64::EPSILON * largest * f64::from(n);
                let gap = (x - f64::from(n) * row[j].float()).abs();
                assert!(gap <= bound, "B{block} K{K}, entry {k} {j}: {gap:e} {bound:e}");
            }
        }
    }
}

#[test]
fn lines_and_parabolas_are_least_squares() {
    check_least_squares::<2>(8);
    check_least_squares::<2>(3);
    check_least_squares::<3>(20);
    check_least_squares::<3>(40);
    check_least_squares::<3>(5);
}

fn unit(count: usize, j: usize) -> Vec<Increment<f64>> {
    let mut samples = vec![Increment::default(); count];
    samples[j].angle_b = Vector::new(1.0, 2.0, 3.0);
    samples[j].velocity_b = Vector::new(4.0, 5.0, 6.0);
    samples
}

/// The windows at a stream's ends: every shape that can occur, worked out on the spot.
#[test]
fn windows_at_the_ends_of_a_stream_are_inverses_too() {
    for (block, all) in (1..=6).flat_map(|b| (b..=MOST_SAMPLES).map(move |p| (b, p))) {
        for history in 0..=all - block {
            let exact = inverse(matrix(history, block, all, all));
            for j in 0..all {
                let (fit, sum) = Fit::<f64, MOST_SAMPLES>::from_any(&unit(all, j), history, block);
                let own = (history..history + block).contains(&j);
                assert_eq!(sum, if own { unit(1, 0)[0] } else { Increment::ZERO });
                for k in 0..MOST_SAMPLES {
                    let a = exact.get(k).map_or(Ratio(0, 1), |row| row[j]);
                    let what = format!("H{history} B{block} P{all}, entry {k} {j}");
                    let entries =
                        fit.rate[k].into_array().into_iter().chain(fit.force[k].into_array());
                    for (n, x) in (1..).zip(entries) {
                        assert_rounded(x, a * Ratio(n, 1), &what);
                    }
                }
            }
        }
    }
}

#[test]
fn a_fit_takes_each_axis_for_itself() {
    // As much history as look-ahead; less; three samples, one of which is the middle.
    each_axis::<6>(2, 2);
    each_axis::<8>(4, 4);
    each_axis::<3>(0, 3);
}

fn each_axis<const P: usize>(history: usize, block: usize) {
    let (single, double) = (table_f32::<P>(history, block), table_f64::<P>(history, block));
    for j in 0..P {
        let samples: [_; P] = unit(P, j).try_into().unwrap();
        let (fit, sum) = Fit::from_samples(&samples, history, block, &single, &double);
        let own = (history..history + block).contains(&j);
        assert_eq!(sum, if own { unit(1, 0)[0] } else { Increment::ZERO });
        for (k, row) in double.iter().enumerate() {
            let a = row[j];
            assert_eq!(fit.rate[k], Vector::new(a, a * 2.0, a * 3.0));
            assert_eq!(fit.force[k], Vector::new(a * 4.0, a * 5.0, a * 6.0));
        }
    }
}
