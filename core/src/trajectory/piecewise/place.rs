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
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Place<const N: usize> {
    /// h, m.
    pub altitude: Series<N>,
    /// r, m.
    pub position: Vector<Series<N>>,
    m: Vector<Series<N>>,
    /// k = 1/|m|.
    inverse_length: Series<N>,
    /// k/W, W² = 1 − e²σ², σ = n̂_z.
    per_w: Series<N>,
}

impl<const N: usize> Place<N> {
    /// From a normal of any length and a height.
    #[inline(always)]
    pub fn new(m: Vector<Series<N>>, altitude: Series<N>) -> Self {
        // r = (N + h)n̂ − e²Nσẑ,  N = a/W,  n̂ = m k:  with q = k/W = (|m|² − e²m_z²)^(−½)
        // r = (a q + h k)m − e² a q m_z ẑ
        let polar = m.z * m.z;
        let square = m.x * m.x + m.y * m.y + polar;
        let inverse_length = square.reciprocal_root();
        let per_w = (square - polar.scaled(ECCENTRICITY_SQUARED)).reciprocal_root();
        let radius = per_w.scaled(SEMI_MAJOR_AXIS);
        let mut position = m * (radius + altitude * inverse_length);
        position.z = position.z - (radius * m.z).scaled(ECCENTRICITY_SQUARED);
        Self { altitude, position, m, inverse_length, per_w }
    }

    /// n̂ = m/|m|, its first `M` coefficients.
    #[inline(always)]
    pub fn normal<const M: usize>(&self) -> Vector<Series<M>> {
        self.m.map(|m| m.first::<M>()) * self.inverse_length.first::<M>()
    }

    /// Normal gravity γ, m/s², its first `M` coefficients.
    #[inline(always)]
    pub fn gravity<const M: usize>(&self) -> Series<M> {
        // γ = γ_e(1 + k σ²)/W · [1 − (2/a)(1 + f + m − 2f σ²)h + 3h²/a²]
        const A: f64 = SEMI_MAJOR_AXIS;
        let (sine, altitude) = (self.normal::<M>().z, self.altitude.first::<M>());
        let square = sine * sine;
        // 1/W = q|m|² k
        let m = self.m.map(|m| m.first::<M>());
        let inverse_w = self.per_w.first::<M>() * (m.dot(m) * self.inverse_length.first());
        let surface = square.scaled(SOMIGLIANA).plus(1.0) * inverse_w;
        let slope = square
            .scaled(4.0 * FLATTENING / A)
            .plus(-2.0 / A * (1.0 + FLATTENING + CENTRIFUGAL_RATIO))
            + altitude.scaled(3.0 / (A * A));
        surface.scaled(EQUATORIAL_GRAVITY) * (slope * altitude).plus(1.0)
    }
}
