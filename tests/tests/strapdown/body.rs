//! The body step against Runge and Kutta, against closed forms, and by the textbook.

use schuler::flight::configuration::{Axes, Precision};
use schuler::flight::plan;
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::strapdown::block::body::BodyMotion;
use schuler::strapdown::block::inside::BlockSeries as _;
use schuler::strapdown::block::window::Window;
use schuler::strapdown::reference::textbook::body::Compensated;
use schuler_tests::Numbers;

/// A rate and a force that are polynomials in σ.
struct Polynomials {
    rate: Vec<Vector<f64>>,
    force: Vec<Vector<f64>>,
}

fn value(coefficients: &[Vector<f64>], sigma: f64) -> Vector<f64> {
    coefficients.iter().rev().fold(Vector::ZERO, |sum, &c| sum * sigma + c)
}

fn integral(coefficients: &[Vector<f64>], from: f64, to: f64) -> Vector<f64> {
    let at = |sigma: f64| {
        let terms = coefficients.iter().zip(1..);
        terms.fold(Vector::ZERO, |sum, (&c, n)| sum + c * (sigma.powi(n) / f64::from(n)))
    };
    at(to) - at(from)
}

impl Polynomials {
    /// Of a window's degree, each power of σ smaller by `pace`, as smooth motion has it.
    fn new<W: Window>(numbers: &mut Numbers, angle: f64, pace: f64) -> Self {
        let mut power = |size: f64, n: usize| numbers.vector(size * pace.powi(n as i32));
        let rate = (0..W::COEFFICIENTS).map(|n| power(angle, n)).collect();
        let force = (0..W::COEFFICIENTS).map(|n| power(0.2, n)).collect();
        Self { rate, force }
    }

    fn samples<W: Window>(&self) -> Vec<Increment<f64>> {
        let edge = |j: usize| -1.0 + 2.0 * (j as f64 - W::HISTORY as f64) / W::BLOCK as f64;
        let sample = |j: usize| Increment {
            angle_b: integral(&self.rate, edge(j), edge(j + 1)),
            velocity_b: integral(&self.force, edge(j), edge(j + 1)),
        };
        (0..W::SAMPLES).map(sample).collect()
    }

    /// q′ = ½ q ⊗ w, u′ = C f, s′ = (T/2)u from the block's start to σ.
    fn runge_kutta(&self, to: f64, half_time_s: f64) -> BodyMotion<f64> {
        type State = (Quaternion<f64>, Vector<f64>, Vector<f64>);
        let plus = |a: State, b: State, k: f64| (a.0 + b.0 * k, a.1 + b.1 * k, a.2 + b.2 * k);
        let slope = |x: State, sigma: f64| {
            let w = value(&self.rate, sigma);
            let f = value(&self.force, sigma);
            let whole = x.0 + Quaternion::IDENTITY;
            let turned = whole * Quaternion::new(0.0, w * 0.5);
            (turned, f + x.0.turn_less_one(f), x.1 * half_time_s)
        };
        let steps = 300;
        let h = (to + 1.0) / f64::from(steps);
        let mut x: State = (Quaternion::ZERO, Vector::ZERO, Vector::ZERO);
        for i in 0..steps {
            let t = -1.0 + f64::from(i) * h;
            let a = slope(x, t);
            let b = slope(plus(x, a, h / 2.0), t + h / 2.0);
            let c = slope(plus(x, b, h / 2.0), t + h / 2.0);
            let d = slope(plus(x, c, h), t + h);
            let sum = plus(plus(plus(a, b, 2.0), c, 2.0), d, 1.0);
            x = plus(x, sum, h / 6.0);
        }
        BodyMotion { rotation: x.0, velocity: x.1, position: x.2, ..BodyMotion::default() }
    }
}

/// Whether rotation, velocity and position agree to three tolerances.
fn assert_same(what: &str, a: &BodyMotion<f64>, b: &BodyMotion<f64>, tolerance: [f64; 3]) {
    let turn = a.rotation - b.rotation;
    let gaps =
        [turn.dot(turn).sqrt(), (a.velocity - b.velocity).norm(), (a.position - b.position).norm()];
    let fine = gaps.iter().zip(tolerance).all(|(&gap, most)| gap <= most);
    assert!(fine, "{what}: {gaps:?} exceed {tolerance:?}\n{a:?}\n{b:?}");
}

/// Rounding of a block's motion: the position comes from the polynomial alone, with the fit's rounding.
fn rounding(half_time_s: f64) -> [f64; 3] {
    [4e-16, 4e-16, 1e-13 * half_time_s]
}

/// The largest angle over half a block at which a window's series ends below 1e-18: that of the position,
/// which has two powers of the angle fewer.
fn liveliest<W: Window>() -> f64 {
    let order = W::TERMS as i32 + 1;
    let factorial: f64 = (1..=order).map(f64::from).product();
    (1e-18 * factorial).powf(1.0 / f64::from(order - 2))
}

