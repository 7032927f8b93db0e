//! Heads of two chains that contradict each other: then not the ports differ, but what they were given.

use super::chain::Chain;
use serde::Serialize;

/// What decides about every row, in the order in which it explains a difference.
const KEYS: [&str; 5] = ["scene", "seed", "rate_hz", "initial", "configuration"];

/// A key that two heads say different things under.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Contradiction {
    /// The key.
    pub key: String,
    /// What each chain says.
    pub values: [String; 2],
}

/// The contradictions of two heads. What only one of them says contradicts nothing.
pub fn contradictions(a: &Chain, b: &Chain) -> Vec<Contradiction> {
    let of = |&key: &&str| {
        let [one, other] = [a.get(key)?.trim(), b.get(key)?.trim()];
        let number = |text: &str| text.parse::<f64>().ok();
        // 20 and 20.0 are one rate.
        let same = one == other || number(one).is_some_and(|x| number(other) == Some(x));
        let values = [one.to_owned(), other.to_owned()];
        (!same).then(|| Contradiction { key: key.to_owned(), values })
    };
    KEYS.iter().filter_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chain(head: &str) -> Chain {
        Chain::parse("", &format!("schuler chain 1\n{head}stage: nav f64 v\n\n")).unwrap()
    }

    #[test]
    fn only_what_both_say_can_contradict() {
        let golden = chain("scene: paper\nrate_hz: 20\nseed: 1\nduration_s: 60\n");
        assert_eq!(contradictions(&golden, &chain("")), []);
        assert_eq!(contradictions(&golden, &chain("rate_hz: 20.0\nduration_s: 3\n")), []);
        let found = contradictions(&golden, &chain("seed: 2\nrate_hz: 50\nscene: paper\n"));
        let found: Vec<_> = found.iter().map(|c| (c.key.as_str(), c.values[1].as_str())).collect();
        assert_eq!(found, [("seed", "2"), ("rate_hz", "50")]);
    }
}
