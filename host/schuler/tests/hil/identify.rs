//! A unit at rest identifies itself on a target: the sums that are read back are the host's own.

use super::{manner, scene};
use schuler::allan::octaves::Point;
use schuler::link::fleet::Every;
use schuler::link::target::Target;
use schuler_host::hil::identify::{Identified, record};
use schuler_host::hil::in_process::InProcess;
use schuler_host::hil::lockstep::Log;
use schuler_host::hil::{self, Manner};
use schuler_simulator::allan::record::of_scene;
use schuler_simulator::scene::{Precision, Scene};
use schuler_simulator::simulate::FlightError;

fn identified(
    scene: &Scene,
    target: InProcess,
    manner: &Manner,
) -> Result<Identified, FlightError> {
    let log = Log::default();
    let met = hil::meet(Box::new(target), manner, "target")?;
    let identified = record(scene, met, manner, &log)?;
    let tally = &log.lock().unwrap().tally;
    for trace in tally.traces() {
        assert!(trace.is_explained(), "{trace:?} of {tally:?}");
    }
    Ok(identified)
}

fn bits(points: &[Vec<Point<f64>>; 6]) -> Vec<[u64; 3]> {
    let of = |point: &Point<f64>| [point.samples, point.variance.to_bits(), point.differences];
    points.iter().flatten().map(of).collect()
}

#[test]
fn the_deviation_that_a_target_finds_has_the_bits_of_the_hosts() {
    let scene = scene("paper", 100.0);
    let own = of_scene(&scene).unwrap();
    assert!(own.axes.iter().all(|points| points.len() > 8));
    for manner in [Manner::default(), manner("all=0.02", 1, 20), manner("reboot=0.01", 2, 20)] {
        let there = identified(&scene, InProcess::every(), &manner).unwrap();
        assert_eq!(bits(&there.record.axes), bits(&own.axes));
        assert_eq!(there.record.said, own.said);
    }
}

#[test]
fn in_single_precision_it_is_the_same_to_its_digits() {
    let mut scene = scene("paper", 100.0);
    scene.navigator.precision = Precision::F32;
    let own = of_scene(&scene).unwrap();
    let there = identified(&scene, InProcess::single(), &manner("all=0.02", 4, 20)).unwrap();
    for (found, own) in there.record.axes.iter().flatten().zip(own.axes.iter().flatten()) {
        assert_eq!((found.samples, found.differences), (own.samples, own.differences));
        // A sum of 2000 squares in f32.
        let ratio = found.variance / own.variance;
        assert!((ratio - 1.0).abs() < 1e-4, "{ratio} at {} s", own.tau_s);
    }
}

#[test]
fn what_a_target_cannot_is_told_with_what_it_can() {
    let before = InProcess::new(Box::new(Target::<Every>::new(0)));
    let text = identified(&scene("paper", 10.0), before, &Manner::default()).unwrap_err();
    let text = text.to_string();
    assert!(text.contains("does not do identification in f64"), "{text}");
    let text = identified(&scene("paper", 10.0), InProcess::single(), &Manner::default());
    let text = text.unwrap_err().to_string();
    assert!(text.contains("identification in f32"), "{text}");
    let too_short = identified(&scene("paper", 1.0), InProcess::every(), &Manner::default());
    assert!(too_short.unwrap_err().to_string().contains("has 20 samples"));
}
