//! What a filter needs to know of a place, and of the vehicle there.
//!
//! ```
//! use schuler::aiding::surroundings::Surroundings;
//! use schuler::earth::Geodetic;
//!
//! let at = Geodetic { latitude: 0.8_f64, longitude: 0.1, altitude: 0.0 };
//! let here = Surroundings::at(&at);
//! // A metre north turns the vertical by 1/R.
//! let turn = here.turn(schuler::math::vector::Vector::new(1.0, 0.0, 0.0));
//! assert!((turn.y + 1.57e-7).abs() < 1e-9);
//! ```

use crate::earth::{self, Geodetic, POLAR_SINE, Radii, gradient};
use crate::math::quaternion::Matrix;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::solution::Solution;

/// The Earth at a place. It changes little over kilometres: a filter may keep it for a second or, at rest, for good.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Surroundings<R> {
    /// ω_ieⁿ, rad/s.
    pub earth_rate_ned: Vector<R>,
    /// γ, m/s².
    pub gravity: R,
    /// Diagonal of ∂gⁿ/∂rⁿ, 1/s².
    gradient: Vector<R>,
    /// ∂g_D/∂r_N, 1/s².
    slope: R,
    /// 1/(R_M + h) and 1/(R_N + h), 1/m.
    curvature: [R; 2],
    /// tanφ; 0 beyond 84°, where north is carried along.
    tangent: R,
}

/// Attitude and velocity at the end of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pose<R> {
    /// C_bⁿ.
    pub body_to_ned: Matrix<R>,
    /// Relative to the Earth, north, east, down, m/s.
    pub velocity_ned: Vector<R>,
}

impl<R: Real> Pose<R> {
    /// Of a solution.
    pub fn of(solution: &Solution<R>) -> Self {
        Self {
            body_to_ned: solution.attitude.map(|c| c.hi).matrix(R::ONE),
            velocity_ned: solution.velocity_ned.map(|c| c.hi),
        }
    }

    /// Cᵀx: components along the body's axes.
    #[inline(always)]
    pub fn to_body(&self, ned: Vector<R>) -> Vector<R> {
        self.body_to_ned.transpose() * ned
    }
}

impl<R: Real> Surroundings<R> {
    /// At a place.
    pub fn at(position: &Geodetic<R>) -> Self {
        let (s, c) = position.latitude.sin_cos();
        Self::from_latitude(s, c, position.altitude)
    }

    /// At a latitude, by its sine and cosine.
    pub fn from_latitude(sine: R, cosine: R, altitude: R) -> Self {
        let radii = Radii::at(sine, cosine);
        let gravity = earth::gravity(sine, altitude);
        let (per_latitude, per_height) = gradient::of_gravity(sine, cosine, altitude);
        let [north, east] =
            [radii.meridian, radii.prime_vertical].map(|radius| R::ONE / (radius + altitude));
        let polar = R::of(POLAR_SINE).less(sine.abs());
        let divisor = R::select(polar, R::ONE, cosine);
        Self {
            earth_rate_ned: earth::rotation_ned(sine, cosine),
            gravity,
            // Gravity γ(φ, h) turns with the vertical: −γ/(R_M + h), −γ/(R_N + h), −∂γ/∂h
            gradient: Vector::new(-(gravity * north), -(gravity * east), -per_height),
            slope: per_latitude * north,
            curvature: [north, east],
            tangent: R::select(polar, R::ZERO, sine / divisor),
        }
    }

    /// Γ_b = CᵀΓC, the gradient of gravitation in body axes, 1/s².
    pub fn gradient_b(&self, pose: &Pose<R>) -> Matrix<R> {
        // Gravitation is gravity without the centrifugal term: Γ = ∂g/∂r + [ω_ie×]²
        let [n, e, d] = pose.body_to_ned.rows;
        let omega = pose.to_body(self.earth_rate_ned);
        let square = omega.dot(omega);
        let row = |n_i: R, e_i: R, d_i: R, omega_i: R| {
            n * (n_i * self.gradient.x + d_i * self.slope)
                + e * (e_i * self.gradient.y)
                + d * (d_i * self.gradient.z)
                + omega * omega_i
        };
        let mut rows =
            [row(n.x, e.x, d.x, omega.x), row(n.y, e.y, d.y, omega.y), row(n.z, e.z, d.z, omega.z)];
        let [a, b, c] = &mut rows;
        (a.x, b.y, c.z) = (a.x - square, b.y - square, c.z - square);
        Matrix { rows }
    }

    /// R_M + h and R_N + h, m.
    pub fn radii(&self) -> [R; 2] {
        self.curvature.map(|curvature| R::ONE / curvature)
    }

    /// The rotation vector of the local axes over a small way in north, east and down, rad.
    #[inline]
    pub fn turn(&self, way_ned: Vector<R>) -> Vector<R> {
        // (D_E/(R_N + h), −D_N/(R_M + h), −D_E tanφ/(R_N + h))
        let [north, east] = self.curvature;
        let along = way_ned.y * east;
        Vector::new(along, -(way_ned.x * north), -(along * self.tangent))
    }

    /// The way from one place to another near it, north, east, down, m; `cosine` is the latitude's.
    pub fn way(&self, from: &Solution<R>, to: &Solution<R>, cosine: R) -> Vector<R> {
        let difference =
            |a: crate::math::compensated::Pair<R>, b: crate::math::compensated::Pair<R>| (a - b).hi;
        let [north, east] = self.curvature;
        let (a, b) = (&from.position, &to.position);
        Vector::new(
            difference(b.latitude, a.latitude) / north,
            difference(b.longitude, a.longitude) * cosine / east,
            difference(a.altitude, b.altitude),
        )
    }
}
