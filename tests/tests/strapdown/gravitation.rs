//! Gravitation with its carried latitude against the long way through geodetic coordinates.

use schuler::earth::{Geodetic, ROTATION_RATE, gravity};
use schuler::math::vector::Vector;
use schuler::strapdown::frame::gravitation::Latitude;
use schuler_tests::{Numbers, largest};
use std::f64::consts::{FRAC_PI_2, PI};

/// G = −γ n̂ + ω × (ω × r)
fn long_way(r: Vector<f64>) -> Vector<f64> {
    let place = Geodetic::from_earth_fixed(r);
    let ((s, c), (sl, cl)) = (place.latitude.sin_cos(), place.longitude.sin_cos());
    let normal = Vector::new(c * cl, c * sl, s);
    let turn = ROTATION_RATE * ROTATION_RATE;
    normal * -gravity(s, place.altitude) - Vector::new(turn * r.x, turn * r.y, 0.0)
}

fn miss(latitude: &mut Latitude<f64>, r: Vector<f64>) -> f64 {
    (latitude.gravitation(r) - long_way(r)).norm()
}

/// A few roundings of γ, 9.8 m/s².
const FLOOR: f64 = 4e-14;

fn at(degrees: f64) -> Latitude<f64> {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    Latitude { sine, cosine, change: 0.0 }
}

#[test]
fn along_a_path_one_step_does() {
    // 7 km/s northward for a quarter of an hour in blocks of 0.2 s, from −80° over the south pole, too.
    for (start, rate) in
        [(45.0_f64, 1e-3), (0.0, -1.1e-3), (-80.0, -1.1e-3), (89.9, 1e-3), (20.0, 0.0)]
    {
        // Where the geocentric latitude is `start`.
        let (s, c) = start.to_radians().sin_cos();
        let first = Geodetic::from_earth_fixed(Vector::new(c * 0.6, c * 0.8, s) * 6.38e6);
        let mut latitude = at(first.latitude.to_degrees());
        for k in 0..4500 {
            let angle = start.to_radians() + rate * 0.2 * f64::from(k);
            let (s, c) = angle.sin_cos();
            let radius = 6.38e6 + 3.0 * f64::from(k);
            let r = Vector::new(c * 0.6, c * 0.8, s) * radius;
            let gap = miss(&mut latitude, r);
            assert!(gap <= FLOOR, "{start} {k}: {gap:e}");
            let place = Geodetic::from_earth_fixed(r);
            assert!((latitude.sine - place.latitude.sin()).abs() < 5e-16, "{start} {k}");
            assert!((latitude.cosine - place.latitude.cos()).abs() < 5e-16, "{start} {k}");
        }
    }
}

#[test]
fn from_a_cold_start_anywhere() {
    let mut numbers = Numbers(81);
    for _ in 0..2000 {
        let place = Geodetic {
            latitude: numbers.within(FRAC_PI_2 - 1e-2),
            longitude: numbers.within(PI),
            altitude: numbers.within(2e4),
        };
        let r = place.to_earth_fixed();
        // A block's way off, 600 m, the first answer is right; 60 km off, the second is.
        let mut near = at((place.latitude + numbers.within(1e-4)).to_degrees());
        let gap = miss(&mut near, r);
        // Just under 5e-7 rad no second step is taken.
        assert!(gap <= 1.2e-13, "{place:?}: {gap:e}");
        let mut far = at((place.latitude + numbers.within(1e-2)).to_degrees());
        let first = miss(&mut far, r);
        let second = miss(&mut far, r);
        assert!(first <= 1e-6 && second <= FLOOR, "{place:?}: {first:e} {second:e}");
    }
}

#[test]
fn at_the_poles_and_at_the_equator() {
    for sign in [1.0, -1.0] {
        let pole = Vector::new(0.0, 0.0, sign * 6_356_752.314245179);
        for start in [sign * 90.0, sign * 89.999, sign * 89.5] {
            let mut latitude = at(start);
            latitude.gravitation(pole);
            let g = latitude.gravitation(pole);
            assert_eq!((g.x, g.y), (0.0, 0.0));
            assert!((g.z + sign * 9.8321849379).abs() < 1.1e-10, "{start}: {g:?}");
            assert!(latitude.cosine.abs() < 1e-15);
        }
        let near = Vector::new(1e-3, -2e-3, sign * 6.37e6);
        assert!(miss(&mut at(sign * 90.0), near) <= FLOOR);
    }
    let equator = Vector::new(0.0, 6378137.0, 0.0);
    let g = at(0.001).gravitation(equator);
    let expected = -(9.7803253359 + 6378137.0 * ROTATION_RATE * ROTATION_RATE);
    assert!((g - Vector::new(0.0, expected, 0.0)).norm() < FLOOR, "{g:?}");
}

#[test]
fn single_precision_to_its_own_floor() {
    let mut numbers = Numbers(82);
    let worst = largest((0..2000).map(|_| {
        let place = Geodetic {
            latitude: numbers.within(FRAC_PI_2),
            longitude: numbers.within(PI),
            altitude: numbers.within(1e4),
        };
        let r = place.to_earth_fixed().map(|c| c as f32);
        let (sine, cosine) = (place.latitude as f32).sin_cos();
        let g = Latitude { sine, cosine, change: 0.0 }.gravitation(r).map(f64::from);
        (g - long_way(r.map(f64::from))).norm()
    }));
    // Half an ulp of γ is 5e-7, and the height in metres is γ·2/a of it.
    assert!(worst < 1e-5, "{worst:e}");
}

#[test]
fn the_vertical_lifts_to_a_height() {
    let mut numbers = Numbers(83);
    for _ in 0..500 {
        let place = Geodetic {
            latitude: numbers.within(FRAC_PI_2),
            longitude: numbers.within(PI),
            altitude: numbers.within(1e4),
        };
        let (sine, cosine) = place.latitude.sin_cos();
        let r = place.to_earth_fixed();
        let wanted = numbers.within(1e4);
        let (up, lift) = Latitude { sine, cosine, change: 0.0 }.vertical(r, wanted);
        assert!((up.norm() - 1.0).abs() < 1e-15 && (lift - (wanted - place.altitude)).abs() < 4e-9);
        let lifted = Geodetic::from_earth_fixed(r + up * lift);
        assert!((lifted.altitude - wanted).abs() < 4e-9);
        assert!((lifted.latitude - place.latitude).abs() < 2e-15);
    }
}
