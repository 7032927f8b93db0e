//! Bounds of a path, as some instants of each piece show them.

use super::piece::{CHANNELS, Half, Piece};
use super::{Attitude, LEAST_SPEED, PathError, Piecewise};
use crate::math::compensated::Pair;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::trajectory::Bound;

/// Instants of a piece, evenly spread with its ends: enough for derivatives of fourth order.
const LOOKS: usize = 5;
/// Differences of readings below this share of them are rounding.
const ROUNDING: f64 = 1e-12;
/// What lies between the instants may turn faster by this factor.
const BETWEEN: f64 = 1.1;

/// The pieces follow each other, and have numbers and directions.
pub(super) fn check<const TERMS: usize>(pieces: &[Piece<TERMS>]) -> Result<(), PathError> {
    let mut end_s = pieces.first().ok_or(PathError::Empty)?.start_s;
    for (index, piece) in pieces.iter().enumerate() {
        let follows = piece.start_s == end_s && piece.end_s > piece.start_s;
        if !follows {
            return Err(PathError::Order { piece: index });
        }
        end_s = piece.end_s;
        let finite = |c: &f64| c.is_within(f64::MAX);
        let is_finite = piece.coefficients.iter().flatten().all(finite);
        let instants = [piece.start_s, piece.middle_s, piece.end_s];
        let has_direction = instants.into_iter().all(|time_s| {
            let square = |channels: core::ops::Range<usize>| {
                channels.map(|c| piece.channel(c, time_s)).map(|x| x * x).sum::<f64>()
            };
            // An unused quaternion is zero throughout.
            let has_attitude =
                piece.coefficients.iter().any(|row| row.iter().skip(4).any(|&c| c != 0.0));
            square(0..3) > 0.0 && (!has_attitude || square(4..CHANNELS) > 0.0)
        });
        if !is_finite || !has_direction {
            return Err(PathError::NotFinite { piece: index });
        }
    }
    Ok(())
}

/// The six readings at the instants of a piece.
fn readings<const TERMS: usize>(
    piece: &Piece<TERMS>,
    attitude: Attitude,
) -> Result<[[f64; 6]; LOOKS], PathError> {
    let mut all = [[0.0; 6]; LOOKS];
    let length_s = piece.end_s - piece.start_s;
    for (look, six) in all.iter_mut().enumerate() {
        let time_s = piece.start_s + length_s * look as f64 / (LOOKS - 1) as f64;
        let at = Pair::new(time_s);
        if attitude != Attitude::Stored {
            let [x, y, z, h] = piece.series::<2>(Half::Position, at);
            let velocity = super::place::Place::new(Vector::new(x, y, z), h).position;
            let speed = velocity.map(|r| r.coefficient(1)).norm();
            let is_told = speed >= LEAST_SPEED;
            if !is_told {
                return Err(PathError::Slow { time_s, speed });
            }
        }
        let rates = piece.rates(attitude, at);
        let [a, b, c] = rates.rate_ib_b.into_array();
        let [d, e, f] = rates.specific_force_b.into_array();
        *six = [a, b, c, d, e, f];
    }
    Ok(all)
}

/// Λ and |ω| of a path.
pub(super) fn bound<P: AsRef<[Piece<TERMS>]>, const TERMS: usize>(
    path: &Piecewise<P, TERMS>,
) -> Result<Bound<f64>, PathError> {
    let mut least = [f64::MAX; 6];
    let mut most = [-f64::MAX; 6];
    let mut turning = 0.0_f64;
    for piece in path.pieces() {
        for six in readings(piece, path.attitude)? {
            for ((least, most), reading) in least.iter_mut().zip(&mut most).zip(six) {
                *least = if reading < *least { reading } else { *least };
                *most = if reading > *most { reading } else { *most };
            }
            let [x, y, z, ..] = six;
            let rate = Vector::new(x, y, z).norm();
            turning = if rate > turning { rate } else { turning };
        }
    }
    let mut bandwidth = 0.0_f64;
    for piece in path.pieces() {
        let step_s = (piece.end_s - piece.start_s) / (LOOKS - 1) as f64;
        let mut differences = readings(piece, path.attitude)?;
        for order in 1..LOOKS {
            // Δᵏf/hᵏ is a k-th derivative within the piece: Λ ≥ (|f⁽ᵏ⁾|/range)^(1/k)
            for n in 0..LOOKS - order {
                let (Some(&before), Some(&after)) = (differences.get(n), differences.get(n + 1))
                else {
                    break;
                };
                let mut change = [0.0; 6];
                let ranges = least.iter().zip(&most);
                for (i, (change, (least, most))) in change.iter_mut().zip(ranges).enumerate() {
                    let of = |six: [f64; 6]| six.get(i).copied().unwrap_or(0.0);
                    *change = of(after) - of(before);
                    let size = if -*least > *most { -*least } else { *most };
                    let range = *most - *least;
                    if change.abs() > ROUNDING * size && range > ROUNDING * size {
                        let share = root(change.abs() / range, order) / step_s;
                        bandwidth = if share > bandwidth { share } else { bandwidth };
                    }
                }
                if let Some(place) = differences.get_mut(n) {
                    *place = change;
                }
            }
        }
    }
    Ok(Bound { bandwidth, angular_rate: turning * BETWEEN })
}

/// x^(1/k) for k from 1 to 4.
fn root(x: f64, order: usize) -> f64 {
    match order {
        1 => x,
        2 => Real::sqrt(x),
        // Newton from the square root of the square root, which lies on the way.
        3 => {
            let mut y = Real::sqrt(x);
            for _ in 0..40 {
                y = (2.0 * y + x / (y * y)) / 3.0;
            }
            y
        }
        _ => Real::sqrt(Real::sqrt(x)),
    }
}
