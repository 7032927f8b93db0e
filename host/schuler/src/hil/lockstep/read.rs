//! The whole state of a target, beside its twin's.

use super::super::difference::{Difference, Value};
use super::super::parted::{MOST_REBOOTS, Parted};
use super::super::reply::Reply;
use super::Lockstep;
use schuler::link::message::Request;

impl Lockstep {
    /// Reads every word of the target's state, and compares it with its twin's.
    pub(in super::super) fn read_back(&mut self) -> Result<Vec<u8>, Parted> {
        let mut words: Vec<u8> = Vec::new();
        loop {
            let offset = (words.len() / 8) as u16;
            let (all, piece) = self.read_piece(offset)?;
            if piece.is_empty() && offset < all {
                return Err(Parted::Answer("to read its state"));
            }
            words.extend(piece);
            if words.len() >= 8 * usize::from(all) {
                break;
            }
        }
        let twin = self.twin.words();
        match first_difference(&words, &twin) {
            None => Ok(words),
            Some((word, target, twin)) => Err(Parted::Difference(Difference {
                sample: self.samples.into(),
                time_s: f64::from(self.samples) / self.rate_hz,
                field: format!("word {word} of the state"),
                target,
                twin,
            })),
        }
    }

    /// The number of words of the state, and some of them.
    fn read_piece(&mut self, from: u16) -> Result<(u16, Vec<u8>), Parted> {
        for _ in 0..MOST_REBOOTS {
            match self.ask(&Request::Read { offset: from })? {
                Some(Reply::State { words, offset, piece }) if offset == from => {
                    return Ok((words, piece));
                }
                // A frame that came twice is answered by where the target stands.
                Some(Reply::Standing(_) | Reply::State { .. }) => {}
                Some(_) => return Err(Parted::Answer("to read its state")),
                None => return Err(Parted::Silence("to read its state")),
            }
        }
        Err(Parted::Answer("to read its state"))
    }
}

/// The first word in which two states differ.
fn first_difference(target: &[u8], twin: &[u8]) -> Option<(usize, Value, Value)> {
    let value = |bytes: &[u8], word: usize| {
        let word = bytes.get(8 * word..8 * word + 8)?;
        Some(Value::Bits(u64::from_le_bytes(word.try_into().ok()?)))
    };
    let longest = target.len().max(twin.len()) / 8;
    (0..longest).map(|word| (word, value(target, word), value(twin, word))).find_map(
        |(word, target, twin)| {
            let or_nothing = |value: Option<Value>| value.unwrap_or(Value::Nothing);
            (target != twin).then(|| (word, or_nothing(target), or_nothing(twin)))
        },
    )
}
