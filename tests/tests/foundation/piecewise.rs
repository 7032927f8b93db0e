//! Paths in pieces: what sensors read against the route over latitude, longitude and Euler's angles, and flown.

use schuler::EarthFixedNavigator8;
use schuler::drift::compare::drift;
use schuler::imu::{Quadrature, instant};
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::solution::EarthFixedSolution;
use schuler::trajectory::Trajectory;
use schuler::trajectory::carried::{Carried, Mount};
use schuler::trajectory::harmonic::{Channel, Channels, Harmonic, HarmonicTrajectory};
use schuler::trajectory::kinematics::Kinematics;
use schuler::trajectory::piecewise::piece::Piece;
use schuler::trajectory::piecewise::stream::{Stream, StreamError};
use schuler::trajectory::piecewise::{Attitude, PathError, Piecewise};

const RULES: [Attitude; 4] =
    [Attitude::Stored, Attitude::Coordinated, Attitude::Upright, Attitude::Level];

/// A minute of climbing and turning, everything at once.
fn piece() -> Piece<8> {
    let mut piece = Piece::new(0.0, 60.0);
    let ((s, c), (sl, cl)) = (0.8_f64.sin_cos(), 1.7_f64.sin_cos());
    piece.coefficients[0] = [c * cl, c * sl, s, 500.0, 0.3, 0.5, -0.2, 0.7];
    piece.coefficients[1] = [3e-5, 1e-5, -2e-5, 3.0, 0.01, -0.02, 0.005, 0.01];
    piece.coefficients[2] = [1e-7, -3e-7, 2e-7, 0.1, 1e-3, 5e-4, -2e-4, -8e-4];
    piece.coefficients[3] = [1e-9, 3e-9, 2e-9, 0.01, 1e-5, 5e-5, -2e-5, -3e-6];
    piece.coefficients[4] = [1e-11, 3e-11, -2e-11, 1e-4, 1e-6, 5e-7, -2e-6, -3e-7];
    piece
}

fn path(rule: Attitude) -> Piecewise<[Piece<8>; 1], 8> {
    Piecewise::new([piece()], rule).unwrap()
}

/// Moved to another middle exactly enough: the same polynomials in two pieces.
fn halves() -> [Piece<8>; 2] {
    let whole = piece();
    [(0.0, 20.0), (20.0, 60.0)].map(|(start_s, end_s)| {
        let mut part = Piece { middle_s: 30.0, ..Piece::new(start_s, end_s) };
        part.coefficients = whole.coefficients;
        part
    })
}

fn swings<const N: usize>(waves: [(f64, f64); N]) -> [[Harmonic<f64>; 1]; N] {
    waves.map(|(amplitude, angular_rate)| [Harmonic { amplitude, angular_rate, phase: 0.4 }])
}

fn shaken(of: &[[Harmonic<f64>; 1]; 3]) -> HarmonicTrajectory<f64, 4> {
    let still = Channel::constant(0.0);
    let [roll, pitch, yaw] =
        of.each_ref().map(|harmonics| Channel { harmonics, ..Channel::constant(0.0) });
    let channels =
        Channels { roll, pitch, yaw, latitude: still, longitude: still, altitude: still };
    HarmonicTrajectory::new(channels).unwrap()
}

fn mount() -> Mount<4> {
    Mount {
        lever_arm_b: Vector::new(20.0, -10.0, 5.0),
        turning: Some(shaken(&swings([(0.01, 12.0), (0.02, 9.0), (0.005, 15.0)]))),
        moving: Some(shaken(&swings([(0.02, 9.0), (0.005, 15.0), (0.01, 12.0)]))),
    }
}

/// What the route over the angles says of every instant, and the derivative of the rate by differences.
fn assert_consistent(what: &str, path: &impl Trajectory<f64>) {
    for k in 1..59 {
        let at = Pair::new(f64::from(k) + 0.3);
        let (rates, other) = (path.rates_at(at), path.at_instant(at).rates());
        let apart = (rates.rate_ib_b - other.rate_ib_b).norm();
        assert!(apart < 1e-15, "{what} at {k} s: {apart:e} rad/s");
        let apart = (rates.specific_force_b - other.specific_force_b).norm();
        assert!(apart < 5e-14, "{what} at {k} s: {apart:e} m/s²");
        let kinematics = path.kinematics_at(at);
        let apart = (kinematics.rates().rate_ib_b - rates.rate_ib_b).norm();
        assert!(apart < 1e-15, "{what} at {k} s: {apart:e} rad/s of the kinematics");
        let rate = |step: f64| path.kinematics_at(Pair::new(at.hi + step)).rate_eb_b;
        let slope =
            (rate(1e-3) - rate(-1e-3)) * (8.0 / 12e-3) - (rate(2e-3) - rate(-2e-3)) * (1.0 / 12e-3);
        let apart = (slope - kinematics.angular_acceleration_b).norm();
        assert!(apart < 1e-8, "{what} at {k} s: {apart:e} rad/s²");
    }
}

