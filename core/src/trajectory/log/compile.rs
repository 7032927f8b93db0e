//! From the rows of a log to splines.

use super::{LogError, Part};
use crate::earth::Radii;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::trajectory::spline::basis::Knots;
use crate::trajectory::spline::interpolate::interpolate;
use crate::trajectory::spline::path::{Path, Spline};
use crate::trajectory::spline::place::LARGEST_SPEED;
use crate::trajectory::spline::smooth::{Fit, Smoothing, Workspace, smooth};
use crate::trajectory::spline::{Ends, SplineError};
use core::ops::Range;

/// Standard deviation of each component of a log's noise; 0 if the path shall pass through every row.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Noise {
    /// North and east, m.
    pub horizontal_m: f64,
    /// Height, m.
    pub vertical_m: f64,
    /// About each axis, rad.
    pub attitude: f64,
}

impl Noise {
    /// The path passes through every row.
    pub const NONE: Self = Self { horizontal_m: 0.0, vertical_m: 0.0, attitude: 0.0 };
}

/// The rows of a log.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Log<'a> {
    /// Times, s.
    pub times_s: &'a [f64],
    /// n̂ and h, as [`rows::positions`](super::rows::positions) gives them.
    pub positions: &'a [[f64; 4]],
    /// Quaternions body → Earth-fixed axes, as [`rows::attitudes`](super::rows::attitudes) gives them.
    pub attitudes: Option<&'a [[f64; 4]]>,
    /// How much the rows scatter.
    pub noise: Noise,
    /// The longest time between two rows, s.
    pub max_gap_s: f64,
}

/// How the parts of a log were smoothed; nothing for a part without noise.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Outcome {
    /// Horizontal position: its residual is √2 of a component's, over the Earth's radius.
    pub horizontal: Option<Smoothing>,
    /// Height, m.
    pub vertical: Option<Smoothing>,
    /// Attitude: its residual is √3/2 of a component's.
    pub attitude: Option<Smoothing>,
}

/// The path of a log with joints at the sites, s: the rows' times, or fewer where everything is smoothed.
///
/// Every slice of the workspace, `position`, and `attitude` if the log has attitudes, need
/// [`EXTRA`](crate::trajectory::spline::EXTRA) more entries than there are sites; the Gram matrix is not needed without
/// noise. Whether the path accelerates too much, [`Pace`](crate::trajectory::spline::place::Pace) tells piece by piece.
///
/// # Errors
///
/// [`LogError`] with the row at fault.
pub fn compile<'a>(
    log: &Log<'_>,
    sites: &'a [f64],
    mut workspace: Workspace<'_, 4>,
    position: &'a mut [[f64; 4]],
    attitude: &'a mut [[f64; 4]],
) -> Result<(Path<'a>, Outcome), LogError> {
    check(log)?;
    // Two components of the position on the ellipsoid, and ½ of each of three small angles.
    let horizontal = Real::sqrt(2.0) * log.noise.horizontal_m / radius(log.positions);
    let parts = [
        (Part::Horizontal, 0..3, horizontal),
        (Part::Vertical, 3..4, log.noise.vertical_m),
        (Part::Attitude, 0..4, 0.5 * Real::sqrt(3.0) * log.noise.attitude),
    ];
    let mut done = [None; 3];
    let mut knots = [Knots::eightfold(sites); 3];
    for (((part, channels, noise), done), knots) in parts.into_iter().zip(&mut done).zip(&mut knots)
    {
        let attitudes = part == Part::Attitude;
        let values = if attitudes { log.attitudes } else { Some(log.positions) };
        let Some(values) = values else { continue };
        let control = if attitudes { &mut *attitude } else { &mut *position };
        let fit = Fit { sites, times_s: log.times_s, values, channels };
        if noise > 0.0 {
            *knots = Knots::continued(sites);
            let smoothing = smooth(&fit, noise, workspace.again(), control);
            *done = Some(smoothing.map_err(|error| LogError::of(error, part))?);
        } else if log.times_s == sites {
            let through = through(&fit, workspace.again(), control);
            through.map_err(|error| LogError::of(error, part))?;
        } else {
            return Err(LogError::Sites { part });
        }
    }
    let [level, height, turned] = knots;
    let (position, attitude) = (&*position, &*attitude);
    let path = Path::new(
        Spline { knots: level, control: position },
        Spline { knots: height, control: position },
        log.attitudes.map(|_| Spline { knots: turned, control: attitude }),
    );
    let [horizontal, vertical, attitude] = done;
    let path = path.map_err(|error| LogError::of(error, Part::Horizontal))?;
    Ok((path, Outcome { horizontal, vertical, attitude }))
}