fn polynomials<W: Window>() {
    let mut numbers = Numbers(71);
    let half_time_s = 0.02;
    // For constant w and f: Uₙ = (−w×)ⁿ⁻¹f/n!, Dₙ = (n − 1)(−w×)ⁿ⁻²f/n!. What follows the last term m is
    // left out twice, at either end; a vector is √3 of its components.
    let order = W::TERMS as i32 + 1;
    // As lively as ten terms follow: what a longer series rounds would show beyond that.
    let pace = 1e-17_f64.powf(1.0 / f64::from(order.min(11)));
    let factorial: f64 = (1..=order).map(f64::from).product();
    let (w, f) = (3f64.sqrt() * pace, 3f64.sqrt() * 0.2);
    let velocity = 1e-15 + 2.0 * f * w.powi(order - 1) / factorial;
    let position = 2.0 * f64::from(order - 1) * f * w.powi(order - 2) / factorial;
    let tolerance = [1e-15, velocity, (2e-14 + position) * half_time_s];
    for _ in 0..10 {
        let motion = Polynomials::new::<W>(&mut numbers, pace, pace);
        let samples = motion.samples::<W>();
        let (whole, series) = W::integrate(&samples, half_time_s, W::TERMS, false).unwrap();
        let what = format!("H{} B{} A{}", W::HISTORY, W::BLOCK, W::LOOKAHEAD);
        let expected = motion.runge_kutta(1.0, half_time_s);
        assert_same(&what, &whole, &expected, tolerance);
        for sigma in [-0.9, -0.5, 0.0, 0.3, 0.95] {
            let inside = series.until(sigma, half_time_s);
            let expected = motion.runge_kutta(sigma, half_time_s);
            assert_same(&format!("{what} to {sigma}"), &inside, &expected, tolerance);
        }
        assert!(W::integrate(&samples[1..], half_time_s, W::TERMS, false).is_none());
    }
}

#[test]
fn polynomial_motion_is_integrated_to_the_floor_by_every_window() {
    for_every_window!(polynomials);
}

/// Without rotation nothing is small: each power of the force counts in full.
fn force_alone<W: Window>() {
    let mut numbers = Numbers(75);
    let half_time_s = 0.02;
    let motion = Polynomials::new::<W>(&mut numbers, 0.0, 1.0);
    let samples = motion.samples::<W>();
    let (whole, series) = W::integrate(&samples, half_time_s, W::TERMS, false).unwrap();
    // s = (T/2)∬f from the block's start
    let twice = |to: f64| {
        let terms = motion.force.iter().zip(0..);
        let term = |c: Vector<f64>, n: i32| {
            let sign = (-1.0_f64).powi(n + 1);
            let (n, power) = (f64::from(n), to.powi(n + 2));
            c * ((power - -sign) / ((n + 1.0) * (n + 2.0)) - sign * (to + 1.0) / (n + 1.0))
        };
        terms.fold(Vector::ZERO, |sum, (&c, n)| sum + term(c, n)) * half_time_s
    };
    let what = format!("H{} B{} A{}", W::HISTORY, W::BLOCK, W::LOOKAHEAD);
    // The window's samples grow with σ's powers outside the block, and so does their rounding.
    let edge = 1.0 + 2.0 * W::HISTORY.max(W::LOOKAHEAD) as f64 / W::BLOCK as f64;
    let relative = 4e-16 * edge.powi(W::COEFFICIENTS as i32);
    let check = |what: &str, computed: BodyMotion<f64>, to: f64| {
        let velocity = integral(&motion.force, -1.0, to);
        let expected = BodyMotion {
            rotation: Quaternion::ZERO,
            velocity,
            position: twice(to),
            ..BodyMotion::default()
        };
        assert_same(what, &computed, &expected, [0.0, relative, 10.0 * relative * half_time_s]);
    };
    check(&what, whole, 1.0);
    for sigma in [-0.9, -0.5, 0.0, 0.3, 0.95] {
        check(&format!("{what} to {sigma}"), series.until(sigma, half_time_s), sigma);
    }
}

#[test]
fn polynomial_force_is_integrated_exactly_by_every_window() {
    for_every_window!(force_alone);
}

/// Constant rate and force: closed forms in the rotation over the whole block, Δθ.
fn constant(angle: Vector<f64>, velocity: Vector<f64>, time_s: f64) -> BodyMotion<f64> {
    let x = angle.norm();
    let (once, twice) = (angle.cross(velocity), angle.cross(angle.cross(velocity)));
    // (1 − cos x)/x², (x − sin x)/x³, (x²/2 − 1 + cos x)/x⁴ by their series
    let series = |first: i32| {
        let factorial = |n: i32| (1..=n).map(f64::from).product::<f64>();
        (0..12).map(|k| (-1.0_f64).powi(k) * x.powi(2 * k) / factorial(first + 2 * k)).sum::<f64>()
    };
    let (s, c) = ((x / 2.0).sin(), 2.0 * (x / 4.0).sin().powi(2));
    BodyMotion {
        rotation: Quaternion::new(-c, if x > 0.0 { angle * (s / x) } else { angle }),
        velocity: velocity + once * series(2) + twice * series(3),
        position: (velocity * 0.5 + once * series(3) + twice * series(4)) * time_s,
        ..BodyMotion::default()
    }
}

