//! Numbers: zeros of both signs, subnormals, no rotation at all.

use super::case::{Case, Check, Outcome};
use super::floor;
use schuler::drift::compare::drift;
use schuler::earth::{self, Geodetic, ROTATION_RATE};
use schuler::flight::plan;
use schuler::math::compensated::Pair;
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::sample::Increment;
use schuler::solution::{Euler, Solution};
use schuler_simulator::navigator::{self, Navigate, Unavailable};
use schuler_simulator::progress::CaseProgress;
use schuler_simulator::scene::{Axes, Navigator};
use schuler_simulator::units::ARCSECOND;

pub(super) const GROUP: &str = "numbers";
/// The least positive number.
pub(super) const SUBNORMAL: f64 = 5e-324;

/// The group's cases.
pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for frame in [Axes::LocalLevel, Axes::EarthFixed] {
        let name = frame.name();
        let mut add = |what: &str, run: fn(Axes, &CaseProgress) -> Outcome| {
            cases.push(Case::new(GROUP, format!("{what}, {name}"), move |p| run(frame, p)));
        };
        add("±0 and subnormals for zeros", |frame, _| zeros(frame));
        add("no rotation at all", no_rotation);
        add("a start of subnormals", |frame, _| subnormal_start(frame));
    }
    cases.push(Case::new(GROUP, "zeros on every input", |_| free_fall()));
    cases
}

pub(super) fn navigator(frame: Axes) -> Navigator {
    Navigator { frame, ..Navigator::default() }
}

/// 100 Hz with eight samples about the block.
pub(super) fn start(
    frame: Axes,
    initial: &Solution<f64>,
) -> Result<Box<dyn Navigate>, Unavailable> {
    let (window, order) = (plan::UNKNOWN, plan::HIGHEST_ORDER);
    navigator::start(&navigator(frame), window, order, Pair::new(100.0).reciprocal(), initial)
}

pub(super) fn at(latitude: f64, altitude: f64, attitude: Euler<f64>) -> Solution<f64> {
    let position = Geodetic { latitude, longitude: 0.5, altitude };
    Solution::new(position, Vector::ZERO, attitude)
}

pub(super) const TILTED: Euler<f64> = Euler { roll: 0.1, pitch: -0.2, yaw: 0.7 };

/// The end of a flight, from increments by their number, from 1.
pub(super) fn fly(
    frame: Axes,
    initial: &Solution<f64>,
    samples: u64,
    increment: &dyn Fn(u64) -> Increment<f64>,
) -> Result<Solution<f64>, String> {
    let mut flying = start(frame, initial).map_err(|error| error.to_string())?;
    let mut end = *initial;
    for n in 1..=samples {
        let taken = flying.push(&increment(n), &mut |_, row| end = *row);
        taken.map_err(|why| format!("sample {n}: {why}"))?;
    }
    flying.finish(&mut |_, row| end = *row);
    Ok(end)
}

/// The largest difference of any coordinate.
fn apart(a: &Solution<f64>, b: &Solution<f64>) -> f64 {
    let numbers = |s: &Solution<f64>| {
        let (p, v, q) = (s.position, s.velocity_ned, s.attitude);
        [p.latitude, p.longitude, p.altitude, v.x, v.y, v.z, q.w, q.v.x, q.v.y, q.v.z]
    };
    let pairs = numbers(a).into_iter().zip(numbers(b));
    let difference = |(a, b): (Pair<f64>, Pair<f64>)| ((a.hi - b.hi) + (a.lo - b.lo)).abs();
    pairs.map(difference).fold(0.0, |most, x| if x > most || x.is_nan() { x } else { most })
}

/// Input of −0, of ±5e-324 and of mixed signs does what input of 0 does.
fn zeros(frame: Axes) -> Outcome {
    let initial = at(0.7, 3000.0, TILTED);
    let end = |zero: &dyn Fn(u64) -> f64| {
        let axes = |n| Vector::new(zero(3 * n), zero(3 * n + 1), zero(3 * n + 2));
        fly(frame, &initial, 1000, &|n| Increment { angle_b: axes(n), velocity_b: axes(n + 7) })
    };
    let zero = end(&|_| 0.0)?;
    let mut checks = Vec::new();
    let signs = |x: f64| move |n: u64| if n.is_multiple_of(2) { x } else { -x };
    for (what, x) in [("±0", 0.0), ("±5e-324", SUBNORMAL), ("±1e-310", 1e-310)] {
        let measured = apart(&end(&signs(x))?, &zero);
        // 3000 roundings of a number that small, scaled by nothing above 10⁷.
        let why = "what is that small adds up to nothing";
        checks.push(Check::at_most(what, 1e-290, measured, "SI", why));
    }
    Ok(checks)
}

