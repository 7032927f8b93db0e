//! The filter for a scene: its sensors' noise and biases, and what is known at the start.

use crate::alignment::sensors;
use crate::scene::Scene;
use schuler::aiding::aided::settings::{Settings, Start, States};
use schuler::aiding::states::Process;
use schuler::aiding::states::latency::Latency;
use schuler::aiding::states::lever_arm::LeverArm;
use schuler::aiding::states::scale::Scale;
use schuler::math::real::Scalar;
use schuler::math::vector::Vector;
use schuler::units::DEGREE;

/// First standard deviations where nothing is off: m, m/s, rad, rad.
const LEAST: [f64; 4] = [0.01, 1e-3, 1e-3 * DEGREE, 1e-2 * DEGREE];

/// The settings of a scene's filter.
pub fn of(scene: &Scene) -> Settings<f64> {
    let (aiding, filter) = (&scene.aiding, &scene.aiding.filter);
    let model = sensors::model(scene);
    let states = States {
        lever_arm: filter.lever_arm_m.map(|sigma| LeverArm { sigma }),
        latency: filter.latency_s.map(|sigma_s| Latency { sigma_s }),
        barometer_bias: aiding
            .barometer
            .map(|barometer| Process::gauss_markov(barometer.bias_m, barometer.correlation_s)),
        odometer_scale: aiding
            .odometer
            .map(|odometer| Scale { sigma: odometer.scale_rms, per_root_s: 0.0 }),
        ..States::new(
            model.noise.gyro,
            model.noise.accelerometer,
            model.gyro_bias,
            model.accelerometer_bias,
        )
    };
    let [position_m, velocity_m_s, level_rad, heading_rad] = start(scene);
    let lever_b = aiding.gnss.map(|gnss| gnss.lever_b);
    let port = aiding.barometer.map(|barometer| barometer.lever_b);
    Settings {
        lever_b: lever_b.unwrap_or(Vector::ZERO),
        barometer_lever_b: port.unwrap_or(Vector::ZERO),
        odometer_lever_b: aiding.odometer.map_or(Vector::ZERO, |odometer| odometer.lever_b),
        false_refusal: filter.false_refusal,
        patience: filter.patience,
        lockout: filter.lockout,
        horizon_samples: filter.horizon_s.map(|s| (s * scene.rate_hz).ceil() as u32),
        ..Settings::new(states, Start { position_m, velocity_m_s, level_rad, heading_rad })
    }
}

/// Settings in a navigator's digits.
pub fn narrow<R: Scalar>(settings: &Settings<f64>) -> Settings<R> {
    let of = |x: f64| R::narrow(x);
    let states = &settings.states;
    let Start { position_m, velocity_m_s, level_rad, heading_rad } = settings.start;
    Settings {
        states: States {
            gyro_noise: of(states.gyro_noise),
            accelerometer_noise: of(states.accelerometer_noise),
            gyro_bias: narrowed(states.gyro_bias),
            accelerometer_bias: narrowed(states.accelerometer_bias),
            lever_arm: states.lever_arm.map(|one| LeverArm { sigma: of(one.sigma) }),
            latency: states.latency.map(|one| Latency { sigma_s: of(one.sigma_s) }),
            barometer_bias: states.barometer_bias.map(narrowed),
            odometer_scale: states
                .odometer_scale
                .map(|one| Scale { sigma: of(one.sigma), per_root_s: of(one.per_root_s) }),
        },
        start: Start {
            position_m: of(position_m),
            velocity_m_s: of(velocity_m_s),
            level_rad: of(level_rad),
            heading_rad: of(heading_rad),
        },
        lever_b: settings.lever_b.map(of),
        barometer_lever_b: settings.barometer_lever_b.map(of),
        odometer_lever_b: settings.odometer_lever_b.map(of),
        false_refusal: of(settings.false_refusal),
        patience: settings.patience,
        lockout: settings.lockout,
        horizon_samples: settings.horizon_samples,
        step_s: of(settings.step_s),
    }
}

/// A process in other digits.
fn narrowed<R: Scalar>(process: Process<f64>) -> Process<R> {
    let of = |x: f64| R::narrow(x);
    match process {
        Process::Constant(one) => Process::constant(of(one.sigma)),
        Process::RandomWalk(one) => Process::random_walk(of(one.sigma), of(one.per_root_s)),
        Process::GaussMarkov(one) => Process::gauss_markov(of(one.rms), of(one.correlation_s)),
    }
}

/// First standard deviations: as the filter is told, or the largest of the initial error's axes.
fn start(scene: &Scene) -> [f64; 4] {
    let initial = &scene.initial_error;
    let largest = |fixed: &[f64], sigma: &[f64]| {
        fixed.iter().zip(sigma).fold(0.0, |most: f64, (fixed, sigma)| most.max(fixed.hypot(*sigma)))
    };
    let (tilt, spread) = (&initial.attitude_rad, &initial.attitude_sigma_rad);
    let known = [
        largest(&initial.position_m, &initial.position_sigma_m),
        largest(&initial.velocity_m_s, &initial.velocity_sigma_m_s),
        largest(&tilt[..2], &spread[..2]),
        largest(&tilt[2..], &spread[2..]),
    ];
    std::array::from_fn(|i| scene.aiding.filter.start[i].unwrap_or(known[i].max(LEAST[i])))
}
