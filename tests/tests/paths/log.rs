//! Logs: interpolated to the last digit, smoothed to their noise, refused by row.

use super::{derivative, left_of_noise};
use schuler::earth::Geodetic;
use schuler::solution::Euler;
use schuler::trajectory::log::{Log, LogError, Noise, Outcome, Part, compile, rows};
use schuler::trajectory::piecewise::piece::Piece;
use schuler::trajectory::segment::attitude::AttitudeRule;
use schuler::trajectory::segment::compile::segment::{Amount, Segment, Tightness};
use schuler::trajectory::segment::compile::{Compiler, Start};
use schuler::trajectory::spline::{BAND, EXTRA, smooth::Workspace};
use schuler::trajectory::wrap;
use schuler_tests::Numbers;

const RADIUS: f64 = 6.378e6;

/// Eight banked turns at 120 m/s, 25° to 60° of bank, with small climbs and straight lines between them.
fn flight() -> Vec<Piece<12>> {
    let start = Start {
        position: Geodetic { latitude: 0.8, longitude: 1.7, altitude: 500.0 },
        course: 0.5,
        speed: 120.0,
    };
    let mut segments = vec![Segment::Hold { duration_s: 20.0 }];
    for (k, bank) in [25.0_f64, 45.0, 60.0, 30.0, 50.0, 60.0, 40.0, 30.0].into_iter().enumerate() {
        let angle = if k % 3 == 1 { -1.2 } else { 1.9 };
        let tightness = Tightness::Bank(bank.to_radians());
        segments.push(Segment::Turn { amount: Amount::By(angle), tightness, blend_s: 4.0 });
        let height = if k % 2 == 0 { 60.0 } else { -60.0 };
        segments.push(Segment::Climb { height, rate: 5.0, blend_s: 8.0 });
        segments.push(Segment::Hold { duration_s: 150.0 });
    }
    let compiler = Compiler::new(start, AttitudeRule::Coordinated, &segments).unwrap();
    compiler.map(Result::unwrap).collect()
}

/// Values and second derivatives of the position's channels.
fn truth(pieces: &[Piece<12>], t: f64) -> ([f64; 4], [f64; 4]) {
    let piece = pieces.iter().find(|piece| t <= piece.end_s).unwrap();
    let of = |order| [0, 1, 2, 3].map(|c| derivative(piece, c, order, t - piece.middle_s));
    (of(0), of(2))
}

fn gauss(numbers: &mut Numbers) -> f64 {
    (0..12).map(|_| numbers.within(0.5)).sum()
}

/// Compiles with joints at the rows.
fn compiled(log: &Log<'_>) -> Result<(Vec<Piece<8>>, Outcome), LogError> {
    let room = log.times_s.len() + EXTRA;
    let (mut gram, mut factors) = (vec![[0.0; BAND]; room], vec![[0.0; BAND]; room]);
    let mut right = vec![[0.0; 4]; room];
    let (mut position, mut attitude) = (vec![[0.0; 4]; room], vec![[0.0; 4]; room]);
    let workspace = Workspace { gram: &mut gram, factors: &mut factors, right: &mut right };
    let (path, outcome) = compile(log, log.times_s, workspace, &mut position, &mut attitude)?;
    Ok(((0..path.pieces()).map(|index| path.piece(index).unwrap()).collect(), outcome))
}

