//! The twin that a beginning asks for.

use super::Beginning;
use super::aided::Aboard;
use super::side::Side;
use schuler::flight::configuration::{Axes, Precision};
use schuler::link::fleet::{Every, Fleet};
use schuler::link::identification::Identification;
use schuler::link::offer::Purpose;
use schuler::link::refusal::Refusal;
use schuler::navigators::{EarthFixedNavigator4, Navigator4};

/// The side that a beginning asks for.
pub(super) fn start(beginning: &Beginning) -> Result<Box<dyn Side>, Refusal> {
    let (start, rate_hz) = (beginning.start(), beginning.rate_hz());
    let (precision, axes) = (beginning.configuration.precision, beginning.configuration.axes);
    match (start.offer.purpose, precision, axes) {
        (Purpose::Navigation, ..) => Ok(Box::new(Every::start(&start)?)),
        (Purpose::Aiding, Precision::F64, Axes::LocalLevel) => {
            Ok(Box::new(Aboard::<Navigator4<f64>>::start(&start, rate_hz)?))
        }
        (Purpose::Aiding, Precision::F64, Axes::EarthFixed) => {
            Ok(Box::new(Aboard::<EarthFixedNavigator4<f64>>::start(&start, rate_hz)?))
        }
        (Purpose::Aiding, _, Axes::LocalLevel) => {
            Ok(Box::new(Aboard::<Navigator4<f32>>::start(&start, rate_hz)?))
        }
        (Purpose::Aiding, _, Axes::EarthFixed) => {
            Ok(Box::new(Aboard::<EarthFixedNavigator4<f32>>::start(&start, rate_hz)?))
        }
        (Purpose::Identification, Precision::F64, _) => {
            Ok(Box::new(Identification::<f64>::start(&start)?))
        }
        (Purpose::Identification, ..) => Ok(Box::new(Identification::<f32>::start(&start)?)),
    }
}
