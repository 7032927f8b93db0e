//! Settings as words, for the link.
//!
//! The first word says which states there are, and of which kind their processes are:
//!
//! | bits | what |
//! |---|---|
//! | 0–1, 2–3, 4–5 | processes of the gyros' biases, the accelerometers', a barometer's: 0 none, 1 constant, 2 random walk, 3 Gauss-Markov |
//! | 6, 7, 8 | lever arm, latency, scale factor of an odometer |
//! | 9 | a lockout changes nothing |
//! | 10 | there is a horizon |
//!
//! Above them, from bit 32 on, is how many refusals are a lockout. Then come the horizon and the numbers; those that are
//! not needed are 0.

use super::settings::{Lockout, Settings, Start, States};
use crate::aiding::states::Process;
use crate::aiding::states::latency::Latency;
use crate::aiding::states::lever_arm::LeverArm;
use crate::aiding::states::scale::Scale;
use crate::math::real::Real;
use crate::math::vector::Vector;
use crate::record::Record;

/// A process: its kind, and two numbers.
fn parts<R: Real>(process: Option<Process<R>>) -> (u32, [R; 2]) {
    match process {
        None => (0, [R::ZERO; 2]),
        Some(Process::Constant(x)) => (1, [x.sigma, R::ZERO]),
        Some(Process::RandomWalk(x)) => (2, [x.sigma, x.per_root_s]),
        Some(Process::GaussMarkov(x)) => (3, [x.rms, x.correlation_s]),
    }
}

/// The same back.
fn process<R: Real>(kind: u32, [sigma, other]: [R; 2]) -> Option<Process<R>> {
    match kind & 3 {
        0 => None,
        1 => Some(Process::constant(sigma)),
        2 => Some(Process::random_walk(sigma, other)),
        _ => Some(Process::gauss_markov(sigma, other)),
    }
}

/// What settings are in words, in their order.
struct Words<R> {
    codes: u64,
    horizon_samples: u32,
    noise: [R; 2],
    processes: [[R; 2]; 3],
    lever_arm: R,
    latency: R,
    odometer_scale: [R; 2],
    start: [R; 4],
    levers: [Vector<R>; 3],
    false_refusal: R,
    step_s: R,
}

impl<R: Record> Record for Words<R> {
    crate::record::record!(
        codes,
        horizon_samples,
        noise,
        processes,
        lever_arm,
        latency,
        odometer_scale,
        start,
        levers,
        false_refusal,
        step_s
    );
}

impl<R: Real> From<&Settings<R>> for Words<R> {
    fn from(settings: &Settings<R>) -> Self {
        let Settings { states, start, lever_b, odometer_lever_b, barometer_lever_b, .. } = settings;
        let Settings { false_refusal, patience, lockout, horizon_samples, step_s, .. } = *settings;
        let (gyro, gyro_numbers) = parts(Some(states.gyro_bias));
        let (accelerometer, accelerometer_numbers) = parts(Some(states.accelerometer_bias));
        let (barometer, barometer_numbers) = parts(states.barometer_bias);
        let flag = |bit: u32, is_set: bool| u32::from(is_set) << bit;
        let codes = gyro
            | accelerometer << 2
            | barometer << 4
            | flag(6, states.lever_arm.is_some())
            | flag(7, states.latency.is_some())
            | flag(8, states.odometer_scale.is_some())
            | flag(9, lockout == Lockout::Keep)
            | flag(10, horizon_samples.is_some());
        Self {
            codes: u64::from(codes) | u64::from(patience) << 32,
            horizon_samples: horizon_samples.unwrap_or(0),
            noise: [states.gyro_noise, states.accelerometer_noise],
            processes: [gyro_numbers, accelerometer_numbers, barometer_numbers],
            lever_arm: states.lever_arm.map_or(R::ZERO, |x| x.sigma),
            latency: states.latency.map_or(R::ZERO, |x| x.sigma_s),
            odometer_scale: states.odometer_scale.map_or([R::ZERO; 2], |x| [x.sigma, x.per_root_s]),
            start: [start.position_m, start.velocity_m_s, start.level_rad, start.heading_rad],
            levers: [*lever_b, *odometer_lever_b, *barometer_lever_b],
            false_refusal,
            step_s,
        }
    }
}

impl<R: Real> From<Words<R>> for Settings<R> {
    fn from(words: Words<R>) -> Self {
        let Words { codes, horizon_samples, noise, processes, start, levers, .. } = words;
        let Words { lever_arm, latency, odometer_scale, false_refusal, step_s, .. } = words;
        let (codes, patience) = (codes as u32, (codes >> 32) as u32);
        let is_set = |bit: u32| codes >> bit & 1 == 1;
        let [gyro_noise, accelerometer_noise] = noise;
        let [gyro, accelerometer, barometer] = processes;
        let none = Process::constant(R::ZERO);
        let [sigma, per_root_s] = odometer_scale;
        let [position_m, velocity_m_s, level_rad, heading_rad] = start;
        let [lever_b, odometer_lever_b, barometer_lever_b] = levers;
        Self {
            states: States {
                gyro_noise,
                accelerometer_noise,
                gyro_bias: process(codes, gyro).unwrap_or(none),
                accelerometer_bias: process(codes >> 2, accelerometer).unwrap_or(none),
                lever_arm: is_set(6).then_some(LeverArm { sigma: lever_arm }),
                latency: is_set(7).then_some(Latency { sigma_s: latency }),
                barometer_bias: process(codes >> 4, barometer),
                odometer_scale: is_set(8).then_some(Scale { sigma, per_root_s }),
            },
            start: Start { position_m, velocity_m_s, level_rad, heading_rad },
            lever_b,
            odometer_lever_b,
            barometer_lever_b,
            false_refusal,
            patience,
            lockout: if is_set(9) { Lockout::Keep } else { Lockout::Inflate },
            horizon_samples: is_set(10).then_some(horizon_samples),
            step_s,
        }
    }
}

/// 29 words, always: they fit a frame.
impl<R: Real + Record> Record for Settings<R> {
    fn record(&self, name: &'static str, read: &mut impl FnMut(&'static str, u64)) {
        Words::from(self).record(name, read);
    }
    fn restore(&mut self, name: &'static str, write: &mut impl FnMut(&'static str, u64) -> u64) {
        let mut words = Words::from(&*self);
        words.restore(name, write);
        *self = words.into();
    }
}
