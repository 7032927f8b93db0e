//! The linear error model against differences of full nonlinear navigation solutions.

use schuler::drift::compare::Drift;
use schuler::drift::linear::{ErrorDynamics, ErrorState};
use schuler::drift::meridian::MeridianShift;
use schuler::imu;
use schuler::math::vector::Vector;
use schuler::sample::Rates;
use schuler::trajectory::harmonic::{Channel, Channels, Harmonic, HarmonicTrajectory};
use schuler::trajectory::{Motion, Trajectory};

type Course = HarmonicTrajectory<f64, 8>;

/// Fast, climbing, turning flight at 57° N: every term of the model counts.
fn course() -> Course {
    let wave = |amplitude, angular_rate, phase| [Harmonic { amplitude, angular_rate, phase }];
    let (roll, pitch, yaw) = (wave(0.9, 0.21, 0.3), wave(0.5, 0.13, 1.0), wave(1.5, 0.05, 2.0));
    let (latitude, longitude, altitude) =
        (wave(1e-5, 0.11, 0.5), wave(2e-5, 0.09, 0.9), wave(90.0, 0.17, 0.1));
    let channel = |offset, rate, harmonics| Channel { offset, rate, harmonics };
    HarmonicTrajectory::new(Channels {
        roll: channel(0.1, 0.0, &roll),
        pitch: channel(-0.2, 0.0, &pitch),
        yaw: channel(0.7, 0.02, &yaw),
        latitude: channel(1.0, 1.2e-4, &latitude),
        longitude: channel(2.0, 2.5e-4, &longitude),
        altitude: channel(12_000.0, 40.0, &altitude),
    })
    .unwrap()
}

const DURATION_S: f64 = 200.0;

/// Latitude, longitude, altitude; north, east, down velocity; C_bⁿ by rows.
type Navigation = [f64; 15];

/// The navigation equations in geodetic coordinates (Titterton & Weston, 2nd ed., §3.5.3).
fn navigation_rate(x: &Navigation, rate: Vector<f64>, force: Vector<f64>) -> Navigation {
    let [latitude, _, h, v_n, v_e, v_d, ..] = *x;
    let (s, c) = latitude.sin_cos();
    let (a, f, w_ie) = (6378137.0, 1.0 / 298.257223563, 7.292115e-5);
    let e2 = f * (2.0 - f);
    let w2: f64 = 1.0 - e2 * s * s;
    let (r_n, r_m) = (a / w2.sqrt(), a * (1.0 - e2) / w2.powf(1.5));
    let bracket =
        1.0 - 2.0 / a * (1.0 + f + 0.00344978650684 - 2.0 * f * s * s) * h + 3.0 * h * h / (a * a);
    let gravity = 9.7803253359 * (1.0 + 0.00193185265241 * s * s) / w2.sqrt() * bracket;
    let row = |i: usize| Vector::new(x[6 + 3 * i], x[7 + 3 * i], x[8 + 3 * i]);
    let force_n = [row(0).dot(force), row(1).dot(force), row(2).dot(force)];
    let (latitude_rate, longitude_rate) = (v_n / (r_m + h), v_e / ((r_n + h) * c));
    let turn = longitude_rate + 2.0 * w_ie;
    let mut y = [0.0; 15];
    y[0] = latitude_rate;
    y[1] = longitude_rate;
    y[2] = -v_d;
    y[3] = force_n[0] - turn * s * v_e + latitude_rate * v_d;
    y[4] = force_n[1] + turn * (s * v_n + c * v_d);
    y[5] = force_n[2] - turn * c * v_e - latitude_rate * v_n + gravity;
    // Ċ = C[ω_ib×] − [ω_in×]C
    let w_in = [(w_ie + longitude_rate) * c, -latitude_rate, -(w_ie + longitude_rate) * s];
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let turned = row(i).cross(rate) - row(k) * w_in[j] + row(j) * w_in[k];
        y[6 + 3 * i..9 + 3 * i].copy_from_slice(&turned.into_array());
    }
    y
}

