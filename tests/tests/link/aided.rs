//! Aided flights at the end of a link: settings, measurements and state as they cross it, and what is refused.

use schuler::aiding::aided::fault::AidedFault;
use schuler::aiding::aided::instant::Instant;
use schuler::aiding::aided::measured::Measured;
use schuler::aiding::aided::settings::{self, Lockout, Settings, States};
use schuler::aiding::states::Process;
use schuler::aiding::states::latency::Latency;
use schuler::aiding::states::lever_arm::LeverArm;
use schuler::aiding::states::scale::Scale;
use schuler::earth::Geodetic;
use schuler::flight::catalogue::Entry;
use schuler::link::aided::{Linked, LinkedAided};
use schuler::link::aided_fleet::EveryAided;
use schuler::link::bytes::Bytes;
use schuler::link::decoder::Decoder;
use schuler::link::fleet::{Fleet, Single};
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

#[test]
fn settings_lead_back_from_their_words() {
    for settings in [simple(), full()] {
        let bytes = words(&settings);
        assert_eq!(bytes.len(), 8 * 27);
        let mut rest = Bytes(&bytes);
        let other = if settings == simple() { full() } else { simple() };
        assert_eq!(rest.record(other), Some(settings));
        assert_eq!(rest.end(), Some(()));
    }
    let single = Settings {
        step_s: 0.2_f32,
        ..Settings::new(
            States::new(3e-5, 8e-4, Process::constant(5e-5), Process::constant(1e-3)),
            settings::Start {
                position_m: 1.0,
                velocity_m_s: 0.1,
                level_rad: 3e-3,
                heading_rad: 0.03,
            },
        )
    };
    assert_eq!(Bytes(&words(&single)).record(single), Some(single));
}

#[test]
fn a_flight_over_the_link_is_the_flight_itself() {
    let mut host = Host::<EveryAided>::new();
    assert!(matches!(host.start(), Said::Stands(0, _)));
    assert_eq!(host.sample(1), Said::Refuses(Refusal::Unaided));
    assert_eq!(host.measure(1, &fix(1)), Said::Refuses(Refusal::Unaided));
    assert!(matches!(host.aid(&full()), Said::Stands(0, _)));
    let mut alone = linked(0.785, &full());
    assert_eq!(host.state(), words(&alone));
    for number in 1..=200 {
        if number % 50 == 0 {
            // What is sent again is known by its number.
            for sent in 0..2 {
                let said = host.measure(number / 50, &fix(number));
                assert_eq!(said, Said::Stands(number - 1, alone.digest()), "{sent}");
            }
            assert_eq!(alone.measure(number / 50, &fix(number)), Ok(Taken::Flown));
        }
        alone.take(number, sample(number), &mut ()).unwrap();
        assert_eq!(host.sample(number), Said::Stands(number, alone.digest()));
    }
    let end = host.ask(&Request::Finish { samples: 200 });
    alone.finish(200, &mut ()).unwrap();
    assert_eq!(end, Said::Stands(200, alone.digest()));
    assert_eq!(host.state(), words(&alone));
    assert_eq!(host.measure(9, &fix(200)), Said::Refuses(Refusal::Finished));
}

#[test]
fn what_is_refused_changes_nothing() {
    let mut host = Host::<EveryAided>::new();
    host.start();
    for (settings, fault) in [
        (Settings { step_s: 0.0, ..simple() }, AidedFault::Settings),
        (Settings { lever_b: Vector::new(1e3, 0.0, 0.0), ..simple() }, AidedFault::Lever),
        (Settings { horizon_samples: Some(1000), ..simple() }, AidedFault::Horizon),
    ] {
        assert_eq!(host.aid(&settings), Said::Refuses(Refusal::Aided(fault)));
    }
    // A bit that means nothing, and a word too few.
    let mut bytes = words(&simple());
    bytes[3] = 1;
    assert_eq!(host.ask(&Request::Aid(Bytes(&bytes))), Said::Refuses(Refusal::Malformed));
    let bytes = words(&simple());
    let short = Request::Aid(Bytes(&bytes[8..]));
    assert_eq!(host.ask(&short), Said::Refuses(Refusal::Malformed));

    host.aid(&simple());
    for number in 1..=60 {
        host.sample(number);
    }
    host.measure(1, &fix(50));
    let before = host.state();
    let nan = Measured { velocity: Vector::new(f64::NAN, 0.0, 0.0), ..fix(60) };
    let none = Measured { position_sigma: Vector::ZERO, ..fix(60) };
    for (measured, fault) in [
        (nan, AidedFault::Velocity),
        (none, AidedFault::Sigma),
        (Measured { at: Instant::of_sample(100_000), ..fix(60) }, AidedFault::Future),
    ] {
        assert_eq!(host.measure(2, &measured), Said::Refuses(Refusal::Aided(fault)));
    }
    let mut bytes = words(&fix(60));
    // There is no such kind of measurement.
    bytes[16] = 99;
    let unknown = Request::Measure { number: 2, measured: Bytes(&bytes) };
    assert_eq!(host.ask(&unknown), Said::Refuses(Refusal::Malformed));
    assert_eq!(host.ask(&Request::Hold(Bytes(&[0; 16]))), Said::Refuses(Refusal::Malformed));
    assert_eq!(host.state(), before);
    assert!(matches!(host.measure(2, &fix(60)), Said::Stands(60, _)));
    assert_ne!(host.state(), before);
}

