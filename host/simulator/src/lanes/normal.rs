//! Normal deviates of many words at once: those of the core's streams, bit for bit.
//!
//! The centre of the distribution is computed for every word. The words of the tails, a logarithm and a
//! root dearer, are gathered first: they are 15 of 100.

use super::drawn::{AT_ONCE, Deviates, Drawn, Generator, Lines};
use super::pack::{Lanes, Task};
use super::words::Words;
use super::{InLanes, Registers, in_registers};
use schuler::noise::Deviate;
use schuler::noise::quantile::double::{CENTRE, UNIT, centre, tail};
use std::marker::PhantomData;

/// Every bit but the sign.
const BELOW_SIGN: u64 = u64::MAX >> 1;

/// Which bits of four are set, from the lowest byte on, and how many.
const MARKED: [(u32, usize); 16] = {
    let mut table = [(0, 0); 16];
    let mut bit = 64;
    while bit > 0 {
        bit -= 1;
        let (marks, place) = (bit / 4, bit as u32 % 4);
        if marks >> place & 1 == 1 {
            table[marks] = (table[marks].0 << 8 | place, table[marks].1 + 1);
        }
    }
    table
};

/// The next words of each lane, one of every lane after the other.
#[inline(always)]
pub fn draw<P: Lanes<N>, const N: usize>(generator: &mut Generator<N>) -> Drawn {
    let [a, b, c, d] = *generator;
    let (mut a, mut b) = (P::Words::from_lanes(a), P::Words::from_lanes(b));
    let (mut c, mut d) = (P::Words::from_lanes(c), P::Words::from_lanes(d));
    let mut drawn = Lines([0; AT_ONCE]);
    for words in drawn.0.as_chunks_mut().0 {
        *words = ((a + d).turned(23) + a).lanes();
        let moved = b.up(17);
        c = c ^ a;
        d = d ^ b;
        b = b ^ c;
        a = a ^ d;
        c = c ^ moved;
        d = d.turned(45);
    }
    *generator = [a.lanes(), b.lanes(), c.lanes(), d.lanes()];
    drawn
}

/// The deviates of words, in the lanes of this kind of number.
#[inline(always)]
pub fn transform<P: Lanes<N>, const N: usize>(drawn: &Drawn, deviates: &mut Deviates) {
    let below_sign = P::Words::all(BELOW_SIGN);
    let (mut places, mut rare) = ([0u8; AT_ONCE + 8], 0);
    let outputs = deviates.0.as_chunks_mut().0;
    let mut first = 0;
    for (words, output) in drawn.0.as_chunks().0.iter().zip(outputs) {
        let words = P::Words::from_lanes(*words);
        let k = words & below_sign;
        *output = signed::<P, N>(centre(probability(k)), words).lanes();
        let marks = P::marks(P::beyond(k, CENTRE - 1));
        // No branch: which words are rare nobody can predict.
        for four in (0..N).step_by(4) {
            let (marked, count) = MARKED[(marks >> four) as usize % 16];
            if let Some(room) = places.get_mut(rare..).and_then(<[u8]>::first_chunk_mut) {
                *room = (marked + 0x0101_0101 * (first + four as u32)).to_le_bytes();
            }
            rare += count;
        }
        first += N as u32;
    }
    // In lanes that are left over, the last one once more.
    let last = places[rare.saturating_sub(1)];
    places[rare..rare + N].fill(last);
    let groups: &[[u8; N]] = places.as_chunks().0;
    for places in &groups[..rare.div_ceil(N)] {
        let mut words = [0; N];
        for lane in 0..N {
            words[lane] = drawn.0[usize::from(places[lane])];
        }
        let words = P::Words::from_lanes(words);
        // 2⁶³ − 1 − k
        let rest = (words & below_sign) ^ below_sign;
        let tails = signed::<P, N>(tail(probability(rest)), words).lanes();
        for lane in 0..N {
            deviates.0[usize::from(places[lane])] = tails[lane];
        }
    }
}

/// The probability that a word without its sign stands for.
#[inline(always)]
fn probability<P: Lanes<N>, const N: usize>(k: P::Words) -> P {
    (P::nearest(k) + P::HALF) * P::of(UNIT)
}

/// Deviates with the signs of words.
#[inline(always)]
fn signed<P: Lanes<N>, const N: usize>(z: P, words: P::Words) -> P {
    P::from_bits(z.to_bits() | (words & P::Words::all(!BELOW_SIGN)))
}

/// The deviates of words of one stream, in the widest registers that are there.
pub fn transform_any(drawn: &Drawn, deviates: &mut Deviates) {
    for registers in [Registers::Avx512, Registers::Avx2] {
        if in_registers(registers, Transform { drawn, deviates: &mut *deviates }).is_some() {
            return;
        }
    }
    for (deviate, word) in deviates.0.iter_mut().zip(drawn.0) {
        *deviate = f64::normal(word);
    }
}

/// Words to transform.
struct Transform<'a> {
    drawn: &'a Drawn,
    deviates: &'a mut Deviates,
}

impl InLanes for Transform<'_> {
    type Output = ();
    fn run<P: Lanes<N>, const N: usize>(self) {
        P::compiled(TransformIn::<P, N>(self, PhantomData));
    }
}

/// The same in lanes of one kind.
struct TransformIn<'a, P, const N: usize>(Transform<'a>, PhantomData<P>);

impl<P: Lanes<N>, const N: usize> Task for TransformIn<'_, P, N> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        transform::<P, N>(self.0.drawn, self.0.deviates);
    }
}

/// Streams to draw from.
pub struct Fill<'a, P, const N: usize> {
    generator: &'a mut Generator<N>,
    deviates: &'a mut Deviates,
    lanes: PhantomData<P>,
}

impl<'a, P: Lanes<N>, const N: usize> Fill<'a, P, N> {
    /// The next deviates of the streams.
    pub fn new(generator: &'a mut Generator<N>, deviates: &'a mut Deviates) -> Self {
        Self { generator, deviates, lanes: PhantomData }
    }
}

impl<P: Lanes<N>, const N: usize> Task for Fill<'_, P, N> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        transform::<P, N>(&draw::<P, N>(self.generator), self.deviates);
    }
}
