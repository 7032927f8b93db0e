//! The perfect unit: reference values, the way back to the trajectory, and its quadrature.

use schuler::earth::{Geodetic, ROTATION_RATE, gravity};
use schuler::imu::{self, Quadrature};
use schuler::math::compensated::Pair;
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::trajectory::Trajectory;
use schuler_simulator::scene::builtin;
use schuler_simulator::source;

fn course(name: &str) -> (source::Course, f64, f64) {
    let scene = builtin::scene(name).unwrap();
    (scene.trajectory.build().unwrap(), 1.0 / scene.rate_hz, scene.duration_s)
}

/// The flights of channels; those of paths have another rule of quadrature, and tests of their own.
fn harmonic() -> impl Iterator<Item = &'static str> {
    let is_harmonic = |name: &&str| builtin::scene(name).unwrap().trajectory.path.is_none();
    builtin::names().map(|(name, _)| name).filter(is_harmonic)
}

/// To 1e-13 of the vector's norm.
fn assert_close(what: &str, computed: Vector<f64>, expected: [f64; 3]) {
    let expected = Vector::from(expected);
    let relative = (computed - expected).norm() / expected.norm();
    assert!(relative <= 1e-13, "{what}: {computed:?} {expected:?}, {relative:e}");
}

/// The paper's flight, by 40-digit arithmetic.
#[test]
fn the_papers_reference_values() {
    let (course, ..) = course("paper-perfect");
    for (t, rate, force) in [
        (
            0.0,
            [5.1385353190533822e-5, -8.5650590709813145e-6, -5.1026261453463316e-5],
            [0.40905172091920195, -1.0879426473577221, -9.7360780863444526],
        ),
        (
            900.0,
            [-3.3752204001276407e-5, -5.0131188033091496e-6, -6.684741453652235e-5],
            [0.27815304480666064, -0.77282575437242614, -9.7609690628931359],
        ),
        (
            1800.0,
            [-7.8440576089438452e-5, 0.0, -7.3868133803915847e-5],
            [-0.016324314439256415, -0.0022104332130107963, -9.7754215672774318],
        ),
    ] {
        let rates = imu::rates(&course.at(t));
        assert_close("rate", rates.rate_ib_b, rate);
        assert_close("force", rates.specific_force_b, force);
    }
    for (t, velocity) in [
        (900.0, [-343.35617226690709, -228.02645517701859, 1.2341341494884351]),
        (1800.0, [-485.1703951100221, -344.22269170453155, 1.7453292519943296]),
    ] {
        assert_close("velocity", course.at(t).velocity_ned(), velocity);
    }
}

#[test]
fn the_papers_first_increment() {
    let (course, interval, _) = course("paper-perfect");
    let planned = Quadrature::plan(course.bound().bandwidth, interval);
    for quadrature in [planned, planned.finest()] {
        let first = quadrature.increment(&course, 0.0, 0.05);
        let angle = [2.5691405027740412e-6, -4.2825066865656072e-7, -2.551336728075746e-6];
        let velocity = [0.020452556087286115, -0.054397073499093993, -0.48680394435968439];
        assert_close("angle", first.angle_b, angle);
        assert_close("velocity", first.velocity_b, velocity);
    }
}

/// Position, velocity relative to the Earth, body axes; all resolved in Earth-fixed axes.
#[derive(Clone, Copy)]
struct Flying([Vector<f64>; 5]);

impl Flying {
    fn plus(self, rate: Self, k: f64) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + rate.0[i] * k))
    }

    /// ṙ = v,  v̇ = C f + g − 2ω × v,  ċ = C(ω_ib × x̂) − ω × c of each body axis.
    fn rate(self, course: &source::Course, t: f64) -> Self {
        let Self([r, v, x, y, down]) = self;
        let rates = imu::rates(&course.at(t));
        let (w, f) = (rates.rate_ib_b, rates.specific_force_b);
        let place = Geodetic::from_earth_fixed(r);
        let ((s, c), (sl, cl)) = (place.latitude.sin_cos(), place.longitude.sin_cos());
        let fall = Vector::new(-c * cl, -c * sl, -s) * gravity(s, place.altitude);
        let omega = Vector::new(0.0, 0.0, ROTATION_RATE);
        let force = x * f.x + y * f.y + down * f.z;
        Self([
            v,
            force + fall - omega.cross(v) * 2.0,
            y * w.z - down * w.y - omega.cross(x),
            down * w.x - x * w.z - omega.cross(y),
            x * w.y - y * w.x - omega.cross(down),
        ])
    }
}

fn truth(course: &source::Course, t: f64) -> Flying {
    let at = course.at(t).initial().to_earth_fixed();
    let attitude: Quaternion<f64> = at.attitude.map(Pair::widen);
    let [x, y, z] = attitude.matrix(1.0).transpose().rows;
    Flying([at.position_e.map(Pair::widen), at.velocity_e.map(Pair::widen), x, y, z])
}

