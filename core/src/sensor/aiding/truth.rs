//! The true motion that aiding sensors measure.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::sensor::aiding::truth::Truth;
//! use schuler::solution::{Euler, Solution};
//!
//! // Turning to the right with 0.1 rad/s on the equator, an antenna 2 m ahead goes east.
//! let solution = Solution::new(Default::default(), Vector::ZERO, Euler::default());
//! let truth = Truth::of(&solution, Vector::new(7.292115e-5_f64, 0.0, 0.1));
//! assert!((truth.velocity_at(Vector::new(2.0, 0.0, 0.0)).y - 0.2).abs() < 1e-12);
//! ```

use crate::earth::{self, Geodetic, Radii};
use crate::math::compensated::Pair;
use crate::math::quaternion::Matrix;
use crate::math::real::Scalar;
use crate::math::vector::Vector;
use crate::solution::Solution;

/// The vehicle at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Truth<R> {
    /// The inertial unit's position.
    pub position: Geodetic<Pair<R>>,
    /// Its velocity relative to the Earth, north, east, down, m/s.
    pub velocity_ned: Vector<R>,
    /// C_bⁿ.
    pub body_to_ned: Matrix<R>,
    /// ω_ebᵇ, rad/s.
    pub rate_eb_b: Vector<R>,
}

impl<R: Scalar> Truth<R> {
    /// From the true solution and ω_ibᵇ, rad/s.
    pub fn of(solution: &Solution<R>, rate_ib_b: Vector<R>) -> Self {
        let body_to_ned = solution.attitude.map(|c| c.hi).matrix(R::ONE);
        let (sine, cosine) = solution.position.latitude.hi.sin_cos();
        let earth_rate_b = body_to_ned.transpose() * earth::rotation_ned(sine, cosine);
        Self {
            position: solution.position,
            velocity_ned: solution.velocity_ned.map(|c| c.hi),
            body_to_ned,
            rate_eb_b: rate_ib_b - earth_rate_b,
        }
    }

    /// The velocity of a point at a lever arm in body axes, north, east, down, m/s.
    pub fn velocity_at(&self, lever_b: Vector<R>) -> Vector<R> {
        self.velocity_ned + self.body_to_ned * self.rate_eb_b.cross(lever_b)
    }

    /// The same in body axes.
    pub fn velocity_b_at(&self, lever_b: Vector<R>) -> Vector<R> {
        self.body_to_ned.transpose() * self.velocity_at(lever_b)
    }

    /// The position so far away, north, east, down, m: horizontal components of the chord, and the height lost.
    pub fn position_at(&self, way_ned: Vector<R>) -> Geodetic<Pair<R>> {
        let Geodetic { latitude, longitude, altitude } = self.position;
        let (sine, cosine) = latitude.hi.sin_cos();
        let radii = Radii::at(sine, cosine);
        let [meridian, prime_vertical] =
            [radii.meridian, radii.prime_vertical].map(|radius| radius + altitude.hi);
        // Δλ = D_E/R_N(cosφ − sinφ Δφ),  Δφ = (D_N − ½R_N sinφ cosφ Δλ²)/R_M
        let along = way_ned.y / (prime_vertical * cosine);
        let bent = prime_vertical * sine * cosine * along * along * R::HALF;
        let north = (way_ned.x - bent) / meridian;
        let along = way_ned.y / (prime_vertical * (cosine - sine * north));
        Geodetic {
            latitude: latitude + Pair::new(north),
            longitude: longitude + Pair::new(along),
            altitude: altitude + Pair::new(-way_ned.z),
        }
    }
}