/// Runge and Kutta's fourth-order step.
fn runge_kutta<T: Copy>(
    y: T,
    t: f64,
    h: f64,
    sum: impl Fn(&T, &T, f64) -> T,
    rate: impl Fn(f64, &T) -> T,
) -> T {
    let a = rate(t, &y);
    let b = rate(t + h / 2.0, &sum(&y, &a, h / 2.0));
    let c = rate(t + h / 2.0, &sum(&y, &b, h / 2.0));
    let d = rate(t + h, &sum(&y, &c, h));
    let y = sum(&sum(&y, &a, h / 6.0), &b, h / 3.0);
    sum(&sum(&y, &c, h / 3.0), &d, h / 6.0)
}

fn start(motion: &Motion<f64>) -> Navigation {
    let solution = motion.solution();
    let v = motion.velocity_ned();
    let [a, b, c] = solution.attitude.map(|c| c.hi).matrix(1.0).rows;
    [
        motion.latitude.value,
        motion.longitude.value,
        motion.altitude.value,
        v.x,
        v.y,
        v.z,
        a.x,
        a.y,
        a.z,
        b.x,
        b.y,
        b.z,
        c.x,
        c.y,
        c.z,
    ]
}

fn radii(motion: &Motion<f64>) -> (f64, f64) {
    let (s, c) = motion.latitude.value.sin_cos();
    let radii = schuler::earth::Radii::at(s, c);
    let h = motion.altitude.value;
    (radii.meridian + h, (radii.prime_vertical + h) * c)
}

/// Flies the nonlinear equations with a start and sensors that are off.
fn fly(course: &Course, off: &Drift, sensor: &Rates<f64>, held: bool) -> Navigation {
    let motion = course.at(0.0);
    let mut x = start(&motion);
    let (north_radius, axis_distance) = radii(&motion);
    x[0] += off.position_ned.x / north_radius;
    x[1] += off.position_ned.y / axis_distance;
    x[2] -= off.position_ned.z;
    for (x, dv) in x[3..6].iter_mut().zip(off.velocity_ned.into_array()) {
        *x += dv;
    }
    // C ← (I + [φ×])C, by columns
    for j in 0..3 {
        let column = Vector::new(x[6 + j], x[9 + j], x[12 + j]);
        let turned = column + off.attitude_ned.cross(column);
        [x[6 + j], x[9 + j], x[12 + j]] = turned.into_array();
    }
    let steps = 4000;
    let h = DURATION_S / f64::from(steps);
    for k in 0..steps {
        let rate = |t: f64, x: &Navigation| {
            let motion = course.at(t);
            let perfect = imu::rates(&motion);
            let (omega, force) = (
                perfect.rate_ib_b + sensor.rate_ib_b,
                perfect.specific_force_b + sensor.specific_force_b,
            );
            if !held {
                return navigation_rate(x, omega, force);
            }
            let mut x = *x;
            (x[2], x[5]) = (motion.altitude.value, -motion.altitude.first);
            let mut y = navigation_rate(&x, omega, force);
            (y[2], y[5]) = (0.0, 0.0);
            y
        };
        let sum = |x: &Navigation, y: &Navigation, k: f64| std::array::from_fn(|i| x[i] + k * y[i]);
        x = runge_kutta(x, f64::from(k) * h, h, sum, rate);
    }
    x
}

/// Half the difference of two flights, as a drift.
fn half_difference(motion: &Motion<f64>, plus: &Navigation, minus: &Navigation) -> [f64; 9] {
    let half = |i: usize| (plus[i] - minus[i]) / 2.0;
    let (north_radius, axis_distance) = radii(motion);
    // [φ×] = ½(C₊ − C₋)C̄ᵀ, its antisymmetric part
    let row =
        |x: &dyn Fn(usize) -> f64, i: usize| Vector::new(x(6 + 3 * i), x(7 + 3 * i), x(8 + 3 * i));
    let mean = |i: usize| (plus[i] + minus[i]) / 2.0;
    let entry = |i: usize, j: usize| row(&half, i).dot(row(&mean, j));
    let turn = |i: usize, j: usize| (entry(i, j) - entry(j, i)) / 2.0;
    [
        half(0) * north_radius,
        half(1) * axis_distance,
        -half(2),
        half(3),
        half(4),
        half(5),
        turn(2, 1),
        turn(0, 2),
        turn(1, 0),
    ]
}

