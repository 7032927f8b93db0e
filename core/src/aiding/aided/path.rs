//! From the time of a measurement to the present: its rows go through steps and corrections, and are judged there.

use super::moment::rest;
use super::ring::{Entry, Ring};
use crate::aiding::filter::{Fading, Filter};
use crate::aiding::gate::{Judged, Rows};
use crate::aiding::model::GYRO_BIAS;
use crate::aiding::transition::Transition;
use crate::aiding::transport::past_correction;
use crate::math::real::{Real, Scalar};

/// The steps since a time.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Path<'a, R, const N: usize, const E: usize, const L: usize> {
    /// Those that are remembered.
    pub ring: &'a Ring<R, N, E, L>,
    /// One that is not among them yet.
    pub ahead: Option<&'a Entry<R, N, E>>,
    /// The end of the last step before it.
    pub start: u64,
    /// How much of the next step has passed by then.
    pub fraction: R,
}

impl<R: Scalar, const N: usize, const E: usize, const L: usize> Path<'_, R, N, E, L> {
    /// Takes rows and innovations to the present.
    fn carry<const K: usize>(&self, rows: &mut Rows<R, N, K>) {
        let mut fraction = self.fraction;
        let since = self.ring.forward().chain(self.ahead).filter(|e| e.samples > self.start);
        for entry in since {
            let part = core::mem::replace(&mut fraction, R::ZERO);
            let stretch = if part > R::ZERO { rest(&entry.stretch, part) } else { entry.stretch };
            let transition = Transition::new(&stretch);
            let Fading { biases: [gyro, force], extras } = entry.fading;
            let factors = [gyro, gyro, gyro, force, force, force].into_iter().chain(extras);
            for (row, innovation) in rows.rows.iter_mut().zip(&mut rows.innovation) {
                transition.carry(row);
                for (cell, factor) in row.iter_mut().skip(GYRO_BIAS).zip(factors.clone()) {
                    *cell = *cell / factor;
                }
                *innovation = past_correction(row, *innovation, &entry.errors);
            }
        }
    }
}

/// Takes rows to the present and judges them.
pub fn judge<R, const N: usize, const P: usize, const E: usize, const L: usize, const K: usize>(
    filter: &mut Filter<R, N, P, E>,
    path: &Path<'_, R, N, E, L>,
    rows: Rows<R, N, K>,
    limit: R,
) -> Judged<R, N>
where
    R: Scalar + Real<Mask = bool>,
{
    let mut rows = rows;
    path.carry(&mut rows);
    filter.measure(&rows, limit)
}