/// Runge and Kutta's fourth-order method on the equations of navigation leads along the trajectory.
#[test]
fn rates_integrate_back_to_the_trajectory() {
    for (name, from, seconds, steps) in [
        ("paper-perfect", 0.0, 60.0, 3000),
        ("hard", 0.0, 5.0, 5000),
        ("manoeuvre", 3.0, 5.0, 5000),
        ("vibration", 3.0, 2.0, 8000),
        ("cruise-180", 890.0, 20.0, 2000),
        ("polar", 295.0, 10.0, 2000),
        ("sea-state", 0.0, 20.0, 4000),
    ] {
        let (course, ..) = course(name);
        let step = seconds / f64::from(steps);
        let mut x = truth(&course, from);
        for k in 0..steps {
            let t = from + f64::from(k) * step;
            let a = x.rate(&course, t);
            let b = x.plus(a, step / 2.0).rate(&course, t + step / 2.0);
            let c = x.plus(b, step / 2.0).rate(&course, t + step / 2.0);
            let d = x.plus(c, step).rate(&course, t + step);
            let sum = a.plus(b, 2.0).plus(c, 2.0).plus(d, 1.0);
            x = x.plus(sum, step / 6.0);
        }
        let end = truth(&course, from + seconds);
        let miss: [f64; 5] = std::array::from_fn(|i| (x.0[i] - end.0[i]).norm());
        assert!(miss[0] < 5e-7, "{name}: {miss:?} m");
        assert!(miss[1] < 1e-7, "{name}: {miss:?} m/s");
        assert!(miss[2..].iter().all(|&m| m < 1e-10), "{name}: {miss:?}");
    }
}

/// Boole's rule on 4·n equal steps, on what the rates change: so that rounding stays small.
fn boole(course: &source::Course, from: f64, to: f64, n: u32) -> Increment<f64> {
    let base = imu::rates(&course.at(from));
    let mut sum = Increment {
        angle_b: base.rate_ib_b * (to - from),
        velocity_b: base.specific_force_b * (to - from),
    };
    let step = (to - from) / f64::from(4 * n);
    for i in 0..=4 * n {
        let weight = match i % 4 {
            _ if i == 0 || i == 4 * n => 7.0,
            0 => 14.0,
            2 => 12.0,
            _ => 32.0,
        };
        let rates = imu::rates(&course.at(from + f64::from(i) * step));
        let k = weight * step * 2.0 / 45.0;
        sum.angle_b = sum.angle_b + (rates.rate_ib_b - base.rate_ib_b) * k;
        sum.velocity_b = sum.velocity_b + (rates.specific_force_b - base.specific_force_b) * k;
    }
    sum
}

#[test]
fn increments_are_the_integrals_of_the_rates() {
    for name in harmonic() {
        let (course, interval, duration) = course(name);
        // Also at a much lower rate, where more nodes and panels are planned.
        for interval in [interval, 20.0 * interval] {
            let quadrature = Quadrature::plan(course.bound().bandwidth, interval);
            for k in 0..20 {
                let from = duration * f64::from(k) / 21.0;
                let to = from + interval;
                let planned = quadrature.increment(&course, from, to);
                let fine = boole(&course, from, to, 256);
                // Relative to the way there and back: a whole period of coning ends where it began.
                let (first, last) = (imu::rates(&course.at(from)), imu::rates(&course.at(to)));
                let rate = first.rate_ib_b.norm() + last.rate_ib_b.norm();
                let force = first.specific_force_b.norm() + last.specific_force_b.norm();
                for (a, b, scale) in [
                    (planned.angle_b, fine.angle_b, rate / 2.0),
                    (planned.velocity_b, fine.velocity_b, force / 2.0),
                ] {
                    let relative = (a - b).norm() / (scale * interval);
                    // The nodes' times are rounded too.
                    let rounding = 8e-15 + f64::EPSILON * from * course.bound().bandwidth;
                    assert!(relative <= rounding, "{name} {from}: {relative:e}");
                }
            }
        }
    }
}

/// More nodes change nothing: over many samples, so that rounding averages out and a bias would not.
#[test]
fn a_planned_quadrature_leaves_nothing_out() {
    for name in harmonic() {
        let (course, interval, _) = course(name);
        let bandwidth = course.bound().bandwidth;
        let planned = Quadrature::plan(bandwidth, interval);
        for finer in [planned.finest(), Quadrature::plan(3.0 * bandwidth, interval)] {
            let mut gap = Increment::default();
            let mut path = [0.0; 2];
            let samples = 2000;
            for n in 0..samples {
                let (from, to) = (f64::from(n) * interval, f64::from(n + 1) * interval);
                let (a, b) =
                    (planned.increment(&course, from, to), finer.increment(&course, from, to));
                gap.angle_b = gap.angle_b + (a.angle_b - b.angle_b);
                gap.velocity_b = gap.velocity_b + (a.velocity_b - b.velocity_b);
                path[0] += b.angle_b.norm();
                path[1] += b.velocity_b.norm();
            }
            let relative = [gap.angle_b.norm() / path[0], gap.velocity_b.norm() / path[1]];
            assert!(relative.iter().all(|&r| r <= 1e-16), "{name}: {relative:?}");
        }
        assert!(planned.evaluations() <= planned.finest().evaluations(), "{name}");
    }
    // What does not change needs one evaluation; what is fast takes panels.
    assert_eq!(Quadrature::plan(0.0, 0.05).evaluations(), 1);
    assert!(Quadrature::plan(1000.0, 0.05).evaluations() > 40);
}
