//! RTKLIB's time tags of a stream (`.tag`): how many bytes had come by which GPS time. They tie the stamps of a
//! recording, which a unit counts by itself, to that time.
//!
//! A header of 64 bytes ends with the counter of milliseconds at the start; then come the start itself (GPS time,
//! seconds since 1970 in 4 bytes, and their part as a double) and pairs of 4 bytes each: milliseconds since, and bytes
//! that had been written by then. All little-endian.

use super::instant::GPS_EPOCH_S;
use super::rows::Recording;
use super::samples::Samples;
use super::survey::Survey;
use crate::input::name::path_of;
use crate::input::{Complaint, InputError};
use crate::quartile::quartile;

const HEADER: usize = 64;
const MAGIC: &[u8] = b"TIMETAG RTKLIB";
/// By how much the last tag's bytes and the file's may differ, as a part.
const ALIKE: f64 = 0.01;

/// What tags say of a recording.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tied {
    /// GPS time less the recording's, s: the middle one.
    pub ahead_s: f64,
    /// Half of them are within this of it, s.
    pub scatter_s: f64,
    /// How many tags there are.
    pub count: usize,
}

/// Ties a recording to GPS time by a file of tags.
pub fn tie(tags: &str, recording: &Recording, survey: &Survey) -> Result<Tied, InputError> {
    let read = |name: &str| {
        std::fs::read(path_of(name)).map_err(|error| {
            InputError::file(name, Complaint::new(format!("cannot be read: {error}"), ""))
        })
    };
    let refuse =
        |what: String, accepted: &str| Err(InputError::file(tags, Complaint::new(what, accepted)));
    let Some((start_s, pairs)) = parse(&read(tags)?) else {
        return refuse("is no file of time tags".to_owned(), "RTKLIB's .tag of the stream");
    };
    let stream = read(&recording.name)?;
    let mut ends: Vec<u64> =
        (1..).zip(&stream).filter(|(_, b)| **b == b'\n').map(|(n, _)| n).collect();
    let whole = stream.len() as u64;
    let last = pairs.last().map_or(0, |(_, bytes)| *bytes);
    // Ends of lines may have lost a byte since.
    let lines = ends.len() as u64;
    let shorter = last.abs_diff(whole + lines) < last.abs_diff(whole);
    if shorter {
        (1..).zip(&mut ends).for_each(|(n, end)| *end += n);
    }
    let written = if shorter { whole + lines } else { whole };
    if last.abs_diff(written) as f64 > ALIKE * written as f64 {
        let what = format!("goes on to byte {last}, and {} has {whole} bytes", recording.name);
        return refuse(what, "the tags of this stream");
    }
    let mut ends_s = vec![None; ends.len() + 2];
    let mut samples = Samples::new(recording, survey, None)?;
    while let Some(sample) = samples.advance()? {
        if let Some(end_s) = ends_s.get_mut(sample.line as usize).filter(|_| !sample.filled) {
            *end_s = Some(sample.end_s);
        }
    }
    let ahead: Vec<f64> = pairs
        .iter()
        .filter_map(|(milliseconds, bytes)| {
            let line = ends.partition_point(|end| end <= bytes);
            let end_s = ends_s.get(line).copied().flatten()?;
            Some(start_s + f64::from(*milliseconds) * 1e-3 - end_s)
        })
        .collect();
    if ahead.is_empty() {
        return refuse("has no tag of a row that is read".to_owned(), "the tags of this stream");
    }
    let ahead_s = quartile(&ahead, 2);
    let off: Vec<f64> = ahead.iter().map(|one| (one - ahead_s).abs()).collect();
    Ok(Tied { ahead_s, scatter_s: quartile(&off, 2), count: ahead.len() })
}

/// The start, s of GPS time, and pairs of milliseconds since and of bytes.
fn parse(bytes: &[u8]) -> Option<(f64, Vec<(u32, u64)>)> {
    let rest = bytes.strip_prefix(MAGIC)?.get(HEADER - MAGIC.len()..)?;
    let (seconds, rest) = rest.split_first_chunk::<4>()?;
    let (part, rest) = rest.split_first_chunk::<8>()?;
    let start_s =
        f64::from(u32::from_le_bytes(*seconds)) + f64::from_le_bytes(*part) - GPS_EPOCH_S as f64;
    let pairs = rest.chunks_exact(8).map(|pair| {
        let of =
            |at: usize| u32::from_le_bytes([pair[at], pair[at + 1], pair[at + 2], pair[at + 3]]);
        (of(0), u64::from(of(4)))
    });
    let pairs: Vec<_> = pairs.collect();
    let rises = pairs.windows(2).all(|two| two[0].1 <= two[1].1);
    (start_s.is_finite() && rises && !pairs.is_empty()).then_some((start_s, pairs))
}
