//! Flights over the link beside the same flights without it, and what is refused.

use super::{Host, RATE_HZ, Said, fix, fly, full, initial, linked, sample, simple, start, words};
use schuler::aiding::aided::fault::AidedFault;
use schuler::aiding::aided::instant::Instant;
use schuler::aiding::aided::measured::Measured;
use schuler::aiding::aided::settings::{self, Settings, States};
use schuler::aiding::states::Process;
use schuler::flight::catalogue::Entry as _;
use schuler::link::aided_fleet::EveryAided;
use schuler::link::bytes::Bytes;
use schuler::link::fleet::{Fleet, Single};
use schuler::link::flight::Taken;
use schuler::link::gap::Policy;
use schuler::link::message::{Request, Start};
use schuler::link::refusal::Refusal;
use schuler::math::compensated::Pair;
use schuler::math::vector::Vector;
use schuler::navigators::Navigator4;
use schuler::record::Record as _;
use schuler::solution::Solution;

#[test]
fn settings_lead_back_from_their_words() {
    for settings in [simple(), full()] {
        let bytes = words(&settings);
        assert_eq!(bytes.len(), 8 * 29);
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
