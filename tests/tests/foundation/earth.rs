//! The Earth against published figures of WGS-84, its gravity field and integrals of its curvature.
//!
//! Published: NIMA TR8350.2, 3rd ed., tables 3.3 to 3.6.

use schuler::earth::{
    ECCENTRICITY_SQUARED, Geodetic, ROTATION_RATE, Radii, SEMI_MAJOR_AXIS, gravity, rotation_ned,
};
use schuler::math::vector::Vector;
use schuler_tests::Numbers;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

fn radii(latitude: f64) -> Radii<f64> {
    Radii::at(latitude.sin(), latitude.cos())
}

/// ∫₀^{90°} by Simpson's rule.
fn over_a_quadrant(f: impl Fn(f64) -> f64) -> f64 {
    let n = 4000;
    let step = FRAC_PI_2 / f64::from(n);
    let weight = |i| if i == 0 || i == n { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
    (0..=n).map(|i| weight(i) * f(f64::from(i) * step)).sum::<f64>() * step / 3.0
}

#[test]
fn radii_as_published() {
    assert!((ECCENTRICITY_SQUARED - 6.69437999014e-3).abs() < 1e-14);
    // The polar radius of curvature c = 6399593.6258 m, both radii there; the equator's meridian.
    let pole = radii(FRAC_PI_2);
    assert!((pole.meridian - 6399593.6258).abs() < 5e-5);
    assert!((pole.prime_vertical - 6399593.6258).abs() < 5e-5);
    assert!((radii(0.0).meridian - 6335439.3273).abs() < 5e-5);
    assert_eq!(radii(0.0).prime_vertical, SEMI_MAJOR_AXIS);
    // 45°, 40 digits: a/√(1 − e²/2) and a(1 − e²)/(1 − e²/2)^1.5
    let middle = radii(FRAC_PI_4);
    assert!((middle.prime_vertical - 6388838.290121148).abs() < 2e-9);
    assert!((middle.meridian - 6367381.815619549).abs() < 2e-9);
    // The quarter of a meridian is 10001965.7293 m long.
    assert!((over_a_quadrant(|x| radii(x).meridian) - 10001965.7293).abs() < 5e-5);
}

#[test]
fn radii_slopes_are_their_derivatives() {
    for degrees in [-89.0, -45.0, -10.0, 0.0, 0.5, 30.0, 60.0, 89.9] {
        let (x, d) = (f64::to_radians(degrees), 1e-4);
        let (here, plus, minus) = (radii(x), radii(x + d), radii(x - d));
        let slope = (plus.meridian - minus.meridian) / (2.0 * d);
        assert!((here.meridian_slope - slope).abs() < 1e-3, "{degrees}");
        let slope = (plus.prime_vertical - minus.prime_vertical) / (2.0 * d);
        assert!((here.prime_vertical_slope - slope).abs() < 1e-3, "{degrees}");
    }
}

#[test]
fn gravity_as_published() {
    assert_eq!(gravity(0.0, 0.0), 9.7803253359);
    for pole in [1.0, -1.0] {
        assert!((gravity::<f64>(pole, 0.0) - 9.8321849379).abs() < 1.01e-10);
    }
    assert!((gravity(FRAC_PI_4.sin(), 0.0) - 9.806197769373237).abs() < 4e-15);
    // The mean over the ellipsoid is 9.7976432222 m/s².
    let area = |x: f64| radii(x).meridian * radii(x).prime_vertical * x.cos();
    let mean = over_a_quadrant(|x| gravity(x.sin(), 0.0) * area(x)) / over_a_quadrant(area);
    assert!((mean - 9.7976432222).abs() < 1e-9, "{mean}");
}

/// The field of the ellipsoid's mass by zonal harmonics, with its centrifugal part.
fn field(r: Vector<f64>) -> Vector<f64> {
    const GM: f64 = 3.986004418e14;
    // J₂, J₄, J₆ of the normal field
    let zonals = [(2, 1.082629821313e-3), (4, -2.37091222e-6), (6, 6.08347e-9)];
    let potential = |x: Vector<f64>| {
        let (length, sine) = (x.norm(), x.z / x.norm());
        let mut legendre = [1.0, sine, 0.0, 0.0, 0.0, 0.0, 0.0];
        for n in 2..7 {
            let k = n as f64;
            legendre[n] =
                ((2.0 * k - 1.0) * sine * legendre[n - 1] - (k - 1.0) * legendre[n - 2]) / k;
        }
        // V without its leading GM/r, which is differentiated by hand
        let tail =
            |(n, j): (usize, f64)| j * (SEMI_MAJOR_AXIS / length).powi(n as i32) * legendre[n];
        -GM / length * zonals.map(tail).iter().sum::<f64>()
    };
    let step = 100.0;
    let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vector::from);
    let slopes = unit.map(|u| (potential(r + u * step) - potential(r - u * step)) / (2.0 * step));
    let centrifugal = Vector::new(r.x, r.y, 0.0) * (ROTATION_RATE * ROTATION_RATE);
    Vector::from(slopes) - r * (GM / r.norm().powi(3)) + centrifugal
}

