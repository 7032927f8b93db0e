//! A navigator's state as bytes: what it takes to go on bit for bit, with a check.
//!
//! Little-endian: a word of 4 bytes each for the mark, the version of the interface, the navigator and the number
//! of words; then words of 8 bytes: the interval's two numbers, the order, the words of the state, and the digest
//! of all words before it.

use crate::SCHULER_ABI;
use crate::held::Keep as _;
use crate::navigation::{Navigation, Numbered, level};
use crate::results::Code;
use schuler::digest::Digest;
use schuler::math::compensated::Pair;
use schuler::math::real::Scalar;
use schuler::record::Record;

/// "SCHU".
const MARK: u32 = u32::from_le_bytes(*b"SCHU");
/// Words of 8 bytes beside those of the state: the head takes two, interval and order three, the digest one.
const BESIDE: usize = 6;
/// More than a state has.
const MOST_WORDS: u32 = 1 << 16;

/// Bytes in pieces of eight.
struct Words<'a>(core::slice::ChunksExact<'a, u8>);

impl Words<'_> {
    fn word(&mut self) -> Option<u64> {
        self.0.next()?.try_into().ok().map(u64::from_le_bytes)
    }

    /// Two numbers of 4 bytes.
    fn halves(&mut self) -> Option<[u32; 2]> {
        self.word().map(|word| [word as u32, (word >> 32) as u32])
    }
}

fn joined([low, high]: [u32; 2]) -> u64 {
    u64::from(low) | u64::from(high) << 32
}

impl<M: Numbered> Navigation<M> {
    /// Shows the words that are stored after the head.
    fn words(&self, see: &mut dyn FnMut(u64)) {
        let Pair { hi, lo } = self.interval_s;
        see(hi.to_bits());
        see(lo.to_bits());
        see(self.order.into());
        self.state.record("", &mut |_, bits| see(bits));
    }

    /// Bytes of the stored form.
    pub(crate) fn saved_size(&self) -> usize {
        let mut words = 0_usize;
        self.words(&mut |_| words = words.saturating_add(1));
        // The head and the digest.
        words.saturating_add(BESIDE - 3).saturating_mul(8)
    }

    /// Writes the stored form to the front of some bytes, and returns its length. Too few bytes stay as they are.
    pub(crate) fn save(&self, bytes: &mut [u8]) -> Result<usize, Code> {
        let length = self.saved_size();
        let bytes = bytes.get_mut(..length).ok_or(Code::SPACE)?;
        let words = (length / 8 - BESIDE) as u32;
        let (mut places, _) = bytes.as_chunks_mut::<8>();
        let mut write = |word: u64| {
            if let Some((place, rest)) = core::mem::take(&mut places).split_first_mut() {
                *place = word.to_le_bytes();
                places = rest;
            }
        };
        let mut digest = Digest::default();
        let mut add = |word: u64| {
            digest.add_words([word]);
            write(word);
        };
        add(joined([MARK, SCHULER_ABI]));
        add(joined([Self::KIND, words]));
        self.words(&mut add);
        write(digest.value());
        Ok(length)
    }

    /// Back from the stored form.
    pub(crate) fn restore(bytes: &[u8]) -> Result<Self, Code> {
        let mut stored = Words(bytes.chunks_exact(8));
        let [mark, abi] = stored.halves().ok_or(Code::DAMAGED)?;
        let [kind, words] = stored.halves().ok_or(Code::DAMAGED)?;
        if mark != MARK || words > MOST_WORDS {
            return Err(Code::DAMAGED);
        }
        if abi != SCHULER_ABI {
            return Err(Code::STALE);
        }
        if kind != Self::KIND {
            return Err(Code::FOREIGN);
        }
        if bytes.len() != (words as usize).saturating_add(BESIDE).saturating_mul(8) {
            return Err(Code::DAMAGED);
        }
        check(bytes)?;
        let mut next = || stored.word().ok_or(Code::DAMAGED);
        let mut number = || Ok::<_, Code>(M::Real::from_bits(next()?));
        let interval_s = Pair { hi: number()?, lo: number()? };
        let order = u32::try_from(next()?).map_err(|_| Code::DAMAGED)?;
        let mechanization = M::configured(interval_s, order as usize).map_err(|_| Code::DAMAGED)?;
        let mut state = mechanization.start(&level())?;
        let mut left = words;
        let mut complete = true;
        state.restore("", &mut |_, bits| {
            complete &= left > 0;
            left = left.saturating_sub(1);
            next().unwrap_or(bits)
        });
        if !complete || left > 0 {
            return Err(Code::DAMAGED);
        }
        mechanization.check(&state)?;
        Ok(Self { mechanization, state, interval_s, order })
    }
}

/// Whether the last word is the digest of those before it.
fn check(bytes: &[u8]) -> Result<(), Code> {
    let (words, _) = bytes.as_chunks::<8>();
    let (last, words) = words.split_last().ok_or(Code::DAMAGED)?;
    let mut digest = Digest::default();
    words.iter().for_each(|word| digest.add_words([u64::from_le_bytes(*word)]));
    if digest.value() == u64::from_le_bytes(*last) { Ok(()) } else { Err(Code::DAMAGED) }
}
