//! Splines of degree 7 with six continuous derivatives (C⁶), over any increasing sites.
//!
//! With n + 1 sites t₀ < … < t_n as simple knots, a spline has n + 7 control points. Either it passes through a value at each site, or it smooths many samples. The control
//! points, rounded to double precision, are the path by definition; what leaves is one polynomial per span.
//!
//! Six continuous derivatives, because the navigators' windows reach over joints: at 20 Hz way-points of 250 m/s
//! joined by a cubic (C²) cost 1.2 m, by degree 5 (C⁴) 1.6e-7 m, by degree 7 the rounding of positions.
//! Source: de Boor, *A Practical Guide to Splines*, rev. ed. (2001), ch. IX to XIV.
//!
//! ```
//! use schuler::trajectory::spline::{BAND, EXTRA, Ends, basis::Knots};
//! use schuler::trajectory::spline::{interpolate::interpolate, local::coefficients};
//!
//! // A parabola through four sites: four are enough for natural ends to reproduce it.
//! let sites = [0.0, 1.0, 3.0, 4.0];
//! let mut band = [[0.0; BAND]; 4 + EXTRA];
//! let mut control = [[0.0]; 4 + EXTRA];
//! interpolate(&sites, sites.iter().map(|t| [t * t]), Ends::Natural, &mut band, &mut control)?;
//! let piece = coefficients(Knots::eightfold(&sites), 1, 2.0, &control).unwrap();
//! // t² about t = 2: 4 + 4u + u².
//! for (got, expected) in piece.iter().zip([4.0, 4.0, 1.0, 0.0]) {
//!     assert!((got[0].hi - expected).abs() < 1e-12);
//! }
//! # Ok::<(), schuler::trajectory::spline::SplineError>(())
//! ```
//!
//! | file | what it has |
//! |---|---|
//! | [`basis`] | knots, and the basis in a span |
//! | [`local`] | a span as a polynomial about its middle |
//! | [`band`] | elimination in a band, with exchange of rows |
//! | [`interpolate`] | the spline through a value at each site |
//! | [`penalty`] | the size of the third derivative, as a quadratic form |
//! | [`normal`] | least squares with that penalty, by Cholesky's factors |
//! | [`smooth`] | the smoothest spline that leaves a given residual |
//! | [`path`] | splines of normal, height and attitude as pieces |
//! | [`place`] | places as normal and height, and how fast a piece moves |

pub mod band;
pub mod basis;
pub mod interpolate;
pub mod local;
pub mod normal;
pub mod path;
pub mod penalty;
pub mod place;
pub mod smooth;

/// Degree of every spline.
pub const DEGREE: usize = 7;
/// Number of coefficients of a span.
pub const TERMS: usize = DEGREE + 1;
/// A spline has this many more control points than sites.
pub const EXTRA: usize = DEGREE - 1;
/// Length of a row of a banded matrix.
pub const BAND: usize = 8;

/// What a spline does at its two ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Ends {
    /// The derivatives of order 4 to 6 are 0: the smoothest spline through the sites. With 2 or 3 sites it is
    /// the line or the parabola.
    #[default]
    Natural,
    /// The derivatives of order 1 to 3 are 0: it starts and ends at rest.
    AtRest,
}

/// Why there is no spline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SplineError {
    /// Fewer than two sites.
    TooFew,
    /// A slice is shorter than needed.
    NoRoom {
        /// The length that is enough.
        needed: usize,
    },
    /// There is not one value for each site.
    Count {
        /// The number of sites, or of samples.
        needed: usize,
    },
    /// A site is not later than the one before.
    NotIncreasing {
        /// Its index.
        index: usize,
    },
    /// A number is not finite.
    NotFinite {
        /// The index of its site or sample.
        index: usize,
    },
    /// A sample lies outside the sites.
    Outside {
        /// Its index.
        index: usize,
    },
    /// The samples do not determine the spline: at least three different ones are needed.
    Undetermined,
    /// The sites lie too far apart for the spline to follow the samples to within the noise.
    TooStiff,
}

impl core::fmt::Display for SplineError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::TooFew => write!(f, "a spline needs at least 2 sites"),
            Self::NoRoom { needed } => write!(f, "there is no room for {needed} entries"),
            Self::Count { needed } => write!(f, "there must be {needed} values"),
            Self::NotIncreasing { index } => {
                write!(f, "the time at index {index} is not later than the one before")
            }
            Self::NotFinite { index } => write!(f, "a number at index {index} is not finite"),
            Self::Outside { index } => {
                write!(f, "the sample at index {index} lies outside the sites")
            }
            Self::Undetermined => write!(f, "at least 3 samples are needed for smoothing"),
            Self::TooStiff => write!(
                f,
                "the path does not come as near to its samples as the noise says: the noise is larger than \
                 stated, or the sites lie too far apart"
            ),
        }
    }
}

impl core::error::Error for SplineError {}

/// Checks that sites are finite, increase, and are at least two.
///
/// # Errors
///
/// [`SplineError`] with the index of the first that is not.
pub fn check_sites(sites: &[f64]) -> Result<(), SplineError> {
    if sites.len() < 2 {
        return Err(SplineError::TooFew);
    }
    let mut last = f64::NEG_INFINITY;
    for (index, &site) in sites.iter().enumerate() {
        if !site.is_finite() {
            return Err(SplineError::NotFinite { index });
        }
        if site <= last {
            return Err(SplineError::NotIncreasing { index });
        }
        last = site;
    }
    Ok(())
}
