//! Where two chains part: the first sample, stage and field, and how the difference grows.

use super::chain::{Chain, Stage, Width};
use crate::input::{Complaint, InputError};
use serde::Serialize;

/// Rows at most that the growth of a difference is shown at.
const SHOWN: usize = 8;

/// Where two chains part.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Parting {
    /// The stage that parts first.
    pub stage: String,
    /// Samples up to which it is alike, as far as rows and checkpoints tell.
    pub alike: u64,
    /// The first sample at which it differs, or at which that is seen.
    pub sample: u64,
    /// The first field that differs; absent where only a digest tells.
    pub field: Option<Difference>,
    /// The largest difference in later rows.
    pub growth: Vec<Growth>,
}

/// Two values of a field.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// The field.
    pub field: String,
    /// Its value in each, with the digits that bring back its bits.
    pub decimal: [String; 2],
    /// The second value less the first.
    pub difference: f64,
    /// The bits of each.
    pub bits: [String; 2],
    /// How many numbers of the type lie between, and one.
    pub ulps: u64,
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

/// What two chains have in common to be compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Common {
    /// Rows.
    pub rows: usize,
    /// Digests.
    pub digests: usize,
}

/// Where two chains part; `None` if they agree in everything that both hold. What that is, too.
pub fn compare(
    a: &Chain,
    b: &Chain,
    file_b: &str,
) -> Result<(Common, Option<Parting>), InputError> {
    let mut pairs = Vec::new();
    for stage in &a.stages {
        let Some(other) = b.stages.iter().find(|other| other.name == stage.name) else { continue };
        if (stage.width, &stage.fields) != (other.width, &other.fields) {
            let fields = stage.fields.join(" ");
            let accepted = format!("stage: {} {} {fields}", stage.name, stage.width.name());
            let what = format!("its stage {} has other fields than the first chain's", stage.name);
            return Err(InputError::file(file_b, Complaint::new(what, accepted)));
        }
        pairs.push((stage, other));
    }
    if pairs.is_empty() {
        let names: Vec<_> = a.stages.iter().map(|stage| stage.name.as_str()).collect();
        let complaint = Complaint::new("has no stage of the first chain", names.join(", "));
        return Err(InputError::file(file_b, complaint));
    }
    let mut held = Common::default();
    for (stage, other) in &pairs {
        held.rows += common(&stage.rows, &other.rows, |row| row.sample).count();
        held.digests += common(&stage.checkpoints, &other.checkpoints, |c| c.sample).count();
        held.digests += usize::from(stage.end.is_some() && other.end.is_some());
    }
    if held == Common::default() {
        let accepted = "a row, checkpoint or end at a sample where the first chain has one";
        let complaint = Complaint::new("has nothing to compare with the first chain", accepted);
        return Err(InputError::file(file_b, complaint));
    }
    let partings = pairs.iter().filter_map(|(stage, other)| parting(stage, other));
    // Data flows in the order of the stages: of those that part at one sample the first is the cause.
    let Some(mut first) = partings.min_by_key(|parting| parting.sample) else {
        return Ok((held, None));
    };
    first.growth = growth(&pairs, first.sample);
    Ok((held, Some(first)))
}

fn parting(a: &Stage, b: &Stage) -> Option<Parting> {
    let mut alike = 0;
    let mut seen = None;
    for (row, other) in common(&a.rows, &b.rows, |row| row.sample) {
        if row.words != other.words {
            seen = Some((row.sample, difference(a, &row.words, &other.words)));
            break;
        }
        alike = row.sample;
    }
    let row = seen.as_ref().map_or(u64::MAX, |(row, _)| *row);
    let checkpoints = common(&a.checkpoints, &b.checkpoints, |c| c.sample);
    for (checkpoint, other) in checkpoints.chain(a.end.iter().zip(&b.end)) {
        let sample = checkpoint.sample.max(other.sample);
        if sample >= row {
            break;
        }
        if checkpoint != other {
            seen = Some((sample, None));
            break;
        }
        alike = alike.max(sample);
    }
    let (sample, field) = seen?;
    let alike = alike.min(sample.saturating_sub(1));
    Some(Parting { stage: a.name.clone(), alike, sample, field, growth: Vec::new() })
}

/// Pairs of items with the same sample.
fn common<'a, T>(
    a: &'a [T],
    b: &'a [T],
    sample: impl Fn(&T) -> u64 + Copy + 'a,
) -> impl Iterator<Item = (&'a T, &'a T)> {
    let mut rest = b;
    a.iter().filter_map(move |item| {
        let skip = rest.partition_point(|other| sample(other) < sample(item));
        rest = &rest[skip..];
        rest.first().filter(|other| sample(other) == sample(item)).map(|other| (item, other))
    })
}

/// The first word that differs.
fn difference(stage: &Stage, a: &[u64], b: &[u64]) -> Option<Difference> {
    let word = a.iter().zip(b).position(|(a, b)| a != b)?;
    Some(between(stage, word, a[word], b[word]))
}

