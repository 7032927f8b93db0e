//! What lies before a conversation, and what comes in its place.

use super::{fly, manner, scene};
use schuler::link::decoder::Decoder;
use schuler::link::frame::{Header, MOST_ENCODED, encode};
use schuler::link::kind::Kind;
use schuler_host::hil::Manner;
use schuler_host::hil::channel::{Broken, Channel};
use schuler_host::hil::conversation::{Conversation, Outcome};
use schuler_host::hil::in_process::InProcess;
use schuler_host::hil::injector::Injector;
use schuler_host::hil::patience::{PATIENCE, Patience};
use schuler_simulator::scene::Gap;
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

/// A target that stays where it is when a flight ends.
#[derive(Clone)]
struct Lasting(Arc<Mutex<InProcess>>);

impl Channel for Lasting {
    fn send(&mut self, frame: &[u8]) -> Result<(), Broken> {
        self.0.lock().unwrap().send(frame)
    }
    fn receive(&mut self, into: &mut Vec<u8>, patience: Duration) -> Result<(), Broken> {
        self.0.lock().unwrap().receive(into, patience)
    }
}

#[test]
fn a_flight_is_not_charged_with_the_faults_of_the_one_before() {
    let target = Lasting(Arc::new(Mutex::new(InProcess::every())));
    let scene = scene("paper", 5.0);
    for seed in 1..=3 {
        let manner = manner("drop=0.1,flip=0.1,duplicate=0.1,reorder=0.1", seed, 20);
        let (flown, ended) = fly(&scene, target.clone(), &manner);
        flown.unwrap();
        for trace in ended.tally.traces() {
            assert!(trace.is_explained(), "{trace:?} of {:?}", ended.tally);
        }
    }
    let (flown, ended) = fly(&scene, target, &Manner::default());
    flown.unwrap();
    assert_eq!(ended.tally.target, Default::default());
}

/// A line on which no sample gets through.
struct WithoutSamples(InProcess);

impl Channel for WithoutSamples {
    fn send(&mut self, frame: &[u8]) -> Result<(), Broken> {
        let mut decoder = Decoder::default();
        let is_sample = frame
            .iter()
            .any(|&byte| decoder.take(byte).is_some_and(|frame| frame.header.kind == Kind::Sample));
        if is_sample { Ok(()) } else { self.0.send(frame) }
    }
    fn receive(&mut self, into: &mut Vec<u8>, patience: Duration) -> Result<(), Broken> {
        self.0.receive(into, patience)
    }
}

#[test]
fn what_both_sides_refuse_is_told_of_both() {
    let mut scene = scene("paper", 1.0);
    scene.navigator.gap = Gap::Bridge;
    let (flown, _) = fly(&scene, WithoutSamples(InProcess::every()), &Manner::default());
    // There is nothing to bridge from.
    let text = flown.unwrap_err().to_string();
    let parts =
        ["the target refuses (samples are missing", "its twin refuses (samples are missing"];
    assert!(parts.iter().all(|part| text.contains(part)), "{text}");
}

/// Something that talks without end, and is no target; it falls silent only to end the test.
struct Chatter {
    says: Vec<u8>,
    left: u32,
}

impl Channel for Chatter {
    fn send(&mut self, _: &[u8]) -> Result<(), Broken> {
        Ok(())
    }
    fn receive(&mut self, into: &mut Vec<u8>, _: Duration) -> Result<(), Broken> {
        thread::sleep(Duration::from_millis(1));
        self.left = self.left.checked_sub(1).ok_or(Broken("it was heard for too long".into()))?;
        into.extend(&self.says);
        Ok(())
    }
}

#[test]
fn a_line_that_talks_without_end_is_not_listened_to_without_end() {
    // A receiver of satellites; and a target that says unasked, over and over, that it is there.
    let mut hello = Vec::new();
    InProcess::every().receive(&mut hello, Duration::ZERO).unwrap();
    for says in [b"$GPGGA,123519,4807.038,N\r\n".to_vec(), hello] {
        let patience = Duration::from_millis(20);
        let chatter = || Chatter { says: says.clone(), left: 2000 };
        let mut conversation =
            Conversation::new(Box::new(chatter()), 1).patient(Patience::Fixed(patience));
        assert_eq!(conversation.greet(), Ok(Outcome::Silence));

        let mut injector = Injector::new(chatter(), Default::default(), 1);
        // Answers to no request are all that comes: none is passed on, or none that is whole.
        injector.send(&greeting()).unwrap();
        injector.receive(&mut Vec::new(), patience).unwrap();
    }
}

/// The frame of a greeting.
fn greeting() -> Vec<u8> {
    let header = Header { kind: Kind::Greet, sequence: 1, time_ns: 0 };
    encode(&header, &mut [0; MOST_ENCODED], |_| ()).unwrap().to_vec()
}

/// A target on a line that loses every tenth frame; it notes how long it is waited for in vain.
struct Lossy {
    target: InProcess,
    frames: u32,
    lost: bool,
    waits: Arc<Mutex<Vec<Duration>>>,
}

impl Channel for Lossy {
    fn send(&mut self, frame: &[u8]) -> Result<(), Broken> {
        self.frames += 1;
        self.lost = self.frames.is_multiple_of(10);
        if self.lost { Ok(()) } else { self.target.send(frame) }
    }
    fn receive(&mut self, into: &mut Vec<u8>, patience: Duration) -> Result<(), Broken> {
        if self.lost {
            self.waits.lock().unwrap().push(patience);
            return Ok(());
        }
        self.target.receive(into, patience)
    }
}

#[test]
fn a_lost_frame_is_waited_for_as_long_as_answers_take() {
    let waits = |timeout| {
        let waits = Arc::new(Mutex::new(Vec::new()));
        let (target, frames, lost) = (InProcess::every(), 0, false);
        let line = Lossy { target, frames, lost, waits: waits.clone() };
        let manner = Manner { retries: 5, timeout, ..Manner::default() };
        let (flown, ended) = fly(&scene("paper", 60.0), line, &manner);
        flown.unwrap();
        let waits = waits.lock().unwrap().clone();
        assert_eq!((ended.tally.resent, ended.tally.recovered), (133, 133));
        assert_eq!(waits.len(), 133);
        waits
    };
    // Answers that are there at once do not take a second, whatever else a machine does now and then.
    let mut waits_by_trips = waits(None);
    waits_by_trips.sort();
    let median = waits_by_trips[waits_by_trips.len() / 2];
    assert!(median < PATIENCE / 5, "{waits_by_trips:?}");
    let fixed = Duration::from_millis(70);
    assert!(waits(Some(fixed)).iter().all(|&wait| wait <= fixed));
}
