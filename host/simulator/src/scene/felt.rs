//! What sensors feel at an instant, and the errors that follow from it.

use super::values::Values;
use schuler::math::vector::Vector;
use std::f64::consts::TAU;

/// What a triad's systematic errors come from.
pub struct Felt<'a> {
    /// The reading x of perfect sensors.
    pub x: Vector<f64>,
    /// The specific force f.
    pub f: Vector<f64>,
    /// The temperature above that of calibration, K.
    pub warmer_k: f64,
    /// x so many seconds ago; what it was at the start before that.
    pub earlier: &'a dyn Fn(f64) -> Vector<f64>,
}

/// Nodes and weights of ∫₀^∞ e^{−s}g(s)ds, exact for polynomials of degree 11 (Gauss-Laguerre).
const LAGUERRE: [(f64, f64); 6] = [
    (0.2228466041792607, 0.45896467394996476),
    (1.1889321016726226, 0.41700083077212),
    (2.992736326059314, 0.11337338207404488),
    (5.77514356910451, 0.010399197453149087),
    (9.83746741838259, 0.00026101720281493265),
    (15.982873980601703, 8.985479064296213e-07),
];

/// S·x.
pub fn scaled(k: Values, felt: &Felt<'_>) -> Vector<f64> {
    Vector::from(k.axes()).zip(felt.x, |k, x| k * x)
}

/// x(t − D) − x(t).
pub fn delayed(k: Values, felt: &Felt<'_>) -> Vector<f64> {
    less_present(k.axes(), felt, |delay_s| axis_earlier(felt, delay_s))
}

/// ∫₀^∞ e^{−s}x(t − sT)ds − x(t), T = 1/2πf.
pub fn lagging(k: Values, felt: &Felt<'_>) -> Vector<f64> {
    less_present(k.axes(), felt, |frequency_hz| {
        let lag_s = (TAU * frequency_hz).recip();
        let parts = LAGUERRE.iter().map(|(s, weight)| axis_earlier(felt, s * lag_s) * *weight);
        parts.fold(Vector::ZERO, |sum, part| sum + part)
    })
}

fn axis_earlier(felt: &Felt<'_>, seconds: f64) -> Vector<f64> {
    if seconds > 0.0 { (felt.earlier)(seconds) } else { felt.x }
}

/// What is read of each axis with its own value, less the present reading.
fn less_present(
    values: [f64; 3],
    felt: &Felt<'_>,
    read: impl Fn(f64) -> Vector<f64>,
) -> Vector<f64> {
    let [x, y, z] = values;
    // Like axes are asked for once.
    let first = read(x);
    let of = |value: f64| if value == x { first } else { read(value) };
    Vector::new(first.x, of(y).y, of(z).z) - felt.x
}
