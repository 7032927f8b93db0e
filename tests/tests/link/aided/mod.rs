//! Aided flights at the end of a link: settings, measurements and state as they cross it, and what is refused.

mod flights;

use schuler::aiding::aided::instant::Instant;
use schuler::aiding::aided::measured::Measured;
use schuler::aiding::aided::settings::{self, Lockout, Settings, States};
use schuler::aiding::states::Process;
use schuler::aiding::states::latency::Latency;
use schuler::aiding::states::lever_arm::LeverArm;
use schuler::aiding::states::scale::Scale;
use schuler::earth::Geodetic;
use schuler::flight::catalogue::Entry as _;
use schuler::link::aided::{Linked, LinkedAided};
use schuler::link::bytes::Bytes;
use schuler::link::decoder::Decoder;
use schuler::link::fleet::Fleet;
use schuler::link::flight::Taken;
use schuler::link::frame::{Header, MOST_ENCODED, encode};
use schuler::link::gap::Policy;
use schuler::link::message::{Answer, Body, Request, Start};
use schuler::link::offer::{Offer, Purpose};
use schuler::link::refusal::Refusal;
use schuler::link::target::Target;
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::navigators::Navigator4;
use schuler::record::Record;
use schuler::sample::Increment;
use schuler::solution::{Euler, Solution};

const RATE_HZ: f64 = 50.0;

fn words(record: &impl Record) -> Vec<u8> {
    let mut bytes = Vec::new();
    record.record("", &mut |_, bits| bytes.extend_from_slice(&bits.to_le_bytes()));
    bytes
}

fn start() -> settings::Start<f64> {
    settings::Start { position_m: 1.0, velocity_m_s: 0.1, level_rad: 3e-3, heading_rad: 0.03 }
}

fn simple() -> Settings<f64> {
    let [gyro, accelerometer] = [5e-5, 1e-3].map(Process::constant);
    Settings::new(States::new(3e-5, 8e-4, gyro, accelerometer), start())
}

/// With everything that settings can have.
fn full() -> Settings<f64> {
    let states = States {
        lever_arm: Some(LeverArm { sigma: 0.1 }),
        latency: Some(Latency { sigma_s: 0.2 }),
        barometer_bias: Some(Process::gauss_markov(3.0, 600.0)),
        odometer_scale: Some(Scale { sigma: 0.01, per_root_s: 1e-4 }),
        ..States::new(3e-5, 8e-4, Process::random_walk(5e-5, 1e-7), Process::constant(1e-3))
    };
    Settings {
        lever_b: Vector::new(0.5, -0.3, -1.0),
        odometer_lever_b: Vector::new(-1.0, 0.7, 0.4),
        barometer_lever_b: Vector::new(0.2, 0.1, -0.6),
        false_refusal: 1e-3,
        patience: 7,
        lockout: Lockout::Keep,
        horizon_samples: Some(25),
        step_s: 0.2,
        ..Settings::new(states, start())
    }
}

/// On the Earth, heading north-east, at rest.
fn initial(yaw: f64) -> Solution<f64> {
    let place = Geodetic { latitude: 0.8, longitude: 0.2, altitude: 100.0 };
    Solution::new(place, Vector::ZERO, Euler { roll: 0.0, pitch: 0.0, yaw })
}

/// How long the vehicle has moved, s: it stands for a second and a half.
fn moved_s(number: u32) -> f64 {
    (f64::from(number) / RATE_HZ - 1.5).max(0.0)
}

/// A vehicle that speeds up and slows down ahead, 1 m/s² at most.
fn sample(number: u32) -> Increment<f64> {
    let moved_s = moved_s(number);
    let ahead = if moved_s > 0.0 { moved_s.cos() } else { 0.0 };
    Increment {
        angle_b: Vector::ZERO,
        velocity_b: Vector::new(ahead / RATE_HZ, 0.0, -9.81 / RATE_HZ),
    }
}

/// What a receiver says of it, heading north-east.
fn fix(number: u32) -> Measured<f64> {
    let time_s = moved_s(number);
    let (speed, way) = (time_s.sin() * 0.5_f64.sqrt(), (1.0 - time_s.cos()) * 0.5_f64.sqrt());
    let place = Geodetic {
        latitude: Pair::of(0.8 + way / 6.37e6),
        longitude: Pair::of(0.2 + way / (6.39e6 * 0.8_f64.cos())),
        altitude: Pair::of(100.0),
    };
    let all = |x: f64| Vector::new(x, x, x);
    let velocity = Vector::new(speed, speed, 0.0);
    Measured::position_velocity(
        Instant::of_sample(number.into()),
        place,
        all(1.0),
        velocity,
        all(0.05),
    )
}

