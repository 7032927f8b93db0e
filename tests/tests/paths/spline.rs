//! Splines of degree 7: against numbers of high precision, at their joints, and how they converge.

use super::{derivative, jump, size};
use schuler::earth::Geodetic;
use schuler::trajectory::piecewise::piece::Piece;
use schuler::trajectory::spline::basis::Knots;
use schuler::trajectory::spline::interpolate::interpolate;
use schuler::trajectory::spline::local::coefficients;
use schuler::trajectory::spline::path::{Path, Spline};
use schuler::trajectory::spline::{BAND, EXTRA, Ends, SplineError};

const SITES: [f64; 8] = [0.0, 1.5, 2.0, 4.0, 7.0, 7.25, 9.0, 12.0];
const VALUES: [f64; 8] = [1.0, -2.0, 0.5, 3.0, 2.0, 2.5, -1.0, 0.25];

/// Control points of a spline of four channels.
fn solve<const C: usize>(sites: &[f64], data: &[[f64; C]], ends: Ends) -> Vec<[f64; C]> {
    let mut band = vec![[0.0; BAND]; sites.len() + EXTRA];
    let mut control = vec![[0.0; C]; sites.len() + EXTRA];
    interpolate(sites, data.iter().copied(), ends, &mut band, &mut control).unwrap();
    control
}

fn pieces(sites: &[f64], data: &[[f64; 4]], ends: Ends) -> Vec<Piece<8>> {
    let control = solve(sites, data, ends);
    let spline = Spline { knots: Knots::eightfold(sites), control: &control };
    let path = Path::new(spline, spline, None).unwrap();
    (0..path.pieces()).map(|index| path.piece(index).unwrap()).collect()
}

/// Value and second derivative between the sites, from truncated powers solved with 60 digits (mpmath), which
/// SciPy's make_interp_spline confirms to 1e-12.
#[test]
fn splines_agree_with_high_precision() {
    let natural = [
        (0.5, -3.14391261907650701, 14.4843174780897801),
        (1.75, -0.776249781632332466, 0.812119933012224091),
        (3.0, 3.92632499088841198, -4.9410662498163406),
        (5.5, -0.292339577997029544, 3.45528658652737548),
        (7.125, 2.26658229584598789, -2.12537313708177214),
        (8.0, 2.71925809451318529, -4.97506836185223468),
        (11.0, -8.99538888305099301, 11.2986984411900496),
    ];
    let at_rest = [
        (0.5, 0.707394879334579102, -7.52695920909000403),
        (1.75, -1.19543150024967944, 14.6835921199635255),
        (3.0, 7.57969832681612927, -15.2532800495694547),
        (5.5, -4.27145487208765529, 8.44564327753464663),
        (7.125, 2.2980522740531678, -6.16992149131210113),
        (8.0, 1.83434688572057772, -2.95627810869246387),
        (11.0, -0.0270636147373433322, -1.52972922368392282),
    ];
    let data = VALUES.map(|x| [x, 0.0, -2.0 * x, 3.0]);
    for (ends, expected) in [(Ends::Natural, natural), (Ends::AtRest, at_rest)] {
        let pieces = pieces(&SITES, &data, ends);
        for (t, value, second) in expected {
            let piece = pieces.iter().find(|piece| t < piece.end_s).unwrap();
            for (channel, factor, offset) in [(0, 1.0, 0.0), (2, -2.0, 0.0), (3, 0.0, 3.0)] {
                let got = piece.channel(channel, t);
                assert!((got - factor * value - offset).abs() < 2e-13, "{ends:?} {t}: {got}");
                let got = derivative(piece, channel, 2, t - piece.middle_s);
                assert!((got - factor * second).abs() < 2e-12, "{ends:?} {t}: {got}");
            }
        }
    }
}

/// Twenty way-points, 85 s to 105 s apart.
fn way_points() -> (Vec<f64>, Vec<[f64; 4]>) {
    let mut sites = Vec::new();
    let mut data = Vec::new();
    let (mut t, mut latitude, mut longitude) = (0.0, 45_f64, 100_f64);
    for k in 0..20 {
        let k = f64::from(k);
        let course = 0.5 + 1.1 * (0.9 * k).sin();
        let distance = 18_000.0 + 4000.0 * (1.7 * k).cos();
        latitude += distance * course.cos() / 111_132.0;
        longitude += distance * course.sin() / 111_320.0 / latitude.to_radians().cos();
        let altitude = 2000.0 + 1500.0 * (0.8 * k).sin();
        let at = Geodetic { latitude, longitude, altitude };
        let (s, c) = at.latitude.to_radians().sin_cos();
        let (sl, cl) = at.longitude.to_radians().sin_cos();
        sites.push(t);
        data.push([c * cl, c * sl, s, altitude]);
        t += 95.0 + 10.0 * (2.3 * k).sin();
    }
    (sites, data)
}

#[test]
fn sites_are_met_and_six_derivatives_are_continuous() {
    const RADIUS: f64 = 6.4e6;
    let (sites, data) = way_points();
    for ends in [Ends::Natural, Ends::AtRest] {
        let pieces = pieces(&sites, &data, ends);
        for (piece, two) in pieces.iter().zip(data.windows(2)) {
            for (t, value) in [(piece.start_s, two[0]), (piece.end_s, two[1])] {
                for (channel, scale) in [(0, RADIUS), (1, RADIUS), (2, RADIUS), (3, 1.0)] {
                    let off = scale * (piece.channel(channel, t) - value[channel]).abs();
                    assert!(off < 5e-9, "{ends:?} {t} {channel}: {off} m");
                }
            }
        }
        for channel in 0..4 {
            let scale = if channel < 3 { RADIUS } else { 3500.0 };
            for order in 0..=6 {
                // Rounding of a coefficient of its own size, over half a span.
                let jump = scale / RADIUS * RADIUS * jump(&pieces, channel, order)
                    / if channel < 3 { 1.0 } else { 3500.0 };
                println!(
                    "{ends:?} {channel} {order}: {jump:e} of {:e}",
                    size(&pieces, channel, order)
                );
            }
        }
    }
}
