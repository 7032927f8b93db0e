//! Φ against differences of the mechanization itself, in both frames.

use schuler::aiding::feedback::correction;
use schuler::aiding::surroundings::{Pose, Surroundings};
use schuler::aiding::transition::{Stretch, Transition};
use schuler::earth::ROTATION_RATE;
use schuler::prelude::*;
use schuler::strapdown::block::body::BodyMotion;

const INTERVAL_S: f64 = 0.01;
const SAMPLES: usize = 8;

/// A turn with a changing force.
fn sample(k: usize, gyro: Vector<f64>, force: Vector<f64>) -> Increment<f64> {
    let t = (k as f64 + 0.5) * INTERVAL_S;
    let rate = Vector::new(0.2 + 0.5 * t, -0.3, 0.4 - 0.8 * t) + gyro;
    let specific = Vector::new(2.0 - 3.0 * t, 1.0 + 2.0 * t, -9.5) + force;
    Increment { angle_b: rate * INTERVAL_S, velocity_b: specific * INTERVAL_S }
}

/// Position, inertial velocity and attitude in Earth-fixed axes.
fn fixed(solution: &Solution<f64>) -> (Vector<f64>, Vector<f64>, Quaternion<f64>) {
    let fixed = solution.to_earth_fixed();
    let whole = |v: Vector<Pair<f64>>| v.map(|c| c.hi + c.lo);
    let (r, v) = (whole(fixed.position_e), whole(fixed.velocity_e));
    let omega = Vector::new(0.0, 0.0, ROTATION_RATE);
    (r, v + omega.cross(r), fixed.attitude.map(|c| c.hi + c.lo))
}

/// The errors of one solution from another by their definition.
fn errors(computed: &Solution<f64>, truth: &Solution<f64>) -> [f64; 9] {
    let ((r1, v1, q1), (r, v, q)) = (fixed(computed), fixed(truth));
    let to_body = q.matrix(1.0).transpose();
    let (dr, dv) = (to_body * (r1 - r), to_body * (v1 - v));
    let psi = (q.conjugate() * q1).rotation_vector();
    [dr.x, dr.y, dr.z, dv.x, dv.y, dv.z, psi.x, psi.y, psi.z]
}

fn flown<M>(
    mechanization: &M,
    errors: &[f64; 15],
    start: &Solution<f64>,
) -> (Solution<f64>, Stretch<f64>)
where
    M: Mechanization<Real = f64, Body = BodyMotion<f64>>,
{
    let mut state = mechanization.start(start).unwrap();
    // The correction takes errors off: here they are to be put on.
    let here = Surroundings::at(&start.position.map(|c| c.hi));
    let put = correction(&errors.map(|x| -x), &Pose::of(start), &here);
    mechanization.correct(&mut state, &put).unwrap();
    let gyro = Vector::new(errors[9], errors[10], errors[11]);
    let force = Vector::new(errors[12], errors[13], errors[14]);
    let mut stretch = Stretch::NONE;
    for k in 0..SAMPLES {
        mechanization
            .push_blocks(&mut state, sample(k, gyro, force), |_, body, _| {
                stretch.add(body, 4.0 * INTERVAL_S);
            })
            .unwrap();
    }
    assert_eq!(M::integrated(&state), SAMPLES as u64);
    (mechanization.output(&state).solution(), stretch)
}

fn compare<M>(mechanization: &M)
where
    M: Mechanization<Real = f64, Body = BodyMotion<f64>>,
{
    let at = Geodetic { latitude: 0.9, longitude: -1.2, altitude: 2500.0 };
    let euler = Euler { roll: 0.4, pitch: -0.3, yaw: 2.0 };
    let start = Solution::new(at, Vector::new(120.0, -60.0, 8.0), euler);
    let (end, stretch) = flown(mechanization, &[0.0; 15], &start);
    let here = Surroundings::at(&at);
    let transition = Transition::new(&stretch).with_gradient(&here.gradient_b(&Pose::of(&end)));
    // Metres, m/s, rad, rad/s, m/s².
    let sizes = [30.0, 0.3, 1e-3, 1e-3, 0.1];
    for n in 0..15 {
        let size = sizes[n / 3];
        let mut x = [0.0; 15];
        let mut one = |size: f64| {
            x[n] = size;
            errors(&flown(mechanization, &x, &start).0, &end)
        };
        let (plus, minus) = (one(size), one(-size));
        let mut unit = [0.0; 15];
        unit[n] = size;
        let (nav, bias) = unit.split_at(9);
        let expected = transition.of(nav.try_into().unwrap(), bias.try_into().unwrap());
        for row in 0..9 {
            let difference = 0.5 * (plus[row] - minus[row]);
            // A fraction of the leading term. Of a bias Φ has the mean over the step, of the rest all.
            let (t, force) = (INTERVAL_S * SAMPLES as f64, 9.8);
            let (leading, fraction) = match (row / 3, n / 3) {
                (a, b) if a == b => (1.0, 2e-6),
                (0, 1) => (t, 1e-5),
                (1, 0) => (1e-6 * t, 3e-2),
                (1, 2) => (force * t, 1e-5),
                (0, 2) => (force * t * t / 2.0, 1e-4),
                (2, 3) | (1, 4) => (t, 1e-3),
                (1, 3) | (0, 4) if row < 3 => (t * t / 2.0, 2e-2),
                (1, 3) => (force * t * t / 2.0, 2e-2),
                (0, 3) => (force * t * t * t / 6.0, 2e-2),
                _ => (1.0, 1e-9),
            };
            let bound = leading * fraction * size;
            assert!(
                (difference - expected[row]).abs() < bound,
                "row {row} of error {n}: {difference:e} by difference, {:e} by Φ, {:e} apart, bound {bound:e}",
                expected[row],
                difference - expected[row],
            );
        }
    }
}

#[test]
fn the_transition_is_the_mechanizations_own_in_local_level_axes() {
    compare(&Navigator4::<f64>::from_rate_hz(1.0 / INTERVAL_S).unwrap());
}

#[test]
fn the_transition_is_the_mechanizations_own_in_earth_fixed_axes() {
    compare(&EarthFixedNavigator4::<f64>::from_rate_hz(1.0 / INTERVAL_S).unwrap());
}
