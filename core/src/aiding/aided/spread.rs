//! The covariance of an aided navigator in the coordinates of a drift: position, velocity and attitude in north, east
//! and down, each solution against its own axes.

use super::navigator::Aided;
use super::state::AidedState;
use crate::aiding::surroundings::Pose;
use crate::math::real::{Real, Scalar};
use crate::math::vector::Vector;
use crate::strapdown::block::body::BodyMotion;
use crate::strapdown::mechanization::Mechanization;

impl<R, M, const N: usize, const P: usize, const E: usize, const L: usize, const Q: usize>
    Aided<M, N, P, E, L, Q>
where
    R: Scalar + Real<Mask = bool>,
    M: Mechanization<Real = R, Body = BodyMotion<R>>,
{
    /// Rows that make the drift at the end of the last block from the errors, in the order of [`Self::covariance_ned`].
    pub fn drift_rows(&self, state: &AidedState<M, N, P, E, L, Q>) -> [[R; N]; 9] {
        let solution = self.solution(state);
        let pose = Pose::of(&solution);
        let here = state.reference.locality(&solution.position).here;
        let mut rows = [[R::ZERO; N]; 9];
        for column in 0..9 {
            let unit = |first: usize| {
                let at = |n: usize| if column == first + n { R::ONE } else { R::ZERO };
                pose.body_to_ned * Vector::new(at(0), at(1), at(2))
            };
            // D_r = Cδr,  D_v = Cδv − ω_ie × D_r − δθ × v,  D_ψ = Cψ − δθ, δθ the turn of the axes over D_r
            let way = unit(0);
            let turned = here.turn(way);
            let velocity =
                unit(3) - here.earth_rate_ned.cross(way) - turned.cross(pose.velocity_ned);
            let attitude = unit(6) - turned;
            let parts = [way, velocity, attitude].into_iter().flat_map(Vector::into_array);
            for (row, x) in rows.iter_mut().zip(parts) {
                if let Some(cell) = row.get_mut(column) {
                    *cell = x;
                }
            }
        }
        rows
    }

    /// The covariance of the drift at the end of the last block: position, m, velocity, m/s, attitude, rad, each in
    /// north, east, down.
    pub fn covariance_ned(&self, state: &AidedState<M, N, P, E, L, Q>) -> [[R; 9]; 9] {
        let rows = self.drift_rows(state);
        let filter = self.filter_now(state);
        let ud = filter.covariance();
        rows.map(|a| rows.map(|b| ud.covariance_of(&a, &b)))
    }

    /// Standard deviations in the same order.
    pub fn sigma_ned(&self, state: &AidedState<M, N, P, E, L, Q>) -> [R; 9] {
        let filter = self.filter_now(state);
        self.drift_rows(state).map(|row| filter.covariance().variance_of(&row).sqrt())
    }
}