fn offer() -> Offer {
    Offer { purpose: Purpose::Aiding, configuration: Navigator4::<f64>::CONFIGURATION }
}

/// A host that sends one frame after the other.
struct Host<F> {
    target: Target<F>,
    sent: u32,
}

/// What a target answered.
#[derive(Debug, PartialEq)]
enum Said {
    /// Samples taken, and the digest.
    Stands(u32, u64),
    Refuses(Refusal),
    Words(u16, Vec<u8>),
}

impl<F: Fleet> Host<F> {
    fn new() -> Self {
        Self { target: Target::new(0), sent: 0 }
    }

    fn ask(&mut self, request: &Request) -> Said {
        self.sent += 1;
        let header = Header { kind: request.kind(), sequence: self.sent, time_ns: 0 };
        let mut buffer = [0; MOST_ENCODED];
        let frame = encode(&header, &mut buffer, |to| request.write(to)).unwrap();
        let mut answer = Vec::new();
        for &byte in frame {
            self.target.take(byte, &mut |bytes: &[u8]| answer.extend_from_slice(bytes));
        }
        let mut decoder = Decoder::default();
        let mut said = None;
        for byte in answer {
            let Some(frame) = decoder.take(byte) else { continue };
            said = Some(match Answer::read(&frame).unwrap().body {
                Body::Solution(standing) => Said::Stands(standing.taken, standing.digest),
                Body::Refused { refusal, .. } => Said::Refuses(refusal),
                Body::State { words, piece, .. } => Said::Words(words, piece.0.to_vec()),
                other => panic!("{other:?}"),
            });
        }
        said.expect("one answer")
    }

    fn start(&mut self) -> Said {
        let interval_s = Pair::new(RATE_HZ).reciprocal();
        let initial = [words(&interval_s), words(&initial(0.785))].concat();
        let initial = Bytes(&initial);
        self.ask(&Request::Start(Start {
            offer: offer(),
            order: 255,
            gap: Policy::Refuse,
            initial,
        }))
    }

    fn aid(&mut self, settings: &Settings<f64>) -> Said {
        self.ask(&Request::Aid(Bytes(&words(settings))))
    }

    fn sample(&mut self, number: u32) -> Said {
        let increment = words(&sample(number));
        self.ask(&Request::Sample { number, increment: Bytes(&increment) })
    }

    fn measure(&mut self, number: u32, measured: &Measured<f64>) -> Said {
        let measured = words(measured);
        self.ask(&Request::Measure { number, measured: Bytes(&measured) })
    }

    /// All words of its state.
    fn state(&mut self) -> Vec<u8> {
        let mut state: Vec<u8> = Vec::new();
        loop {
            let offset = (state.len() / 8) as u16;
            let Said::Words(all, piece) = self.ask(&Request::Read { offset }) else {
                panic!("no words");
            };
            assert!(!piece.is_empty());
            state.extend(piece);
            if state.len() == 8 * usize::from(all) {
                return state;
            }
        }
    }
}

fn linked(yaw: f64, settings: &Settings<f64>) -> Linked<Navigator4<f64>> {
    let navigator = Navigator4::from_rate_hz(RATE_HZ).unwrap();
    let interval_s = Pair::new(RATE_HZ).reciprocal();
    let mut flight = LinkedAided::new(navigator, interval_s, initial(yaw), Policy::Refuse).unwrap();
    flight.aid(settings).unwrap();
    flight
}

/// From one sample to another, with a measurement every second that comes a third of a second late.
fn fly(flight: &mut Linked<Navigator4<f64>>, numbers: std::ops::RangeInclusive<u32>) {
    for number in numbers {
        let late = number.saturating_sub(17);
        if late > 0 && late.is_multiple_of(50) {
            assert_eq!(flight.measure(late / 50, &fix(late)), Ok(Taken::Flown));
        }
        assert_eq!(flight.take(number, sample(number), &mut ()), Ok(Taken::Flown));
    }
}
