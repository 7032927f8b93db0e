//! How far two chains may be apart, field by field: for ports that cannot have the same bits.

use super::difference::{Difference, between};
use super::pair::Pair;
use schuler_simulator::input::{Complaint, InputError};
use serde::Serialize;

/// How far two values of a field may be apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    /// Steps from number to number of the type.
    Ulps(u64),
    /// In the field's unit.
    Within(f64),
}

/// A limit for one field, or for all that have none of their own.
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// The field, as the `stage` line names it.
    field: Option<String>,
    limit: Limit,
}

impl Rule {
    fn parse(
        text: &str,
        limit: impl Fn(&str) -> Option<Limit>,
        accepted: &str,
    ) -> Result<Self, Complaint> {
        let (field, number) = match text.rsplit_once('=') {
            Some((field, number)) => (Some(field.to_owned()), number),
            None => (None, text),
        };
        let limit = limit(number).filter(|_| field.as_deref() != Some(""));
        let limit = limit.ok_or_else(|| Complaint::new(format!("{text} is no limit"), accepted))?;
        Ok(Self { field, limit })
    }

    /// As `--ulps` gives it.
    pub fn ulps(text: &str) -> Result<Self, Complaint> {
        let limit = |number: &str| number.parse().ok().map(Limit::Ulps);
        Self::parse(text, limit, "N or FIELD=N, a whole number of units in the last place")
    }

    /// As `--within` gives it.
    pub fn within(text: &str) -> Result<Self, Complaint> {
        let limit = |number: &str| {
            let number = number.parse().ok().filter(|x: &f64| x.is_finite() && *x >= 0.0);
            number.map(Limit::Within)
        };
        Self::parse(text, limit, "M or FIELD=M, a number of the field's unit, 0 or more")
    }
}

/// A word of a stage: its worst difference, and whether it is near enough.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FieldVerdict {
    /// The stage.
    pub stage: String,
    /// The field, and which component of it.
    pub field: String,
    /// The limit.
    pub limit: String,
    /// Rows compared.
    pub rows: usize,
    /// Rows beyond the limit.
    pub beyond: usize,
    /// The first sample beyond it.
    pub first: Option<u64>,
    /// The sample with the worst difference; absent where all are the same.
    pub sample: Option<u64>,
    /// The worst difference.
    pub worst: Option<Difference>,
}

/// The verdict on every word that two chains have in common. An error where a rule names no field of them.
pub fn judge(
    pairs: &[Pair],
    rules: &[Rule],
    file_b: &str,
) -> Result<Vec<FieldVerdict>, InputError> {
    let mut fields: Vec<&str> =
        pairs.iter().flat_map(|p| p.a.fields.iter().map(String::as_str)).collect();
    fields.dedup();
    for Rule { field, .. } in rules {
        if let Some(name) = field.as_deref().filter(|name| !fields.contains(name)) {
            let what = format!("has no field {name} in common with the first chain");
            return Err(InputError::file(file_b, Complaint::new(what, fields.join(", "))));
        }
    }
    let words =
        pairs.iter().flat_map(|pair| (0..pair.a.fields.len()).map(move |word| (pair, word)));
    Ok(words
        .map(|(pair, word)| of_word(pair, word, &limits(rules, &pair.a.fields[word])))
        .collect())
}

/// The limits of a field: its own, or else those of all. One that holds is enough.
fn limits(rules: &[Rule], field: &str) -> Vec<Limit> {
    let of = |name: Option<&str>| -> Vec<Limit> {
        rules.iter().filter(|rule| rule.field.as_deref() == name).map(|rule| rule.limit).collect()
    };
    let own = of(Some(field));
    if own.is_empty() { of(None) } else { own }
}

