//! Motion: its derivatives by differences, its bounds, its way over the pole.

use schuler::imu;
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::trajectory::harmonic::{Channel, Channels, CourseError, Harmonic, HarmonicTrajectory};
use schuler::trajectory::{Jet, Motion, Trajectory, wrap};
use schuler_simulator::scene::builtin;
use schuler_simulator::source::Course;
use schuler_tests::Numbers;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The flights of channels; paths have tests of their own.
fn courses() -> impl Iterator<Item = (&'static str, Course, f64)> {
    builtin::names().filter_map(|(name, _)| {
        let scene = builtin::scene(name).unwrap();
        let course = scene.trajectory.build().unwrap();
        course.path().is_none().then_some((name, course, scene.duration_s))
    })
}

fn channels(motion: &Motion<f64>) -> [Jet<f64>; 6] {
    let Motion { roll, pitch, yaw, latitude, longitude, altitude } = *motion;
    [roll, pitch, yaw, latitude, longitude, altitude]
}

/// f′ by the central difference of fourth order.
fn slope(f: impl Fn(f64) -> f64, step: f64) -> f64 {
    (8.0 * (f(step) - f(-step)) - (f(2.0 * step) - f(-2.0 * step))) / (12.0 * step)
}

#[test]
fn derivatives_are_those_of_the_value() {
    for (name, course, duration) in courses() {
        // So that the step's fourth power and rounding both stay small.
        let step = 0.02 / course.bound().bandwidth.clamp(0.01, 100.0);
        for k in 0..20 {
            let t = duration * (f64::from(k) + 0.37) / 20.0;
            let jets = channels(&course.at(t));
            for (i, jet) in jets.into_iter().enumerate() {
                let at = |dt| channels(&course.at(t + dt))[i];
                let scale = jet.value.abs().max(1.0);
                let first = slope(|dt| at(dt).value, step);
                let second = slope(|dt| at(dt).first, step);
                let rounding = 4e-15 * scale / step;
                let bound = 1e-7 * jet.first.abs().max(at(0.3 * step).first.abs()) + rounding;
                assert!((jet.first - first).abs() <= bound, "{name} {i} {t}: {jet:?} {first}");
                let bound = 1e-6 * course.bound().bandwidth * jet.first.abs()
                    + 1e-6 * jet.second.abs()
                    + rounding;
                assert!((jet.second - second).abs() <= bound, "{name} {i} {t}: {jet:?} {second}");
            }
        }
    }
}

#[test]
fn a_channel_is_what_its_equation_says() {
    let tones = [
        Harmonic { amplitude: 0.5, angular_rate: 2.0, phase: 0.3 },
        Harmonic { amplitude: -0.25, angular_rate: 7.0, phase: -1.0 },
        Harmonic { amplitude: 0.125, angular_rate: 2.0, phase: 2.0 },
    ];
    let none = Channel { offset: 0.0, rate: 0.0, harmonics: &[] };
    let moving = Channel { offset: 3.0, rate: -0.5, harmonics: &tones };
    let course = HarmonicTrajectory::<f64, 6>::new(Channels {
        roll: none,
        pitch: moving,
        yaw: none,
        latitude: none,
        longitude: Channel { offset: 1.0, ..none },
        altitude: moving,
    })
    .unwrap();
    for t in [0.0, 0.7, 11.3, 1234.5] {
        let motion = course.at(t);
        let sum: f64 =
            tones.iter().map(|h| h.amplitude * (h.angular_rate * t + h.phase).cos()).sum();
        // An angle's rate comes without its whole turns, an altitude's as it is.
        let moved = 3.0 - 0.5 * t + sum;
        assert!(wrap(motion.pitch.value - moved).abs() < 1e-12);
        assert!((motion.altitude.value - moved).abs() < 1e-12);
        assert_eq!(motion.altitude.first, motion.pitch.first);
        assert_eq!(motion.altitude.second, motion.pitch.second);
        assert_eq!(motion.longitude, Jet { value: 1.0, first: 0.0, second: 0.0 });
        assert_eq!(motion.roll, Jet::default());
    }
    let full = Channels {
        roll: moving,
        pitch: moving,
        yaw: moving,
        latitude: none,
        longitude: none,
        altitude: none,
    };
    let error = HarmonicTrajectory::<f64, 8>::new(full).unwrap_err();
    assert_eq!(error, CourseError::TooManyHarmonics { room: 8 });
}

