//! Fine alignment against the limits of theory, in ensembles that are small here.

use super::bases::{ARCMINUTE, LATITUDE, Motion, Read, SENSORS, align, read, settings};
use schuler::aiding::alignment::aligned::Aligned;
use schuler::aiding::alignment::base::Base;
use schuler::aiding::alignment::fine::Fine15;
use schuler::aiding::alignment::verdict::AlignmentFault;
use schuler::aiding::surroundings::Surroundings;
use schuler::math::real::{Real, Scalar};
use schuler::prelude::*;
use schuler::units::DEGREE;

const RUNS: u64 = 12;

/// Runs from a first attitude that is off by so much: level, heading.
fn runs(
    motion: Motion,
    base: Base<f64>,
    off: [f64; 2],
    heading_sigma: f64,
    times: &[f64],
) -> Vec<Vec<Read>> {
    let (perfect, truth) = motion.perfect(times[times.len() - 1]);
    let first = Euler::from_quaternion(truth[0]);
    let first =
        Euler { roll: first.roll + off[0], pitch: first.pitch - off[0], yaw: first.yaw + off[1] };
    let hz = motion.rate_hz();
    let velocity = if motion == Motion::Swaying { 0.3 } else { 1e-3 };
    let settings = settings(base, 0.01, heading_sigma, velocity);
    let navigator = Navigator4::from_rate_hz(hz).unwrap();
    let one = |run| {
        let samples = read(&perfect, hz, run, &SENSORS);
        if let Base::Swaying { .. } = base {
            align::<f64, _, 21, 231, 6>(navigator, motion, &samples, &truth, first, settings, times)
        } else {
            align::<f64, _, 15, 120, 0>(navigator, motion, &samples, &truth, first, settings, times)
        }
    };
    (0..RUNS).map(one).collect()
}

/// The claimed σ of the heading in minutes of arc, after checking that errors are as large as claimed.
fn checked(runs: &[Vec<Read>], at: usize) -> f64 {
    let n = RUNS as f64;
    let nees = runs.iter().map(|reads| reads[at].nees).sum::<f64>() / (3.0 * n);
    // χ² of 36 degrees of freedom: 17.9 and 64.0 at 99 %.
    assert!((0.497..1.777).contains(&nees), "NEES {nees}");
    for reads in runs {
        assert_eq!(reads[at].refused, 0);
        assert!(reads[at].residual < 1.1, "residual {}", reads[at].residual);
    }
    let square = runs.iter().map(|reads| reads[at].sigma[2].powi(2)).sum::<f64>() / n;
    square.sqrt() / ARCMINUTE
}

#[test]
fn a_still_vehicle_reaches_the_limit() {
    let times = [60.0, 120.0, 300.0];
    let runs = runs(Motion::Still, Base::still(), [0.005, 5.0 * DEGREE], 0.09, &times);
    let here = Surroundings::at(&Motion::Still.place());
    for (at, time) in times.into_iter().enumerate() {
        let limit = SENSORS.heading(&here, time) / ARCMINUTE;
        let sigma = checked(&runs, at);
        let bound = if time < 100.0 { 1.15 } else { 1.08 };
        assert!((0.97..bound).contains(&(sigma / limit)), "{time} s: {sigma}′ of {limit}′");
    }
}

#[test]
fn a_heading_that_is_found_tells_nothing_of_the_level() {
    // At rest no measurement tells a tilt from a bias of the accelerometers, however far the heading is corrected.
    let here = Surroundings::at(&Motion::Still.place());
    let limit = SENSORS.level(&here);
    for heading in [0.0, 20.0, -60.0] {
        let off = [0.005, heading * DEGREE];
        for reads in runs(Motion::Still, Base::still(), off, 0.09, &[60.0]) {
            for sigma in &reads[0].sigma[..2] {
                assert!((sigma / limit - 1.0).abs() < 0.01, "{heading}°: {sigma:e} of {limit:e}");
            }
        }
    }
}

#[test]
fn half_a_turn_wrong_it_finds_the_same() {
    let runs = runs(Motion::Still, Base::still(), [0.01, 180.0 * DEGREE], 1.8, &[300.0]);
    let here = Surroundings::at(&Motion::Still.place());
    let limit = SENSORS.heading(&here, 300.0) / ARCMINUTE;
    let sigma = checked(&runs, 0);
    assert!(sigma < 1.1 * limit, "{sigma}′ of {limit}′");
}

