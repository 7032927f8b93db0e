//! Age: states stored after a long run, and sums of very many terms.

use super::case::{Case, Check, Outcome};
use super::floor::{SINGLE_UNIT, UNIT};
use super::flown::built_in;
use super::split_mix::word;
use schuler::flight::carried::Carried;
use schuler::math::compensated::{Accumulate as _, Pair, Plain, TwoFloat};
use schuler::math::real::{Real as _, Scalar};
use schuler::record::Record;
use schuler::solution::Solution;
use schuler::strapdown::block::window::{H0B4A0, H2B4A2};
use schuler::strapdown::frame::earth_fixed::EarthFixed;
use schuler::strapdown::frame::local_level::LocalLevel;
use schuler::strapdown::limits::StartError;
use schuler::strapdown::mechanization::Mechanization;
use schuler::strapdown::navigator::Strapdown;
use schuler::strapdown::reference::textbook::{LocalLevelTextbook, Textbook};
use schuler_simulator::progress::CaseProgress;
use schuler_simulator::source::Source;

const GROUP: &str = "aged";

/// The group's cases.
pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for (days, long) in [(0.25, false), (10.0, true)] {
        let mut add = |what: &str, run: fn(f64, &CaseProgress) -> Outcome| {
            let name = format!("stored after {days} d, {what}");
            let case = Case::new(GROUP, name, move |p| run(days, p));
            cases.push(if long { case.long() } else { case });
        };
        add("local-level f64", |days, p| {
            stored(days, Strapdown::<LocalLevel<Pair<f64>>, H2B4A2>::new, p)
        });
        add("earth-fixed f64", |days, p| {
            stored(days, Strapdown::<EarthFixed<Pair<f64>>, H2B4A2>::new, p)
        });
        add("local-level f32x2", |days, p| {
            stored(days, Strapdown::<LocalLevel<TwoFloat<f32>>, H0B4A0>::new, p)
        });
        add("earth-fixed f32x2", |days, p| {
            stored(days, Strapdown::<EarthFixed<TwoFloat<f32>>, H0B4A0>::new, p)
        });
        add("textbook f64", |days, p| {
            stored(days, |h| Textbook::<LocalLevelTextbook<f64>>::new(h.hi), p)
        });
    }
    for (terms, long) in [(10_000_000, false), (1_000_000_000, true)] {
        let mut add = |what: &str, run: fn(u64, &CaseProgress) -> Outcome| {
            let case = Case::new(GROUP, format!("{terms:e} terms, {what}"), move |p| run(terms, p));
            cases.push(if long { case.long() } else { case });
        };
        add("random", random_terms);
        add("all alike", equal_terms);
        add("random, f32", random_singles);
    }
    cases
}

/// Flies for days, stores the state as words in the middle of a block, reads them back into the state of
/// another flight, and goes on with both.
fn stored<M>(
    days: f64,
    new: impl Fn(Pair<M::Real>) -> Result<M, StartError>,
    progress: &CaseProgress,
) -> Outcome
where
    M: Mechanization<Real: Scalar, State: Record>,
{
    const AFTER: u64 = 10_000;
    let scene = built_in("sea-state", |scene| scene.duration_s = days * 86400.0)?;
    let source = Source::new(&scene, false).map_err(|error| error.to_string())?;
    let before = scene.samples() + 1;
    // The swell repeats itself by and by; a hundred seconds of it, over and over, age as well.
    let cycle: Vec<_> = (1..=5000).map(|n| source.perfect_sample(n)).collect();
    let interval_s = Pair::narrow(Pair::new(scene.rate_hz).reciprocal());
    let refused = |error: StartError| error.to_string();
    let mechanization = new(interval_s).map_err(refused)?;
    let initial = Solution::narrow(&source.initial(0));
    let mut original = mechanization.start(&initial).map_err(refused)?;
    let mut carried = Carried::default();
    let mut samples = cycle.iter().cycle().map(|sample| carried.narrow(sample));
    for n in 1..=before {
        let Some(sample) = samples.next() else { break };
        // The vertical channel is held, as no flight of days is possible otherwise.
        if n % 4 == 0 {
            let held = mechanization.hold_vertical(&mut original, M::Real::ZERO, M::Real::ZERO);
            held.map_err(|why| why.to_string())?;
        }
        let taken = mechanization.push(&mut original, sample);
        taken.map_err(|why| format!("sample {n}: {why}"))?;
        progress.reach(n, before);
    }
    let words = bits(&original);
    let mut copy = mechanization.start(&initial).map_err(refused)?;
    let mut rest = words.iter();
    copy.restore("", &mut |_, word| rest.next().copied().unwrap_or(!word));
    let mut differing = count(&bits(&copy), &words) + rest.len() as u64;
    for sample in samples.take(AFTER as usize) {
        for state in [&mut original, &mut copy] {
            mechanization.push(state, sample).map_err(|why| why.to_string())?;
        }
        differing += count(&bits(&copy), &bits(&original));
    }
    let why = "a state read back from its words goes on bit for bit";
    Ok(vec![Check::never("words that differ", differing, why)])
}

