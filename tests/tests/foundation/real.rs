//! The scalar seam: both widths against the standard library and their definitions.

use schuler::math::real::Twin;
use schuler::math::real::{Real, Scalar};
use schuler::math::twin::Both;
use schuler_tests::Numbers;

fn functions<R: Scalar + std::fmt::Debug>(tolerance: f64) {
    let mut numbers = Numbers(11);
    let close = |computed: R, expected: f64, what: &str, x: f64| {
        let bound = tolerance * expected.abs().max(1e-3);
        assert!(
            (computed.widen() - expected).abs() <= bound,
            "{what} {x}: {computed:?} {expected}"
        );
    };
    for _ in 0..2000 {
        let x = R::narrow(numbers.within(20.0));
        let y = R::narrow(numbers.within(20.0));
        let (wide, wide_y) = (x.widen(), y.widen());
        let (s, c) = x.sin_cos();
        close(s, wide.sin(), "sin", wide);
        close(c, wide.cos(), "cos", wide);
        close(x.atan2(y), wide.atan2(wide_y), "atan2", wide);
        close(x.exp_m1(), wide.exp_m1(), "exp_m1", wide);
        close(x.abs().ln(), wide.abs().ln(), "ln", wide);
        close(x.abs().sqrt(), wide.abs().sqrt(), "sqrt", wide);
        assert_eq!(x.round().widen(), wide.round_ties_even());
        assert_eq!(x.abs().widen(), wide.abs());
        assert_eq!(R::from_bits(x.to_bits()), x);
        assert_eq!(R::narrow(wide), x);
    }
}

#[test]
fn functions_in_double_precision() {
    functions::<f64>(4.0 * f64::EPSILON);
}

#[test]
fn functions_in_single_precision() {
    functions::<f32>(4.0 * f64::from(f32::EPSILON));
}

fn constants<R: Scalar + std::fmt::Debug>() {
    assert_eq!(R::INVERSE[0], R::ZERO);
    for n in 1..24 {
        assert_eq!(R::INVERSE[n as usize], R::ONE / R::count(n));
        assert_eq!(R::count(n).widen(), f64::from(n));
        assert_eq!(R::ratio(-3, n.into()), -(R::count(3) / R::count(n)));
    }
    assert_eq!((R::ONE + R::ONE, R::HALF * R::TWO), (R::TWO, R::ONE));
    assert_eq!((R::of(0.5).round(), R::of(1.5).round()), (R::ZERO, R::TWO));
}

#[test]
fn constants_are_what_they_are_called() {
    constants::<f32>();
    constants::<f64>();
    assert_eq!(<f64 as Real>::residual(0.1), 0.0);
    let whole = f64::from(<f32 as Real>::of(0.1)) + f64::from(<f32 as Real>::residual(0.1));
    assert!((whole - 0.1).abs() < 1e-16);
    assert_eq!((<f32 as Real>::entry(1.0, 2.0), <f64 as Real>::entry(1.0, 2.0)), (1.0, 2.0));
}

fn comparisons<R: Scalar>() {
    let (nan, infinite) = (R::of(f64::NAN), R::of(f64::INFINITY));
    for x in [nan, infinite, -infinite, R::TWO, -R::TWO] {
        assert!(!x.is_within(R::ONE));
    }
    for x in [R::ZERO, R::ONE, -R::ONE, R::HALF] {
        assert!(x.is_within(R::ONE));
    }
    assert!(R::any(R::ZERO.less(R::ONE)) && !R::any(R::ONE.less(R::ONE)));
    assert!(!R::any(nan.less(R::ONE)) && !R::any(R::ONE.less(nan)));
    assert!(R::select(R::ZERO.less(R::ONE), R::ONE, R::TWO) == R::ONE);
    assert!(R::select(R::ONE.less(R::ZERO), R::ONE, R::TWO) == R::TWO);
}

#[test]
fn nothing_that_is_not_finite_lies_within_a_bound() {
    comparisons::<f32>();
    comparisons::<f64>();
}

fn twins<R: Scalar + std::fmt::Debug>() {
    let mut numbers = Numbers(12);
    for _ in 0..2000 {
        let [a, b, c, d] = std::array::from_fn(|_| match numbers.word() % 8 {
            0 => R::ZERO,
            1 => -R::ZERO,
            _ => R::narrow(numbers.within(1e3)),
        });
        let (one, other) = (R::Twin::new(a, b), R::Twin::new(c, d));
        let (plain, plain_other) = (Both(a, b), Both(c, d));
        for (twin, expected, by_hand) in [
            (one + other, plain + plain_other, (a + c, b + d)),
            (one - other, plain - plain_other, (a - c, b - d)),
            (one * other, plain * plain_other, (a * c, b * d)),
            (one.quarter_turn(), plain.quarter_turn(), (-b, a)),
            (-one, -plain, (-a, -b)),
            (Twin::both(a), Twin::both(a), (a, a)),
        ] {
            let words = |(a, b): (R, R)| [a.to_bits(), b.to_bits()];
            assert_eq!(words(twin.parts()), words(by_hand));
            assert_eq!(words(expected.parts()), words(by_hand));
        }
    }
    // Each of the six in its turn, over its own bound and none of the others'.
    let bounds: [R; 6] = std::array::from_fn(|i| R::count(i as u32 + 1));
    let pairs = |x: [R; 6]| [0, 2, 4].map(|i| R::Twin::new(x[i], x[i + 1]));
    let plain = |x: [R; 6]| [0, 2, 4].map(|i| Both(x[i], x[i + 1]));
    let within = |x| {
        let within = R::Twin::all_within(pairs(x), pairs(bounds));
        assert_eq!(within, Both::all_within(plain(x), plain(bounds)), "{x:?}");
        within
    };
    assert!(within(bounds) && within(bounds.map(|x| -x)) && within([-R::ZERO; 6]));
    for i in 0..6 {
        let over = bounds[i] + R::HALF;
        for x in [over, -over, R::narrow(f64::NAN), R::narrow(f64::INFINITY)] {
            let mut values = bounds;
            values[i] = x;
            assert!(!within(values), "{i} {x:?}");
        }
    }
}

/// The vector unit's pair of numbers has the bits of two scalars.
#[test]
fn twins_have_the_bits_of_scalars() {
    twins::<f64>();
    twins::<f32>();
}
