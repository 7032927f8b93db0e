//! That pieces meet smoothly, and that a coordinated flight feels no lateral force.

use super::*;
use schuler::earth::SEMI_MAJOR_AXIS;
use schuler::math::compensated::Pair;
use schuler::trajectory::Trajectory;

/// Derivative `k` of a channel at a time, over k!.
fn derivative(piece: &Piece<TERMS>, channel: usize, k: usize, time_s: f64) -> f64 {
    let u = time_s - piece.middle_s;
    (k..TERMS).rev().fold(0.0, |sum, n| {
        let binomial = (0..k).fold(1.0, |b, i| b * (n - i) as f64 / (i + 1) as f64);
        sum * u + binomial * piece.coefficients[n][channel]
    })
}

#[test]
fn six_derivatives_go_on_at_every_joint() {
    for blend_s in [0.5, 2.0] {
        let (from, mut segments) = circuit();
        segments.extend([
            accelerate(30.0, 5.0),
            turn(-170.0, 40.0, blend_s),
            Segment::Rotate { angles: [0.4, -0.3, 9.0], blend_s },
            straight_s(3.0),
        ]);
        let pieces = pieces(from, AttitudeRule::Coordinated, &segments);
        for pair in pieces.windows(2) {
            let [a, b] = pair else { continue };
            assert_eq!(a.end_s, b.start_s);
            let span = (a.end_s - a.start_s).min(b.end_s - b.start_s);
            for channel in 0..8 {
                // Normal and height in metres; the size that rounds is that of the polynomial itself.
                let unit = if channel < 3 { SEMI_MAJOR_AXIS } else { 1.0 };
                let largest = |k: usize| {
                    let sum = |piece: &Piece<TERMS>| {
                        let half = 0.5 * (piece.end_s - piece.start_s);
                        (k.max(1)..TERMS)
                            .map(|n| {
                                2_f64.powi(n as i32)
                                    * piece.coefficients[n][channel].abs()
                                    * half.powi((n - k) as i32)
                            })
                            .sum::<f64>()
                    };
                    sum(a).max(sum(b))
                };
                for k in 0..6 {
                    let jump =
                        derivative(a, channel, k, a.end_s) - derivative(b, channel, k, a.end_s);
                    let value = if k == 0 { a.coefficients[0][channel].abs() } else { 0.0 };
                    // Some ulps of the terms, and what the pair left of a value of 1 in 10³² does to it.
                    let bound = 4e-16 * (value + largest(k)) + 1e-30 / span.powi(k as i32);
                    assert!(
                        jump.abs() <= bound,
                        "{channel} {k} at {}: {:e} {:e}",
                        a.end_s,
                        unit * jump,
                        unit * bound
                    );
                }
            }
        }
    }
}

#[test]
fn a_coordinated_flight_feels_no_lateral_force() {
    let (from, segments) = circuit();
    let path = path(from, AttitudeRule::Coordinated, &segments);
    let lateral = |time_s: f64| path.rates_at(Pair::new(time_s)).specific_force_b.y.abs();
    let times = (0..).map(|k| 0.003 + 0.02 * f64::from(k)).take_while(|t| *t < path.end_s());
    let largest = times.map(lateral).fold(0.0, f64::max);
    assert!(largest < 1e-6, "{largest:e}");
    // Not because there is none: an upright one turns with it.
    let upright = super::path(from, AttitudeRule::Upright, &segments);
    let turning = spans(from, AttitudeRule::Upright, &segments)[4];
    let middle = Pair::new(0.5 * (turning.start_s + turning.end_s));
    let force = upright.rates_at(middle).specific_force_b.y;
    assert!((force - 9.8 * 25_f64.to_radians().tan()).abs() < 0.05, "{force}");
}

#[test]
fn quaternions_stay_near_unit_length_and_keep_their_sign() {
    let (from, segments) = circuit();
    for piece in pieces(from, AttitudeRule::Coordinated, &segments) {
        for time_s in [piece.start_s, piece.middle_s, piece.end_s] {
            let square = (4..8).map(|channel| piece.channel(channel, time_s).powi(2)).sum::<f64>();
            assert!((square - 1.0).abs() < 1e-6, "{time_s} {square}");
        }
    }
}