/// The largest error of a row over a minute at 200 Hz.
fn fly(path: &impl Trajectory<f64>) -> f64 {
    const RATE_HZ: f64 = 200.0;
    let quadrature = Quadrature::of_nodes(8);
    let navigator = EarthFixedNavigator8::<f64>::from_rate_hz(RATE_HZ).unwrap();
    let mut state = navigator.start(&path.initial_at(Pair::new(0.0))).unwrap();
    let mut most = 0.0_f64;
    let mut read = |n: u64, row: EarthFixedSolution<f64>| {
        let truth = path.solution_at(instant(n as f64, RATE_HZ));
        most = most.max(drift(&row.to_local(), &truth).position_ned.norm());
    };
    for n in 1..=12_000 {
        navigator.push_rows(&mut state, quadrature.sample(path, n, RATE_HZ), &mut read).unwrap();
    }
    navigator.finish_rows(&mut state, &mut read);
    most
}

#[test]
fn every_rule_reads_what_the_angles_say() {
    for rule in RULES {
        assert_consistent(&format!("{rule:?}"), &path(rule));
    }
}

#[test]
fn a_navigator_finds_every_rule_again() {
    for rule in RULES {
        let most = fly(&path(rule));
        assert!(most < 8e-9, "{rule:?}: {most:e} m");
    }
}

#[test]
fn a_coordinated_path_has_no_lateral_force() {
    for k in 0..60 {
        let rates = path(Attitude::Coordinated).rates_at(Pair::new(f64::from(k)));
        assert_eq!(rates.specific_force_b.y, 0.0);
        let kinematics = path(Attitude::Coordinated).kinematics_at(Pair::new(f64::from(k)));
        assert!(kinematics.rates().specific_force_b.y.abs() < 1e-14);
    }
}

#[test]
fn a_lever_and_vibration_ride_on_any_motion() {
    for rule in RULES {
        let rigid = Carried::new(path(rule), Mount::<1>::rigid(Vector::new(20.0, -10.0, 5.0)));
        let shaken = Carried::new(path(rule), mount());
        assert_consistent(&format!("{rule:?} with a lever"), &rigid);
        assert_consistent(&format!("{rule:?} shaken"), &shaken);
        for most in [fly(&rigid), fly(&shaken)] {
            assert!(most < 8e-9, "{rule:?}: {most:e} m");
        }
    }
    let [pitching, _, _] = swings([(0.3, 0.4), (0.0, 1.0), (0.0, 1.0)]);
    let table = HarmonicTrajectory::<f64, 1>::new(Channels {
        roll: Channel::constant(0.1),
        pitch: Channel { harmonics: &pitching, ..Channel::constant(0.0) },
        yaw: Channel::steady(0.0, 0.3),
        latitude: Channel::steady(0.8, 2e-5),
        longitude: Channel::steady(0.1, 3e-5),
        altitude: Channel::constant(100.0),
    })
    .unwrap();
    let shaken = Carried::new(table, mount());
    assert_consistent("harmonics shaken", &shaken);
    assert!(fly(&shaken) < 8e-9);
}

#[test]
fn a_lever_leads_to_the_place_that_geometry_says() {
    // Against the Earth-fixed vectors in two-float numbers.
    let vehicle = path(Attitude::Stored);
    let lever = Vector::new(300.0, -200.0, 100.0);
    let unit = Carried::new(vehicle.clone(), Mount::<1>::rigid(lever));
    for k in 0..60 {
        let at = Pair::new(f64::from(k));
        let [from, to] = [vehicle.solution_at(at), unit.solution_at(at)];
        let (from, to) = (from.to_earth_fixed(), to.to_earth_fixed());
        let apart = to.position_e.zip(from.position_e, |a, b| (a.hi - b.hi) + (a.lo - b.lo));
        let attitude = from.attitude.map(|c| c.hi);
        let expected = attitude.matrix(1.0) * lever;
        assert!((apart - expected).norm() < 5e-9, "{k} s: {:e}", (apart - expected).norm());
    }
}

