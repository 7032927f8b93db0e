//! A mechanization in flight: samples are narrowed, states digested, rows widened.

use super::{Navigate, Reader};
use crate::flight::{Edges, Used};
use crate::lanes::abreast::Refused;
use schuler::flight::carried::Carried;
use schuler::flight::from_double::FromDouble;
use schuler::math::compensated::Pair;
use schuler::math::real::Scalar;
use schuler::output::Output;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::solution::Solution;
use schuler::strapdown::block::newton;
use schuler::strapdown::correction::{Correction, CorrectionError};
use schuler::strapdown::limits::{Rejected, StartError};
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::mechanization::UnequalIntervals;

/// One of the core's mechanizations with its state.
pub(super) struct Flying<M: Mechanization> {
    flown: FromDouble<M>,
    /// The nominal interval, s.
    interval_s: Pair<M::Real>,
    initial: Solution<M::Real>,
}

impl<M> Flying<M>
where
    M: UnequalIntervals<Real: Scalar + Send, Frame: Record, State: Send> + Send + 'static,
{
    pub(super) fn boxed(
        mechanization: M,
        interval_s: Pair<M::Real>,
        initial: &Solution<f64>,
    ) -> Result<Box<dyn Navigate>, StartError> {
        let flown = FromDouble::new(mechanization, initial)?;
        Ok(Box::new(Self { flown, interval_s, initial: Solution::narrow(initial) }))
    }
}

/// Samples with a carried rest.
fn narrow<R: Scalar>(samples: &[Increment<f64>], carried: &mut Carried) -> Vec<Increment<R>> {
    samples.iter().map(|sample| carried.narrow(sample)).collect()
}

/// Hands rows on in double precision. One type for all uses: each is a copy of the navigator.
fn wide<R: Scalar, O: Output<R>>(read: &mut Reader) -> impl FnMut(u64, O) {
    move |n, row: O| read(n, &row.wide())
}

/// Takes a sample, and reads the rows that it completes: once for each mechanization, whoever flies it.
#[inline(never)]
pub fn push<M: Mechanization<Real: Scalar>>(
    mechanization: &M,
    state: &mut M::State,
    sample: Increment<M::Real>,
    read: &mut Reader,
) -> Result<(), Rejected> {
    mechanization.push_rows(state, sample, wide(read))
}

/// Takes a sample of its own interval, and reads the rows that it completes.
#[inline(never)]
fn push_over<M: UnequalIntervals<Real: Scalar>>(
    mechanization: &M,
    state: &mut M::State,
    sample: Increment<M::Real>,
    interval_s: Pair<M::Real>,
    read: &mut Reader,
) -> Result<(), Rejected> {
    mechanization.push_rows_over(state, sample, interval_s, wide(read))
}

/// Completes the rows that wait for samples, and reads them.
#[inline(never)]
pub fn finish<M: Mechanization<Real: Scalar>>(
    mechanization: &M,
    state: &mut M::State,
    read: &mut Reader,
) {
    mechanization.finish_rows(state, wide(read));
}

/// Takes samples without reading a row; stops before one that is refused.
#[inline(never)]
fn fly<M: Mechanization>(
    mechanization: &M,
    state: &mut M::State,
    samples: &[Increment<M::Real>],
) -> Result<(), Refused> {
    for (taken, &sample) in samples.iter().enumerate() {
        let pushed = mechanization.push(state, sample);
        pushed.map_err(|reason| Refused { taken, reason })?;
    }
    Ok(())
}

impl<M> Navigate for Flying<M>
where
    M: UnequalIntervals<Real: Scalar + Send, Frame: Record, State: Send> + Send + 'static,
{
    fn push(&mut self, sample: &Increment<f64>, read: &mut Reader) -> Result<(), Rejected> {
        self.flown.push_by(sample, &mut |m, state, sample| push(m, state, sample, read))
    }

    fn push_over(
        &mut self,
        sample: &Increment<f64>,
        interval_s: f64,
        read: &mut Reader,
    ) -> Result<(), Rejected> {
        let nominal = self.interval_s;
        if interval_s == nominal.widen() || Pair::narrow(Pair::new(interval_s)) == nominal {
            return self.push(sample, read);
        }
        self.flown.push_over_by(sample, interval_s, &mut |m, state, sample, interval_s| {
            push_over(m, state, sample, interval_s, read)
        })
    }

    fn fly(&mut self, samples: &[Increment<f64>]) -> Result<(), Refused> {
        let (mechanization, state, carried) = self.flown.parts_mut();
        fly(mechanization, state, &narrow(samples, carried))
    }

    fn solution(&self) -> Solution<f64> {
        self.flown.solution()
    }

    fn finish(&mut self, read: &mut Reader) {
        self.flown.flight.finish_by(|m, state| finish(m, state, read));
    }

    fn hold_vertical(&mut self, altitude_m: f64, down_m_s: f64) -> Result<(), Rejected> {
        self.flown.hold_vertical(altitude_m, down_m_s)
    }

    fn correct(&mut self, correction: &Correction<f64>) -> Result<(), CorrectionError> {
        let Correction { position_ned, velocity_ned, attitude_ned } = correction;
        let narrowed = Correction {
            position_ned: position_ned.map(Scalar::narrow),
            velocity_ned: velocity_ned.map(Scalar::narrow),
            attitude_ned: attitude_ned.map(Scalar::narrow),
        };
        let (mechanization, state, _) = self.flown.parts_mut();
        mechanization.correct(state, &narrowed)
    }

    fn integrated(&self) -> u64 {
        self.flown.flight.integrated()
    }

    fn edges(&self) -> Option<Edges> {
        let used = |used: newton::Used<M::Real>| {
            let [gyro, accelerometer] = [used.gyro, used.accelerometer].map(|n| n.widen() as u32);
            (gyro > 0).then_some(Used { gyro, accelerometer })
        };
        let edges = M::edges(self.flown.flight.state())?;
        Some(Edges { first: used(edges.first), last: used(edges.last) })
    }

    fn digest(&self) -> u64 {
        self.flown.flight.digest()
    }

    fn fly_unread(
        &self,
        before: &[Increment<f64>],
        samples: &[Increment<f64>],
    ) -> Box<dyn FnMut() + '_> {
        let mut carried = Carried::default();
        let (before, samples) = (narrow(before, &mut carried), narrow(samples, &mut carried));
        // What cannot be right was refused in the run itself.
        let mechanization = self.flown.flight.mechanization();
        let start = mechanization.start(&self.initial).map(|mut state| {
            let _ = fly(mechanization, &mut state, &before);
            state
        });
        Box::new(move || {
            if let Ok(mut state) = start {
                let _ = fly(mechanization, &mut state, &samples);
                std::hint::black_box(&state);
            }
        })
    }
}
