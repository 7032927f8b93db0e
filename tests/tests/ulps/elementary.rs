//! Functions of a number, and two-float arithmetic.

use super::big::{Big, big};
use super::{Precision, Worst, ulp};
use schuler::math::compensated::{Pair, two_product, two_sum};
use schuler::math::real::Scalar;
use schuler_tests::Numbers;

const TRIES: u32 = 1000;

/// Everything in this file.
pub fn measure(worst: &mut Worst) {
    functions::<f64>(worst);
    functions::<f32>(worst);
    pairs::<f64>(worst);
    pairs::<f32>(worst);
}

/// A number in ± bound.
fn within<R: Scalar>(numbers: &mut Numbers, bound: f64) -> R {
    R::narrow(numbers.within(bound))
}

fn functions<R: Scalar + Precision>(worst: &mut Worst) {
    let mut numbers = Numbers(11);
    let mut check = |what: &str, computed: R, exact: Big| {
        let ulps = (big(computed.widen()) - exact).rough() / (ulp(exact.rough()) * R::ULP);
        worst.add(format!("{what} {}", R::NAME), ulps.abs());
    };
    for _ in 0..TRIES {
        let x: R = within(&mut numbers, 7.0);
        let exact = big(x.widen());
        let (sine, cosine) = x.sin_cos();
        check("sin", sine, exact.sin());
        check("cos", cosine, exact.cos());
        check("expm1", x.exp_m1(), exact.exp() - big(1.0));
        let y: R = within(&mut numbers, 7.0);
        check("atan2", y.atan2(x), big(y.widen()).atan2(exact));
        let x = x.abs();
        let exact = big(x.widen());
        check("sqrt", x.sqrt(), exact.sqrt());
        check("ln", x.ln(), exact.ln());
    }
}

/// A pair of a leading and a trailing part.
fn pair<R: Scalar>(numbers: &mut Numbers) -> Pair<R> {
    Pair::narrow(Pair::sum(numbers.within(3.0), numbers.within(1e-16)))
}

/// Its exact value.
fn value<R: Scalar>(x: Pair<R>) -> Big {
    big(x.hi.widen()) + big(x.lo.widen())
}

fn pairs<R: Scalar + Precision>(worst: &mut Worst) {
    let mut numbers = Numbers(12);
    // An ulp of a pair is the half ulp of its leading part times 2⁻⁵², or 2⁻²³.
    let unit = f64::EPSILON / 2.0 * R::ULP;
    let mut against = |what: &str, computed: Pair<R>, exact: Big, size: f64| {
        let ulps = (value(computed) - exact).rough() / (ulp(size) * R::ULP * unit);
        worst.add(format!("{what} {}", R::NAME), ulps.abs());
    };
    let one = big(1.0);
    for _ in 0..TRIES {
        let (x, y): (Pair<R>, Pair<R>) = (pair(&mut numbers), pair(&mut numbers));
        let (a, b) = (value(x), value(y));
        let mut check = |what: &str, computed: Pair<R>, exact: Big| {
            against(what, computed, exact, exact.rough());
        };
        let (hi, lo) = two_sum(x.hi, y.hi);
        check("two_sum", Pair { hi, lo }, big(x.hi.widen()) + big(y.hi.widen()));
        let (hi, lo) = two_product(x.hi, y.hi);
        check("two_product", Pair { hi, lo }, big(x.hi.widen()) * big(y.hi.widen()));
        // Of like sign, so that nothing cancels.
        let like = if a.is_negative() == b.is_negative() { y } else { -y };
        check("Pair +", x + like, a + value(like));
        check("Pair ×", x * y, a * b);
        check("Pair reciprocal", x.reciprocal(), one / a);
        let square = if a.is_negative() { -x } else { x };
        check("Pair √", square.sqrt(), value(square).sqrt());
        // Series of terms up to e³: what they lose counts in ulps of 1.
        let (sine, cosine) = x.sin_cos();
        against("Pair sin, of 1,", sine, a.sin(), 1.0);
        against("Pair cos, of 1,", cosine, a.cos(), 1.0);
    }
}
