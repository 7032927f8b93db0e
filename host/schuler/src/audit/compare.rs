//! The first difference of two chains: sample, stage and field, and how the difference grows.

use super::chain::Chain;
use super::difference::{Difference, between};
use super::pair::{Common, Pair, pairs};
use schuler_simulator::input::InputError;
use serde::Serialize;

/// Rows at most that the growth of a difference is shown at.
const SHOWN: usize = 8;

/// Where two chains part.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Parting {
    /// The stage that parts first.
    pub stage: String,
    /// Samples up to which it is alike: to a checkpoint, or by rows of which none is left out.
    pub alike: u64,
    /// The first sample at which it differs, or at which that is seen.
    pub sample: u64,
    /// The first field that differs; absent where only a digest tells.
    pub field: Option<Difference>,
    /// The largest difference in later rows.
    pub growth: Vec<Growth>,
}

/// How far a stage has come apart.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Growth {
    /// The stage.
    pub stage: String,
    /// Samples behind it.
    pub sample: u64,
    /// The field that differs most in units of the last place.
    pub worst: Difference,
}

/// Where two chains part; `None` if they agree in everything that both hold. What that is, too.
pub fn compare(
    a: &Chain,
    b: &Chain,
    file_b: &str,
) -> Result<(Common, Option<Parting>), InputError> {
    let (pairs, held) = pairs(a, b, file_b)?;
    let partings = pairs.iter().filter_map(parting);
    // Data flows in the order of the stages: of those that part at one sample the first is the cause.
    let Some(mut first) = partings.min_by_key(|parting| parting.sample) else {
        return Ok((held, None));
    };
    first.growth = growth(&pairs, first.sample);
    Ok((held, Some(first)))
}

fn parting(pair: &Pair) -> Option<Parting> {
    let unequal = pair.rows().find(|(row, other)| row.words != other.words);
    let row = unequal.map_or(u64::MAX, |(row, _)| row.sample);
    let digests = pair.digests();
    let earlier: Vec<_> = digests.iter().filter(|(digest, _)| digest.sample < row).collect();
    let agree = earlier.iter().take_while(|(digest, other)| digest == other).count();
    let (sample, field) = match earlier.get(agree) {
        Some((digest, _)) => (digest.sample, None),
        None => {
            let (row, other) = unequal?;
            let mut words = row.words.iter().zip(&other.words).enumerate();
            let differs = words.find(|(_, (x, y))| x != y);
            let field = differs.map(|(i, (&x, &y))| between(&pair.a, pair.frame, i, x, y));
            (row.sample, field)
        }
    };
    // A row that is the same later on proves nothing: without feedback a stage forgets.
    let rows = pair.a.rows.iter().zip(&pair.b.rows);
    let unbroken = rows
        .take_while(|(row, other)| row == other && row.sample <= pair.complete.min(sample))
        .last()
        .map_or(0, |(row, _)| row.sample);
    let checkpoint = agree.checked_sub(1).and_then(|last| earlier.get(last));
    let alike = checkpoint.map_or(0, |(digest, _)| digest.sample).max(unbroken);
    Some(Parting { stage: pair.a.name.clone(), alike, sample, field, growth: Vec::new() })
}

