//! The body step of a block against the same rates integrated in high precision.
//!
//! The rates are the polynomial through the window's increments, so that only the series and its rounding
//! differ: here by Lagrange's formula, there by the window's table; here with thirty terms about the
//! block's start, there with eight to fourteen about its centre.

use super::big::{Big, big, largest};
use super::{Precision, Worst, ulp};
use schuler::math::quaternion::Quaternion;
use schuler::math::real::Scalar;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::strapdown::block::window::{H0B4A0, H2B4A2, H4B4A4, Window};
use schuler_tests::Numbers;

const TRIES: u32 = 20;
const TERMS: usize = 30;
const INTERVAL_S: f64 = 0.0078125;

/// Everything in this file.
pub fn measure(worst: &mut Worst) {
    window::<f64, H0B4A0>(worst, "H0B4A0");
    window::<f64, H2B4A2>(worst, "H2B4A2");
    window::<f64, H4B4A4>(worst, "H4B4A4");
    window::<f32, H0B4A0>(worst, "H0B4A0");
    window::<f32, H2B4A2>(worst, "H2B4A2");
}

/// A polynomial of vectors in t, one sample long.
type Polynomial = Vec<Vector<Big>>;

/// The rates whose integrals over the samples are these; t = 0 at the block's start.
fn through(increments: &[Vector<Big>], history: usize) -> Polynomial {
    let count = increments.len();
    let edge = |m: usize| big(m as f64 - history as f64);
    let zero = Vector::new(big(0.0), big(0.0), big(0.0));
    let mut integral = vec![zero; count + 1];
    let mut sum = zero;
    for m in 1..=count {
        sum = sum + increments[m - 1];
        // ℓ_m(t) = Π_{i≠m}(t − tᵢ)/(t_m − tᵢ)
        let mut basis = vec![big(1.0)];
        for i in (0..=count).filter(|&i| i != m) {
            let scale = big(1.0) / (edge(m) - edge(i));
            let mut next = vec![big(0.0); basis.len() + 1];
            for (n, &c) in basis.iter().enumerate() {
                next[n] = next[n] - c * edge(i) * scale;
                next[n + 1] = next[n + 1] + c * scale;
            }
            basis = next;
        }
        for (total, c) in integral.iter_mut().zip(basis) {
            *total = *total + sum * c;
        }
    }
    (1..=count).map(|n| integral[n] * big(n as f64)).collect()
}

/// Rotation less one, velocity and position over the block, by their series about its start.
fn integrate(
    rate: &Polynomial,
    force: &Polynomial,
    block: f64,
) -> (Quaternion<Big>, [Vector<Big>; 2]) {
    let zero = Vector::new(big(0.0), big(0.0), big(0.0));
    // q′ = ½q ⊗ w; C f = q ⊗ f ⊗ q*; v′ = C f; s′ = v
    let mut q = vec![Quaternion::new(big(1.0), zero)];
    for n in 0..TERMS {
        let mut sum = Quaternion::new(big(0.0), zero);
        for (k, &w) in rate.iter().enumerate().take(n + 1) {
            sum = sum + q[n - k] * Quaternion::new(big(0.0), w);
        }
        q.push(sum * (big(0.5) / big((n + 1) as f64)));
    }
    let zero_quaternion = Quaternion::new(big(0.0), zero);
    let product = |a: &[Quaternion<Big>], b: &[Quaternion<Big>]| -> Vec<_> {
        let term = |n: usize| {
            (0..=n).fold(zero_quaternion, |sum, k| match (a.get(k), b.get(n - k)) {
                (Some(&a), Some(&b)) => sum + a * b,
                _ => sum,
            })
        };
        (0..=TERMS).map(term).collect()
    };
    let force: Vec<_> = force.iter().map(|&f| Quaternion::new(big(0.0), f)).collect();
    let back: Vec<_> = q.iter().map(|q| q.conjugate()).collect();
    let pulled = product(&product(&q, &force), &back);
    let (mut rotation, mut velocity, mut position) = (zero_quaternion, zero, zero);
    for n in (0..=TERMS).rev() {
        if n > 0 {
            rotation = (rotation + q[n]) * big(block);
        }
        velocity = (velocity + pulled[n].v * (big(1.0) / big((n + 1) as f64))) * big(block);
        let twice = big(1.0) / (big((n + 1) as f64) * big((n + 2) as f64));
        position = (position + pulled[n].v * twice) * big(block);
    }
    (rotation, [velocity, position * big(block)])
}

fn window<R: Scalar + Precision, W: Window>(worst: &mut Worst, name: &str) {
    let mut numbers = Numbers(41);
    for _ in 0..TRIES {
        // 0.1 rad/s and 10 m/s² that change by about a tenth over a window, smoothly: a motion that the
        // series is long enough for.
        let mut smooth = |size: f64| {
            let mut part = |scale: f64| numbers.vector(size * scale);
            let (mean, slope, curve) = (part(1.0), part(0.1), part(0.01));
            move |sample: usize| {
                let x = sample as f64 / W::SAMPLES as f64;
                (mean + slope * x + curve * (x * x)).map(R::narrow)
            }
        };
        let (angle, velocity) = (smooth(0.001), smooth(0.1));
        let samples: Vec<Increment<R>> = (0..W::SAMPLES)
            .map(|j| Increment { angle_b: angle(j), velocity_b: velocity(j) })
            .collect();
        let half = R::narrow(INTERVAL_S * W::BLOCK as f64 / 2.0);
        let (body, _) = W::integrate(&samples, half, W::TERMS, false).unwrap();
        let exactly = |x: Vector<R>| x.map(|c| big(c.widen()));
        let angles: Vec<_> = samples.iter().map(|s| exactly(s.angle_b)).collect();
        let velocities: Vec<_> = samples.iter().map(|s| exactly(s.velocity_b)).collect();
        let (rotation, [velocity, position]) = integrate(
            &through(&angles, W::HISTORY),
            &through(&velocities, W::HISTORY),
            W::BLOCK as f64,
        );
        let position = position * big(INTERVAL_S);
        let length = |x: Vector<Big>| x.dot(x).sqrt().rough();
        let mut check = |what: &str, off: f64, size: f64| {
            let kernel = format!("{name} {what} {}", R::NAME);
            worst.add(kernel, off / (ulp(size) * R::ULP));
        };
        let apart = |a: Vector<R>, b: Vector<Big>| largest((exactly(a) - b).into_array());
        let Quaternion { w, v } = body.rotation;
        check("rotation", apart(v, rotation.v), length(rotation.v));
        check("rotation's scalar", largest([big(w.widen()) - rotation.w]), rotation.w.rough());
        check("velocity", apart(body.velocity, velocity), length(velocity));
        check("position", apart(body.position, position), length(position));
    }
}
