//! Age: states stored after a long run, and sums of very many terms.

use super::case::{Case, Check, Outcome};
use super::floor::{SINGLE_UNIT, UNIT};
use super::flown::built_in;
use schuler::flight::configuration::Configuration;
use schuler::flight::plan;
use schuler::link::gap::Policy;
use schuler::math::compensated::{Accumulate as _, Pair, Plain, TwoFloat};
use schuler_simulator::progress::CaseProgress;
use schuler_simulator::rounding::split_mix::word;
use schuler_simulator::source::Source;
use schuler_simulator::twin::{Beginning, Twin};

const GROUP: &str = "aged";

/// The group's cases.
pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for (days, long) in [(0.25, false), (10.0, true)] {
        for (what, configuration) in [
            ("local-level f64", "f64 local-level taylor 2,4,2"),
            ("earth-fixed f64", "f64 earth-fixed taylor 2,4,2"),
            ("local-level f32x2", "f32x2 local-level taylor 0,4,0"),
            ("earth-fixed f32x2", "f32x2 earth-fixed taylor 0,4,0"),
            ("textbook f64", "f64 local-level textbook"),
        ] {
            let name = format!("stored after {days} d, {what}");
            let case = Case::new(GROUP, name, move |p| stored(days, configuration, p));
            cases.push(if long { case.long() } else { case });
        }
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
fn stored(days: f64, configuration: &str, progress: &CaseProgress) -> Outcome {
    const AFTER: u64 = 10_000;
    let configuration: Configuration = configuration.parse().map_err(told)?;
    let scene = built_in("sea-state", |scene| scene.duration_s = days * 86400.0)?;
    let source = Source::new(&scene, false).map_err(told)?;
    let before = scene.samples() + 1;
    // The swell repeats itself by and by; a hundred seconds of it, over and over, age as well.
    let cycle: Vec<_> = (1..=5000).map(|n| source.perfect_sample(n)).collect();
    let interval_s = Pair::new(scene.rate_hz).reciprocal();
    let (order, initial) = (plan::HIGHEST_ORDER, source.initial(0));
    let start = Beginning::new(configuration, order, Policy::Refuse, interval_s, &initial);
    let mut original = Twin::start(&start).map_err(told)?;
    let level = original.vertical(0.0, 0.0);
    let mut samples = (1..).zip(cycle.iter().cycle());
    for (n, sample) in samples.by_ref().take(before as usize) {
        let sample = original.narrow(sample);
        // The vertical channel is held, as no flight of days is possible otherwise.
        if n % 4 == 0 {
            original.hold(&level).map_err(told)?;
        }
        original.take_unread(n, &sample).map_err(|why| format!("sample {n}: {why}"))?;
        progress.reach(n.into(), before);
    }
    let words = original.words();
    let mut copy = Twin::start(&start).map_err(told)?;
    copy.restore(&words).map_err(told)?;
    let mut differing = count(&copy.words(), &words);
    for (n, sample) in samples.take(AFTER as usize) {
        let sample = original.narrow(sample);
        for flight in [&mut original, &mut copy] {
            flight.take_unread(n, &sample).map_err(told)?;
        }
        differing += count(&copy.words(), &original.words());
    }
    let why = "a state read back from its words goes on bit for bit";
    Ok(vec![Check::never("words that differ", differing, why)])
}

fn told(error: impl ToString) -> String {
    error.to_string()
}

/// How many of the words differ.
fn count(a: &[u8], b: &[u8]) -> u64 {
    let (a, b) = (a.as_chunks::<8>().0, b.as_chunks::<8>().0);
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
