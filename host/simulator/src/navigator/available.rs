//! Which algorithms, precisions, frames and windows go together.

use crate::input::Complaint;
use crate::scene::{Algorithm, Navigator, Precision, WindowShape};
use schuler::aiding::alignment::verdict::AlignmentFault;
use schuler::flight::catalogue::{Catalogue as _, Every};
use schuler::flight::configuration::Configuration;
use schuler::strapdown::block::window::{H0B4A0, Window as _};
use schuler::strapdown::limits::StartError;
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
        accepted: Vec<WindowShape>,
    },
    /// A window for textbook.
    NoWindow,
    /// Two-float products where there are none.
    TwoFloat,
    /// The core refuses to start.
    Start(StartError),
    /// The alignment of a run does not start, or does not end.
    Alignment {
        /// The run.
        run: u64,
        /// The sample that it did not take, from 1; 0 if it does not start.
        sample: u64,
        /// Why not.
        why: AlignmentFault,
    },
    /// There is no such alignment of the scene.
    NoAlignment(Complaint),
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
            Self::Alignment { .. } | Self::NoAlignment(_) => "alignment",
        }
    }

    /// What is wrong, and what would be accepted.
    pub fn complaint(&self) -> Complaint {
        match self {
            Self::Window { shape, of, accepted } => {
                let shapes = accepted.iter().map(|shape| format!("; {shape}"));
                let what = format!("{of} has no window {shape}");
                Complaint::new(what, format!("auto{}", shapes.collect::<String>()))
            }
            Self::NoWindow => Complaint::new("textbook has no window", "auto, or taylor"),
            Self::TwoFloat => {
                let accepted = "f32x2 with taylor, else f64, f32";
                Complaint::new("f32x2 is not to be had here", accepted)
            }
            Self::Start(error) => Complaint::new(error.to_string(), ""),
            Self::Alignment { run, sample, why } => {
                let at = if *sample > 0 { format!(", sample {sample}") } else { String::new() };
                Complaint::new(format!("run {run}{at}: {why}"), "")
            }
            Self::NoAlignment(complaint) => complaint.clone(),
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

/// The windows that an algorithm has in some axes and precision.
pub fn windows(asked: &Configuration) -> Vec<WindowShape> {
    let mut windows = Vec::new();
    Every::each(&mut |one| {
        if one == (Configuration { window: one.window, ..*asked }) {
            windows.extend(one.window());
        }
    });
    windows
}

/// Why there is no such navigator.
pub fn unknown(asked: &Configuration) -> Unavailable {
    let accepted = windows(asked);
    let of = if asked.precision == Precision::F32x2 { "f32x2" } else { "taylor" };
    match asked.window() {
        Some(shape) if !accepted.is_empty() => Unavailable::Window { shape, of, accepted },
        _ => Unavailable::TwoFloat,
    }
}

/// Whether there is a navigator of this algorithm, precision, frame and window.
pub fn check(navigator: &Navigator) -> Result<(), Unavailable> {
    // The plan chooses among windows that are there.
    let any = || windows(&navigator.configuration(H0B4A0::SHAPE)).first().copied();
    let window = navigator.window.or_else(any).unwrap_or(H0B4A0::SHAPE);
    let asked = navigator.configuration(window);
    match navigator.algorithm {
        _ if !Every::has(&asked) => Err(unknown(&asked)),
        Algorithm::Textbook if navigator.window.is_some() => Err(Unavailable::NoWindow),
        _ => Ok(()),
    }
}

/// The order that a named window's series has at most.
pub fn terms(shape: WindowShape) -> Option<usize> {
    use schuler::strapdown::block::window::*;
    macro_rules! find {
        ($($window:ident),+) => {
            [$(($window::SHAPE, $window::TERMS)),+]
        };
    }
    let terms: &[(WindowShape, usize)] = &schuler::every_window! { find! };
    terms.iter().find(|(other, _)| *other == shape).map(|&(_, terms)| terms)
}
