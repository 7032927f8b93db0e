//! Paths made of polynomials: splines through way-points, logs.

mod fly_by;
mod log;
mod smooth;
mod spline;
mod through;

use schuler::trajectory::piecewise::piece::Piece;

/// The coefficient of a power after a Taylor shift by `u`, times the power's factorial: a derivative.
fn derivative<const TERMS: usize>(
    piece: &Piece<TERMS>,
    channel: usize,
    order: usize,
    u: f64,
) -> f64 {
    let rows = piece.coefficients.iter().enumerate().skip(order).rev();
    rows.fold(0.0, |sum, (k, row)| {
        let falling: f64 = (k + 1 - order..=k).map(|j| j as f64).product();
        sum * u + falling * row[channel]
    })
}

/// The largest jump of a derivative at the joints of pieces.
fn jump<const TERMS: usize>(pieces: &[Piece<TERMS>], channel: usize, order: usize) -> f64 {
    let jumps = pieces.windows(2).map(|two| {
        let [a, b] = [two[0], two[1]];
        let before = derivative(&a, channel, order, a.end_s - a.middle_s);
        let after = derivative(&b, channel, order, b.start_s - b.middle_s);
        (after - before).abs()
    });
    jumps.fold(0.0, f64::max)
}

/// The largest size of a derivative at the joints.
fn size<const TERMS: usize>(pieces: &[Piece<TERMS>], channel: usize, order: usize) -> f64 {
    let sizes = pieces.iter().flat_map(|piece| {
        [piece.start_s, piece.end_s].map(|t| derivative(piece, channel, order, t - piece.middle_s))
    });
    sizes.fold(0.0, |most, x| most.max(x.abs()))
}
