//! Standing still: how often noise alone is taken for motion, and motion for none.

use super::drive::{
    ACCELEROMETER_BIAS, ACCELEROMETER_NOISE, GYRO_BIAS, GYRO_NOISE, RATE_HZ, run, three, truth,
};
use schuler::aiding::standstill::{Standstill, Stillness};
use schuler::math::real::Scalar;
use schuler::noise::Streams;
use schuler::prelude::*;

const WINDOW: u32 = 50;
const FALSE_ALARM: f64 = 0.01;

fn detector<R: Scalar>() -> Standstill<R> {
    let of = |x: f64| R::narrow(x);
    let interval = of(1.0 / RATE_HZ);
    let (gyro, force) = (of(GYRO_NOISE), of(ACCELEROMETER_NOISE));
    Standstill::new(WINDOW, interval, gyro, force, of(FALSE_ALARM)).unwrap()
}

#[test]
fn noise_is_taken_for_motion_as_often_as_stated() {
    let (double, single) = (detector::<f64>(), detector::<f32>());
    let (mut wide, mut narrow) = (Stillness::default(), Stillness::default());
    let mut stream = Streams::new(31, 0).open();
    let root = (1.0 / RATE_HZ).sqrt();
    let mut deviates = |sigma: f64| {
        Vector::new(stream.normal::<f64>(), stream.normal(), stream.normal()) * (sigma * root)
    };
    let bias = Increment {
        angle_b: three(GYRO_BIAS / RATE_HZ),
        velocity_b: Vector::new(ACCELEROMETER_BIAS, 0.1, -9.8) * (1.0 / RATE_HZ),
    };
    let windows = 20_000;
    let (mut alarms, mut differ) = (0.0, 0);
    let (mut ratio, mut ratios) = (0.0, 0.0);
    for _ in 0..windows {
        for k in 0..WINDOW {
            let sample = Increment {
                angle_b: bias.angle_b + deviates(GYRO_NOISE),
                velocity_b: bias.velocity_b + deviates(ACCELEROMETER_NOISE),
            };
            let small = Increment {
                angle_b: sample.angle_b.map(|x| x as f32),
                velocity_b: sample.velocity_b.map(|x| x as f32),
            };
            let said = double.push(&mut wide, &sample);
            differ += u32::from(single.push(&mut narrow, &small) != said);
            assert_eq!(said.is_some(), k + 1 == WINDOW);
            alarms += f64::from(u8::from(said == Some(false)));
            if said.is_some() {
                ratio = wide.ratio();
                ratios += ratio;
            }
            // It stands until the next window ends.
            assert_eq!(wide.ratio(), ratio);
        }
    }
    // A binomial: four standard deviations.
    let expected = f64::from(windows) * FALSE_ALARM;
    assert!((alarms - expected).abs() < 4.0 * expected.sqrt(), "{alarms} for {expected}");
    assert!(differ < 20, "{differ}");
    // χ² over its degrees of freedom has mean 1 and variance 2/n.
    let (mean, n) = (ratios / f64::from(windows), f64::from(6 * (WINDOW - 1)));
    assert!((mean - 1.0).abs() < 4.0 * (2.0 / n / f64::from(windows)).sqrt(), "{mean}");
}

#[test]
fn a_drive_is_no_standstill() {
    let truth = truth(120.0);
    let run = run(&truth, 2, 0.0);
    let detector = detector::<f64>();
    let mut state = Stillness::default();
    let said: Vec<bool> = run.samples.iter().filter_map(|s| detector.push(&mut state, s)).collect();
    let still = said.iter().filter(|still| **still).count();
    assert!(still * 10 < said.len(), "{still} of {}", said.len());
}

#[test]
fn what_cannot_be_judged_is_refused() {
    let new = |window, noise: f64, alarm: f64| Standstill::new(window, 0.01, noise, 1e-3, alarm);
    assert!(new(1, 1e-5, 0.01).is_none() && new(5000, 1e-5, 0.01).is_none());
    assert!(new(50, 0.0, 0.01).is_none() && new(50, f64::NAN, 0.01).is_none());
    assert!(new(50, 1e-5, 0.0).is_none() && new(50, 1e-5, 0.6).is_none());
}
