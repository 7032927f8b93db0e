//! The methods that need no filter: the means of gyros and accelerometers, and velocities in two inertial frames.

use super::setup::Setup;
use crate::source::Source;
use schuler::alignment::inertial::Inertial;
use schuler::alignment::place::Place;
use schuler::alignment::{Alignment, AlignmentError};
use schuler::drift::compare::drift;
use schuler::math::vector::Vector;
use schuler::solution::{Euler, Solution};

/// A method without a filter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coarse {
    /// The means of gyros and accelerometers.
    TwoVector,
    /// Velocities in two inertial frames.
    Inertial,
}

/// What a run's attitude at the end is off by: the rotation vector in north, east, down, rad; with the attitude.
pub fn of_run(
    setup: &Setup<'_>,
    source: &Source,
    run: u64,
    method: Coarse,
) -> Result<([f64; 3], Euler<f64>), AlignmentError> {
    let interval_s = 1.0 / source.rate_hz();
    let place = source.initial(0).position.map(|coordinate| coordinate.hi);
    let (mut means, mut inertial) = (Alignment::default(), Inertial::new(&Place::new(place)));
    let mut stream = source.start(run);
    for _ in 0..setup.samples {
        let Some(sample) = stream.advance() else { continue };
        match method {
            Coarse::TwoVector => means.add(&sample),
            Coarse::Inertial => inertial.add(&sample, interval_s),
        }
    }
    let attitude = match method {
        Coarse::TwoVector => means.attitude()?,
        Coarse::Inertial => inertial.attitude()?,
    };
    let computed = Solution::new(place, Vector::ZERO, attitude);
    let error = drift(&computed, &source.truth(setup.samples)).attitude_ned;
    Ok((error.into_array(), attitude))
}
