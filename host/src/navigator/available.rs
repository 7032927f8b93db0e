//! Which algorithms, precisions, frames and windows go together.

use super::{TAYLOR, TWO_FLOAT};
use crate::input::Complaint;
use crate::scene::{Algorithm, Navigator, Precision, WindowShape};
use schuler::strapdown::block::window::*;
use schuler::strapdown::limits::StartError;
use schuler::strapdown::plan::Shape;
use std::fmt;

/// What a scene or an option asked for, and is not to be had.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unavailable {
    /// No window of this shape.
    Window {
        /// The shape.
        shape: WindowShape,
        /// What has no such window.
        of: &'static str,
        /// Those that it has.
        accepted: &'static [Shape],
    },
    /// A window for textbook.
    NoWindow,
    /// Two-float products where there are none.
    TwoFloat,
    /// The core refuses to start.
    Start(StartError),
}

impl Unavailable {
    /// The key of a scene to blame.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Window { .. } | Self::NoWindow => "navigator.window",
            Self::TwoFloat => "navigator.precision",
            Self::Start(StartError::Pole) => "trajectory.latitude_deg",
            Self::Start(StartError::Position | StartError::Velocity) => "trajectory",
            Self::Start(_) => "navigator",
        }
    }

    /// What is wrong, and what would be accepted.
    pub fn complaint(&self) -> Complaint {
        match self {
            Self::Window { shape: WindowShape { history, block, lookahead }, of, accepted } => {
                let shapes = accepted.iter().map(|(h, b, a)| format!("; {h},{b},{a}"));
                let what = format!("{of} has no window {history},{block},{lookahead}");
                Complaint::new(what, format!("auto{}", shapes.collect::<String>()))
            }
            Self::NoWindow => Complaint::new("textbook has no window", "auto, or taylor"),
            Self::TwoFloat => {
                let accepted = "f32x2 with taylor, else f64, f32";
                Complaint::new("f32x2 is not to be had here", accepted)
            }
            Self::Start(error) => Complaint::new(error.to_string(), ""),
        }
    }
}

impl fmt::Display for Unavailable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.complaint().fmt(f)
    }
}

impl std::error::Error for Unavailable {}

impl From<StartError> for Unavailable {
    fn from(error: StartError) -> Self {
        Self::Start(error)
    }
}

/// Whether there is a navigator of this algorithm, precision, frame and window.
pub fn check(navigator: &Navigator) -> Result<(), Unavailable> {
    let Navigator { algorithm, precision, window, .. } = *navigator;
    let (of, accepted) = match (algorithm, precision) {
        (Algorithm::Taylor, Precision::F32x2) => ("f32x2", TWO_FLOAT),
        (Algorithm::Textbook, Precision::F32x2) => return Err(Unavailable::TwoFloat),
        (Algorithm::Textbook, ..) if window.is_some() => return Err(Unavailable::NoWindow),
        _ => ("taylor", TAYLOR),
    };
    match window {
        Some(shape) if !accepted.iter().any(|&other| shape == other.into()) => {
            Err(Unavailable::Window { shape, of, accepted })
        }
        _ => Ok(()),
    }
}

/// The order that a named window's series has at most.
pub fn terms(shape: WindowShape) -> Option<usize> {
    macro_rules! find {
        ($($window:ident),+) => {
            [$(($window::SHAPE, $window::TERMS)),+]
        };
    }
    let terms: &[(Shape, usize)] = &schuler::every_window! { find! };
    terms.iter().find(|(other, _)| shape == (*other).into()).map(|&(_, terms)| terms)
}