#[test]
fn a_vehicle_that_turns_shows_its_biases() {
    let motion = Motion::Turning(3.0 * DEGREE);
    let runs = runs(motion, Base::still(), [0.005, 5.0 * DEGREE], 0.09, &[300.0]);
    let here = Surroundings::at(&motion.place());
    let limit = SENSORS.heading_turning(&here, 300.0) / ARCMINUTE;
    let sigma = checked(&runs, 0);
    assert!((0.97..1.08).contains(&(sigma / limit)), "{sigma}′ of {limit}′");
}

#[test]
fn a_swaying_vehicle_is_aligned_by_a_resonator() {
    let runs = runs(Motion::Swaying, Base::swaying(), [0.005, 5.0 * DEGREE], 0.09, &[300.0]);
    let sigma = checked(&runs, 0);
    assert!(sigma < 4.3, "{sigma}′");
}

/// A vehicle at rest, aligned in some precision.
fn at_rest<R: Scalar + Real<Mask = bool>>() -> Vec<Read> {
    let motion = Motion::Still;
    let (perfect, truth) = motion.perfect(60.0);
    let samples = read(&perfect, motion.rate_hz(), 0, &SENSORS);
    let first = Euler::from_quaternion(truth[0]);
    let navigator = Navigator4::<R>::from_rate_hz(motion.rate_hz()).unwrap();
    let settings = settings(Base::still(), 0.01, 0.09, 1e-3);
    align::<R, _, 15, 120, 0>(navigator, motion, &samples, &truth, first, settings, &[20.0, 60.0])
}

#[test]
fn single_precision_claims_what_double_does() {
    let (single, double) = (at_rest::<f32>(), at_rest::<f64>());
    for (one, other) in single.iter().zip(&double) {
        for axis in 0..3 {
            let apart = (one.sigma[axis] / other.sigma[axis] - 1.0).abs();
            assert!(apart < 1e-3, "axis {axis}: {apart:e}");
        }
    }
}

fn fine(latitude: f64) -> Result<Fine15<Navigator4<f64>>, AlignmentFault> {
    let place = Geodetic { latitude, longitude: 0.0, altitude: 0.0 };
    let settings = settings(Base::still(), 0.01, 1.8, 1e-3);
    Fine15::new(Navigator4::from_rate_hz(10.0).unwrap(), Pair::of(0.1), &place, settings)
}

#[test]
fn a_pole_and_broken_samples_are_refused() {
    assert_eq!(fine(89.0 * DEGREE).unwrap_err(), AlignmentFault::Pole);
    let fine = fine(LATITUDE).unwrap();
    let mut state = fine.start(Euler::default()).unwrap();
    let before = fine.aligned(&state);
    let broken = Increment { angle_b: Vector::new(f64::NAN, 0.0, 0.0), velocity_b: Vector::ZERO };
    assert!(matches!(fine.push(&mut state, broken), Err(AlignmentFault::Rejected(_))));
    assert_eq!(fine.aligned(&state), before);
}

#[test]
fn residuals_fit_up_to_five_of_their_spread() {
    let fine = fine(LATITUDE).unwrap();
    let aligned = fine.aligned(&fine.start(Euler::default()).unwrap());
    // χ² of 1800 degrees of freedom, by its number: σ is 1/30.
    let fits = |residual| Aligned { residual, accepted: 600, ..aligned }.fits();
    assert!(fits(0.5) && fits(1.1666) && !fits(1.1667) && !fits(f64::NAN));
}

#[test]
fn a_vehicle_that_drives_off_is_told() {
    let motion = Motion::Still;
    let (perfect, truth) = motion.perfect(90.0);
    let mut samples = read(&perfect, motion.rate_hz(), 0, &SENSORS);
    // After a minute it gains 0.3 m/s.
    for sample in samples.iter_mut().skip(600).take(10) {
        sample.velocity_b.x += 0.03;
    }
    let fine = fine(LATITUDE).unwrap();
    let mut state = fine.start(Euler::from_quaternion(truth[0])).unwrap();
    for sample in samples {
        fine.push(&mut state, sample).unwrap();
    }
    let moved_s = fine.aligned(&state).moved_s.unwrap();
    assert!((60.0..70.0).contains(&moved_s), "{moved_s}");
}
