//! Normal deviates of many words at once: those of the core's streams, bit for bit.
//!
//! The centre of the distribution is computed for every word. The words of the tails, a logarithm and a
//! root dearer, are gathered first: they are 15 of 100.

use super::pack::{Lanes, Task};
use super::words::Words;
use super::{InLanes, Registers, in_registers};
use schuler::noise::Deviate;
use schuler::noise::quantile::double::{CENTRE, UNIT, centre, tail};
use std::array;
use std::marker::PhantomData;

/// How many deviates are made at once, of all lanes together.
pub const AT_ONCE: usize = 128;

/// As many words.
pub type Drawn = [u64; AT_ONCE];

/// As many deviates, in the order of the words.
pub type Deviates = [f64; AT_ONCE];

/// The states of the generators of all lanes, xoshiro256++.
pub type Generator<const N: usize> = [[u64; N]; 4];

/// Every bit but the sign.
const BELOW_SIGN: u64 = u64::MAX >> 1;

/// The next words of each lane, one of every lane after the other.
#[inline(always)]
pub fn draw<P: Lanes<N>, const N: usize>(generator: &mut Generator<N>) -> Drawn {
    let [mut a, mut b, mut c, mut d] = generator.map(P::Words::from_lanes);
    let turned = |words: P::Words, places| words.up(places) | words.down(64 - places);
    let mut drawn = [0; AT_ONCE];
    for words in drawn.as_chunks_mut().0 {
        *words = (turned(a + d, 23) + a).lanes();
        let moved = b.up(17);
        c = c ^ a;
        d = d ^ b;
        b = b ^ c;
        a = a ^ d;
        c = c ^ moved;
        d = turned(d, 45);
    }
    *generator = [a, b, c, d].map(Words::lanes);
    drawn
}

/// The deviates of words, in the lanes of this kind of number.
#[inline(always)]
pub fn transform<P: Lanes<N>, const N: usize>(drawn: &Drawn, deviates: &mut Deviates) {
    let below_sign = P::Words::all(BELOW_SIGN);
    let sign = P::Words::all(!BELOW_SIGN);
    let signed = |z: P, words: P::Words| P::from_bits(z.to_bits() | (words & sign)).lanes();
    let probability = |k: P::Words| (P::nearest(k) + P::HALF) * P::of(UNIT);

    let (mut places, mut rare) = ([0u8; AT_ONCE], 0);
    let outputs = deviates.as_chunks_mut().0;
    for ((first, words), output) in (0..).step_by(N).zip(drawn.as_chunks().0).zip(outputs) {
        let words = P::Words::from_lanes(*words);
        let k = words & below_sign;
        *output = signed(centre(probability(k)), words);
        let mut marks = P::marks(P::beyond(k, CENTRE - 1));
        while marks != 0 {
            places[rare % AT_ONCE] = first + marks.trailing_zeros() as u8;
            rare += 1;
            marks &= marks - 1;
        }
    }
    for places in places[..rare].chunks(N) {
        // In lanes that are left over, the first word once more.
        let places: [usize; N] =
            array::from_fn(|lane| usize::from(*places.get(lane).unwrap_or(&places[0])) % AT_ONCE);
        let words = P::Words::from_lanes(places.map(|place| drawn[place]));
        // 2⁶³ − 1 − k
        let rest = (words & below_sign) ^ below_sign;
        let tails = signed(tail(probability(rest)), words);
        for (place, tail) in places.into_iter().zip(tails) {
            deviates[place] = tail;
        }
    }
}

/// The deviates of words of one stream, in the widest registers that are there.
pub fn transform_any(drawn: &Drawn, deviates: &mut Deviates) {
    for registers in [Registers::Avx512, Registers::Avx2] {
        if in_registers(registers, Transform { drawn, deviates: &mut *deviates }).is_some() {
            return;
        }
    }
    for (deviate, &word) in deviates.iter_mut().zip(drawn) {
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