fn steady<W: Window>() {
    let mut numbers = Numbers(72);
    let time_s = 0.04;
    for turn in [0.0, 1e-6, 1e-3, 0.5 * liveliest::<W>()] {
        let sample = Increment {
            angle_b: numbers.vector(turn / W::BLOCK as f64),
            velocity_b: numbers.vector(0.5 / W::BLOCK as f64),
        };
        let samples = vec![sample; W::SAMPLES];
        let n = W::BLOCK as f64;
        let expected = constant(sample.angle_b * n, sample.velocity_b * n, time_s);
        let what = format!("H{} B{} A{}, {turn}", W::HISTORY, W::BLOCK, W::LOOKAHEAD);
        let (whole, _) = W::integrate(&samples, time_s / 2.0, W::TERMS, false).unwrap();
        assert_same(&what, &whole, &expected, rounding(time_s));
    }
}

#[test]
fn steady_turns_have_their_closed_form() {
    for_every_window!(steady);
}

/// Order 3 is planned where it is enough, and hardly any earlier than it must be.
#[test]
fn a_low_order_is_planned_where_it_reaches_the_floor() {
    use schuler::strapdown::block::window::H0B4A0;
    let mut switched = 0.0;
    for k in 0..40 {
        let turn = 1e-6 * 1.26_f64.powi(k);
        let demand = plan::Demand {
            bandwidth: 0.0,
            angular_rate: turn / 0.04,
            speed: 0.0,
            interval_s: 0.01,
            precision: Precision::F64,
            axes: Axes::EarthFixed,
        };
        let sample = Increment {
            angle_b: Vector::new(0.6, 0.0, -0.8) * (turn / 4.0),
            velocity_b: Vector::new(0.1, 0.2, -0.05),
        };
        let (whole, _) = H0B4A0::integrate(&[sample; 4], 0.02, 3, false).unwrap();
        let expected = constant(sample.angle_b * 4.0, sample.velocity_b * 4.0, 0.04);
        if plan::order(&demand, H0B4A0::SHAPE) == 3 {
            // A block's position is left without 2·3 w³f/4! and more of T/2: a nanometre in ten thousand.
            assert_same(&format!("{turn}"), &whole, &expected, [4e-16, 4e-16, 1e-13]);
            switched = turn;
        } else if turn > 30.0 * switched {
            assert!((whole.velocity - expected.velocity).norm() > 4e-16, "{turn}");
        }
    }
    assert!((3e-4..3e-3).contains(&switched), "{switched}");
}

#[test]
fn single_precision_keeps_the_sums() {
    let mut numbers = Numbers(73);
    for _ in 0..50 {
        use schuler::strapdown::block::window::H2B4A2;
        let motion = Polynomials::new::<H2B4A2>(&mut numbers, 0.05, 0.05);
        let samples = motion.samples::<H2B4A2>();
        let narrow = |v: Vector<f64>| v.map(|c| c as f32);
        let wide = |v: Vector<f32>| v.map(f64::from);
        let single: Vec<_> = samples
            .iter()
            .map(|s| Increment { angle_b: narrow(s.angle_b), velocity_b: narrow(s.velocity_b) })
            .collect();
        let rounded: Vec<_> = single
            .iter()
            .map(|s| Increment { angle_b: wide(s.angle_b), velocity_b: wide(s.velocity_b) })
            .collect();
        let (a, _) = H2B4A2::integrate(&single, 0.02, H2B4A2::TERMS, false).unwrap();
        let (b, _) = H2B4A2::integrate(&rounded, 0.02, H2B4A2::TERMS, false).unwrap();
        let miss = wide(a.rotation.v) - b.rotation.v;
        assert!(miss.norm() <= 1.5e-7 * b.rotation.v.norm(), "{miss:?} {b:?}");
        let miss = wide(a.velocity) - b.velocity;
        assert!(miss.norm() <= 1.5e-7 * b.velocity.norm(), "{miss:?} {b:?}");
    }
}

#[test]
fn the_textbooks_sample_turns_velocity_completely() {
    let mut numbers = Numbers(74);
    for turn in [0.0, 1e-5, 1e-3, 0.05, 0.2] {
        let sample = Increment { angle_b: numbers.vector(turn), velocity_b: numbers.vector(0.1) };
        let body = Compensated::from_samples(&sample, &sample);
        let expected = constant(sample.angle_b, sample.velocity_b, 1.0);
        let rest = body.rotation - (expected.rotation + Quaternion::IDENTITY);
        // Its series end at θ⁶/40320 and the like.
        let floor = 3e-16 + turn.powi(6) / 20_000.0;
        assert!(rest.dot(rest).sqrt() <= floor, "{turn}: {rest:?}");
        assert!((body.velocity - expected.velocity).norm() <= floor, "{turn}");
    }
}
