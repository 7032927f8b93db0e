//! Splines of degree 7: against numbers of high precision, at their joints, and how they converge.

use super::{derivative, jump, size};
use schuler::earth::Geodetic;
use schuler::math::compensated::Pair;
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
                assert!((got - factor * value - offset).abs() < 1e-12, "{ends:?} {t}: {got}");
                let got = derivative(piece, channel, 2, t - piece.middle_s);
                assert!((got - factor * second).abs() < 5e-12, "{ends:?} {t}: {got}");
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
            for order in 0..=6 {
                // A coefficient is rounded to half an ulp of its size; eight of them add up, on either side.
                let largest = (order..8).map(|k| reach(&pieces, channel, k, order));
                let rounding = f64::EPSILON * largest.fold(0.0, f64::max);
                let jump = jump(&pieces, channel, order);
                assert!(jump < 8.0 * rounding, "{ends:?} {channel} {order}: {jump} {rounding}");
            }
            // The seventh is what steps from piece to piece.
            assert!(jump(&pieces, channel, 7) > 0.01 * size(&pieces, channel, 7));
        }
    }
}

/// Before it is rounded, a conversion to twice the digits joins to twice the digits. Plain double precision does not,
/// here 1e-16 of the value.
#[test]
fn the_conversion_has_twice_the_digits() {
    let (sites, data) = way_points();
    let control = solve(&sites, &data, Ends::Natural);
    let knots = Knots::eightfold(&sites);
    let spans: Vec<_> = (0..sites.len() - 1)
        .map(|k| {
            let middle = Piece::<8>::new(sites[k], sites[k + 1]).middle_s;
            (middle, coefficients(knots, k, middle, &control).unwrap())
        })
        .collect();
    let value = |(middle, rows): &(f64, [[Pair<f64>; 4]; 8]), channel: usize, t: f64| {
        let u = Pair::sum(t, -middle);
        rows.iter().rev().fold(Pair::new(0.0), |sum, row| sum * u + row[channel])
    };
    for (two, t) in spans.windows(2).zip(&sites[1..]) {
        for channel in 0..4 {
            let [before, after] = [&two[0], &two[1]].map(|span| value(span, channel, *t));
            let jump = (after - before).widen().abs() / before.hi.abs();
            assert!(jump < 1e-28, "{t} {channel}: {jump}");
        }
    }
    // What leaves is these coefficients, rounded.
    for ((_, rows), piece) in spans.iter().zip(pieces(&sites, &data, Ends::Natural)) {
        for (row, rounded) in rows.iter().zip(piece.coefficients) {
            assert!(row.iter().zip(rounded).all(|(c, rounded)| c.hi == rounded));
        }
    }
}

/// What a coefficient of a power contributes at most to a derivative at a joint.
fn reach(pieces: &[Piece<8>], channel: usize, power: usize, order: usize) -> f64 {
    let falling: f64 = (power + 1 - order..=power).map(|j| j as f64).product();
    let of = |piece: &Piece<8>| {
        let half = 0.5 * (piece.end_s - piece.start_s);
        (falling * half.powi((power - order) as i32) * piece.coefficients[power][channel]).abs()
    };
    pieces.iter().map(of).fold(0.0, f64::max)
}

/// A cubic spline, whose third derivative steps, is told from one with six continuous derivatives.
#[test]
fn a_cubic_is_found() {
    let cube = |t0: f64, t1: f64, k: f64| {
        let mut piece = Piece::<8>::new(t0, t1);
        // Value, slope and curvature go on at t = 1; the third derivative does not.
        let u = piece.middle_s - 1.0;
        for (place, c) in
            piece.coefficients.iter_mut().zip([k * u * u * u, 3.0 * k * u * u, 3.0 * k * u, k])
        {
            place[0] = c;
        }
        piece
    };
    let pieces = [cube(0.0, 1.0, 0.5), cube(1.0, 2.0, -0.25)];
    assert!((0..3).all(|order| jump(&pieces, 0, order) < 1e-15));
    assert_eq!(jump(&pieces, 0, 3), 4.5);
}

/// Twice as many sites leave 1/2⁸ of the error, away from the ends.
#[test]
fn the_error_is_of_order_eight() {
    let f = |t: f64| (0.9 * t).sin() + 0.3 * (0.37 * t).cos();
    let error = |count: u32| {
        let sites: Vec<f64> = (0..=count).map(|k| 40.0 * f64::from(k) / f64::from(count)).collect();
        let data: Vec<[f64; 4]> = sites.iter().map(|t| [f(*t), 0.0, 0.0, 0.0]).collect();
        let inner = pieces(&sites, &data, Ends::Natural).into_iter();
        let inner = inner.filter(|piece| (15.0..25.0).contains(&piece.middle_s));
        inner
            .map(|piece| (piece.channel(0, piece.middle_s) - f(piece.middle_s)).abs())
            .fold(0.0, f64::max)
    };
    let ratio = error(96) / error(192);
    assert!((200.0..330.0).contains(&ratio), "{ratio}");
}

/// With two or three sites the spline is the line or the parabola.
#[test]
fn few_sites_make_the_polynomial_of_least_degree() {
    let line = &pieces(&[1.0, 3.0], &[[1.0; 4], [2.0; 4]], Ends::Natural)[0];
    assert!((line.channel(0, 2.5) - 1.75).abs() < 1e-15);
    let square = |t: f64| [t * t; 4];
    let sites = [0.0, 1.0, 3.0];
    let parabola = pieces(&sites, &sites.map(square), Ends::Natural);
    assert!((parabola[0].channel(0, 0.5) - 0.25).abs() < 1e-13);
    assert!((parabola[1].channel(0, 2.0) - 4.0).abs() < 1e-13);
}

#[test]
fn what_determines_no_spline_is_refused() {
    let mut band = [[0.0; BAND]; 9];
    let mut control = [[0.0; 1]; 9];
    let mut attempt = |sites: &[f64], data: &[f64]| {
        let data = data.iter().map(|x| [*x]);
        interpolate(sites, data, Ends::Natural, &mut band, &mut control)
    };
    assert_eq!(attempt(&[0.0, 1.0, 2.0], &[1.0, 2.0, 3.0]), Ok(()));
    assert_eq!(attempt(&[0.0], &[1.0]), Err(SplineError::TooFew));
    assert_eq!(
        attempt(&[0.0, 1.0, 1.0], &[1.0, 2.0, 3.0]),
        Err(SplineError::NotIncreasing { index: 2 })
    );
    assert_eq!(attempt(&[0.0, f64::NAN], &[1.0, 2.0]), Err(SplineError::NotFinite { index: 1 }));
    assert_eq!(
        attempt(&[0.0, 1.0], &[1.0, f64::INFINITY]),
        Err(SplineError::NotFinite { index: 1 })
    );
    assert_eq!(attempt(&[0.0, 1.0], &[1.0]), Err(SplineError::Count { needed: 2 }));
    assert_eq!(attempt(&[0.0, 1.0], &[1.0; 3]), Err(SplineError::Count { needed: 2 }));
    assert_eq!(attempt(&[0.0, 1.0, 2.0, 3.0], &[1.0; 4]), Err(SplineError::NoRoom { needed: 10 }));
}