/// Propagates the linear model from a start, driven as told.
fn propagate(
    course: &Course,
    off: &Drift,
    held: bool,
    drive: impl Fn(f64, &ErrorDynamics<f64>) -> ErrorState<f64>,
) -> ErrorState<f64> {
    let mut x = MeridianShift::new(&course.at(0.0)).error(off);
    let steps = 2000;
    let h = DURATION_S / f64::from(steps);
    for k in 0..steps {
        let rate = |t: f64, x: &ErrorState<f64>| {
            let motion = course.at(t);
            let dynamics = ErrorDynamics::new(&motion, &imu::rates(&motion), held);
            dynamics.growth(x) + drive(t, &dynamics)
        };
        x = runge_kutta(x, f64::from(k) * h, h, |x, y, k| *x + *y * k, rate);
    }
    x
}

/// Unit errors: nine of the start, six of the sensors, each of a size that stays linear.
fn perturbation(index: usize, sign: f64) -> (Drift, Rates<f64>) {
    const SIZES: [f64; 5] = [1.0, 1e-2, 1e-6, 1e-8, 1e-5];
    let mut values = [[0.0; 3]; 5];
    values[index / 3][index % 3] = sign * SIZES[index / 3];
    let [position_ned, velocity_ned, attitude_ned, rate_ib_b, specific_force_b] =
        values.map(Vector::from);
    (Drift { position_ned, velocity_ned, attitude_ned }, Rates { rate_ib_b, specific_force_b })
}

fn compare(held: bool) {
    let course = course();
    let end = course.at(DURATION_S);
    for index in (0..15).filter(|index| !(held && [2, 5].contains(index))) {
        let (off, sensor) = perturbation(index, 1.0);
        let (opposite, against) = perturbation(index, -1.0);
        let plus = fly(&course, &off, &sensor, held);
        let minus = fly(&course, &opposite, &against, held);
        let nonlinear = half_difference(&end, &plus, &minus);
        let x = propagate(&course, &off, held, |_, dynamics| dynamics.drive(&sensor));
        let drift = MeridianShift::new(&end).drift(&x);
        let position = drift.position_ned.into_array();
        let linear = [position, drift.velocity_ned.into_array(), drift.attitude_ned.into_array()];
        for (i, (l, n)) in linear.into_iter().flatten().zip(nonlinear).enumerate() {
            if held && [2, 5].contains(&i) {
                continue;
            }
            // What the differences of a position in radians cannot resolve: 1e-9 m.
            let floor = if i < 3 { 1e-8 } else { 1e-14 };
            assert!(
                (l - n).abs() <= 1e-4 * n.abs() + floor,
                "error {index}, component {i}: {l} {n}"
            );
        }
    }
}

#[test]
fn linear_model_is_the_derivative_of_the_navigation_equations() {
    compare(false);
}

#[test]
fn so_it_is_with_the_vertical_held() {
    compare(true);
}

/// x − G·e, driven by e, is the same as x, driven by ė.
#[test]
fn integral_of_a_sensor_error_may_stand_for_the_error() {
    let course = course();
    for sensor in 0..6 {
        let unit = perturbation(9 + sensor, 1.0).1;
        let times = |k: f64| Rates {
            rate_ib_b: unit.rate_ib_b * k,
            specific_force_b: unit.specific_force_b * k,
        };
        let w = 0.31;
        let none = Drift::default();
        let direct = propagate(&course, &none, false, |t, d| d.drive(&times(w * (w * t).cos())));
        let rest =
            propagate(&course, &none, false, |t, d| d.drive_of_integral(&times((w * t).sin())));
        let end = course.at(DURATION_S);
        let dynamics = ErrorDynamics::new(&end, &imu::rates(&end), false);
        let whole = rest + dynamics.drive(&times((w * DURATION_S).sin()));
        for (a, b) in direct.into_array().into_iter().zip(whole.into_array()) {
            assert!((a - b).abs() <= 1e-5 * a.abs() + 1e-12, "sensor {sensor}: {a} {b}");
        }
    }
}