/// How the difference grows: at samples from the parting on, each about twice as far behind it.
fn growth(pairs: &[Pair], parting: u64) -> Vec<Growth> {
    let mut shown = Vec::new();
    for pair in pairs {
        let rows: Vec<_> = pair
            .rows()
            .filter(|(row, other)| row.sample >= parting && row.words != other.words)
            .collect();
        let mut due = 0;
        let mut kept = Vec::new();
        for (i, (row, other)) in rows.iter().enumerate() {
            let since = row.sample - parting;
            if since >= due || i + 1 == rows.len() {
                let each = row.words.iter().zip(&other.words).enumerate();
                let worst = each
                    .map(|(word, (&x, &y))| between(&pair.a, pair.frame, word, x, y))
                    .max_by_key(|difference| difference.ulps);
                kept.extend(worst.map(|worst| Growth {
                    stage: pair.a.name.clone(),
                    sample: row.sample,
                    worst,
                }));
                due = (2 * since).max(1);
            }
        }
        // The first says where it began, the last where it came to.
        if kept.len() > SHOWN {
            kept.drain(1..kept.len() + 1 - SHOWN);
        }
        shown.extend(kept);
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::super::pair::{Partly, Shorter};
    use super::*;

    fn chain(rows: &[(u64, u64)], checkpoints: &[(u64, u64)]) -> Chain {
        let mut text =
            "schuler chain 1\nrows: 3\nstage: body f64 u\nstage: nav f64 v\n\n".to_owned();
        for stage in ["body", "nav"] {
            for (sample, bits) in rows {
                text += &format!("{stage} {sample} {bits:016x}\n");
            }
            for (sample, digest) in checkpoints {
                text += &format!("{stage} # {sample} {digest:016x}\n");
            }
        }
        Chain::parse("", &text).unwrap()
    }

    fn text(stage: &str, rows: &str) -> Chain {
        Chain::parse("", &format!("schuler chain 1\nstage: nav f32 {stage}\n\n{rows}")).unwrap()
    }

    fn held(rows: usize, digests: usize) -> Common {
        Common { rows, digests, ..Common::default() }
    }

    #[test]
    fn finds_the_first_row_and_the_first_stage() {
        let a = chain(&[(1, 5), (2, 6), (3, 7)], &[]);
        let mut b = a.clone();
        assert_eq!(compare(&a, &b, ""), Ok((held(6, 0), None)));
        b.stages[1].rows[1].words = vec![9];
        b.stages[0].rows[2].words = vec![1];
        let parting = compare(&a, &b, "").unwrap().1.unwrap();
        assert_eq!((parting.stage.as_str(), parting.alike, parting.sample), ("nav", 1, 2));
        let field = parting.field.unwrap();
        assert_eq!((field.field.as_str(), field.ulps), ("v", 3));
        assert_eq!(parting.growth.len(), 2);
        b.stages[0].rows[1].words = vec![9];
        assert_eq!(compare(&a, &b, "").unwrap().1.unwrap().stage, "body");
    }

    /// From where to where they part, where only a digest tells.
    fn seen(a: &Chain, b: &Chain) -> (u64, u64) {
        let parting = compare(a, b, "").unwrap().1.unwrap();
        assert_eq!(parting.field, None);
        (parting.alike, parting.sample)
    }

    #[test]
    fn a_digest_tells_where_rows_are_left_out() {
        let a =
            chain(&[(1, 5), (2, 5), (4, 5), (7, 5), (8, 5), (12, 5)], &[(4, 1), (8, 2), (12, 3)]);
        let mut b = a.clone();
        b.stages[1].checkpoints[1].digest = 7;
        b.stages[1].checkpoints[2].digest = 8;
        // Not 7, whose row is the same.
        assert_eq!(seen(&a, &b), (4, 8));
        // Every row up to 3 is kept, as the head says: they prove what no checkpoint does.
        b.stages[1].checkpoints[0].digest = 9;
        assert_eq!(seen(&a, &b), (2, 4));
        b.stages[1].rows.remove(0);
        assert_eq!(seen(&a, &b), (0, 4));
        // Every row is the same, so the digest is made in another way.
        let a = chain(&[(1, 5), (2, 5), (3, 5)], &[(2, 1)]);
        let b = chain(&[(1, 5), (2, 5), (3, 5)], &[(2, 2)]);
        assert_eq!(seen(&a, &b), (2, 2));
    }

    #[test]
    fn ends_are_compared_where_they_are_at_one_sample() {
        let rows = "nav 1 00000001\nnav # 4 00000000000000aa\n";
        let long = text("v", &format!("{rows}nav = 8 00000000000000bb\n"));
        let short = text("v", "nav 1 00000001\nnav = 4 00000000000000aa\n");
        let shorter = |a, b| vec![Shorter { stage: "nav".into(), samples: [a, b] }];
        let common = Common { shorter: shorter(4, 8), ..held(1, 1) };
        assert_eq!(compare(&long, &short, ""), Ok((common.clone(), None)));
        assert_eq!(compare(&short, &long, ""), Ok((common, None)));
        let other = text("v", "nav = 4 00000000000000ab\n");
        assert_eq!(seen(&long, &other), (0, 4));
        // A checkpoint at the end is no second digest.
        let twice = text("v", "nav # 4 00000000000000aa\nnav = 4 00000000000000aa\n");
        assert_eq!(compare(&twice, &twice, ""), Ok((held(0, 1), None)));
        let later = text("v", &format!("{rows}nav = 9 00000000000000cc\n"));
        let common = Common { shorter: shorter(8, 9), ..held(1, 1) };
        assert_eq!(compare(&long, &later, ""), Ok((common, None)));
    }

    #[test]
    fn fields_that_one_lacks_are_left_out() {
        let rest = "nav # 1 00000000000000aa\nnav = 2 00000000000000bb\n";
        let a = text(
            "p p q v v",
            &format!("nav 1 00000001 00000002 00000003 00000004 00000005\n{rest}"),
        );
        let names = |names: &[&str]| names.iter().map(|name| name.to_string()).collect();
        let b = text(
            "v v p p w",
            &format!("nav 1 00000004 00000005 00000001 00000002 00000009\n{rest}"),
        );
        let partly =
            |left_out| Partly { stage: "nav".into(), fields: names(&["p", "v"]), left_out };
        let common = Common { partly: vec![partly(names(&["q", "w"]))], ..held(1, 0) };
        assert_eq!(compare(&a, &b, ""), Ok((common, None)));
        let b = text("v v p p", "nav 1 00000004 00000006 00000001 00000002\n");
        let (common, parting) = compare(&a, &b, "").unwrap();
        assert_eq!(common.partly, [partly(names(&["q"]))]);
        let field = parting.unwrap().field.unwrap();
        assert_eq!((field.field.as_str(), field.ulps), ("v lo", 1));
        // The same fields in another order: no digest is the same.
        let b = text(
            "q p p v v",
            "nav 1 00000003 00000001 00000002 00000004 00000005\nnav # 1 0000000000000001\n",
        );
        let (common, parting) = compare(&a, &b, "").unwrap();
        assert_eq!((common.rows, common.digests, parting), (1, 0, None));
        assert_eq!(common.partly[0].left_out, Vec::<String>::new());
    }

    #[test]
    fn chains_of_other_things_are_not_compared() {
        let a = text("p p v", "nav 1 00000001 00000002 00000003\nnav = 2 00000000000000bb\n");
        let refused = |b: &Chain| compare(&a, b, "b").unwrap_err().to_string();
        let nav = |stage: &str, rows: &str| refused(&text(stage, rows));
        assert!(
            nav("w", "").contains(
                "no field of the first chain's; accepted: fields of stage: nav f32 p p v"
            )
        );
        assert!(nav("p v", "").contains("has p ×1; accepted: p ×2"));
        assert!(nav("p p v", "nav 2 00000001 00000002 00000003\n").contains("nothing to compare"));
        let error = nav("v", "nav = 2 00000000000000bb\n");
        assert!(error.contains("a digest of a stage with all the first chain's fields"), "{error}");
        assert!(refused(&chain(&[], &[])).contains("is of f64"));
        let mut b = a.clone();
        b.stages.clear();
        assert!(refused(&b).contains("has no stage of the first chain; accepted: nav"));
    }
}
