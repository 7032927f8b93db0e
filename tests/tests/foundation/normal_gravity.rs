//! Normal gravity above the ellipsoid: its closed form against the potential's zonal harmonics, and the
//! table of what the series of height leaves out.

use schuler::earth::closed_form::{GRAVITATIONAL_CONSTANT, gravity_ned, neglected_ned};
use schuler::earth::{
    ECCENTRICITY_SQUARED, Geodetic, ROTATION_RATE, SEMI_MAJOR_AXIS, SEMI_MINOR_AXIS, gravity,
};
use schuler::math::vector::Vector;

const MICRO_G: f64 = 9.80665e-6;

/// ∇[GM/r (1 − Σ J₂ₙ (a/r)²ⁿ P₂ₙ(sin θ)) + ½ω²p²], north and down (Heiskanen & Moritz, 2-90 to 2-92).
fn by_harmonics(latitude: f64, altitude: f64) -> Vector<f64> {
    let (a, b, gm) = (SEMI_MAJOR_AXIS, SEMI_MINOR_AXIS, GRAVITATIONAL_CONSTANT);
    let e2 = ECCENTRICITY_SQUARED;
    // J₂ = ⅓e²(1 − ²⁄₁₅ m e′/q₀), m = ω²a²b/GM, q₀ as a series of e′: no cancellation
    let second = (e2 / (1.0 - e2)).sqrt();
    let q0: f64 = (1..20)
        .map(|n| {
            let (n, sign) = (f64::from(n), if n % 2 == 1 { 1.0 } else { -1.0 });
            sign * 2.0 * n / ((2.0 * n + 1.0) * (2.0 * n + 3.0)) * second.powf(2.0 * n + 1.0)
        })
        .sum();
    let m = ROTATION_RATE * ROTATION_RATE * a * a * b / gm;
    let j2 = e2 / 3.0 * (1.0 - 2.0 / 15.0 * m * second / q0);
    let at = Geodetic { latitude, longitude: 0.0, altitude }.to_earth_fixed();
    let (p, z) = (at.x, at.z);
    let r = p.hypot(z);
    let (t, u) = (z / r, p / r);
    let (mut radial, mut polar) = (-gm / (r * r), 0.0);
    // Legendre's polynomials and their derivatives by recurrence.
    let (mut before, mut now) = ((1.0, 0.0), (t, 1.0));
    for degree in 2..=20 {
        let k = f64::from(degree);
        let value = ((2.0 * k - 1.0) * t * now.0 - (k - 1.0) * before.0) / k;
        let slope = before.1 + (2.0 * k - 1.0) * now.0;
        (before, now) = (now, (value, slope));
        if degree % 2 == 0 {
            let n = k / 2.0;
            let sign = if degree % 4 == 2 { 1.0 } else { -1.0 };
            let j = sign * 3.0 * e2.powf(n) / ((2.0 * n + 1.0) * (2.0 * n + 3.0))
                * (1.0 - n + 5.0 * n * j2 / e2);
            let scale = gm / (r * r) * j * (a / r).powf(k);
            radial += (k + 1.0) * scale * value;
            polar -= scale * slope * u;
        }
    }
    let centrifugal = ROTATION_RATE * ROTATION_RATE * p;
    let from_axis = radial * u - polar * t + centrifugal;
    let to_pole = radial * t + polar * u;
    let (s, c) = latitude.sin_cos();
    Vector::new(to_pole * c - from_axis * s, 0.0, -(to_pole * s + from_axis * c))
}

#[test]
fn the_closed_form_is_the_harmonics_sum() {
    for latitude in [-90.0_f64, -60.0, -10.0, 0.0, 1e-3, 30.0, 45.0, 75.0, 89.999, 90.0] {
        let latitude = latitude.to_radians();
        for altitude in [-10_000.0, 0.0, 1.0, 10_000.0, 100_000.0, 1_000_000.0] {
            let apart = gravity_ned(latitude, altitude) - by_harmonics(latitude, altitude);
            assert!(apart.norm() < 1e-3 * MICRO_G, "{latitude} {altitude} {apart:?}");
        }
        // Somigliana's formula is exact where the height is 0.
        let ground = gravity_ned(latitude, 0.0);
        assert!((ground.z - gravity(latitude.sin(), 0.0)).abs() < 1e-3 * MICRO_G);
        assert!(ground.x.abs() < 1e-3 * MICRO_G);
    }
}

/// Every cell of the table in the documentation of [`gravity`].
#[test]
fn the_documented_limits_of_the_series_hold() {
    let text = include_str!("../../../core/src/earth.rs");
    let rows: Vec<Vec<f64>> = text
        .lines()
        .filter_map(|line| line.strip_prefix("/// | "))
        .filter_map(|line| {
            let mut cells = line.split('|').map(str::trim);
            let altitude = cells.next()?.strip_suffix(" km")?.parse().ok()?;
            let rest = cells.filter(|cell| !cell.is_empty()).map(|cell| cell.parse().unwrap());
            Some([altitude].into_iter().chain(rest).collect())
        })
        .collect();
    assert_eq!(rows.len(), 7);
    for row in rows {
        let [kilometres, equator, middle, pole, north] = row[..] else { panic!("{row:?}") };
        let lacks = |latitude: f64| {
            let whole = by_harmonics(latitude.to_radians(), kilometres * 1e3);
            let series = gravity(latitude.to_radians().sin(), kilometres * 1e3);
            let lacks = Vector::new(whole.x, whole.y, whole.z - series);
            let own = neglected_ned(latitude.to_radians(), kilometres * 1e3);
            assert!((lacks - own).norm() < 1e-3 * MICRO_G, "{latitude} {kilometres}");
            lacks * (1.0 / MICRO_G)
        };
        let [at_equator, half_way, at_pole] = [0.0, 45.0, 90.0].map(lacks);
        for (stated, is) in
            [(equator, at_equator.z), (middle, half_way.z), (pole, at_pole.z), (north, half_way.x)]
        {
            assert!((stated - is).abs() <= 1.1e-3 + 6e-4 * is.abs(), "{kilometres}: {stated} {is}");
        }
    }
}