#[test]
fn a_stream_of_pieces_is_the_path_itself() {
    let whole = Piecewise::new(halves(), Attitude::Stored).unwrap();
    let pieces = halves().into_iter().map(Ok::<_, PathError>);
    let mut stream = Stream::<_, 8, 2>::new(pieces, Attitude::Stored);
    let quadrature = Quadrature::of_nodes(3);
    for n in 0..59 {
        let (from_s, to_s) = (f64::from(n) + 0.5, f64::from(n + 1) + 0.5);
        let to_s = to_s.min(60.0);
        stream.advance(from_s, to_s).unwrap();
        let of_stream = quadrature.increment(&stream, from_s, to_s);
        assert_eq!(of_stream, quadrature.increment(&whole, from_s, to_s), "{n}");
    }
    assert_eq!(stream.advance(10.0, 11.0), Err(StreamError::Past { start_s: 20.0 }));
    assert_eq!(stream.advance(59.0, 61.0), Err(StreamError::Ended { end_s: 60.0 }));
    let three = (0..3).map(|n| Ok::<_, PathError>(Piece::new(f64::from(n), f64::from(n + 1))));
    let mut narrow = Stream::<_, 8, 2>::new(three, Attitude::Stored);
    assert_eq!(narrow.advance(0.0, 2.5), Err(StreamError::TooManyPieces { room: 2 }));
}

#[test]
fn quadrature_ends_at_joints() {
    // A jump of the third derivative at 20 s, within a sample.
    let mut pieces = halves();
    let [_, late] = &mut pieces;
    for channel in 4..8 {
        // + 1e-4 (t − 20)³ = 1e-4 (u + 10)³
        for (power, factor) in [(0, 1000.0), (1, 300.0), (2, 30.0), (3, 1.0)] {
            late.coefficients[power][channel] += 1e-4 * factor;
        }
    }
    let path = Piecewise::new(pieces, Attitude::Stored).unwrap();
    let quadrature = Quadrature::of_nodes(6);
    let whole = quadrature.increment(&path, 19.9, 20.1);
    let parts = [quadrature.increment(&path, 19.9, 20.0), quadrature.increment(&path, 20.0, 20.1)];
    let apart = parts[0].angle_b + parts[1].angle_b - whole.angle_b;
    assert!(apart.norm() < 1e-16, "{:e}", apart.norm());
    // Across the joint the rule itself is off by far more.
    let early = Piecewise::new([halves()[0]], Attitude::Stored).unwrap();
    let unbroken = quadrature.increment(&early, 19.9, 20.1);
    assert!((unbroken.angle_b - whole.angle_b).norm() > 1e-9);
}

#[test]
fn what_is_no_path_is_refused() {
    let new = |pieces: &[Piece<8>], rule| Piecewise::new(pieces.to_vec(), rule).map(drop);
    assert_eq!(new(&[], Attitude::Stored), Err(PathError::Empty));
    let [a, b] = halves();
    assert_eq!(new(&[b, a], Attitude::Stored), Err(PathError::Order { piece: 1 }));
    let backwards = Piece { end_s: -1.0, ..a };
    assert_eq!(new(&[backwards], Attitude::Stored), Err(PathError::Order { piece: 0 }));
    let mut bad = b;
    bad.coefficients[7][2] = f64::NAN;
    assert_eq!(new(&[a, bad], Attitude::Stored), Err(PathError::NotFinite { piece: 1 }));
    let mut bad = b;
    bad.coefficients[0][..3].fill(0.0);
    for row in &mut bad.coefficients[1..] {
        row[..3].fill(0.0);
    }
    assert_eq!(new(&[a, bad], Attitude::Stored), Err(PathError::NotFinite { piece: 1 }));
    let mut still = Piece::<8>::new(0.0, 1.0);
    still.coefficients[0] = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    let slow = Err(PathError::Slow { time_s: 0.0, speed: 0.0 });
    assert_eq!(new(&[still], Attitude::Coordinated), slow);
    assert_eq!(new(&[still], Attitude::Stored), Ok(()));
    let bound = Piecewise::new([still], Attitude::Stored).unwrap().bound();
    assert_eq!(bound.bandwidth, 0.0);
}

#[test]
fn kinematics_of_a_motion_read_the_same() {
    for k in 0..20 {
        let motion = path(Attitude::Stored).at(f64::from(k));
        let (a, b) = (Kinematics::from(&motion).rates(), motion.rates());
        assert!((a.specific_force_b - b.specific_force_b).norm() < 5e-14);
        assert!((a.rate_ib_b - b.rate_ib_b).norm() < 1e-15);
    }
}
