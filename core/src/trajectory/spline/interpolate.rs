//! The spline through a value at each site.
//!
//! A row for each site, Σ_j B_j(t_i) c_j = z_i, and three at each end, where derivatives are 0. Solved for the
//! differences from the first value, so that what counts is rounded to the size of the path, not of the Earth.
//! Source: de Boor, *A Practical Guide to Splines*, ch. XIII.
//!
//! ```
//! use schuler::trajectory::spline::{BAND, EXTRA, Ends, basis::Knots};
//! use schuler::trajectory::spline::{interpolate::interpolate, local::coefficients};
//!
//! // From rest to rest over 1 m: halfway after half the time.
//! let sites = [0.0, 2.0];
//! let (mut band, mut control) = ([[0.0; BAND]; 2 + EXTRA], [[0.0]; 2 + EXTRA]);
//! interpolate(&sites, [[0.0], [1.0]], Ends::AtRest, &mut band, &mut control)?;
//! let middle = coefficients(Knots::eightfold(&sites), 0, 1.0, &control).unwrap();
//! assert!((middle[0][0].hi - 0.5).abs() < 1e-15);
//! assert!((middle[1][0].hi - 35.0 / 16.0 / 2.0).abs() < 1e-14);
//! # Ok::<(), schuler::trajectory::spline::SplineError>(())
//! ```

use super::band::solve;
use super::basis::{Knots, values};
use super::local::polynomial;
use super::{BAND, EXTRA, Ends, SplineError, TERMS, check_sites};

/// Conditions at each end.
const ENDS: usize = 3;

/// Finds the control points of the spline that takes the values at the sites, in as many channels as they have;
/// its knots are [`Knots::eightfold`].
///
/// Both slices must have at least [`EXTRA`] more entries than there are sites; further ones stay as they are.
///
/// # Errors
///
/// [`SplineError`] with the index of the site.
pub fn interpolate<const C: usize>(
    sites: &[f64],
    data: impl IntoIterator<Item = [f64; C]>,
    ends: Ends,
    band: &mut [[f64; BAND]],
    control: &mut [[f64; C]],
) -> Result<(), SplineError> {
    check_sites(sites)?;
    let needed = sites.len() + EXTRA;
    let no_room = SplineError::NoRoom { needed };
    let band = band.get_mut(..needed).ok_or(no_room)?;
    let control = control.get_mut(..needed).ok_or(no_room)?;
    band.fill([0.0; BAND]);
    control.fill([0.0; C]);

    let base = fill_right(sites.len(), data, control)?;
    let knots = Knots::eightfold(sites);
    fill_rows(knots, band);
    fill_end(knots, ends, band, false);
    fill_end(knots, ends, band, true);
    solve(band, control)?;
    for row in control {
        row.iter_mut().zip(base).for_each(|(c, base)| *c += base);
    }
    Ok(())
}

/// The values less the first one, which is returned.
fn fill_right<const C: usize>(
    sites: usize,
    data: impl IntoIterator<Item = [f64; C]>,
    right: &mut [[f64; C]],
) -> Result<[f64; C], SplineError> {
    let mut base = None;
    let mut count = 0;
    for (index, value) in data.into_iter().enumerate() {
        count += 1;
        let place = right.get_mut(index + ENDS).filter(|_| index < sites);
        let place = place.ok_or(SplineError::Count { needed: sites })?;
        let base = *base.get_or_insert(value);
        for ((place, x), base) in place.iter_mut().zip(value).zip(base) {
            *place = x - base;
            if !place.is_finite() {
                return Err(SplineError::NotFinite { index });
            }
        }
    }
    base.filter(|_| count == sites).ok_or(SplineError::Count { needed: sites })
}

/// The rows of the sites.
fn fill_rows(knots: Knots<'_>, band: &mut [[f64; BAND]]) {
    let sites = knots.sites();
    let last_span = sites.len() - 2;
    let rows = band.iter_mut().skip(ENDS);
    for (index, (row, &site)) in rows.zip(sites).enumerate() {
        *row = values(&knots.around(index.min(last_span)), site);
        // At its first knot the last function of a span is 0, at its last knot the first one.
        if index > last_span {
            row.rotate_left(1);
        }
    }
}

/// The three rows of one end's conditions.
fn fill_end(knots: Knots<'_>, ends: Ends, band: &mut [[f64; BAND]], at_end: bool) {
    let sites = knots.sites();
    let lowest = match ends {
        // With fewer than four sites the conditions would leave the spline undetermined: lower orders make it the
        // polynomial of least degree.
        Ends::Natural => sites.len().min(4),
        Ends::AtRest => 1,
    };
    let (span, time) = if at_end { (sites.len() - 2, sites.last()) } else { (0, sites.first()) };
    let Some(&time) = time else { return };
    // By order, what each control point of the span contributes to the derivative.
    let unit = |j: usize| core::array::from_fn(|k| if j == k { 1.0 } else { 0.0 });
    let units: [[f64; TERMS]; TERMS] = core::array::from_fn(unit);
    let shares = polynomial(&knots.around(span), time, &units);
    let rows = band.iter_mut().skip(if at_end { sites.len() + ENDS } else { 0 });
    for (row, shares) in rows.zip(shares.iter().skip(lowest)).take(ENDS) {
        for (place, share) in row.iter_mut().zip(shares.iter().skip(at_end.into())) {
            *place = share.hi;
        }
    }
}
