//! Navigation as plain numbers, navigators by their short names, intervals by rate.

use schuler::math::compensated::Pair;
use schuler::prelude::*;
use schuler::record::Record;
use schuler_tests::{bits, near};
use std::f64::consts::PI;

fn somewhere() -> Solution<f64> {
    Solution::new(
        Geodetic { latitude: -0.6, longitude: 2.9, altitude: 4321.0 },
        Vector::new(12.5, -3.25, 0.5),
        Euler { roll: -0.3, pitch: 0.2, yaw: 3.0 },
    )
}

/// Degrees, metres and metres per second of the same state from either frame, each number rounded once.
#[test]
fn either_frame_reads_in_degrees() {
    let solution = somewhere();
    let (local, earth) = (solution.readout(), solution.to_earth_fixed().readout());
    let [latitude, longitude] = [-0.6_f64, 2.9].map(|x| x * 180.0 / PI);
    for shown in [local, earth] {
        near(shown.latitude_deg, latitude, 1e-15, "latitude");
        near(shown.longitude_deg, longitude, 1e-15, "longitude");
        near(shown.altitude_m, 4321.0, 1e-12, "altitude");
        near(shown.velocity_ned_m_s.x, 12.5, 1e-14, "north");
        near(shown.velocity_ned_m_s.y, -3.25, 1e-14, "east");
        near(shown.velocity_ned_m_s.z, 0.5, 1e-13, "down");
        near(shown.roll_deg, -0.3 * 180.0 / PI, 1e-14, "roll");
        near(shown.pitch_deg, 0.2 * 180.0 / PI, 1e-14, "pitch");
        near(shown.yaw_deg, 3.0 * 180.0 / PI, 1e-14, "yaw");
    }
    let single = Solution::<f32>::narrow(&solution).readout();
    near(single.longitude_deg.into(), longitude, 6e-8, "longitude");
    assert_eq!(
        local.to_string(),
        "-34.3774677° 166.1577606° 4321.000 m, 12.5000 -3.2500 0.5000 m/s, \
         -17.1887° 11.4592° 171.8873°"
    );
    assert_eq!(
        format!("{local:.1}"),
        "-34.4° 166.2° 4321.0 m, 12.5 -3.2 0.5 m/s, -17.2° 11.5° 171.9°"
    );
}

/// The interval of a rate has twice the digits: both ways to say 100 Hz give the same flight.
#[test]
fn a_rate_is_an_exact_interval() {
    fn end<M: Mechanization<Real: From<f32>, State: Record>>(navigator: &M) -> Vec<u64> {
        let initial = Solution {
            attitude: Quaternion::new(Pair::new(M::Real::from(1.0)), Default::default()),
            ..Solution::default()
        };
        let mut state = navigator.start(&initial).unwrap();
        let sample = Increment {
            angle_b: Vector::new(0.01, 0.02, 0.03).map(M::Real::from),
            velocity_b: Vector::new(0.0, 0.1, -0.098).map(M::Real::from),
        };
        for _ in 0..40 {
            navigator.push(&mut state, sample).unwrap();
        }
        bits(&state)
    }
    let exact = || Pair::new(100.0).reciprocal();
    let single = Navigator4::<f32>::new(Pair::new(100.0).reciprocal()).unwrap();
    assert_eq!(end(&Navigator4::<f32>::from_rate_hz(100.0).unwrap()), end(&single));
    let double = EarthFixedNavigator8::<f64>::new(exact()).unwrap();
    assert_eq!(end(&EarthFixedNavigator8::<f64>::from_rate_hz(100.0).unwrap()), end(&double));
    let textbook = TextbookNavigator::<f64>::new(0.01).unwrap();
    assert_eq!(end(&TextbookNavigator::<f64>::from_rate_hz(100.0).unwrap()), end(&textbook));
    let literal = Navigator4::<f32>::from_interval_s(0.01).unwrap();
    assert_eq!(end(&literal), end(&Navigator4::<f32>::new(Pair::of(0.01)).unwrap()));
    // What the short way without a remainder does.
    assert_ne!(end(&literal), end(&Navigator4::<f32>::new(Pair::new(0.01)).unwrap()));
    for wrong in [0.0, -1.0, 0.5, f64::NAN, f64::INFINITY, 1e40] {
        let refused = Err(StartError::Interval);
        assert_eq!(Navigator4::<f32>::from_rate_hz(wrong).map(|_| ()), refused, "{wrong}");
        assert_eq!(TextbookNavigator::<f64>::from_rate_hz(wrong).map(|_| ()), refused, "{wrong}");
    }
}
