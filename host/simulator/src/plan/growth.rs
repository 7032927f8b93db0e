//! The growth of a position error from steady errors of the steps, without aiding.

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

impl Rate {
    /// What this one has beyond another.
    pub fn less(&self, other: &Self) -> Self {
        Self {
            time_s: self.time_s,
            tilt: self.tilt - other.tilt,
            acceleration: self.acceleration - other.acceleration,
            velocity: self.velocity - other.velocity,
        }
    }
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

/// Where what is added at an instant has led to by another, north, east, down, m, and what comes of the
/// heading.
fn led(added: &Rate, end_s: f64) -> (Vector<f64>, f64) {
    let t = end_s - added.time_s;
    let ((along, swung), (up, risen)) = (swing(t), rise(t));
    let (tilt, a, v) = (added.tilt, added.acceleration, added.velocity);
    let tilted = SEMI_MAJOR_AXIS * swung;
    let position = Vector::new(
        a.x * along - tilt.y * tilted + v.x,
        a.y * along + tilt.x * tilted + v.y,
        a.z * up + v.z * (1.0 + risen),
    );
    // Heading tilts the level by the Earth's rate only.
    (position, tilt.z * tilted * (ROTATION_RATE * t / 3.0))
}

/// The largest of what some instants of a flight have.
fn most(of: impl Fn(f64) -> f64, duration_s: f64) -> f64 {
    [0.25, 0.5, 0.75, 1.0].into_iter().map(|part| of(part * duration_s)).fold(0.0, f64::max)
}

/// Where errors of a beginning lead to together with what some instants, spread evenly over the flight, add
/// from then on; with an allowance for what lies between the instants.
///
/// `begun` has tilt, velocity and position in the places of what is added to them.
pub fn position_m(begun: &Rate, rates: &[Rate], duration_s: f64) -> f64 {
    let share_s = duration_s / rates.len().max(1) as f64;
    let at = |end_s: f64| {
        let (mut position, mut turned) = led(begun, end_s.max(begun.time_s));
        let mut halves = [Vector::ZERO; 2];
        for (i, rate) in rates.iter().enumerate() {
            let (from_s, to_s) = (i as f64 * share_s, (i + 1) as f64 * share_s);
            let (from_s, to_s) = (from_s.max(begun.time_s), to_s.min(end_s));
            if from_s < to_s {
                let rate = Rate { time_s: 0.5 * (from_s + to_s), ..*rate };
                let (added, also) = led(&rate, end_s);
                halves[i % 2] = halves[i % 2] + added * (to_s - from_s);
                turned += also * (to_s - from_s);
            }
        }
        let [even, odd] = halves;
        position = position + even + odd;
        position.norm() + turned.abs() + (even - odd).norm()
    };
    most(at, duration_s)
}

/// What one rounding may cost: that of a coordinate, and of gravity through the free vertical, m.
pub fn rounding_m(duration_s: f64) -> f64 {
    // u(R + (γ/κ²)(cosh κt − 1)), γ/κ² = R/2
    let (_, risen) = rise(duration_s);
    0.5 * f64::EPSILON * SEMI_MAJOR_AXIS * (1.0 + 0.5 * risen)
}
