//! Rows of measurements: how each depends on the errors.
//!
//! Every vector is turned into body axes, where the errors are: noise that is the same in all directions stays so.
//! An innovation is what the navigator expects less what is measured.
//!
//! ```
//! use schuler::aiding::measurement;
//! use schuler::math::vector::Vector;
//!
//! // An antenna 1 m above the unit: a tilt about the first axis moves it sideways.
//! let innovation = Vector::new(0.1_f64, 0.0, 0.0);
//! let rows = measurement::position::<f64, 15>(innovation, Vector::new(0.0, 0.0, -1.0), 1.0);
//! assert_eq!(rows.rows[1][6], 1.0);
//! ```

use super::gate::Rows;
use super::model::GYRO_BIAS;
use super::transition::{cross_matrix, matrix_of};
use crate::math::quaternion::Matrix;
use crate::math::real::Real;
use crate::math::vector::Vector;

/// The first velocity error.
const VELOCITY: usize = 3;
/// The first attitude error.
const ATTITUDE: usize = 6;

/// Puts a block into three rows, from a state on.
fn put<R: Real, const N: usize>(rows: &mut [[R; N]; 3], first: usize, block: &Matrix<R>) {
    for (row, block) in rows.iter_mut().zip(block.rows) {
        for (cell, x) in row.iter_mut().skip(first).zip(block.into_array()) {
            *cell = x;
        }
    }
}

/// k·I.
fn diagonal<R: Real>(k: R) -> Matrix<R> {
    matrix_of(|x| x * k)
}

impl<R: Real, const N: usize> Rows<R, N, 3> {
    /// Three rows of one standard deviation, still without blocks.
    pub fn vector(innovation_b: Vector<R>, sigma: R) -> Self {
        Self {
            rows: [[R::ZERO; N]; 3],
            innovation: innovation_b.into_array(),
            variance: [sigma * sigma; 3],
        }
    }

    /// With the columns of a state that has three components.
    pub fn with(mut self, first: usize, block: &Matrix<R>) -> Self {
        put(&mut self.rows, first, block);
        self
    }

    /// With the column of a single state.
    pub fn with_column(mut self, state: usize, column: Vector<R>) -> Self {
        for (row, x) in self.rows.iter_mut().zip(column.into_array()) {
            if let Some(cell) = row.get_mut(state) {
                *cell = x;
            }
        }
        self
    }
}

/// A position at a lever arm from the unit, m: [I 0 −[l×]].
pub fn position<R: Real, const N: usize>(
    innovation_b: Vector<R>,
    lever_b: Vector<R>,
    sigma_m: R,
) -> Rows<R, N, 3> {
    Rows::vector(innovation_b, sigma_m)
        .with(0, &diagonal(R::ONE))
        .with(ATTITUDE, &cross_matrix(-lever_b))
}

/// What a velocity at a lever arm needs of the vehicle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Turning<R> {
    /// ω_ieᵇ, rad/s.
    pub earth_rate_b: Vector<R>,
    /// ω_ibᵇ, rad/s.
    pub rate_ib_b: Vector<R>,
}

/// A velocity relative to the Earth, at a lever arm from the unit, m/s.
pub fn velocity<R: Real, const N: usize>(
    innovation_b: Vector<R>,
    turning: &Turning<R>,
    lever_b: Vector<R>,
    sigma_m_s: R,
) -> Rows<R, N, 3> {
    // δv is of the inertial velocity: that relative to the Earth has δv − ω_ie × δr. At the lever arm
    // δv + b_g×l − (ω_ib×l)×ψ − ω_ie×(δr − l×ψ)
    let Turning { earth_rate_b, rate_ib_b } = *turning;
    let swing = rate_ib_b.cross(lever_b);
    let attitude =
        matrix_of(|psi: Vector<R>| earth_rate_b.cross(lever_b.cross(psi)) - swing.cross(psi));
    Rows::vector(innovation_b, sigma_m_s)
        .with(0, &cross_matrix(-earth_rate_b))
        .with(VELOCITY, &diagonal(R::ONE))
        .with(ATTITUDE, &attitude)
        .with(GYRO_BIAS, &cross_matrix(-lever_b))
}

/// No velocity relative to the Earth, m/s; the innovation is the computed velocity.
pub fn zero_velocity<R: Real, const N: usize>(
    velocity_b: Vector<R>,
    earth_rate_b: Vector<R>,
    sigma_m_s: R,
) -> Rows<R, N, 3> {
    Rows::vector(velocity_b, sigma_m_s)
        .with(0, &cross_matrix(-earth_rate_b))
        .with(VELOCITY, &diagonal(R::ONE))
}

/// A displacement from a point, m; with a resonator's first state, the displacement less that of the resonator.
pub fn displacement<R: Real, const N: usize>(
    displacement_b: Vector<R>,
    resonator: Option<usize>,
    sigma_m: R,
) -> Rows<R, N, 3> {
    let rows = Rows::vector(displacement_b, sigma_m).with(0, &diagonal(R::ONE));
    match resonator {
        Some(first) => rows.with(first, &diagonal(-R::ONE)),
        None => rows,
    }
}

/// A velocity relative to the Earth in body axes, of which a wheel or a hull sets some components: an odometer's
/// speed along the first axis, and none along the others (non-holonomic). `velocity_b` is the computed one.
pub fn along_body<R: Real, const N: usize>(
    innovation_b: Vector<R>,
    velocity_b: Vector<R>,
    earth_rate_b: Vector<R>,
    sigma_m_s: R,
) -> Rows<R, N, 3> {
    Rows::vector(innovation_b, sigma_m_s)
        .with(0, &cross_matrix(-earth_rate_b))
        .with(VELOCITY, &diagonal(R::ONE))
        .with(ATTITUDE, &cross_matrix(velocity_b))
}

/// A height above the ellipsoid, m; `down_b` is the vertical in body axes.
pub fn height<R: Real, const N: usize>(
    innovation: R,
    down_b: Vector<R>,
    lever_b: Vector<R>,
    sigma_m: R,
) -> Rows<R, N, 1> {
    // δh = −d·(δr − l×ψ)
    let mut row = [R::ZERO; N];
    for (cell, x) in row.iter_mut().zip((-down_b).into_array()) {
        *cell = x;
    }
    for (cell, x) in row.iter_mut().skip(ATTITUDE).zip(down_b.cross(lever_b).into_array()) {
        *cell = x;
    }
    Rows { rows: [row], innovation: [innovation], variance: [sigma_m * sigma_m] }
}
