//! Pure coning: the drift that each window leaves, against the leading terms of its residual.

use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::strapdown::block::body::{Sum, integrate};
use schuler::strapdown::block::fit::Fit;
use schuler::strapdown::block::series::Series;
use schuler::strapdown::block::window::{H0B4A0, H2B2A2, H2B4A2, H4B4A4, Window};
use schuler::strapdown::reference::textbook::body::Compensated;
use std::f64::consts::TAU;

/// Half-cone angle, rad.
const CONE: f64 = 0.02;

/// ω = aΩ(cos Ωt, sin Ωt, 0), Ω = 1: increments from one phase to another.
fn increment(from: f64, to: f64) -> Increment<f64> {
    // cos and sin of differences, so that no digits cancel.
    let (middle, half) = ((from + to) / 2.0, (to - from) / 2.0);
    let length = 2.0 * CONE * half.sin();
    Increment {
        angle_b: Vector::new(length * middle.cos(), length * middle.sin(), 0.0),
        velocity_b: Vector::ZERO,
    }
}

/// The rotation over it: C = exp([(a, 0, 1)t ×]) Rz(−t), about the phase at the start.
fn rotation(from: f64, to: f64) -> Quaternion<f64> {
    let t = to - from;
    let about_z = |x: f64| Quaternion::new((x / 2.0).cos(), Vector::new(0.0, 0.0, (x / 2.0).sin()));
    let n = Vector::new(CONE, 0.0, 1.0);
    let half = n.norm() * t / 2.0;
    let cone = Quaternion::new(half.cos(), n * (half.sin() / n.norm()));
    about_z(from) * cone * about_z(-t) * about_z(-from)
}

/// Mean drift about the cone's axis per sample, divided by a²: by the window's own series, and by one
/// so long that only the fit is left.
fn drifts<W: Window, const P: usize>(samples_per_cycle: u32) -> [f64; 2] {
    let beta = TAU / f64::from(samples_per_cycle);
    let start = 0.3 - W::HISTORY as f64 * beta;
    let edge = |j: usize| start + j as f64 * beta;
    let samples: [_; P] = std::array::from_fn(|j| increment(edge(j), edge(j + 1)));
    let (own, _) = W::integrate(&samples, 1.0, W::TERMS, false).unwrap();
    let (fit, sum) = Fit::<f64, P>::from_any(&samples, W::HISTORY, W::BLOCK);
    let (long, _): (_, Series<f64, 23>) = integrate(&fit, &Sum::rounded(sum), 1.0, 22);
    let truth = rotation(0.3, 0.3 + W::BLOCK as f64 * beta);
    [own, long].map(|body| {
        let rest = truth.conjugate() * (body.rotation + Quaternion::IDENTITY);
        rest.rotation_vector().z.abs() / (CONE * CONE * W::BLOCK as f64)
    })
}

fn assert_near(computed: f64, expected: f64, what: &str) {
    assert!((computed / expected - 1.0).abs() < 0.1, "{what}: {computed:e} {expected:e}");
}

/// Per sample, at 10 and 20 samples per cycle, by high-precision arithmetic.
#[test]
fn residual_drift_of_windows() {
    for ([own, long], expected, what) in [
        (drifts::<H0B4A0, 4>(10), 3.4e-4, "H0B4A0 10"),
        (drifts::<H0B4A0, 4>(20), 3.0e-6, "H0B4A0 20"),
        (drifts::<H2B2A2, 6>(10), 9.8e-6, "H2B2A2 10"),
        (drifts::<H2B2A2, 6>(20), 2.1e-8, "H2B2A2 20"),
        (drifts::<H2B4A2, 8>(10), 1.4e-6, "H2B4A2 10"),
        (drifts::<H2B4A2, 8>(20), 8.0e-10, "H2B4A2 20"),
        (drifts::<H4B4A4, 12>(10), 8.5e-9, "H4B4A4 10"),
    ] {
        assert_near(long, expected, what);
        // The window's own series ends earlier; that must not add to it.
        assert!(own <= 1.1 * expected, "{what}: {own:e} {expected:e}");
    }
}

/// The leading terms per block: 8β⁷/189, .00142β⁹, .00119β¹¹.
#[test]
fn leading_terms_at_many_samples_per_cycle() {
    let beta = TAU / 40.0;
    assert_near(4.0 * drifts::<H0B4A0, 4>(40)[1], 8.0 * beta.powi(7) / 189.0, "H0B4A0");
    assert_near(2.0 * drifts::<H2B2A2, 6>(40)[1], 0.00142 * beta.powi(9), "H2B2A2");
    let beta = TAU / 24.0;
    assert_near(4.0 * drifts::<H2B4A2, 8>(24)[1], 0.00119 * beta.powi(11), "H2B4A2");
}

/// β⁵/60 per sample with the previous sample alone.
#[test]
fn residual_drift_of_the_textbook() {
    for (samples_per_cycle, expected) in [(10, 1.6e-3), (20, 5.0e-5), (100, 1.6e-8)] {
        let beta = TAU / f64::from(samples_per_cycle);
        let body =
            Compensated::from_samples(&increment(0.3, 0.3 + beta), &increment(0.3 - beta, 0.3));
        let rest = rotation(0.3, 0.3 + beta).conjugate() * body.rotation;
        let drift = rest.rotation_vector().z.abs() / (CONE * CONE);
        assert_near(drift, expected, &format!("{samples_per_cycle}"));
    }
}

#[test]
fn the_textbooks_rotation_is_as_close_as_its_series() {
    let axis = Vector::new(2.0, -1.0, 2.0) * (1.0 / 3.0);
    for turn in [0.1, 0.5, 1.0, 1.5, 2.0_f64] {
        // Two samples about one axis: nothing cones.
        let sample = Increment { angle_b: axis * turn, velocity_b: Vector::ZERO };
        let body = Compensated::from_samples(&sample, &sample);
        let (sine, cosine) = (turn / 2.0).sin_cos();
        // The terms that follow, x = ¼θ²: x⁵/10! of the cosine, x⁵/11! of the sine over its angle.
        let left = (turn * turn / 4.0).powi(5) / 3_628_800.0 + 4.0 * f64::EPSILON;
        assert!((body.rotation.w - cosine).abs() <= left, "{turn}: {:?}", body.rotation);
        let off = (body.rotation.v - axis * sine).norm();
        assert!(off <= left * turn / 2.0 / 11.0 + 4.0 * f64::EPSILON, "{turn}: {off:e}");
    }
}