/// Rms error of a horizontal component of acceleration, and of the vertical one, m/s².
fn acceleration_error(rate_hz: f64, sigma: f64, noise: Noise) -> [f64; 2] {
    let pieces = flight();
    let duration = pieces.last().unwrap().end_s;
    let mut numbers = Numbers(11);
    let count = (duration * rate_hz) as usize;
    let times: Vec<f64> = (0..count).map(|k| k as f64 / rate_hz).collect();
    let positions: Vec<[f64; 4]> = times
        .iter()
        .map(|t| {
            let mut row = truth(&pieces, *t).0;
            // On the plane across the normal, of which noise along the normal is a part that does not count.
            for x in &mut row[..3] {
                *x += sigma / RADIUS * gauss(&mut numbers);
            }
            let length = row[..3].iter().map(|x| x * x).sum::<f64>().sqrt();
            row[..3].iter_mut().for_each(|x| *x /= length);
            row[3] += sigma * gauss(&mut numbers);
            row
        })
        .collect();
    let log =
        Log { times_s: &times, positions: &positions, attitudes: None, noise, max_gap_s: 2.0 };
    let (path, _) = compiled(&log).unwrap();
    let inner = 20..path.len() - 20;
    let n = inner.len() as f64;
    let mut sums = [0.0; 2];
    for piece in &path[inner] {
        let (_, expected) = truth(&pieces, piece.middle_s);
        let off = |c: usize| derivative(piece, c, 2, 0.0) - expected[c];
        sums[0] += [0, 1, 2].map(|c| (RADIUS * off(c)).powi(2)).iter().sum::<f64>() / 2.0;
        sums[1] += off(3).powi(2);
    }
    sums.map(|sum| (sum / n).sqrt())
}

fn noise(sigma: f64) -> Noise {
    Noise { horizontal_m: sigma, vertical_m: sigma, attitude: 0.0 }
}

#[test]
fn smoothing_takes_the_noise_out_of_the_acceleration() {
    let [smoothed, vertical] = acceleration_error(10.0, 0.02, noise(0.02));
    assert!(smoothed < 0.05 && vertical < 0.05, "{smoothed} {vertical} m/s²");
    let [interpolated, _] = acceleration_error(10.0, 0.02, Noise::NONE);
    assert!(interpolated > 5.0, "{interpolated} m/s²");
    // Fixes of a satellite receiver on its own.
    let [level, vertical] = acceleration_error(1.0, 1.5, noise(1.5));
    assert!(level < 0.45 && vertical < 0.45, "{level} {vertical} m/s²");
}

/// A turn with attitudes over the antimeridian and by more than a circle, at rows that are not evenly spaced.
fn rows_of(count: usize) -> (Vec<f64>, Vec<Geodetic<f64>>, Vec<Euler<f64>>) {
    let mut numbers = Numbers(3);
    let mut t = 0.0_f64;
    let mut rows = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..count {
        let turn = 0.05 * t;
        rows.0.push(t);
        rows.1.push(Geodetic {
            latitude: 0.7 + 3e-4 * turn.sin(),
            longitude: wrap(3.1414 + 4e-4 * (1.0 - turn.cos())),
            altitude: 100.0 + 5.0 * (0.1 * t).sin(),
        });
        rows.2.push(Euler { roll: 0.3, pitch: 0.02 * (0.2 * t).sin(), yaw: wrap(turn) });
        t += 0.1 + numbers.within(0.03);
    }
    rows
}

#[test]
fn rows_without_noise_are_met() {
    let (times, places, eulers) = rows_of(1500);
    let (mut positions, mut attitudes) = (vec![[0.0; 4]; 1500], vec![[0.0; 4]; 1500]);
    rows::positions(&places, &mut positions).unwrap();
    rows::attitudes(&places, &eulers, &mut attitudes).unwrap();
    // More than a whole turn: the sign goes on.
    assert!(
        attitudes.windows(2).all(|two| (0..4).map(|c| two[0][c] * two[1][c]).sum::<f64>() > 0.99)
    );
    let log = Log {
        times_s: &times,
        positions: &positions,
        attitudes: Some(&attitudes),
        noise: Noise::NONE,
        max_gap_s: 0.2,
    };
    let (path, outcome) = compiled(&log).unwrap();
    assert_eq!(outcome, Outcome::default());
    for (piece, (place, q)) in path.iter().zip(positions.iter().zip(&attitudes)) {
        for c in 0..4 {
            let scale = if c < 3 { RADIUS } else { 1.0 };
            assert!(scale * (piece.channel(c, piece.start_s) - place[c]).abs() < 5e-9);
            assert!((piece.channel(4 + c, piece.start_s) - q[c]).abs() < 5e-15);
        }
    }
}

