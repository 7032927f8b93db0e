//! The largest number that a sample can have: none is lost next to it.

use schuler::flight::catalogue::Entry as _;
use schuler::link::flight::{LinkedFlight, Taken};
use schuler::link::gap::{MOST_BRIDGED, Policy};
use schuler::link::refusal::Refusal;
use schuler::math::compensated::Pair;
use schuler::record::Record;
use schuler::strapdown::block::window::H0B4A0;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::navigator::Strapdown;
use schuler_tests::Course;

type Flown = Strapdown<LocalLevel<Pair<f64>>, H0B4A0>;

/// A flight whose last sample has a number so far below the largest.
fn flight(below: u32) -> LinkedFlight<Flown> {
    let course = Course::new("manoeuvre", 1.0, 0.5);
    let mechanization = Flown::configured(course.interval_s, 20).unwrap();
    let mut flight = LinkedFlight::new(mechanization, course.initial(), Policy::Bridge).unwrap();
    flight.take(1, course.samples[0], Flown::push).unwrap();
    let number = u32::MAX - below;
    flight.restore("", &mut |name, bits| if name == "taken" { number.into() } else { bits });
    assert_eq!(flight.taken(), number);
    flight
}

fn finish(flight: &mut LinkedFlight<Flown>) -> Result<Taken, Refusal> {
    flight.finish(u32::MAX, Flown::push, Flown::finish)
}

#[test]
fn every_missing_sample_is_filled_up_to_the_largest_number() {
    for missing in [0, 1, 3, MOST_BRIDGED] {
        let mut flight = flight(missing);
        assert_eq!(finish(&mut flight), Ok(Taken::Flown));
        let came = 1_u32.unbounded_shl(missing);
        assert_eq!((flight.bridged(), flight.taken(), flight.came()), (missing, u32::MAX, came));
    }
    let mut flight = flight(MOST_BRIDGED + 1);
    assert_eq!(finish(&mut flight), Err(Refusal::Gap));
    assert_eq!(flight.taken(), u32::MAX - MOST_BRIDGED - 1);
}

#[test]
fn the_largest_number_is_taken_once() {
    let sample = Course::new("manoeuvre", 1.0, 0.5).samples[1];
    let mut flight = flight(3);
    assert_eq!(flight.take(u32::MAX, sample, Flown::push), Ok(Taken::Flown));
    assert_eq!((flight.bridged(), flight.taken(), flight.came()), (2, u32::MAX, 0b1001));
    assert_eq!(flight.take(u32::MAX, sample, Flown::push), Ok(Taken::Again));
    assert_eq!(finish(&mut flight), Ok(Taken::Flown));
    assert_eq!(flight.bridged(), 2);
}
