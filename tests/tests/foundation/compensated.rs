//! Two-float arithmetic against integers, which are exact, and digits of known constants.

use schuler::math::compensated::{Accumulate, Pair, Plain, TwoFloat, two_product, two_sum};
use schuler::math::real::{Real, Scalar};
use schuler_tests::Numbers;
use std::f64::consts::{FRAC_PI_2, PI};

/// A double of up to 53 significant bits times 2^exponent, |exponent| ≤ 30.
fn double(numbers: &mut Numbers) -> f64 {
    let exponent = (numbers.word() % 61) as i32 - 30;
    let signed = (numbers.word() as i64) >> 11;
    signed as f64 * 2.0_f64.powi(exponent)
}

/// x·2⁹⁰ as an integer, exactly.
fn fixed(x: f64) -> i128 {
    let scaled = x * 2.0_f64.powi(90);
    assert!(scaled.abs() < 2.0_f64.powi(126) && scaled == scaled.trunc(), "{x:e}");
    scaled as i128
}

#[test]
fn two_sum_drops_nothing() {
    let mut numbers = Numbers(1);
    let mut dropped = 0;
    for _ in 0..20_000 {
        let a = numbers.within(1.0) * 2.0_f64.powi((numbers.word() % 30) as i32);
        let b = numbers.within(1.0) * 2.0_f64.powi((numbers.word() % 30) as i32);
        let (s, e) = two_sum(a, b);
        assert_eq!(s, a + b);
        assert_eq!(fixed(s) + fixed(e), fixed(a) + fixed(b), "{a:e} {b:e}");
        dropped += u32::from(e != 0.0);
    }
    assert!(dropped > 10_000, "{dropped}");
}

#[test]
fn two_sum_drops_nothing_in_single_precision() {
    let mut numbers = Numbers(2);
    for _ in 0..20_000 {
        let a = numbers.within(1.0) as f32;
        let b = (numbers.within(1.0) * 2.0_f64.powi((numbers.word() % 20) as i32)) as f32;
        let (s, e) = two_sum(a, b);
        // A double holds the sum of two singles of such ratio exactly.
        assert_eq!(f64::from(s) + f64::from(e), f64::from(a) + f64::from(b), "{a:e} {b:e}");
    }
}

#[test]
fn two_product_drops_nothing_in_single_precision() {
    let mut numbers = Numbers(3);
    for _ in 0..20_000 {
        let (a, b) = (numbers.within(1e3) as f32, numbers.within(1e3) as f32);
        let (p, e) = two_product(a, b);
        assert_eq!(f64::from(p) + f64::from(e), f64::from(a) * f64::from(b), "{a:e} {b:e}");
    }
}

#[test]
fn two_product_drops_next_to_nothing_in_double_precision() {
    let mut numbers = Numbers(4);
    for _ in 0..20_000 {
        let (a, b) = ((numbers.word() >> 11) as i64, -((numbers.word() >> 11) as i64));
        let (p, e) = two_product(a as f64, b as f64);
        let exact = i128::from(a) * i128::from(b) - p as i128;
        // The lower halves' product has 54 bits: it alone is rounded, by 2⁻¹⁰⁵ of the whole or so.
        let bound = 2.0_f64.powi(-104) * p.abs();
        assert!(((e as i128 - exact) as f64).abs() <= bound, "{a} {b}: {e} {exact}");
    }
}

/// How far a pair is from another, exactly subtracted.
fn apart(x: Pair<f64>, hi: f64, lo: f64) -> f64 {
    ((x.hi - hi) + (x.lo - lo)).abs()
}

/// Values by mpmath, 60 digits: leading double, then the rest.
#[test]
fn thirty_digits_of_reciprocals_and_roots() {
    let third = Pair::new(3.0).reciprocal();
    assert!(apart(third, 0.3333333333333333, 1.850371707708594e-17) <= 1e-32);
    let pi = Pair { hi: PI, lo: 1.2246467991473532e-16 };
    assert!(apart(pi.reciprocal(), std::f64::consts::FRAC_1_PI, -1.9678676675182486e-17) <= 1e-32);
    assert!(apart(pi.sqrt(), 1.772453850905516, -7.666586499825799e-17) <= 1e-31);
    assert!(
        apart(Pair::new(2.0).sqrt(), std::f64::consts::SQRT_2, -9.667293313452913e-17) <= 1e-31
    );
    assert!(apart(pi * pi, 9.869604401089358, 6.265295508739711e-16) <= 2e-31);
    assert!(apart(pi * pi.reciprocal() - Pair::new(1.0), 0.0, 0.0) <= 1e-31);
}

