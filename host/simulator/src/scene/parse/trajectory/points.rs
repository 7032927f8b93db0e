//! Places in degrees: whether they are degrees, and which is which.

use crate::input::Complaint;
use crate::input::document::Section;
use crate::input::{InputError, key::Key};
use schuler::earth::Geodetic;
use std::f64::consts::{FRAC_PI_2, PI};

/// What numbers that look like radians are told, in degrees; `None` if they do not, or do not move.
pub fn radians(places: &[Geodetic<f64>], degree: f64) -> Option<Complaint> {
    let small = |at: &Geodetic<f64>| {
        at.latitude.abs() <= FRAC_PI_2 * degree && at.longitude.abs() <= PI * degree
    };
    let first = places.first()?;
    let moves =
        places.iter().any(|at| (at.latitude, at.longitude) != (first.latitude, first.longitude));
    (moves && places.iter().all(small)).then(|| {
        Complaint::new(
            "has all latitudes within ±π/2 and all longitudes within ±π: are they radians?",
            "degrees; near_origin = true if they are",
        )
    })
}

/// Whether a table says that its points do lie there.
pub fn near_origin(section: &Section<'_>, key: &Key) -> Result<bool, InputError> {
    section.get(key.name).map_or(Ok(false), |value| value.truth(key.accepted()))
}

/// A latitude beyond 90° is told what it may be.
pub fn swapped(mut error: InputError) -> InputError {
    let latitude = error.key.as_deref().is_some_and(|key| key.ends_with("latitude_deg"));
    if latitude && error.complaint.what.ends_with("out of range") {
        error.complaint.what += ": is it the longitude?";
    }
    error
}
