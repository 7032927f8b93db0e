//! `tests/golden/aided.toml`.

use super::Scene;
use schuler::aiding::aided::settings::{Settings, Start, States};
use schuler::aiding::states::Process;
use schuler::aiding::states::latency::Latency;
use schuler::aiding::states::lever_arm::LeverArm;
use schuler::math::real::Scalar;
use schuler::math::vector::Vector;
use schuler::sensor::aiding::gnss::Gnss;
use schuler::sensor::aiding::line::{Line, Outage};
use schuler::sensor::aiding::noise::VectorNoise;
use schuler::sensor::constant::Constant;
use schuler::sensor::triad::Triad;
use schuler::sensor::white::White;
use schuler::trajectory::harmonic::Channels;
use schuler_scenes::channel::{channel, harmonic};
use schuler_scenes::units::*;

pub const SCENE: Scene = Scene {
    name: "aided",
    duration_s: 120,
    rate_hz: 50,
    channels: Channels {
        roll: channel(0.0, 0.0, &[harmonic(2.0, 23.0, 5.7, DEGREE)], DEGREE),
        pitch: channel(0.0, 0.0, &[harmonic(1.5, 37.0, 40.0, DEGREE)], DEGREE),
        yaw: channel(60.0, 0.0, &[harmonic(70.0, 120.0, 17.0, DEGREE)], DEGREE),
        latitude: channel(45.0, 0.0, &[harmonic(4.5e-3, 120.0, 0.0, DEGREE)], DEGREE),
        longitude: channel(8.0, 0.0, &[harmonic(8.9e-3, 170.0, 40.0, DEGREE)], DEGREE),
        altitude: channel(200.0, 0.0, &[harmonic(20.0, 200.0, 0.0, METRE)], METRE),
    },
    gyro: |timing| {
        Ok(Triad {
            constant: Some(Constant::new(axes(10.0, -8.0, 6.0, DEGREE_PER_HOUR), timing)?),
            white: Some(White::new(all(0.1, DEGREE_PER_ROOT_HOUR), timing)?),
            ..Triad::PERFECT
        })
    },
    accelerometer: |timing| {
        Ok(Triad {
            constant: Some(Constant::new(axes(100.0, -80.0, 60.0, MICRO_G), timing)?),
            white: Some(White::new(all(0.05, METRE_PER_SECOND_PER_ROOT_HOUR), timing)?),
            ..Triad::PERFECT
        })
    },
};

/// The receiver; `None` if it had more outages than there is room for.
pub fn gnss() -> Option<Gnss<f64>> {
    let line = Line {
        latency_s: 0.25,
        jitter_s: 0.4,
        loss: 0.1,
        repetition: 0.2,
        ..Line::every(1.0)
    };
    let line = line.with_outage(Outage { from_s: 60.0, until_s: 75.0 })?;
    let noise = |white: f64| VectorNoise { correlation_s: 100.0, ..VectorNoise::white(all(white, 1.0)) };
    Some(Gnss {
        position: noise(1.0),
        velocity: noise(0.05),
        lever_b: axes(0.5, -0.3, -1.0, 1.0),
        ..Gnss::new(line, 1.0, 0.05)
    })
}

/// The filter.
pub fn settings<R: Scalar>() -> Settings<R> {
    let of = |x: f64| R::narrow(x);
    let states = States {
        lever_arm: Some(LeverArm { sigma: of(0.1) }),
        latency: Some(Latency { sigma_s: of(0.05) }),
        ..States::new(
            of(0.1 * DEGREE_PER_ROOT_HOUR),
            of(0.05 * METRE_PER_SECOND_PER_ROOT_HOUR),
            Process::constant(of(10.0 * DEGREE_PER_HOUR)),
            Process::constant(of(100.0 * MICRO_G)),
        )
    };
    let start = Start {
        position_m: of(1.0),
        velocity_m_s: of(0.1),
        level_rad: of(0.2 * DEGREE),
        heading_rad: of(2.0 * DEGREE),
    };
    let lever_b: Vector<f64> = axes(0.5, -0.3, -1.0, 1.0);
    Settings { lever_b: lever_b.map(of), ..Settings::new(states, start) }
}