#[test]
fn gravity_is_the_fields_up_to_ten_kilometres() {
    for degrees in [0.0, 20.0, 45.0, 70.0, 90.0] {
        let latitude = f64::to_radians(degrees);
        for altitude in [0.0, 1000.0, 3500.0, 10_000.0] {
            let place = Geodetic { latitude, longitude: 0.3, altitude };
            let expected = field(place.to_earth_fixed()).norm();
            let miss = gravity(latitude.sin(), altitude) - expected;
            // Second order in h/a and first in f·h/a: 3e-7 m/s² are left at 10 km.
            assert!(miss.abs() < 1e-6, "{degrees}° {altitude} m: {miss:e}");
        }
    }
}

#[test]
fn earth_turns_about_its_axis() {
    for degrees in [-90.0, -30.0, 0.0, 45.0, 90.0] {
        let latitude = f64::to_radians(degrees);
        let rate = rotation_ned(latitude.sin(), latitude.cos());
        assert!((rate.norm() - 7.292115e-5).abs() < 2e-20);
        // Towards the north pole: along north at the equator, up at the pole.
        assert!((rate.x.atan2(-rate.z) - (FRAC_PI_2 - latitude)).abs() < 1e-15);
        assert_eq!(rate.y, 0.0);
    }
}

#[test]
fn earth_fixed_places_by_hand() {
    let at =
        |latitude, longitude, altitude| Geodetic { latitude, longitude, altitude }.to_earth_fixed();
    // b = 6356752.3142 m
    assert!((at(FRAC_PI_2, 1.0, 0.0) - Vector::new(0.0, 0.0, 6356752.314245179)).norm() < 2e-9);
    assert!((at(-FRAC_PI_2, 1.0, 5.0) - Vector::new(0.0, 0.0, -6356757.314245179)).norm() < 2e-9);
    assert_eq!(at(0.0, 0.0, 1.0), Vector::new(6378138.0, 0.0, 0.0));
    assert!((at(0.0, FRAC_PI_2, 0.0) - Vector::new(0.0, 6378137.0, 0.0)).norm() < 1e-9);
    assert!((at(0.0, -PI, 2.0) - Vector::new(-6378139.0, 0.0, 0.0)).norm() < 2e-9);
    // 45° N, 100° E, 3500 m, 40 digits
    let paper = Vector::new(PLACE[0], PLACE[1], PLACE[2]);
    assert!((at(FRAC_PI_4, 100.0_f64.to_radians(), 3500.0) - paper).norm() < 2e-9);
}

const PLACE: [f64; 3] = [-784901.1808707546, 4451395.7972687821, 4489823.2826000727];

#[test]
fn there_and_back_everywhere() {
    let mut numbers = Numbers(31);
    let ends = [-FRAC_PI_2, -FRAC_PI_4, -1e-9, 0.0, 1e-300, FRAC_PI_4, FRAC_PI_2 - 1e-9, FRAC_PI_2];
    let latitudes: Vec<f64> =
        ends.into_iter().chain((0..200).map(|_| numbers.within(FRAC_PI_2))).collect();
    for altitude in [-6e6, -1e5, -100.0, 0.0, 3500.0, 1e5, 1e6, 3.6e7] {
        for &latitude in &latitudes {
            let longitude = numbers.within(PI);
            let place = Geodetic { latitude, longitude, altitude };
            let r = place.to_earth_fixed();
            let back = Geodetic::from_earth_fixed(r);
            // An ulp of the place itself counts too, and one of 180° is 2.8e-9 m on the ellipsoid.
            let scale = r.norm() / 6.4e6;
            let (dp, dh) = (back.latitude - latitude, back.altitude - altitude);
            let radius = radii(latitude).meridian + altitude;
            assert!((dp * radius).abs() <= 4e-9 * scale.max(1.0), "{place:?}: {dp:e}");
            assert!(dh.abs() <= 4e-9 * scale.max(1.0), "{place:?}: {dh:e}");
            let again = back.to_earth_fixed();
            assert!((again - r).norm() <= 4e-9 * scale.max(1.0), "{place:?}: {again:?} {r:?}");
        }
    }
}

/// From 300 km off the Earth's centre on; nearer, three corrections do not do.
#[test]
fn there_and_back_deep_inside() {
    let mut numbers = Numbers(32);
    for distance in [3e5, 1e6, 3e6] {
        for _ in 0..200 {
            let direction = numbers.vector(1.0);
            let r = direction * (distance / direction.norm());
            let back = Geodetic::from_earth_fixed(r).to_earth_fixed();
            assert!((back - r).norm() <= 5e-9, "{distance}: {r:?} {back:?}");
        }
    }
}
