//! Each operation on the factors against the same on the full matrix.

use super::dense::{self, Matrix, N};
use schuler::aiding::covariance::ud::Ud;
use schuler::aiding::filter::Filter15;
use schuler::aiding::model::Model;
use schuler::aiding::states::Process;
use schuler::aiding::transition::{Stretch, Transition};
use schuler::prelude::*;

type Factors = Ud<f64, 15, 120>;

/// Numbers without a pattern.
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Factors with every covariance, and one state that is known exactly.
fn some(seed: u64) -> Factors {
    let mut next = numbers(seed);
    let mut ud = Factors::exact();
    for n in 0..N + 3 {
        let mut along: [f64; N] = core::array::from_fn(|_| next());
        along[11] = 0.0;
        ud.add_rank_one(1.0 + n as f64, along);
    }
    ud
}

fn full(ud: &Factors) -> Matrix {
    (0..N).map(|i| core::array::from_fn(|j| ud.covariance(i, j))).collect()
}

fn close(ud: &Factors, expected: &Matrix, what: &str) {
    for i in 0..N {
        for j in 0..N {
            let scale = (expected[i][i] * expected[j][j]).sqrt() + 1e-12;
            let apart = (ud.covariance(i, j) - expected[i][j]).abs();
            assert!(apart < 1e-12 * scale, "{what}: {i}, {j}: {apart:e} of {scale:e}");
        }
    }
}

#[test]
fn a_term_of_rank_one() {
    let mut next = numbers(5);
    let mut ud = some(1);
    let mut p = full(&ud);
    let along: [f64; N] = core::array::from_fn(|_| next());
    ud.add_rank_one(0.7, along);
    dense::add(&mut p, 0.7, &along);
    close(&ud, &p, "rank one");
    ud.add_variance(4, 2.5);
    p[4][4] += 2.5;
    close(&ud, &p, "variance");
    // What is known exactly stays so.
    let mut ud = some(1);
    let mut along = along;
    along[11] = 0.0;
    ud.add_rank_one(0.7, along);
    assert_eq!(ud.variance(11), 0.0);
}

#[test]
fn a_scalar_measurement() {
    let mut next = numbers(6);
    let h: [f64; N] = core::array::from_fn(|_| next());
    let mut ud = some(2);
    let p = full(&ud);
    let k = dense::gain(&p, &h, 0.3);
    let gain = ud.measure(&h, 0.3);
    for (a, b) in gain.along.iter().zip(k) {
        assert!((a / gain.variance - b).abs() < 1e-12);
    }
    close(&ud, &dense::measured(&p, &h, &k, 0.3), "measurement");
    assert!((gain.variance - 0.3 - some(2).variance_of(&h)).abs() < 1e-10);
    assert_eq!((ud.variance(11), gain.along[11]), (0.0, 0.0));
}

#[test]
fn a_map_of_consecutive_states() {
    let mut next = numbers(7);
    for first in [0, 3, 9, 12] {
        let map: [[f64; 3]; 3] = core::array::from_fn(|_| core::array::from_fn(|_| next()));
        let mut ud = some(3);
        let p = full(&ud);
        ud.map_states(first, &map);
        let mut a = dense::diagonal([1.0; N]);
        for i in 0..3 {
            for j in 0..3 {
                a[first + i][first + j] = map[i][j];
            }
        }
        close(&ud, &dense::mapped(&a, &p), "map");
    }
}

/// Φ and G·Q·Gᵀ of a transition as matrices.
pub fn matrices(transition: &Transition<f64>) -> Matrix {
    let mut phi = dense::diagonal([1.0; N]);
    for n in 0..N {
        let mut unit = [0.0; N];
        unit[n] = 1.0;
        let (x, b) = unit.split_at(9);
        let column = transition.of(x.try_into().unwrap(), b.try_into().unwrap());
        for (row, value) in column.into_iter().enumerate() {
            phi[row][n] = value;
        }
    }
    phi
}

#[test]
fn a_step() {
    let mut ud = some(4);
    let p = full(&ud);
    let stretch = Stretch {
        time_s: 0.3,
        rotation: Quaternion::new(0.0, Vector::new(0.05, -0.02, 0.1)).normalised_less_one(),
        velocity: Vector::new(0.5, 0.1, -3.0),
        position: Vector::new(0.07, 0.02, -0.4),
    };
    let transition = Transition::new(&stretch);
    let model = Model::new(0.03, 0.2, Process::constant(1.0), Process::constant(1.0));
    ud.propagate(&transition, &model.noise);
    let mut expected = dense::mapped(&matrices(&transition), &p);
    // Noise enters as ψ-noise does by Φ over half the step and δv-noise over half the time.
    let half = *transition.back() * stretch.velocity * 0.5;
    for axis in 0..3 {
        let e = [0, 1, 2].map(|n| f64::from(u8::from(n == axis)));
        let psi = Vector::new(e[0], e[1], e[2]);
        let v = psi.cross(half);
        dense::add(
            &mut expected,
            0.03 * 0.03 * 0.3,
            &[0.0, 0.0, 0.0, v.x, v.y, v.z, e[0], e[1], e[2]],
        );
        let r = e.map(|x| 0.15 * x);
        dense::add(&mut expected, 0.2 * 0.2 * 0.3, &[r[0], r[1], r[2], e[0], e[1], e[2]]);
    }
    close(&ud, &expected, "step");
}

#[test]
fn a_filter_without_uncertainty_stays_so() {
    let exact = Process::constant(0.0);
    let model = Model::new(0.0, 0.0, exact, exact);
    let mut filter = Filter15::<f32>::new(&model);
    let stretch = Stretch { time_s: 0.1, velocity: Vector::new(0.0, 0.0, -1.0), ..Stretch::NONE };
    filter.advance(&model, &Transition::new(&stretch));
    let mut ud = *filter.covariance();
    let gain = ud.measure(&[1.0; 15], 1.0);
    assert!((0..15).all(|n| ud.variance(n) == 0.0 && gain.along[n] == 0.0));
}