/// Whatever number of whichever channel is not finite, the channel is named.
#[test]
fn what_is_not_finite_is_refused() {
    let tone = Harmonic { amplitude: 0.5, angular_rate: 2.0, phase: 0.3 };
    let good = Channel { offset: 3.0, rate: -0.5, harmonics: &[tone] };
    let course = |channels: [Channel<'_, f64>; 6]| {
        let [roll, pitch, yaw, latitude, longitude, altitude] = channels;
        HarmonicTrajectory::<f64, 6>::new(Channels {
            roll,
            pitch,
            yaw,
            latitude,
            longitude,
            altitude,
        })
    };
    assert!(course([good; 6]).is_ok());
    for channel in 0..6 {
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let tones = [
                Harmonic { amplitude: x, ..tone },
                Harmonic { angular_rate: x, ..tone },
                Harmonic { phase: x, ..tone },
            ];
            let fast = Harmonic { amplitude: 1e200, angular_rate: 1e200, phase: 0.0 };
            let bad =
                [Channel { offset: x, ..good }, Channel { rate: x, ..good }].into_iter().chain(
                    tones
                        .iter()
                        .chain([&fast])
                        .map(|tone| Channel { harmonics: std::slice::from_ref(tone), ..good }),
                );
            for bad in bad {
                let mut channels = [good; 6];
                channels[channel] = bad;
                let error = course(channels).err();
                assert_eq!(error, Some(CourseError::NotFinite { channel }), "{bad:?}");
            }
        }
    }
}

/// Gravity changes on the way up: one sample's increment is not the next one's.
#[test]
fn a_steady_climb_has_a_bandwidth() {
    let mut scene = builtin::scene("stationary").unwrap().trajectory;
    assert_eq!(scene.build().unwrap().bound().bandwidth, 0.0);
    scene.altitude.rate = 10.0;
    let course = scene.build().unwrap();
    let force = |t: f64| imu::rates(&course.at(t)).specific_force_b.norm();
    for t in [0.0, 600.0] {
        let steepest = slope(|dt| force(t + dt), 10.0).abs();
        assert!(
            steepest > 0.0 && steepest <= course.bound().bandwidth * force(t),
            "{t}: {steepest:e}"
        );
    }
}

/// Derivatives of rate and specific force stay within the bandwidth times each component's range.
#[test]
fn bounds_hold_on_every_scene() {
    for (name, course, duration) in courses() {
        let bound = course.bound();
        let all = |t: f64| {
            let rates = imu::rates(&course.at(t));
            let (w, f) = (rates.rate_ib_b.into_array(), rates.specific_force_b.into_array());
            [w[0], w[1], w[2], f[0], f[1], f[2]]
        };
        let mut numbers = Numbers(52);
        let times: Vec<f64> = (0..4000).map(|_| numbers.within(duration).abs()).collect();
        let mut range = [(f64::MAX, f64::MIN); 6];
        for &t in &times {
            for (range, x) in range.iter_mut().zip(all(t)) {
                *range = (range.0.min(x), range.1.max(x));
            }
            let turn = imu::rates(&course.at(t)).rate_ib_b.norm();
            assert!(turn <= bound.angular_rate * (1.0 + 1e-12), "{name} {t}: {turn}");
        }
        let step = 0.02 / bound.bandwidth.clamp(0.001, 100.0);
        for &t in times.iter().step_by(7) {
            for i in 0..6 {
                let steepest = slope(|dt| all(t + dt)[i], step).abs();
                let range = range[i].1 - range[i].0;
                let size = all(t)[i].abs() + range;
                let most = bound.bandwidth * range + 1e-14 * size / step;
                assert!(steepest <= most, "{name} {t} {i}: {steepest:e} {most:e}");
            }
        }
    }
}

