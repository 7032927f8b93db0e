//! The Earth: gravity, radii, coordinates, gravitation with its latitude, the meridian's step.

use super::big::{Big, big, largest};
use super::{Precision, Worst, ulp};
use schuler::earth::{self, Geodetic, Radii};
use schuler::math::real::Scalar;
use schuler::math::vector::Vector;
use schuler::strapdown::frame::gravitation::Latitude;
use schuler::strapdown::frame::meridian::{Meridian, curvature};
use schuler_tests::Numbers;

const TRIES: u32 = 500;

/// Everything in this file.
pub fn measure(worst: &mut Worst) {
    field::<f64>(worst);
    field::<f32>(worst);
    coordinates(worst);
    steps::<f64>(worst);
    steps::<f32>(worst);
}

fn e2() -> Big {
    let f = big(1.0) / big(298.257223563);
    f * (big(2.0) - f)
}

fn a() -> Big {
    big(6_378_137.0)
}

/// W² = 1 − e² sin²φ.
fn w2(sine: Big) -> Big {
    big(1.0) - e2() * sine * sine
}

/// γ(φ, h), by the formula of TR8350.2 from its constants as they are printed.
fn gravity(sine: Big, altitude: Big) -> Big {
    let (one, two) = (big(1.0), big(2.0));
    let decimal = |digits: f64, scale: f64| big(digits) / big(scale);
    let (f, m) = (one / big(298.257223563), decimal(344_978_650_684.0, 1e14));
    let (gamma, k) = (decimal(97_803_253_359.0, 1e10), decimal(193_185_265_241.0, 1e14));
    let s2 = sine * sine;
    let falling = two / a() * (one + f + m - two * f * s2) * altitude;
    let curved = big(3.0) * altitude * altitude / (a() * a());
    gamma * (one + k * s2) / w2(sine).sqrt() * (one - falling + curved)
}

fn field<R: Scalar + Precision>(worst: &mut Worst) {
    let mut numbers = Numbers(31);
    let mut check = |what: &str, computed: R, exact: Big| {
        let ulps = (big(computed.widen()) - exact).rough() / (ulp(exact.rough()) * R::ULP);
        worst.add(format!("{what} {}", R::NAME), ulps.abs());
    };
    for _ in 0..TRIES {
        let latitude = numbers.within(1.57);
        let (sine, cosine) = (R::narrow(latitude.sin()), R::narrow(latitude.cos()));
        let altitude = R::narrow(50_000.0 + numbers.within(50_000.0));
        let (s, c, h) = (big(sine.widen()), big(cosine.widen()), big(altitude.widen()));
        check("gravity", earth::gravity(sine, altitude), gravity(s, h));
        let w = w2(s).sqrt();
        let normal = a() / w;
        let meridian = a() * (big(1.0) - e2()) / (w * w * w);
        let radii = Radii::at(sine, cosine);
        check("R_N", radii.prime_vertical, normal);
        check("R_M", radii.meridian, meridian);
        check("dR_M/dφ", radii.meridian_slope, big(3.0) * meridian * e2() * s * c / (w * w));
        check("dR_N/dφ", radii.prime_vertical_slope, normal * e2() * s * c / (w * w));
        check("1/W − 1", curvature(sine), big(1.0) / w - big(1.0));
    }
}

/// Earth-fixed coordinates of a geodetic position.
fn earth_fixed([latitude, longitude, altitude]: [Big; 3]) -> Vector<Big> {
    let (s, c) = (latitude.sin(), latitude.cos());
    let n = a() / w2(s).sqrt();
    let p = (n + altitude) * c;
    Vector::new(p * longitude.cos(), p * longitude.sin(), (n * (big(1.0) - e2()) + altitude) * s)
}

/// Latitude and height of an axis distance and z, by Newton's method until nothing moves.
fn geodetic(p: Big, z: Big, start: f64) -> [Big; 2] {
    let mut latitude = big(start);
    for _ in 0..6 {
        let (s, c) = (latitude.sin(), latitude.cos());
        let w = w2(s).sqrt();
        let n = a() / w;
        let meridian = a() * (big(1.0) - e2()) / (w * w * w);
        let height = p * c + z * s - a() * w;
        let off = c * z - s * p + e2() * n * s * c;
        latitude = latitude + off / (meridian + height);
    }
    let (s, c) = (latitude.sin(), latitude.cos());
    [latitude, p * c + z * s - a() * w2(s).sqrt()]
}

