//! Every byte of a recorded session changed, dropped, and joined by others: at most one frame is lost,
//! and what is accepted was sent.

use super::session::{frame, increments, initial, said, start};
use schuler::link::bytes::Bytes;
use schuler::link::counters::Dropped;
use schuler::link::decoder::Decoder;
use schuler::link::fleet::Single;
use schuler::link::frame::{Header, LEAST_FRAME, MOST_ENCODED, MOST_PAYLOAD, TooLong, encode};
use schuler::link::gap::Policy;
use schuler::link::kind::Kind;
use schuler::link::message::Request;
use schuler::link::target::Target;
use schuler::math::compensated::Pair;
use schuler::strapdown::block::window::H0B4A0;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::navigator::Strapdown;
use schuler_tests::{Course, Numbers};

type Flown = Strapdown<LocalLevel<Pair<f32>>, H0B4A0>;

/// A frame that came through: kind, sequence number, time, payload.
type Whole = (Kind, u32, u64, Vec<u8>);

fn decoded(bytes: impl IntoIterator<Item = u8>) -> (Vec<Whole>, Dropped) {
    let (mut decoder, mut frames) = (Decoder::default(), Vec::new());
    for byte in bytes {
        if let Some(frame) = decoder.take(byte) {
            let Header { kind, sequence, time_ns } = frame.header;
            frames.push((kind, sequence, time_ns, frame.payload.to_vec()));
        }
    }
    (frames, decoder.dropped())
}

/// The frames of a short flight, to the target and back.
fn session() -> [Vec<Vec<u8>>; 2] {
    let course = Course::new("manoeuvre", 1.0, 0.12);
    let (initial, increments) = (initial::<Flown>(&course), increments::<f32>(&course));
    let mut requests = vec![Request::Greet, start::<Flown>(&initial, Policy::Bridge)];
    for (number, increment) in (1..).zip(&increments) {
        requests.push(Request::Sample { number, increment: Bytes(increment) });
    }
    requests.push(Request::Finish { samples: increments.len() as u32 });
    let mut target = Target::<Single>::new(3);
    let out: Vec<_> = (1..).zip(&requests).map(|(n, request)| frame(request, n)).collect();
    let back = out.iter().map(|frame| said(&mut target, frame)).collect();
    [out, back]
}

/// Changes every byte of every frame, among its neighbours, in every way, and looks at what comes through.
fn hit(frames: &[Vec<u8>], mut ways: impl FnMut(&[u8], usize, &mut dyn FnMut(&[u8]))) -> u64 {
    let mut cases = 0;
    for window in frames.windows(3) {
        let whole: Vec<u8> = window.concat();
        let (sent, dropped) = decoded(whole.iter().copied());
        assert_eq!((sent.len(), dropped.total()), (3, 0));
        let (begin, end) = (window[0].len(), window[0].len() + window[1].len());
        for place in begin..end {
            ways(&whole, place, &mut |bytes| {
                cases += 1;
                let (came, _) = decoded(bytes.iter().copied());
                let mut rest = sent.iter();
                let wrong = came.iter().find(|&frame| !rest.any(|sent| sent == frame));
                assert_eq!(wrong, None, "byte {place} of {whole:?}: {bytes:?}");
                assert!(came.len() >= 2, "byte {place} of {whole:?}: {bytes:?}");
            });
        }
    }
    cases
}

#[test]
fn a_byte_that_is_another_costs_one_frame() {
    for frames in session() {
        let bytes: usize = frames[1..frames.len() - 1].iter().map(Vec::len).sum();
        let cases = hit(&frames, |whole, place, look| {
            let mut bytes = whole.to_vec();
            for change in 1..=255 {
                bytes[place] = whole[place] ^ change;
                look(&bytes);
            }
        });
        assert_eq!(cases, 255 * bytes as u64);
    }
}

#[test]
fn a_byte_too_few_costs_one_frame() {
    for frames in session() {
        let cases = hit(&frames, |whole, place, look| {
            look(&[&whole[..place], &whole[place + 1..]].concat());
        });
        assert!(cases > 500);
    }
}

#[test]
fn a_byte_too_many_costs_one_frame() {
    for frames in session() {
        let cases = hit(&frames, |whole, place, look| {
            for byte in [0, 1, 2, 0x7f, 0xfe, 0xff, whole[place]] {
                look(&[&whole[..place], &[byte], &whole[place..]].concat());
            }
        });
        assert!(cases > 500);
    }
}

#[test]
fn noise_is_no_frame_and_every_reason_is_counted() {
    let mut numbers = Numbers(5);
    let (frames, dropped) = decoded((0..300_000).map(|_| numbers.word() as u8));
    assert!(frames.is_empty());
    // A zero byte in 256 ends a piece: most are longer than a header, many longer than a frame.
    for count in [dropped.stuffing, dropped.long] {
        assert!(count > 100, "{dropped:?}");
    }
    let mut broken = unknown_kind();
    broken[9] ^= 1;
    assert_eq!(decoded(broken).1, Dropped { check: 1, ..Dropped::default() });
    assert_eq!(decoded([0, 3, 7, 7, 0]).1, Dropped { short: 1, ..Dropped::default() });
    assert_eq!(decoded([0, 9, 7, 7, 0]).1, Dropped { stuffing: 1, ..Dropped::default() });
    assert_eq!(decoded(unknown_kind()).1, Dropped { kind: 1, ..Dropped::default() });
}

/// A frame that is right but for its kind. CRC-32 (ISO-HDLC) bit by bit, as its definition has it.
fn unknown_kind() -> Vec<u8> {
    let mut content = vec![0x42_u8; LEAST_FRAME - 4];
    let mut remainder = u32::MAX;
    for &byte in &content {
        remainder ^= u32::from(byte);
        for _ in 0..8 {
            let carry = remainder & 1;
            remainder = (remainder >> 1) ^ (0xedb8_8320 * carry);
        }
    }
    content.extend((!remainder).to_le_bytes());
    // Nothing in it is zero: one stuffing byte, then all of it.
    assert!(!content.contains(&0));
    let mut bytes = vec![0, content.len() as u8 + 1];
    bytes.extend(content);
    bytes.push(0);
    bytes
}

#[test]
fn frames_of_every_length_come_through_and_longer_ones_are_refused() {
    let header = Header { kind: Kind::Sample, sequence: 0xffff_ff00, time_ns: u64::MAX };
    for length in 0..=MOST_PAYLOAD + 1 {
        for fill in [0, 1, 0xff] {
            let payload = vec![fill; length];
            let mut buffer = [0xaa; MOST_ENCODED];
            let encoded = encode(&header, &mut buffer, |to| to.bytes(&payload));
            if length > MOST_PAYLOAD {
                assert_eq!(encoded, Err(TooLong));
                continue;
            }
            let encoded = encoded.unwrap();
            let inner = &encoded[1..encoded.len() - 1];
            assert!(encoded.len() <= MOST_ENCODED && !inner.contains(&0));
            let (frames, _) = decoded(encoded.iter().copied());
            assert_eq!(frames, [(Kind::Sample, 0xffff_ff00, u64::MAX, payload)]);
        }
    }
}
