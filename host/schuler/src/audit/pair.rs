//! Two chains side by side: the stages that both have, in the fields that both have.

use super::chain::{Chain, Checkpoint, Row, Stage};
use schuler_simulator::input::{Complaint, InputError};
use schuler_simulator::scene::Axes;
use serde::Serialize;
use std::borrow::Cow;

/// A stage of two chains, with the same fields in both.
#[derive(Clone, Debug)]
pub struct Pair<'a> {
    /// The first chain's.
    pub a: Cow<'a, Stage>,
    /// The second chain's.
    pub b: Cow<'a, Stage>,
    /// What their words belong to, where a chain says so.
    pub frame: Option<Axes>,
    /// The sample up to which a chain says that it keeps every row.
    pub complete: u64,
}

/// What two chains have in common to be compared.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Common {
    /// Rows.
    pub rows: usize,
    /// Digests.
    pub digests: usize,
    /// Stages that one chain has other fields of.
    pub partly: Vec<Partly>,
    /// Stages that end earlier in one chain.
    pub shorter: Vec<Shorter>,
}

/// A stage of which only some fields are compared, and no digest.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Partly {
    /// The stage.
    pub stage: String,
    /// The fields that both chains have.
    pub fields: Vec<String>,
    /// The fields that only one has.
    pub left_out: Vec<String>,
}

/// A stage that one chain has less of.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Shorter {
    /// The stage.
    pub stage: String,
    /// Samples behind its last row or digest, in the shorter chain and in the longer.
    pub samples: [u64; 2],
}

/// The stages that two chains share and what these have in common; an error, about the second chain's
/// file, if that is nothing.
pub fn pairs<'a>(
    a: &'a Chain,
    b: &'a Chain,
    file_b: &str,
) -> Result<(Vec<Pair<'a>>, Common), InputError> {
    let bad =
        |what: &str, accepted: &str| Err(InputError::file(file_b, Complaint::new(what, accepted)));
    let frame = a.frame().or(b.frame());
    let complete = |chain: &Chain| chain.get("rows").and_then(|text| text.parse().ok());
    let complete = complete(a).max(complete(b)).unwrap_or(0);
    let (mut pairs, mut held) = (Vec::new(), Common::default());
    for stage in &a.stages {
        let Some(other) = b.stages.iter().find(|other| other.name == stage.name) else { continue };
        let (one, two) = if (stage.width, &stage.fields) == (other.width, &other.fields) {
            (Cow::Borrowed(stage), Cow::Borrowed(other))
        } else {
            let partly =
                partly(stage, other).map_err(|complaint| InputError::file(file_b, complaint))?;
            let narrowed = [narrow(stage, &partly.fields), narrow(other, &partly.fields)];
            held.partly.push(partly);
            let [one, two] = narrowed.map(Cow::Owned);
            (one, two)
        };
        held.rows += common(&one.rows, &two.rows, |row| row.sample).count();
        held.digests += common(&one.digests(), &two.digests(), |c| c.sample).count();
        let (last, others) = (stage.last(), other.last());
        if last != others {
            let samples = [last.min(others), last.max(others)];
            held.shorter.push(Shorter { stage: stage.name.clone(), samples });
        }
        pairs.push(Pair { a: one, b: two, frame, complete });
    }
    if pairs.is_empty() {
        let names: Vec<_> = a.stages.iter().map(|stage| stage.name.as_str()).collect();
        return bad("has no stage of the first chain", &names.join(", "));
    }
    if (held.rows, held.digests) == (0, 0) {
        let accepted = match held.partly.as_slice() {
            [] => "a row, checkpoint or end at a sample where the first chain has one",
            _ => {
                "a row at a sample where the first chain has one; a digest of a stage with all the \
                 first chain's fields"
            }
        };
        return bad("has nothing to compare with the first chain", accepted);
    }
    Ok((pairs, held))
}

/// Which fields two stages share, or why they cannot be compared.
fn partly(a: &Stage, b: &Stage) -> Result<Partly, Complaint> {
    let name = &a.name;
    if a.width != b.width {
        let what = format!("its stage {name} is of {}", b.width.name());
        return Err(Complaint::new(what, format!("stage: {}", a.line())));
    }
    let count = |stage: &Stage, field: &String| stage.fields.iter().filter(|f| *f == field).count();
    let (mut fields, mut left_out) = (Vec::new(), Vec::new());
    for field in a.fields.iter().chain(&b.fields) {
        if fields.contains(field) || left_out.contains(field) {
            continue;
        }
        match (count(a, field), count(b, field)) {
            (0, _) | (_, 0) => left_out.push(field.clone()),
            (n, m) if n == m => fields.push(field.clone()),
            (n, m) => {
                let what = format!("its stage {name} has {field} ×{m}");
                return Err(Complaint::new(what, format!("{field} ×{n}, as the first chain has")));
            }
        }
    }
    if fields.is_empty() {
        let what = format!("its stage {name} has no field of the first chain's");
        return Err(Complaint::new(what, format!("fields of stage: {}", a.line())));
    }
    Ok(Partly { stage: name.clone(), fields, left_out })
}

/// A stage's rows in some of its fields, in the order given; digests, which are of all, are left out.
fn narrow(stage: &Stage, fields: &[String]) -> Stage {
    let of = |field: &'_ String| {
        let each = stage.fields.iter().enumerate();
        each.filter(|(_, own)| *own == field).map(|(word, _)| word).collect::<Vec<_>>()
    };
    let chosen: Vec<usize> = fields.iter().flat_map(of).collect();
    let mut narrow = Stage::new(&stage.name, stage.width);
    narrow.fields = chosen.iter().map(|&word| stage.fields[word].clone()).collect();
    let row = |row: &Row| Row {
        sample: row.sample,
        words: chosen.iter().map(|&word| row.words[word]).collect(),
    };
    narrow.rows = stage.rows.iter().map(row).collect();
    narrow
}

impl Pair<'_> {
    /// The rows that both have.
    pub fn rows(&self) -> impl Iterator<Item = (&Row, &Row)> {
        common(&self.a.rows, &self.b.rows, |row| row.sample)
    }

    /// The digests that both have.
    pub fn digests(&self) -> Vec<(Checkpoint, Checkpoint)> {
        let (a, b) = (self.a.digests(), self.b.digests());
        common(&a, &b, |c| c.sample).map(|(one, other)| (*one, *other)).collect()
    }
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
