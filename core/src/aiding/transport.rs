//! A measurement of the past as one of the present: its row goes through the steps and the corrections since then.
//!
//! y = h·x + v holds at the time of the measurement. Over a step x₁ = Φx, so that h₁ = h·Φ⁻¹; a correction takes x_k
//! off the errors, so that y₁ = y − h·x_k. What the noise of the steps in between adds is left out.
//!
//! ```
//! use schuler::aiding::transition::{Stretch, Transition};
//!
//! // A position that is a second old, of a vehicle that does not turn: the errors now are δr + Tδv.
//! let stretch = Stretch { time_s: 1.0_f64, ..Stretch::NONE };
//! let mut row = [0.0; 15];
//! row[0] = 1.0;
//! Transition::new(&stretch).carry(&mut row);
//! assert_eq!((row[0], row[3], row[12]), (1.0, -1.0, 0.5));
//! ```

use super::transition::Transition;
use crate::math::real::Real;
use crate::math::vector::Vector;

/// A row's parts along δr, δv, ψ and the biases of gyros and accelerometers.
fn parts<R: Real, const N: usize>(row: &[R; N]) -> [Vector<R>; 5] {
    let mut parts = [Vector::ZERO; 5];
    for (part, cells) in parts.iter_mut().zip(row.as_chunks().0) {
        *part = Vector::from(*cells);
    }
    parts
}

/// The parts put back.
fn put<R: Real, const N: usize>(row: &mut [R; N], parts: [Vector<R>; 5]) {
    for (cells, part) in row.as_chunks_mut().0.iter_mut().zip(parts) {
        *cells = part.into_array();
    }
}

impl<R: Real> Transition<R> {
    /// h ← h·Φ⁻¹: a row of the errors at the start becomes one of those at the end. Further states stay.
    pub fn carry<const N: usize>(&self, row: &mut [R; N]) {
        let [r, mut v, mut psi, mut gyro, mut force] = parts(row);
        let t = self.time_s();
        let (u, s) = (self.velocity(), self.position());
        // δr = Rδr₁ − Tδv − ψ×s − b_g×(Ts/3) − ½T²b_a;  a·(ψ×b) = ψ·(b×a)
        let swept = s.cross(r);
        v = v - r * t;
        psi = psi - swept;
        gyro = gyro - swept * (t * R::ratio(1, 3));
        force = force - r * (t * t * R::HALF);
        // δv = R(δv₁ − TΓδr₁) − ψ×u − b_g×(Tu − s) − Jb_a
        psi = psi - u.cross(v);
        gyro = gyro - (u * t - s).cross(v);
        force = force - self.integral_transposed(v);
        // ψ = Rψ₁ − Jb_g
        gyro = gyro - self.integral_transposed(psi);
        let back = |x: Vector<R>| *self.back() * x;
        let velocity = back(v);
        put(row, [back(r) - self.fallen(velocity), velocity, back(psi), gyro, force]);
    }
}

/// Takes the innovation of a row past a correction by estimated errors.
pub fn past_correction<R: Real, const N: usize>(row: &[R; N], innovation: R, errors: &[R; N]) -> R {
    row.iter().zip(errors).fold(innovation, |y, (h, x)| y - *h * *x)
}