fn of_word(pair: &Pair, word: usize, limits: &[Limit]) -> FieldVerdict {
    let mut verdict = FieldVerdict {
        stage: pair.a.name.clone(),
        field: pair.a.label(word, pair.frame),
        limit: text(limits),
        rows: 0,
        beyond: 0,
        first: None,
        sample: None,
        worst: None,
    };
    for (row, other) in pair.rows() {
        verdict.rows += 1;
        let (x, y) = (row.words[word], other.words[word]);
        if x == y {
            continue;
        }
        let difference = between(&pair.a, pair.frame, word, x, y);
        let holds = |limit: &Limit| match *limit {
            Limit::Ulps(most) => difference.ulps <= most,
            Limit::Within(most) => difference.difference.abs() <= most,
        };
        if !limits.iter().any(holds) {
            verdict.beyond += 1;
            verdict.first = verdict.first.or(Some(row.sample));
        }
        if verdict.worst.as_ref().is_none_or(|worst| is_worse(&difference, worst, limits)) {
            (verdict.worst, verdict.sample) = (Some(difference), Some(row.sample));
        }
    }
    verdict
}

/// Whether a difference is larger than another: by its value where a value is the limit, else by its steps. One that
/// is no number is the largest.
fn is_worse(a: &Difference, b: &Difference, limits: &[Limit]) -> bool {
    let by_value = matches!(limits, [Limit::Within(_), ..]);
    let size =
        |d: &Difference| if d.difference.is_nan() { f64::INFINITY } else { d.difference.abs() };
    if by_value { size(a) > size(b) } else { a.ulps > b.ulps }
}

fn text(limits: &[Limit]) -> String {
    let each = limits.iter().map(|limit| match limit {
        Limit::Ulps(most) => format!("{most} ulp"),
        Limit::Within(most) => format!("{most:e}"),
    });
    let all: Vec<_> = each.collect();
    if all.is_empty() { "the same bits".to_owned() } else { all.join(" or ") }
}

#[cfg(test)]
mod tests {
    use super::super::chain::Chain;
    use super::super::pair::pairs;
    use super::*;

    fn chain(rows: [[f64; 3]; 2]) -> Chain {
        let mut text = "schuler chain 1\nstage: nav f64 p v v\n\n".to_owned();
        for (sample, row) in (1..).zip(rows) {
            let words = row.map(|x| format!("{:016x}", x.to_bits())).join(" ");
            text += &format!("nav {sample} {words}\n");
        }
        Chain::parse("", &text).unwrap()
    }

    /// Rows beyond the limit, and the worst sample, of each word.
    fn judged(rules: &[Rule]) -> Vec<(usize, Option<u64>)> {
        let next = 1.0_f64.next_up();
        let (a, b) = (
            chain([[1.0; 3], [1.0; 3]]),
            chain([[next, 1.0, 1.5], [next.next_up(), 1.0, f64::NAN]]),
        );
        let (pairs, _) = pairs(&a, &b, "").unwrap();
        let judged = judge(&pairs, rules, "").unwrap();
        judged.iter().map(|verdict| (verdict.beyond, verdict.sample)).collect()
    }

    #[test]
    fn a_limit_is_kept_or_not_word_by_word() {
        assert_eq!(judged(&[]), [(2, Some(2)), (0, None), (2, Some(2))]);
        let ulps = |text| Rule::ulps(text).unwrap();
        let within = |text| Rule::within(text).unwrap();
        assert_eq!(judged(&[ulps("1")])[0], (1, Some(2)));
        assert_eq!(judged(&[ulps("2")])[0], (0, Some(2)));
        // Its own limit replaces that of all; of two one is enough; what is no number is beyond any.
        assert_eq!(judged(&[ulps("0"), within("p=1e-15")])[0].0, 0);
        assert_eq!(judged(&[within("v=0.5"), ulps("v=0")])[2], (1, Some(2)));
    }

    #[test]
    fn what_is_no_limit_is_refused() {
        for text in ["", "x", "=3", "p=", "-1", "1.5"] {
            assert!(Rule::ulps(text).is_err(), "{text}");
        }
        for text in ["", "nan", "inf", "-1e-9", "p=x"] {
            assert!(Rule::within(text).is_err(), "{text}");
        }
        let a = chain([[1.0; 3], [1.0; 3]]);
        let (pairs, _) = pairs(&a, &a, "b").unwrap();
        let error = judge(&pairs, &[Rule::ulps("q=1").unwrap()], "b").unwrap_err().to_string();
        assert!(
            error.contains("has no field q in common") && error.contains("accepted: p, v"),
            "{error}"
        );
    }
}