fn between(stage: &Stage, word: usize, a: u64, b: u64) -> Difference {
    let value = |bits: u64| match stage.width {
        Width::Single => f64::from(f32::from_bits(bits as u32)),
        Width::Double => f64::from_bits(bits),
    };
    let decimal = |bits: u64| match stage.width {
        Width::Single => zmij::Buffer::new().format(f32::from_bits(bits as u32)).to_owned(),
        Width::Double => zmij::Buffer::new().format(f64::from_bits(bits)).to_owned(),
    };
    let hex = |bits: u64| match stage.width {
        Width::Single => format!("0x{bits:08x}"),
        Width::Double => format!("0x{bits:016x}"),
    };
    Difference {
        field: stage.label(word),
        decimal: [decimal(a), decimal(b)],
        difference: value(b) - value(a),
        bits: [hex(a), hex(b)],
        ulps: ulps(stage.width, a, b),
    }
}

/// How many numbers of a type one has to step over to come from one to the other; −0 and +0 are one
/// apart, so that no difference of bits counts as none.
pub fn ulps(width: Width, a: u64, b: u64) -> u64 {
    let sign = match width {
        Width::Single => 1 << 31,
        Width::Double => 1 << 63,
    };
    // In order of value: −0 is −1, +0 is 0.
    let ordered = |bits: u64| {
        let magnitude = i128::from(bits & (sign - 1));
        if bits & sign == 0 { magnitude } else { -magnitude - 1 }
    };
    u64::try_from((ordered(a) - ordered(b)).unsigned_abs()).unwrap_or(u64::MAX)
}

/// How the difference grows: at samples from the parting on, each about twice as far behind it.
fn growth(pairs: &[(&Stage, &Stage)], parting: u64) -> Vec<Growth> {
    let mut shown = Vec::new();
    for (a, b) in pairs {
        let rows: Vec<_> = common(&a.rows, &b.rows, |row| row.sample)
            .filter(|(row, other)| row.sample >= parting && row.words != other.words)
            .collect();
        let mut due = 0;
        let mut kept = Vec::new();
        for (i, (row, other)) in rows.iter().enumerate() {
            let since = row.sample - parting;
            if since >= due || i + 1 == rows.len() {
                let each = row.words.iter().zip(&other.words).enumerate();
                let worst = each
                    .map(|(word, (&x, &y))| between(a, word, x, y))
                    .max_by_key(|difference| difference.ulps);
                kept.extend(worst.map(|worst| Growth {
                    stage: a.name.clone(),
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
    use super::*;

    #[test]
    fn ulps_count_steps() {
        let of = |a: f64, b: f64| ulps(Width::Double, a.to_bits(), b.to_bits());
        assert_eq!(of(1.0, 1.0), 0);
        assert_eq!(of(1.0, 1.0f64.next_up()), 1);
        assert_eq!(of(1.0f64.next_down(), 1.0f64.next_up()), 2);
        assert_eq!(of(0.0, -0.0), 1);
        assert_eq!(of(f64::from_bits(1), -f64::from_bits(1)), 3);
        assert_eq!(of(f64::INFINITY, f64::NEG_INFINITY), 2 * f64::INFINITY.to_bits() + 1);
        let single = |a: f32, b: f32| ulps(Width::Single, a.to_bits().into(), b.to_bits().into());
        assert_eq!(single(-2.0, -2.0f32.next_down()), 1);
    }

    fn chain(rows: &[(u64, u64)], checkpoints: &[(u64, u64)]) -> Chain {
        let mut text = "schuler chain 1\nstage: body f64 u\nstage: nav f64 v\n\n".to_owned();
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

    #[test]
    fn finds_the_first_row_and_the_first_stage() {
        let a = chain(&[(1, 5), (2, 6), (3, 7)], &[]);
        let mut b = a.clone();
        assert_eq!(compare(&a, &b, ""), Ok((Common { rows: 6, digests: 0 }, None)));
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

    #[test]
    fn a_digest_tells_where_rows_are_left_out() {
        let a = chain(&[(1, 5)], &[(4, 1), (8, 2), (12, 3)]);
        let mut b = a.clone();
        b.stages[1].checkpoints[1].digest = 7;
        b.stages[1].checkpoints[2].digest = 8;
        let parting = compare(&a, &b, "").unwrap().1.unwrap();
        assert_eq!((parting.alike, parting.sample, parting.field), (4, 8, None));
    }

    #[test]
    fn chains_of_other_things_are_not_compared() {
        let a = chain(&[(1, 5)], &[]);
        let mut b = a.clone();
        b.stages[1].fields = vec!["w".into()];
        assert!(compare(&a, &b, "").is_err());
        b = chain(&[(2, 5)], &[]);
        assert!(compare(&a, &b, "").is_err());
        b.stages.clear();
        assert!(compare(&a, &b, "").is_err());
    }
}