/// Each part by its own noise; the others as they are without.
#[test]
fn parts_are_smoothed_apart() {
    let (times, places, eulers) = rows_of(600);
    let (mut positions, mut attitudes) = (vec![[0.0; 4]; 600], vec![[0.0; 4]; 600]);
    rows::positions(&places, &mut positions).unwrap();
    rows::attitudes(&places, &eulers, &mut attitudes).unwrap();
    let mut numbers = Numbers(8);
    for (place, q) in positions.iter_mut().zip(&mut attitudes) {
        place[3] += 0.5 * gauss(&mut numbers);
        // ½ of small angles of 1e-3 rad about three axes.
        for x in q {
            *x += 5e-4 * gauss(&mut numbers);
        }
    }
    let noise = Noise { horizontal_m: 0.0, vertical_m: 0.5, attitude: 1e-3 };
    let log = Log {
        times_s: &times,
        positions: &positions,
        attitudes: Some(&attitudes),
        noise,
        max_gap_s: 1.0,
    };
    let (path, outcome) = compiled(&log).unwrap();
    assert!(outcome.horizontal.is_none());
    let vertical = outcome.vertical.unwrap();
    let attitude = outcome.attitude.unwrap();
    for (part, sigma) in [(vertical, 0.5), (attitude, 1e-3 * 0.75_f64.sqrt())] {
        let expected = left_of_noise(sigma, &times, part.time_constant_s);
        assert!((part.residual / expected - 1.0).abs() < 1e-6 && !part.at_limit, "{part:?}");
    }
    let mut height = 0.0;
    for (piece, (place, clean)) in path.iter().zip(positions.iter().zip(&places)).skip(20) {
        for (c, x) in place[..3].iter().enumerate() {
            assert!(RADIUS * (piece.channel(c, piece.start_s) - x).abs() < 5e-9);
        }
        height += (piece.channel(3, piece.start_s) - clean.altitude).powi(2) / 580.0;
    }
    assert!(height.sqrt() < 0.2, "{}", height.sqrt());
}

#[test]
fn faults_are_named_by_row() {
    let (times, places, _) = rows_of(12);
    let mut positions = vec![[0.0; 4]; 12];
    rows::positions(&places, &mut positions).unwrap();
    let attempt = |times: &[f64], positions: &[[f64; 4]], noise: Noise, max_gap_s: f64| {
        compiled(&Log { times_s: times, positions, attitudes: None, noise, max_gap_s }).err()
    };
    let none = Noise::NONE;
    assert_eq!(attempt(&times, &positions, none, 1.0), None);
    let late: Vec<f64> = times.iter().map(|t| if *t > 0.55 { t + 3.0 } else { *t }).collect();
    let index = late.iter().position(|t| *t > 3.0).unwrap();
    let gap = LogError::Gap { index, from_s: late[index - 1], to_s: late[index], max_gap_s: 2.0 };
    assert_eq!(attempt(&late, &positions, none, 2.0), Some(gap));
    assert!(gap.to_string().contains(&late[index].to_string()));
    assert!(attempt(&times, &positions, none, f64::NAN).is_some());
    let mut same = times.clone();
    same[4] = same[3];
    assert_eq!(attempt(&same, &positions, none, 1.0), Some(LogError::NotIncreasing { index: 4 }));
    let mut jump = positions.clone();
    jump[7][3] += 2e5;
    assert!(matches!(attempt(&times, &jump, none, 1.0), Some(LogError::TooFast { index: 7, .. })));
    let mut bad = positions.clone();
    bad[5][1] = f64::NAN;
    assert_eq!(attempt(&times, &bad, none, 1.0), Some(LogError::NotFinite { index: 5 }));
    let negative = Noise { vertical_m: -1.0, ..none };
    assert_eq!(
        attempt(&times, &positions, negative, 1.0),
        Some(LogError::Noise { part: Part::Vertical })
    );
    assert_eq!(attempt(&times[..1], &positions[..1], none, 1.0), Some(LogError::TooFew));
    assert_eq!(attempt(&times, &positions[1..], none, 1.0), Some(LogError::Count { needed: 12 }));
}
