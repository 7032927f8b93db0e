//! The place on the ellipsoid and in space as power series of time.
//!
//! ```
//! use schuler::math::vector::Vector;
//! use schuler::trajectory::piecewise::place::Place;
//! use schuler::trajectory::series::Series;
//!
//! // Northwards across the equator, 1 µrad/s.
//! let m = Vector::new(Series::<3>([1.0, 0.0, 0.0]), Series::ZERO, Series([0.0, 1e-6, 0.0]));
//! let place = Place::new(m, Series::constant(0.0));
//! // The meridian radius at the equator is a(1 − e²).
//! assert!((place.position.z.0[1] - 6.335439).abs() < 1e-6);
//! ```

use crate::earth::{
    CENTRIFUGAL_RATIO, ECCENTRICITY_SQUARED, EQUATORIAL_GRAVITY, FLATTENING, SEMI_MAJOR_AXIS,
    SOMIGLIANA,
};
use crate::math::vector::Vector;
use crate::trajectory::series::Series;

/// Normal and position about an instant, in Earth-fixed axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place<const N: usize> {
    /// n̂ = m/|m|.
    pub normal: Vector<Series<N>>,
    /// h, m.
    pub altitude: Series<N>,
    /// r, m.
    pub position: Vector<Series<N>>,
    /// 1/W, W² = 1 − e²σ², σ = n̂_z.
    inverse_w: Series<N>,
}

impl<const N: usize> Place<N> {
    /// From a normal of any length and a height.
    #[inline(always)]
    pub fn new(m: Vector<Series<N>>, altitude: Series<N>) -> Self {
        let length = m.dot(m).reciprocal_root();
        let normal = m * length;
        // r = (N + h)n̂ − e²Nσẑ,  N = a/W
        let sine = normal.z;
        let inverse_w = (sine * sine).scaled(-ECCENTRICITY_SQUARED).plus(1.0).reciprocal_root();
        let prime_vertical = inverse_w.scaled(SEMI_MAJOR_AXIS);
        let radius = prime_vertical + altitude;
        let mut position = normal * radius;
        position.z = position.z - (prime_vertical * sine).scaled(ECCENTRICITY_SQUARED);
        Self { normal, altitude, position, inverse_w }
    }

    /// Normal gravity γ, m/s², its first `M` coefficients.
    #[inline(always)]
    pub fn gravity<const M: usize>(&self) -> Series<M> {
        // γ = γ_e(1 + k σ²)/W · [1 − (2/a)(1 + f + m − 2f σ²)h + 3h²/a²]
        const A: f64 = SEMI_MAJOR_AXIS;
        let sine = self.normal.z.first::<M>();
        let (square, altitude) = (sine * sine, self.altitude.first::<M>());
        let surface = square.scaled(SOMIGLIANA).plus(1.0) * self.inverse_w.first();
        let slope = square
            .scaled(4.0 * FLATTENING / A)
            .plus(-2.0 / A * (1.0 + FLATTENING + CENTRIFUGAL_RATIO))
            + altitude.scaled(3.0 / (A * A));
        surface.scaled(EQUATORIAL_GRAVITY) * (slope * altitude).plus(1.0)
    }
}
