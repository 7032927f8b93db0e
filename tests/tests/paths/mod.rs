//! Paths made of polynomials: splines through way-points, logs.

#![expect(clippy::excessive_precision, reason = "expected values keep their printed digits")]

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

/// What noise leaves as its residual after smoothing over times: σ√(1 − ½ν/n), ν = 3 + T/(3τ).
fn left_of_noise(sigma: f64, times_s: &[f64], time_constant_s: f64) -> f64 {
    let duration = times_s[times_s.len() - 1] - times_s[0];
    let followed = 3.0 + duration / (3.0 * time_constant_s);
    sigma * (1.0 - 0.5 * followed / times_s.len() as f64).sqrt()
}
