//! States of single runs joined in lanes and split again, by the list of fields that storage and digests use.

use super::pack::LANE;
use schuler::record::Record;
use std::ops::Range;
use std::vec::IntoIter;

/// Whose a field of lanes is: every count is of all runs, and lanes follow one another.
struct Turns(usize);

impl Turns {
    fn whose<const N: usize>(&mut self, name: &str) -> Range<usize> {
        if name != LANE {
            return 0..N;
        }
        let run = self.0 % N;
        self.0 += 1;
        run..run + 1
    }

    /// The word of a field in lanes, from the words of every run.
    fn joined<const N: usize>(&mut self, name: &str, runs: &mut [IntoIter<u64>], word: u64) -> u64 {
        let whose = &mut runs[self.whose::<N>(name)];
        whose.iter_mut().filter_map(Iterator::next).last().unwrap_or(word)
    }
}

/// What a state with room for samples of any length keeps, and lanes do not: every sample lasts the nominal
/// interval.
const KEPT: [&str; 3] = ["interval_excess", "interval_rest", "history_time"];

/// States of single runs into lanes.
pub fn join<const N: usize>(together: &mut impl Record, apart: &[impl Record; N]) {
    let mut runs: Vec<_> = apart.iter().map(|state| words(state).into_iter()).collect();
    let mut turns = Turns(0);
    together.restore("", &mut |name, word| turns.joined::<N>(name, &mut runs, word));
}

/// Lanes into states of single runs.
pub fn split<const N: usize>(together: &impl Record, apart: &mut [impl Record; N]) {
    let mut runs = vec![Vec::new(); N];
    let mut turns = Turns(0);
    together.record("", &mut |name, word| {
        runs[turns.whose::<N>(name)].iter_mut().for_each(|run| run.push(word));
    });
    for (state, words) in apart.iter_mut().zip(runs) {
        let mut words = words.into_iter();
        state.restore("", &mut |name, word| {
            if KEPT.contains(&name) { word } else { words.next().unwrap_or(word) }
        });
    }
}

/// Every field of a state that lanes have, too.
fn words(state: &impl Record) -> Vec<u64> {
    let mut words = Vec::new();
    state.record("", &mut |name, word| {
        if !KEPT.contains(&name) {
            words.push(word);
        }
    });
    words
}
