//! What can go wrong in a flight before anything is compared.

use schuler::aiding::aided::fault::AidedFault;
use schuler::sensor::parameter::ParameterError;
use schuler::strapdown::limits::{Rejected, StartError};
use schuler::trajectory::harmonic::CourseError;

/// What can go wrong.
#[derive(defmt::Format)]
pub enum Fault {
    /// The motion has more harmonics than there is room for.
    Motion(CourseError),
    /// A sensor parameter is out of range.
    Sensors(ParameterError),
    /// The navigator does not start.
    Start(StartError),
    /// It refuses a sample.
    Rejected(Rejected),
    /// The aided navigator refuses its settings, a sample or a measurement.
    Aided(AidedFault),
    /// There is no counter of instructions or cycles.
    Counter,
}

macro_rules! fault_from {
    ($($error:ty => $fault:ident),+) => {
        $(impl From<$error> for Fault {
            fn from(error: $error) -> Self {
                Self::$fault(error)
            }
        })+
    };
}
fault_from!(
    CourseError => Motion,
    ParameterError => Sensors,
    StartError => Start,
    Rejected => Rejected,
    AidedFault => Aided
);