/// Interpolates, and writes some channels.
fn through(
    fit: &Fit<'_, 4>,
    workspace: Workspace<'_, 4>,
    control: &mut [[f64; 4]],
) -> Result<(), SplineError> {
    let Workspace { factors, right, .. } = workspace;
    interpolate(fit.sites, fit.values.iter().copied(), Ends::Natural, factors, right)?;
    let needed = fit.sites.len() + crate::trajectory::spline::EXTRA;
    let control = control.get_mut(..needed).ok_or(SplineError::NoRoom { needed })?;
    for (row, solved) in control.iter_mut().zip(right) {
        copy(row, solved, &fit.channels);
    }
    Ok(())
}

fn copy(to: &mut [f64; 4], from: &[f64; 4], channels: &Range<usize>) {
    let places = to.iter_mut().zip(from).enumerate();
    for (_, (to, from)) in places.filter(|(k, _)| channels.contains(k)) {
        *to = *from;
    }
}

/// Checks everything that does not depend on the noise.
fn check(log: &Log<'_>) -> Result<(), LogError> {
    let needed = log.times_s.len();
    if needed < 2 {
        return Err(LogError::TooFew);
    }
    if log.positions.len() != needed || log.attitudes.is_some_and(|rows| rows.len() != needed) {
        return Err(LogError::Count { needed });
    }
    let Noise { horizontal_m, vertical_m, attitude } = log.noise;
    let noises = [horizontal_m, vertical_m, attitude];
    for (noise, part) in noises.iter().zip([Part::Horizontal, Part::Vertical, Part::Attitude]) {
        if !(noise.is_finite() && *noise >= 0.0) {
            return Err(LogError::Noise { part });
        }
    }
    if let Some(index) = log.times_s.iter().position(|t| !t.is_finite()) {
        return Err(LogError::NotFinite { index });
    }
    let rows = log.times_s.windows(2).zip(log.positions.windows(2));
    for ((times, places), index) in rows.zip(1..) {
        let ([from_s, to_s], [from, to]) = (times, places) else { continue };
        let (from_s, to_s) = (*from_s, *to_s);
        if to_s <= from_s {
            return Err(LogError::NotIncreasing { index });
        }
        if (to_s - from_s > log.max_gap_s) | log.max_gap_s.is_nan() {
            return Err(LogError::Gap { index, from_s, to_s, max_gap_s: log.max_gap_s });
        }
        let [x, y, z, h] = core::array::from_fn(|k| {
            let of = |row: &[f64; 4]| row.get(k).copied().unwrap_or(0.0);
            of(to) - of(from)
        });
        let level = Vector::new(x, y, z).norm() * radius(log.positions);
        let speed_m_s = Real::sqrt(level * level + h * h) / (to_s - from_s);
        if !speed_m_s.is_finite() {
            return Err(LogError::NotFinite { index });
        }
        if speed_m_s > LARGEST_SPEED {
            return Err(LogError::TooFast { index, speed_m_s });
        }
    }
    Ok(())
}

/// The Earth's mean radius of curvature √(R_M R_N) at the first row, m, and its height.
fn radius(positions: &[[f64; 4]]) -> f64 {
    let [x, y, sine, h] = positions.first().copied().unwrap_or_default();
    let radii = Radii::at(sine, Real::sqrt(x * x + y * y));
    Real::sqrt(radii.meridian * radii.prime_vertical) + h
}
