//! A host as simple as can be, and what it says to a target.

use schuler::flight::carried::Carried;
use schuler::flight::catalogue::Entry;
use schuler::link::bytes::Bytes;
use schuler::link::decoder::Decoder;
use schuler::link::fleet::Fleet;
use schuler::link::frame::{Header, MOST_ENCODED, encode};
use schuler::link::gap::Policy;
use schuler::link::message::{Answer, Request, Start};
use schuler::link::target::Target;
use schuler::math::compensated::Pair;
use schuler::math::real::Scalar;
use schuler::record::Record;
use schuler::solution::Solution;
use schuler_tests::Course;

/// A request on its way to a target.
pub fn frame(request: &Request, sequence: u32) -> Vec<u8> {
    let header = Header { kind: request.kind(), sequence, time_ns: u64::from(sequence) };
    let mut buffer = [0; MOST_ENCODED];
    encode(&header, &mut buffer, |to| request.write(to)).unwrap().to_vec()
}

/// Everything that a target says to some bytes.
pub fn said<F: Fleet>(target: &mut Target<F>, bytes: &[u8]) -> Vec<u8> {
    let mut said = Vec::new();
    for &byte in bytes {
        target.take(byte, &mut |answer| said.extend_from_slice(answer));
    }
    said
}

/// Shows every answer among some bytes.
pub fn answers(bytes: &[u8], mut show: impl FnMut(Header, Answer)) {
    let mut decoder = Decoder::default();
    for &byte in bytes {
        if let Some(frame) = decoder.take(byte) {
            show(frame.header, Answer::read(&frame).expect("an answer"));
        }
    }
    assert_eq!(decoder.dropped().total(), 0);
}

/// The words of a record as scalars on the line.
pub fn scalars<R: Scalar>(record: impl Record) -> Vec<u8> {
    let mut bytes = Vec::new();
    record.record("", &mut |_, bits| {
        bytes.extend_from_slice(&bits.to_le_bytes()[..size_of::<R>()]);
    });
    bytes
}

/// The samples of a course as they cross the line.
pub fn increments<R: Scalar + Record>(course: &Course) -> Vec<Vec<u8>> {
    let mut carried = Carried::default();
    course.samples.iter().map(|sample| scalars::<R>(carried.narrow::<R>(sample))).collect()
}

/// What the start of a mechanization carries.
pub fn initial<M: Entry>(course: &Course) -> Vec<u8> {
    let interval_s = Pair::<M::Real>::narrow(course.interval_s);
    let mut bytes = scalars::<M::Real>(interval_s);
    bytes.extend(scalars::<M::Real>(Solution::<M::Real>::narrow(&course.initial())));
    bytes
}

/// The request that starts a mechanization.
pub fn start<M: Entry>(initial: &[u8], gap: Policy) -> Request<'_> {
    let configuration = M::CONFIGURATION;
    Request::Start(Start { offer: configuration.into(), order: 20, gap, initial: Bytes(initial) })
}