#[test]
fn who_is_not_aided_says_so() {
    let mut host = Host::<Single>::new();
    assert_eq!(host.start(), Said::Refuses(Refusal::Configuration));
    let configuration = Navigator4::<f32>::CONFIGURATION;
    let pair = Pair::<f32>::narrow(Pair::new(RATE_HZ).reciprocal());
    let mut initial = Vec::new();
    let mut write = |bits: u64| initial.extend_from_slice(&(bits as u32).to_le_bytes());
    pair.record("", &mut |_, bits| write(bits));
    Solution::<f32>::narrow(&self::initial(0.0)).record("", &mut |_, bits| write(bits));
    let initial = Bytes(&initial);
    let offer = configuration.into();
    let start = Start { offer, order: 3, gap: Policy::Refuse, initial };
    assert!(matches!(host.ask(&Request::Start(start)), Said::Stands(0, _)));
    assert_eq!(host.aid(&simple()), Said::Refuses(Refusal::Unaided));
    assert_eq!(host.measure(1, &fix(1)), Said::Refuses(Refusal::Unaided));
    // Its state can be read all the same.
    assert!(host.state().len() > 300);
}

#[test]
fn a_flight_that_looks_for_its_heading_goes_on_from_its_words() {
    let settings = Settings { start: settings::Start { heading_rad: 1.5, ..start() }, ..full() };
    // A heading that is half a turn off.
    let mut whole = linked(-2.3, &settings);
    let mut looking = 0;
    for cut in [70, 100, 130, 170, 230, 410] {
        let from = whole.taken() + 1;
        fly(&mut whole, from..=cut);
        let (_, state) = whole.flying().unwrap();
        looking += u32::from(state.looks_for_heading());
        let mut copy = linked(0.0, &settings);
        let bytes = words(&whole);
        let mut each = bytes.as_chunks::<8>().0.iter().map(|word| u64::from_le_bytes(*word));
        Fleet::restore(&mut copy, &mut |_| each.next().unwrap());
        assert_eq!(Fleet::check(&copy), Ok(()));
        let mut on = whole;
        fly(&mut on, cut + 1..=cut + 600);
        fly(&mut copy, cut + 1..=cut + 600);
        assert_eq!(copy.digest(), on.digest());
        assert_eq!(words(&copy), words(&on));
    }
    assert!(looking >= 2, "the heading was looked for at {looking} cuts");
}

#[test]
fn damaged_words_are_refused() {
    let mut flight = linked(0.785, &full());
    fly(&mut flight, 1..=130);
    let bytes = words(&flight);
    // The count of what waits, far beyond its room; not a number in the covariance.
    let all = bytes.len() / 8;
    let nan = f64::NAN.to_bits();
    let mut refused = 0;
    for place in (0..all).step_by(37) {
        let mut copy = flight;
        let mut index = 0;
        Fleet::restore(&mut copy, &mut |bits| {
            index += 1;
            if index == place + 1 { nan } else { bits }
        });
        refused += u32::from(Fleet::check(&copy).is_err());
    }
    // Some words are counts, and any is possible; or of what is not looked at any more.
    assert!(refused > 20, "{refused} of {}", all / 37);
    let mut fresh = linked(0.785, &full());
    Fleet::restore(&mut fresh, &mut |_| 0);
    assert_eq!(Fleet::check(&fresh), Err(Refusal::Damaged));
}