#[test]
fn angles_are_wrapped_into_half_a_turn_either_way() {
    let mut numbers = Numbers(51);
    for _ in 0..1000 {
        let x = numbers.within(50.0);
        let y = wrap(x);
        assert!(y.abs() <= PI);
        let turns = (x - y) / TAU;
        assert!((turns - turns.round()).abs() < 1e-14, "{x} {y}");
    }
    for x in [0.0, 1.0, -3.0, PI, -PI] {
        assert_eq!(wrap(x), x);
    }
}

fn moving(offset: f64, rate: f64) -> Channel<'static, f64> {
    Channel { offset, rate, harmonics: &[] }
}

/// Folding changes coordinates, not the motion: in Earth-fixed axes nothing jumps at a pole.
#[test]
fn over_either_pole_without_a_jump() {
    for sign in [1.0, -1.0] {
        let course = HarmonicTrajectory::<f64, 1>::new(Channels {
            roll: moving(0.2, 0.01),
            pitch: moving(-0.1, 0.002),
            yaw: moving(3.0, 0.001),
            latitude: moving(sign * (FRAC_PI_2 - 1e-4), sign * 1e-5),
            longitude: moving(2.5, 1e-4),
            altitude: moving(9000.0, 3.0),
        })
        .unwrap();
        for k in 0..=200 {
            let motion = course.at(0.1 * f64::from(k));
            let folded = motion.solution();
            let place = folded.position.map(|c| c.hi);
            assert!(place.latitude.abs() <= FRAC_PI_2 && place.longitude.abs() <= PI);
            let euler = folded.euler();
            assert!((euler.pitch - motion.pitch.value).abs() < 1e-14);
            assert!((euler.roll - motion.roll.value).abs() < 1e-14);

            // The same in the axes of the latitude that runs on, by hand.
            let (s, c) = motion.latitude.value.sin_cos();
            let (sl, cl) = motion.longitude.value.sin_cos();
            let [north, east, down] =
                [[-s * cl, -s * sl, c], [-sl, cl, 0.0], [-c * cl, -c * sl, -s]].map(Vector::from);
            let v = motion.velocity_ned();
            let at = folded.to_earth_fixed();
            let velocity = north * v.x + east * v.y + down * v.z;
            assert!((at.velocity_e.map(Pair::widen) - velocity).norm() < 1e-10, "{k}");
            let (sr, cr) = motion.pitch.value.sin_cos();
            let (sy, cy) = motion.yaw.value.sin_cos();
            let nose = north * (cr * cy) + east * (cr * sy) - down * sr;
            let forward = at.attitude.map(Pair::widen).matrix(1.0) * Vector::new(1.0, 0.0, 0.0);
            assert!((forward - nose).norm() < 1e-14, "{k}");
            // x = (N + h)cosφ cosλ needs no fold either.
            let n = schuler::earth::Radii::at(s, c).prime_vertical + motion.altitude.value;
            let p = at.position_e.map(Pair::widen);
            assert!((p.x - n * c * cl).hypot(p.y - n * c * sl) < 2e-9, "{k}");
            assert!(p.z * sign > 6e6);
        }
    }
}

#[test]
fn a_start_is_the_solution_to_twice_the_digits() {
    for (name, course, duration) in courses() {
        for t in [0.0, 0.3 * duration, duration] {
            let motion = course.at(t);
            let (start, printed) = (motion.initial(), motion.solution());
            assert_eq!(start.position, printed.position, "{name}");
            assert_eq!(start.velocity_ned, printed.velocity_ned, "{name}");
            let rest = start.attitude.map(|c| c.hi) - printed.attitude.map(|c| c.hi);
            assert!(rest.dot(rest).sqrt() < 5e-16, "{name}");
        }
    }
}
