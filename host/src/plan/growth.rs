//! How far steady errors of the steps carry a position: the unaided growth laws.

use schuler::earth::{EQUATORIAL_GRAVITY, ROTATION_RATE, SEMI_MAJOR_AXIS};
use schuler::math::real::Real;
use schuler::math::vector::Vector;

/// Errors that blocks add per second, in north, east, down, about one instant.
#[derive(Clone, Copy, Debug, Default)]
pub struct Rate {
    /// When, s.
    pub time_s: f64,
    /// rad/s.
    pub tilt: Vector<f64>,
    /// m/s².
    pub acceleration: Vector<f64>,
    /// m/s.
    pub velocity: Vector<f64>,
}

/// ω_s² = g/R; the vertical diverges with κ² = 2ω_s².
fn schuler_rate() -> f64 {
    (EQUATORIAL_GRAVITY / SEMI_MAJOR_AXIS).sqrt()
}

/// sin ωt/ω and 1 − cos ωt.
fn swing(time_s: f64) -> (f64, f64) {
    let x = schuler_rate() * time_s;
    let (sine, _) = Real::sin_cos(x);
    let (half, _) = Real::sin_cos(0.5 * x);
    (sine / schuler_rate(), 2.0 * half * half)
}

/// sinh κt/κ and cosh κt − 1.
pub fn rise(time_s: f64) -> (f64, f64) {
    let kappa = core::f64::consts::SQRT_2 * schuler_rate();
    // Beyond any flight's length numbers would overflow.
    let x = (kappa * time_s).min(300.0);
    let (up, down) = (Real::exp_m1(x), Real::exp_m1(-x));
    (0.5 * (up - down) / kappa, 0.5 * (up + down))
}

/// Where the errors of some instants spread evenly over a flight lead to, with an allowance for what lies
/// between the instants: `wave_s` is the reciprocal of the slowest turning that they do not resolve.
pub fn position_m(rates: &[Rate], duration_s: f64, wave_s: f64) -> f64 {
    let share_s = duration_s / rates.len().max(1) as f64;
    let at = |end_s: f64| {
        let mut halves = [Vector::ZERO; 2];
        let mut heading = 0.0;
        for (i, rate) in rates.iter().enumerate().filter(|(_, rate)| rate.time_s < end_s) {
            let t = end_s - rate.time_s;
            let ((along, swung), (up, risen)) = (swing(t), rise(t));
            let (tilt, a, v) = (rate.tilt, rate.acceleration, rate.velocity);
            let tilted = SEMI_MAJOR_AXIS * swung;
            halves[i % 2] = halves[i % 2]
                + Vector::new(
                    a.x * along - tilt.y * tilted + v.x,
                    a.y * along + tilt.x * tilted + v.y,
                    a.z * up + v.z * (1.0 + risen),
                ) * share_s;
            // Heading tilts the level by the Earth's rate only.
            heading += tilt.z * tilted * (ROTATION_RATE * t / 3.0) * share_s;
        }
        let [even, odd] = halves;
        (even + odd).norm() + heading.abs() + (even - odd).norm()
    };
    let quarters = [0.25, 0.5, 0.75, 1.0].map(|part| at(part * duration_s));
    let steady = quarters.into_iter().fold(0.0, f64::max);
    let count = rates.len().max(1) as f64;
    let spread = |of: fn(&Rate) -> Vector<f64>| {
        let mean = rates.iter().fold(Vector::ZERO, |s, r| s + of(r)) * (1.0 / count);
        let square: f64 = rates.iter().map(|r| (of(r) - mean).dot(of(r) - mean)).sum();
        (square / count).sqrt()
    };
    let wave_s = wave_s.min(share_s);
    let (along, swung) = (duration_s, 0.5 * EQUATORIAL_GRAVITY * duration_s * duration_s);
    let offset = wave_s * (spread(|r| r.tilt) * swung + spread(|r| r.acceleration) * along);
    steady + offset
}

/// What one rounding may cost: that of a coordinate, and of gravity through the free vertical, m.
pub fn rounding_m(duration_s: f64) -> f64 {
    // u(R + (γ/κ²)(cosh κt − 1)), γ/κ² = R/2
    let (_, risen) = rise(duration_s);
    0.5 * f64::EPSILON * SEMI_MAJOR_AXIS * (1.0 + 0.5 * risen)
}
