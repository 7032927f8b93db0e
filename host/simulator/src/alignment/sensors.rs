//! What a filter takes a scene's sensors for: their white noise, and a bias.

use crate::scene::{Scene, SensorErrors};
use schuler::aiding::alignment::limit::Limit;
use schuler::aiding::model::Model;
use schuler::aiding::states::Process;

/// A filter needs some noise: below these there is none, rad/√s and m/s/√s.
const LEAST_NOISE: [f64; 2] = [1e-9, 1e-7];

/// Noise and bias of three like sensors, as the worst of them has it.
#[derive(Clone, Copy, Debug)]
struct Taken {
    noise: f64,
    bias: f64,
    process: Process<f64>,
}

/// What limits an alignment by a scene's sensors.
pub fn limit(scene: &Scene) -> Limit<f64> {
    let [gyro, accelerometer] = both(scene);
    Limit {
        gyro_noise: gyro.noise,
        accelerometer_noise: accelerometer.noise,
        gyro_bias: gyro.bias,
        accelerometer_bias: accelerometer.bias,
    }
}

/// A filter's model of a scene's sensors.
pub fn model(scene: &Scene) -> Model<f64> {
    let [gyro, accelerometer] = both(scene);
    Model::new(gyro.noise, accelerometer.noise, gyro.process, accelerometer.process)
}

fn both(scene: &Scene) -> [Taken; 2] {
    let [gyro, accelerometer] = LEAST_NOISE;
    [taken(&scene.gyro, gyro), taken(&scene.accelerometer, accelerometer)]
}

/// All that is like a bias together is one: with a correlation time if most of it is a Gauss-Markov process, with a
/// random walk if there is one, constant else.
fn taken(errors: &SensorErrors, least_noise: f64) -> Taken {
    let worst = |values: Option<[f64; 3]>| {
        values.unwrap_or_default().into_iter().fold(0.0, |most: f64, x| most.max(x.abs()))
    };
    let markov = errors.gauss_markov;
    let varying = worst(markov.map(|process| process.rms));
    let fixed = [errors.constant, errors.turn_on, errors.bias_instability].map(worst);
    let fixed = fixed.into_iter().fold(0.0, f64::hypot);
    let bias = fixed.hypot(varying);
    let walk = worst(errors.random_walk);
    let process = match markov {
        Some(process) if varying > fixed => {
            let times = process.correlation_s;
            Process::gauss_markov(bias, times.into_iter().fold(f64::INFINITY, f64::min))
        }
        _ if walk > 0.0 => Process::random_walk(bias, walk),
        _ => Process::constant(bias),
    };
    Taken { noise: worst(errors.white).max(least_noise), bias, process }
}