fn coordinates(worst: &mut Worst) {
    let mut numbers = Numbers(32);
    for _ in 0..TRIES / 2 {
        let at = Geodetic {
            latitude: numbers.within(1.57),
            longitude: numbers.within(3.1),
            altitude: 50_000.0 + numbers.within(50_000.0),
        };
        let Geodetic { latitude, longitude, altitude } = at.map(big);
        let exact = earth_fixed([latitude, longitude, altitude]);
        let computed = at.to_earth_fixed();
        let off = largest((computed.map(big) - exact).into_array());
        worst.add("to Earth-fixed, of R", off / ulp(6.4e6));
        let back = Geodetic::from_earth_fixed(computed);
        let Vector { x, y, z } = computed.map(big);
        let [latitude, height] = geodetic((x * x + y * y).sqrt(), z, at.latitude);
        let off = |computed: f64, exact: Big| (big(computed) - exact).rough().abs();
        worst.add("from Earth-fixed: φ, of 1", off(back.latitude, latitude) / ulp(1.0));
        worst.add("from Earth-fixed: λ", {
            let exact = y.atan2(x);
            off(back.longitude, exact) / ulp(exact.rough())
        });
        worst.add("from Earth-fixed: h, of R", off(back.altitude, height) / ulp(6.4e6));
    }
}

fn steps<R: Scalar + Precision>(worst: &mut Worst) {
    let mut numbers = Numbers(33);
    for _ in 0..TRIES / 2 {
        let latitude = numbers.within(1.5);
        let altitude = 50_000.0 + numbers.within(50_000.0);
        gravitation::<R>(worst, &mut numbers, latitude, altitude);
        meridian::<R>(worst, &mut numbers, latitude, altitude);
    }
}

/// G = −γ n̂ + ω × (ω × r), from the latitude that is carried along.
fn gravitation<R: Scalar + Precision>(
    worst: &mut Worst,
    numbers: &mut Numbers,
    latitude: f64,
    altitude: f64,
) {
    let at = Geodetic { latitude, longitude: numbers.within(3.1), altitude };
    // A change of 5e-8 rad per block, 0.3 m, is predicted; one of 5e-6, from a start, is not.
    for (what, step, behind) in [("predicted", 5e-8, 3), ("cold", 5e-6, 0)] {
        let place = |behind: u32| {
            let latitude = latitude - step * f64::from(behind);
            Geodetic { latitude, ..at }.to_earth_fixed().map(R::narrow)
        };
        let start = latitude - step * f64::from(behind + 1);
        let (sine, cosine) = (R::narrow(start.sin()), R::narrow(start.cos()));
        let mut carried = Latitude { sine, cosine, change: R::ZERO };
        for behind in (1..=behind).rev() {
            carried.gravitation(place(behind));
        }
        let exact = exact_gravitation(place(0).map(|c| big(c.widen())), latitude);
        let computed = carried.gravitation(place(0)).map(|c| big(c.widen()));
        let off = largest((computed - exact).into_array());
        worst.add(format!("gravitation {what}, of g {}", R::NAME), off / (ulp(9.8) * R::ULP));
    }
}

/// The same at a position, about a latitude.
fn exact_gravitation(position: Vector<Big>, latitude: f64) -> Vector<Big> {
    let Vector { x, y, z } = position;
    let p = (x * x + y * y).sqrt();
    let [latitude, height] = geodetic(p, z, latitude);
    let (s, c) = (latitude.sin(), latitude.cos());
    let pull = gravity(s, height);
    let omega2 = big(7.292115e-5) * big(7.292115e-5);
    let outward = -(pull * c) - omega2 * p;
    Vector::new(outward * x / p, outward * y / p, -(pull * s))
}

/// A displacement of tens of metres against the Newton's method above.
fn meridian<R: Scalar + Precision>(
    worst: &mut Worst,
    numbers: &mut Numbers,
    latitude: f64,
    altitude: f64,
) {
    // The functions are handed a sine and a cosine: this latitude is what belongs to them.
    let (sine, cosine) = (R::narrow(latitude.sin()), R::narrow(latitude.cos()));
    let altitude = R::narrow(altitude);
    let moved = numbers.vector(60.0).map(R::narrow);
    let change = Meridian::at(sine, cosine, altitude, curvature(sine)).moved(moved);
    let (s, c) = (big(sine.widen()), big(cosine.widen()));
    let length = (s * s + c * c).sqrt();
    let (s, c) = (s / length, c / length);
    let start = s.atan2(c);
    let h = big(altitude.widen());
    let Vector { x: north, y: east, z: down } = moved.map(|x| big(x.widen()));
    let n = a() / w2(s).sqrt();
    // In the start's meridian plane: outward, along east, along the axis.
    let outward = (n + h) * c - north * s - down * c;
    let axial = (n * (big(1.0) - e2()) + h) * s + north * c - down * s;
    let [latitude, height] = geodetic((outward * outward + east * east).sqrt(), axial, latitude);
    let mut check = |what: &str, computed: R, exact: Big, size: f64| {
        let off = (big(computed.widen()) - exact).rough().abs();
        worst.add(format!("{what} {}", R::NAME), off / (ulp(size) * R::ULP));
    };
    let size = moved.norm().widen() / 6.4e6;
    check("meridian step: Δφ", change.latitude, latitude - start, size);
    let turned = east.atan2(outward);
    check("meridian step: Δλ", change.longitude, turned, turned.rough());
    check("meridian step: Δh", change.altitude, height - h, moved.norm().widen());
}
