//! Any bytes, and frames of any content, to a target: every whole frame of a host is answered by one whole
//! frame, and what was counted adds up.

#![no_main]

use libfuzzer_sys::fuzz_target;
use schuler::link::counters::Counters;
use schuler::link::decoder::Decoder;
use schuler::link::fleet::Single;
use schuler::link::frame::{Header, MOST_ENCODED, MOST_PAYLOAD, encode};
use schuler::link::kind::Kind;
use schuler::link::message::{Answer, Body};
use schuler::link::target::Target;

/// What a host says.
const REQUESTS: [Kind; 7] =
    [Kind::Greet, Kind::Start, Kind::Restore, Kind::Sample, Kind::Hold, Kind::Finish, Kind::Reset];

/// A target with the host's ends of both lines.
struct Line {
    target: Target<Single>,
    /// What a decoder makes of the bytes to it, and of those from it.
    to: Decoder,
    from: Decoder,
    sequence: u32,
    /// The last sequence number that was new to the target.
    last: Option<u32>,
    /// Frames missing, duplicated and late.
    counts: [u32; 3],
}

impl Line {
    /// Some bytes to the target, and what it says to them.
    fn tell(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            let request = self.to.take(byte).map(|frame| frame.header);
            let mut said = Vec::new();
            self.target.take(byte, &mut |bytes| said.extend_from_slice(bytes));
            let is_asked = request.is_some_and(|request| REQUESTS.contains(&request.kind));
            if let Some(request) = request.filter(|_| is_asked) {
                self.expect(&request);
            }
            let mut answers = 0;
            for byte in said {
                let Some(frame) = self.from.take(byte) else { continue };
                answers += 1;
                let answer = Answer::read(&frame).expect("what a target says is understood");
                let request = request.expect("nothing but a frame is answered");
                let unasked = request.kind == Kind::Reset;
                assert_eq!(answer.answers, if unasked { 0 } else { request.sequence });
                let Counters { dropped, missing, duplicated, late, .. } = answer.counters;
                assert_eq!(dropped, self.to.dropped());
                assert_eq!([missing, duplicated, late], self.counts);
                if let Body::Solution(standing) = answer.body {
                    assert!(standing.integrated <= u64::from(standing.taken));
                }
            }
            assert_eq!(answers, u32::from(is_asked));
            assert_eq!(self.from.dropped().total(), 0);
        }
    }

    /// Counts a request, as the target should.
    fn expect(&mut self, request: &Header) {
        let Header { kind, sequence, .. } = *request;
        if matches!(kind, Kind::Greet | Kind::Reset) {
            (self.to, self.counts) = (Decoder::default(), [0; 3]);
            self.last = (kind == Kind::Greet).then_some(sequence);
            return;
        }
        let [missing, duplicated, late] = &mut self.counts;
        match self.last.map_or(1, |last| sequence.wrapping_sub(last)) {
            0 => *duplicated += 1,
            // Half of all numbers lie ahead of one.
            ahead @ 1..0x8000_0000 => {
                *missing = missing.wrapping_add(ahead - 1);
                self.last = Some(sequence);
            }
            _ => *late += 1,
        }
    }

    /// A frame with some payload, the next in the sequence or not.
    fn ask(&mut self, choice: u8, payload: &[u8]) {
        let kind = REQUESTS[usize::from(choice) % REQUESTS.len()];
        if choice < 0xe0 {
            self.sequence = self.sequence.wrapping_add(1);
        }
        let header = Header { kind, sequence: self.sequence, time_ns: self.sequence.into() };
        let mut buffer = [0; MOST_ENCODED];
        let frame = encode(&header, &mut buffer, |to| to.bytes(payload));
        self.tell(frame.expect("no longer than a payload may be"));
    }
}

/// A start of the first mechanization of [`Single`]: interval, position, velocity, attitude.
fn start() -> Vec<u8> {
    let solution = [0.8, 0.2, 1000.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0_f32];
    let pairs = [0.05].into_iter().chain(solution).flat_map(|x| [x, 0.0]);
    let configuration = [1, 0, 0, 0, 4, 0, 20, 1];
    configuration.into_iter().chain(pairs.flat_map(f32::to_le_bytes)).collect()
}

fuzz_target!(|bytes: &[u8]| {
    let mut line = Line {
        target: Target::new(0),
        to: Decoder::default(),
        from: Decoder::default(),
        sequence: 0,
        last: None,
        counts: [0; 3],
    };
    line.ask(1, &start());
    assert!(line.target.flight().is_some());
    let mut rest = bytes;
    while let [choice, length, after @ ..] = rest {
        let length = usize::from(*length).min(MOST_PAYLOAD).min(after.len());
        let (piece, after) = after.split_at(length);
        // One in sixteen is no frame.
        if choice % 16 == 15 {
            line.tell(piece)
        } else {
            line.ask(*choice, piece)
        }
        rest = after;
    }
});