/// Nothing pulls but gravitation: the two frames, which share no equation of motion, fall alike.
fn free_fall() -> Outcome {
    let initial = at(0.7, 100e3, TILTED);
    let nothing = |_| Increment::default();
    let local = fly(Axes::LocalLevel, &initial, 6000, &nothing)?;
    let earth = fly(Axes::EarthFixed, &initial, 6000, &nothing)?;
    let off = drift(&local, &earth);
    // ½gt² less its decrease aloft and the Earth's turning away, to a thousandth of itself.
    let fallen = initial.position.altitude.hi - local.position.altitude.hi;
    let expected = 0.5 * earth::gravity(0.7_f64.sin(), 91e3) * 3600.0;
    let why = "both frames stand on the floor";
    let floor_m = floor::free_m(60.0);
    let attitude_arcsec = floor::attitude_arcsec(2.0 * floor_m, 0.0);
    Ok(vec![
        Check::at_most("frames apart", 2.0 * floor_m, off.position_ned.norm(), "m", why),
        Check::at_most(
            "attitudes apart",
            attitude_arcsec,
            off.attitude_ned.norm() / ARCSECOND,
            "arcsec",
            why,
        ),
        Check::at_most(
            "off ½gt²",
            0.2,
            100.0 * (fallen / expected - 1.0).abs(),
            "%",
            "γ at the mean height of the fall; its curvature and Coriolis add 0.1 %",
        ),
    ])
}

/// The gyro reads exactly 0 all the time: the body stands still among the stars and its case on the
/// Earth, so that the force it feels turns backwards about the Earth's axis. All of it in closed form.
fn no_rotation(frame: Axes, progress: &CaseProgress) -> Outcome {
    const SAMPLES: u64 = 180_000;
    let (interval_s, latitude, altitude) = (0.01, 0.7_f64, 1000.0);
    let initial = at(latitude, altitude, TILTED);
    let to_body = initial.attitude.map(|c| c.hi).conjugate().matrix(1.0);
    let (sine, cosine) = latitude.sin_cos();
    let axis = to_body * Vector::new(cosine, 0.0, -sine);
    let force = to_body * Vector::new(0.0, 0.0, -earth::gravity(sine, altitude));
    let along = axis * axis.dot(force);
    let across = force - along;
    // ∫R(p, ωt)f dt = f∥h + (2/ω)sin ½ωh (f⊥ cos ωt_m + p × f⊥ sin ωt_m)
    let chord = 2.0 * (0.5 * ROTATION_RATE * interval_s).sin() / ROTATION_RATE;
    let increment = |n: u64| {
        progress.reach(n, SAMPLES);
        let (s, c) = (ROTATION_RATE * interval_s * (n as f64 - 0.5)).sin_cos();
        let turned = across * c + axis.cross(across) * s;
        Increment { angle_b: Vector::ZERO, velocity_b: along * interval_s + turned * chord }
    };
    let end = fly(frame, &initial, SAMPLES, &increment)?;
    // Against north, east and down it has turned by −ωt about the axis.
    let turn = -ROTATION_RATE * interval_s * SAMPLES as f64;
    let (half_sine, half_cosine) = (0.5 * turn).sin_cos();
    let axis_ned = Vector::new(cosine, 0.0, -sine);
    let turned = Quaternion::new(half_cosine, axis_ned * half_sine).map(Pair::new);
    let mut truth = initial;
    truth.attitude = turned * initial.attitude;
    let off = drift(&end, &truth);
    let floor_m = floor::free_m(interval_s * SAMPLES as f64);
    Ok(vec![
        Check::at_most("position", floor_m, off.position_ned.norm(), "m", floor::FREE_WHY),
        Check::at_most(
            "attitude",
            floor::attitude_arcsec(floor_m, 0.0),
            off.attitude_ned.norm() / ARCSECOND,
            "arcsec",
            floor::ATTITUDE_WHY,
        ),
    ])
}

/// A latitude, a height and speeds of 5e-324 stay what they are: nothing.
fn subnormal_start(frame: Axes) -> Outcome {
    let at = |x: f64| {
        let position = Geodetic { latitude: x, longitude: -x, altitude: x };
        let attitude = Euler { roll: x, pitch: -x, yaw: x };
        Solution::new(position, Vector::new(x, -x, x), attitude)
    };
    let pull = earth::gravity(0.0, 0.0) * 0.01;
    let rest = |_| Increment {
        angle_b: Vector::new(ROTATION_RATE * 0.01, 0.0, 0.0),
        velocity_b: Vector::new(0.0, 0.0, -pull),
    };
    let exact = fly(frame, &at(0.0), 6000, &rest)?;
    let subnormal = fly(frame, &at(SUBNORMAL), 6000, &rest)?;
    let why = "what is that small adds up to nothing";
    Ok(vec![
        Check::at_most("apart", 1e-290, apart(&subnormal, &exact), "SI", why),
        Check::at_most(
            "position",
            floor::free_m(60.0),
            drift(&subnormal, &at(0.0)).position_ned.norm(),
            "m",
            floor::FREE_WHY,
        ),
    ])
}