fn bits<S: Record>(state: &S) -> Vec<u64> {
    let mut words = Vec::new();
    state.record("", &mut |_, word| words.push(word));
    words
}

/// How many of the words differ.
fn count(a: &[u64], b: &[u64]) -> u64 {
    a.iter().zip(b).filter(|(a, b)| a != b).count() as u64 + a.len().abs_diff(b.len()) as u64
}

/// 2⁶⁰: what makes an integer of a term.
const SCALE: f64 = 1_152_921_504_606_846_976.0;

/// A pair less an exact sum in units of 2⁻⁶⁰: the leading part is a whole number of them.
fn off(sum: Pair<f64>, exact: i128) -> f64 {
    (((sum.hi * SCALE) as i128 - exact) as f64 + sum.lo * SCALE).abs() / SCALE
}

/// Deviates of a walk that are not met.
const MOST_SIGMA: f64 = 6.0;

/// Terms from 1/256 to 1 of 53 random bits.
fn random_terms(terms: u64, progress: &CaseProgress) -> Outcome {
    let (mut pair, mut plain) = (Pair::new(0.0), Plain(0.0));
    let mut whole = TwoFloat(Pair::new(0.0));
    let (mut exact, mut state) = (0_i128, 1);
    for n in 0..terms {
        let random = word(&mut state);
        let integer = i128::from((random >> 12) | (1 << 52)) << (random & 7);
        let term = integer as f64 / SCALE;
        exact += integer;
        pair.add(term);
        plain.add(term);
        whole.add_pair(Pair::new(term));
        progress.reach(n, terms);
    }
    let n = terms as f64;
    // A pair rounds d + lo, |lo| ≤ ½ulp(sum) < 1, once per term: to half an ulp of 1 at most, u, of rms u/√3.
    let walk = MOST_SIGMA * UNIT * (n / 3.0).sqrt();
    // A whole pair rounds its low part only: to u of half an ulp of the sum.
    let low = MOST_SIGMA * UNIT * UNIT * n * (n / 3.0).sqrt();
    // A plain sum rounds itself: u of it, each time.
    let why = "6 sigma of a walk of n roundings: of a term, of the low part";
    let (plain_off, pair_off) = (off(Pair::new(plain.0), exact), off(pair, exact));
    let worse = plain_off / pair_off;
    Ok(vec![
        Check::at_most("compensated", walk, pair_off, "", why),
        // The comparison itself rounds the low part to a double.
        Check::at_most("two-float", low + UNIT * UNIT * n, off(whole.0, exact), "", why),
        Check::at_most("plain", MOST_SIGMA * UNIT * n * (n / 9.0).sqrt(), plain_off, "", why),
        Check::at_least(
            "plain over compensated",
            10.0,
            worse,
            "times",
            "or the case shows nothing",
        ),
    ])
}

/// A tenth again and again: roundings that are all of one sign.
fn equal_terms(terms: u64, progress: &CaseProgress) -> Outcome {
    let term = 0.1_f64;
    let (mut pair, mut whole) = (Pair::new(0.0), TwoFloat(Pair::new(0.0)));
    for n in 0..terms {
        pair.add(term);
        whole.add_pair(Pair::new(term));
        progress.reach(n, terms);
    }
    // 0.1 is a whole number of 2⁻⁵⁶.
    let exact = (term * SCALE) as i128 * i128::from(terms);
    let n = terms as f64;
    let why = "n roundings of one sign: of a term and the low part, of the low part";
    // |d + lo| < 0.1 + ½ulp(sum)
    let rounded = term + UNIT * term * n;
    Ok(vec![
        Check::at_most("compensated", n * UNIT * rounded, off(pair, exact), "", why),
        Check::at_most("two-float", n * UNIT * UNIT * term * n, off(whole.0, exact), "", why),
    ])
}

/// The same in single precision: terms in [½, 1) of 24 random bits.
fn random_singles(terms: u64, progress: &CaseProgress) -> Outcome {
    let (mut pair, mut whole) = (Pair::new(0.0_f32), TwoFloat(Pair::new(0.0_f32)));
    let (mut exact, mut state) = (0_u64, 2);
    for n in 0..terms {
        let integer = (word(&mut state) >> 41) as u32 | (1 << 23);
        let term = integer as f32 / 16_777_216.0;
        exact += u64::from(integer);
        pair.add(term);
        whole.add_pair(Pair::new(term));
        progress.reach(n, terms);
    }
    let off = |sum: Pair<f32>| (sum.widen() - exact as f64 / 16_777_216.0).abs();
    let n = terms as f64;
    // |d + lo| ≤ 1 + ½ulp(sum)
    let rounded = 1.0 + SINGLE_UNIT * n;
    let why = "6 sigma of a walk of n roundings: of a term and the low part, of the low part";
    let walk = MOST_SIGMA * (n / 3.0).sqrt();
    Ok(vec![
        Check::at_most("compensated", walk * SINGLE_UNIT * rounded, off(pair), "", why),
        Check::at_most("two-float", walk * SINGLE_UNIT * SINGLE_UNIT * n, off(whole.0), "", why),
    ])
}