#[test]
fn thirty_digits_of_sine_and_cosine() {
    for (angle, sine, cosine) in [
        (
            1.0,
            (0.8414709848078965, 1.776845092935536e-18),
            (0.5403023058681398, -4.760954612604417e-17),
        ),
        (
            0.1,
            (0.09983341664682815, 3.08001512929492e-18),
            (0.9950041652780258, -5.50210156918377e-17),
        ),
        (
            2.5,
            (0.5984721441039565, -5.521403334082375e-17),
            (-0.8011436155469337, -1.8674742705085553e-17),
        ),
        (
            -3.0,
            (-0.1411200080598672, -8.577269787017502e-18),
            (-0.9899924966004454, -4.2060261566099734e-17),
        ),
        (
            0.001,
            (0.0009999998333333417, 5.670638989736153e-21),
            (0.9999995000000417, -7.831485455398128e-18),
        ),
        (PI, (1.2246467991473532e-16, -2.9947698097e-33), (-1.0, 7.4987989133e-33)),
        (FRAC_PI_2, (1.0, -1.8746997283e-33), (6.123233995736766e-17, -1.4973849049e-33)),
        (0.0, (0.0, 0.0), (1.0, 0.0)),
    ] {
        let (s, c) = Pair::new(angle).sin_cos();
        // The series' largest term is about 5, and 2⁻¹⁰⁴ of it 2e-31.
        assert!(apart(s, sine.0, sine.1) <= 1e-30, "sin {angle}: {s:?}");
        assert!(apart(c, cosine.0, cosine.1) <= 1e-30, "cos {angle}: {c:?}");
    }
}

#[test]
fn single_pairs_hold_fourteen_digits() {
    let mut numbers = Numbers(5);
    for _ in 0..1000 {
        let x = numbers.within(3.0);
        let narrow = Pair::<f32>::narrow(Pair::new(x));
        let carried = narrow.widen();
        assert!((carried - x).abs() <= 1e-14 * x.abs());
        let (s, c) = narrow.sin_cos();
        assert!((s.widen() - carried.sin()).abs() <= 5e-14, "{x}");
        assert!((c.widen() - carried.cos()).abs() <= 5e-14, "{x}");
        let product = narrow * narrow;
        assert!((product.widen() - carried * carried).abs() <= 3e-14 * x * x, "{x}");
    }
    let literal = Pair::<f32>::of(0.1);
    assert_eq!(literal.hi, 0.1);
    assert!((literal.widen() - 0.1).abs() < 1e-16);
}

/// A million terms of every size, against the exact sum in integers.
#[test]
fn a_million_terms_lose_nothing() {
    let mut numbers = Numbers(6);
    let terms: Vec<f64> = (0..1_000_000).map(|_| (1.0 + numbers.within(1.0)) / 3.0).collect();
    let exact: i128 = terms.iter().map(|&x| fixed(x)).sum();
    let (mut pair, mut plain) = (Pair::new(0.0), Plain(0.0));
    let mut whole = TwoFloat(Pair::new(0.0));
    for &term in &terms {
        pair.add(term);
        plain.add(term);
        whole.add_pair(Pair::new(term));
    }
    // With its increments' remainders a sum keeps all but the last bits of the pair.
    let TwoFloat(Pair { hi, lo }) = whole;
    let rest = (fixed(hi) + fixed(lo) - exact) as f64 * 2.0_f64.powi(-90);
    assert!(rest.abs() <= 1e-20, "{rest:e}");
    let miss = (fixed(pair.hi) + fixed(pair.lo) - exact) as f64 * 2.0_f64.powi(-90);
    // Half an ulp of each term, as a random walk.
    assert!(miss.abs() <= 1e-12, "{miss:e}");
    assert_eq!(pair.value() + pair.remainder(), pair.hi);
    let plain_miss = (fixed(plain.0) - exact) as f64 * 2.0_f64.powi(-90);
    assert!(plain_miss.abs() > 1e-9, "{plain_miss:e}");
}

#[test]
fn a_million_terms_in_single_precision() {
    let (mut pair, mut plain) = (Pair::new(0.0_f32), Plain(0.0_f32));
    for _ in 0..1_000_000 {
        pair.add(0.1);
        plain.add(0.1);
    }
    let exact = 1e6 * f64::from(0.1_f32);
    assert!((pair.widen() - exact).abs() <= 1e-2, "{}", pair.widen() - exact);
    assert_eq!(pair.hi, exact as f32);
    assert!((f64::from(plain.0) - exact).abs() > 100.0);
}

#[test]
fn pairs_widen_and_narrow_to_the_same_bits() {
    let mut numbers = Numbers(7);
    for _ in 0..1000 {
        let x = Pair::<f32>::narrow(Pair::new(double(&mut numbers)));
        assert_eq!(Pair::<f32>::narrow(x.widen_pair()), x);
        let wide = Pair::sum(double(&mut numbers), double(&mut numbers) * f64::EPSILON);
        assert_eq!(Pair::<f64>::narrow(wide.widen_pair()), wide);
        assert_eq!(Accumulate::pair(Pair::<f64>::from_pair(wide)), wide);
        assert_eq!(Plain::from_pair(wide).pair(), Pair::new(wide.hi));
        assert_eq!(TwoFloat::from_pair(wide).pair(), wide);
        let (h, l) = (x.hi.upper_half(), x.hi - x.hi.upper_half());
        assert_eq!(h + l, x.hi);
        assert_eq!(Scalar::to_bits(h) & 0xfff, 0);
    }
}
