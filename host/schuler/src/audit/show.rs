//! The result of an audit, in words and tables.

use super::compare::{Growth, Parting};
use super::difference::Difference;
use super::functions;
use super::golden::{Verdict, digest};
use super::heads::Contradiction;
use super::page::Table;
use super::pair::{Common, Partly, Shorter};
use super::record::Named;
use super::sensitivity::Effect;
use super::tolerance::FieldVerdict;
use super::verdict;
use schuler_report::axis::printed;
use schuler_simulator::number::Quantity;
use schuler_simulator::scene::Scene;
use serde::Serialize;

/// Two chains compared.
#[derive(Clone, Debug, Serialize)]
pub struct Compared {
    /// Their name.
    pub chain: String,
    /// What their heads say against each other.
    pub heads: Vec<Contradiction>,
    /// What both hold.
    pub held: Common,
    /// Where they part.
    pub parting: Option<Parting>,
    /// The verdict on every field, where limits are given.
    pub fields: Option<Vec<FieldVerdict>>,
}

impl Compared {
    /// Whether they are further apart than they may be.
    pub fn fails(&self) -> bool {
        match &self.fields {
            Some(fields) => fields.iter().any(|field| field.beyond > 0),
            None => self.parting.is_some(),
        }
    }
}

/// What heads say against each other, before anything else.
pub fn heads(heads: &[Contradiction]) -> String {
    let each = heads.iter().map(|Contradiction { key, values: [a, b] }| {
        format!("{key} is {a} in the one, {b} in the other")
    });
    let all: Vec<_> = each.collect();
    if all.is_empty() {
        String::new()
    } else {
        format!("the heads contradict each other: {}\n", all.join("; "))
    }
}

/// The digests of what was recorded.
pub fn recorded(scene: &str, chains: &[Named]) -> Table {
    let mut table = Table::new(scene, &["chain", "digest"]);
    table.rows.extend(chains.iter().map(|(stem, chain)| vec![stem.clone(), digest(chain)]));
    table
}

/// What became of libm's functions, and what it means where one differs.
pub fn functions(verdicts: Option<&[functions::Verdict]>) -> String {
    let version = env!("SCHULER_LIBM_VERSION");
    let Some(verdicts) = verdicts else {
        return format!("no {}: libm's functions are not compared\n", functions::FILE);
    };
    let mut text = String::new();
    for verdict in verdicts.iter().filter(|verdict| !verdict.holds()) {
        let functions::Verdict { function, stored, computed } = verdict;
        text += &format!("{function:48} {stored}  DIFFERS: {computed}\n");
    }
    if text.is_empty() {
        return format!("{} functions of libm {version}, the same bits\n", verdicts.len());
    }
    text + &format!(
        "libm {version} of this build has other bits than the golden chains' in these functions. What \
         calls them parts\nfor that alone: the golden bits take libm as Cargo.lock has it\n"
    )
}

/// A line for a golden chain, and where the flight parts from it.
pub fn verdict(verdict: &Verdict) -> String {
    let Verdict { chain, digest, parting, .. } = verdict;
    match parting {
        None => format!("equal  {chain:48} {digest}\n"),
        Some(parting) => format!("PARTS  {chain:48} {digest}\n{}", part(parting, None)),
    }
}

/// The same for a page: what parts comes first, with how the difference grows.
pub fn verdicts(verdicts: &[Verdict]) -> Vec<Table> {
    let mut table = Table::new("Flown again", &["chain", "golden digest", "verdict"]);
    let (bad, good): (Vec<_>, Vec<_>) = verdicts.iter().partition(|v| v.parting.is_some());
    table.marked = bad.len();
    let mut tables = Vec::new();
    for Verdict { chain, digest, held, parting } in bad.into_iter().chain(good) {
        let verdict = parting.as_ref().map_or_else(|| same(held), |p| format!("✗ {}", place(p)));
        table.rows.push(vec![chain.clone(), digest.clone(), verdict]);
        tables.extend(parting.as_ref().map(|parting| grown(chain, parting)));
    }
    tables.insert(0, table);
    tables
}

/// How many chains part, and what the others have in common.
pub fn verified(verdicts: &[Verdict], failed: usize) -> String {
    let equal = || verdicts.iter().filter(|verdict| verdict.parting.is_none());
    let rows: u64 = equal().map(|verdict| verdict.held.rows as u64).sum();
    let digests: u64 = equal().map(|verdict| verdict.held.digests as u64).sum();
    format!(
        "{} chains, {failed} of them part; the same bits in {rows} rows and {digests} digests\n",
        verdicts.len()
    )
}

/// How many of the chains are equal, for a page.
pub fn equal(chains: usize, parted: usize) -> (bool, String) {
    let text = match parted {
        0 => format!("all of {chains} equal"),
        _ => format!("{} of {chains} equal", chains - parted),
    };
    (parted == 0, text)
}

fn grown(chain: &str, parting: &Parting) -> Table {
    let mut table = growth(&parting.growth);
    table.title = format!("{chain}: {}", table.title);
    table
}

fn same(Common { rows, digests, .. }: &Common) -> String {
    format!("the same bits in {rows} rows and {digests} digests")
}

/// Two chains compared, in words.
pub fn compared(compared: &Compared, rate_hz: Option<&str>) -> String {
    let Compared { chain, held, parting, fields, .. } = compared;
    let mut text = match (parting, fields) {
        (None, None) => format!("{chain}: {}\n", same(held)),
        (_, Some(fields)) => {
            format!("{chain}: {}\n{}", verdict::near(fields), verdict::table(fields).text())
        }
        (Some(parting), None) => {
            let rate_hz = rate_hz.and_then(|text| text.parse().ok());
            format!("{chain}: part\n{}", part(parting, rate_hz))
        }
    };
    for remark in remarks(held) {
        text += &format!("  {remark}\n");
    }
    text
}

/// What is not compared, though a chain has it.
fn remarks(Common { partly, shorter, .. }: &Common) -> Vec<String> {
    let ends = shorter.iter().map(|Shorter { stage, samples: [least, most] }| {
        format!("stage {stage} ends at {least} of {most}")
    });
    let fields = partly.iter().map(|Partly { stage, fields, left_out }| {
        let fields = fields.join(", ");
        let why = match left_out.as_slice() {
            [] => "stand in another order".to_owned(),
            names => format!("are not all: only one chain has {}", names.join(", ")),
        };
        format!(
            "stage {stage} is compared in {fields}, by rows alone; no digest of it can be, as its \
             fields {why}"
        )
    });
    ends.chain(fields).collect()
}

/// The first parting of many.
pub fn first(found: &[Compared]) -> String {
    let order = ["trajectory", "increments", "noise", "body", "nav"];
    let rank = |p: &Parting| (p.sample, order.iter().position(|name| *name == p.stage));
    let partings = found.iter().filter_map(|c| Some((c, c.parting.as_ref()?)));
    match partings.min_by_key(|(_, parting)| rank(parting)) {
        Some((compared, parting)) => format!("first: {}, {}\n", compared.chain, place(parting)),
        None => format!("{} chains, all the same bits\n", found.len()),
    }
}

/// The same for a page.
pub fn partings(found: &[Compared]) -> Vec<Table> {
    let mut table = Table::new("Compared", &["chain", "rows", "digests", "verdict", "remarks"]);
    let mut tables = Vec::new();
    let (bad, good): (Vec<_>, Vec<_>) = found.iter().partition(|compared| compared.fails());
    table.marked = bad.len();
    for Compared { chain, heads: contradicting, held, parting, fields } in
        bad.into_iter().chain(good)
    {
        let verdict = match fields {
            Some(fields) => verdict::near(fields),
            None => parting.as_ref().map_or("the same bits".to_owned(), place),
        };
        let (rows, digests) = (held.rows.to_string(), held.digests.to_string());
        let contradicting = heads(contradicting).trim_end().to_owned();
        let first = (!contradicting.is_empty()).then_some(contradicting);
        let remarks = first.into_iter().chain(remarks(held)).collect::<Vec<_>>().join("; ");
        table.rows.push(vec![chain.clone(), rows, digests, verdict, remarks]);
        tables.extend(parting.as_ref().map(|parting| grown(chain, parting)));
        tables.extend(fields.as_ref().map(|fields| {
            let mut table = verdict::table(fields);
            table.title = format!("{chain}: {}", table.title);
            table
        }));
    }
    tables.insert(0, table);
    tables
}

/// Where they part, in a line.
fn place(parting: &Parting) -> String {
    let Parting { stage, alike, sample, field, .. } = parting;
    match field {
        Some(Difference { field, ulps, .. }) => {
            format!("sample {sample}, stage {stage}, field {field}: {ulps} ulp")
        }
        None if alike == sample => {
            format!(
                "stage {stage}, the digest of sample {sample} alone: every row up to it is the same"
            )
        }
        None => format!("stage {stage}, after sample {alike} and by sample {sample}"),
    }
}

fn part(parting: &Parting, rate_hz: Option<f64>) -> String {
    let time = rate_hz.map(|rate| format!(" ({} s)", parting.sample as f64 / rate));
    let mut text = format!("  {}{}\n", place(parting), time.unwrap_or_default());
    if let Some(Difference { decimal: [a, b], bits: [x, y], .. }) = &parting.field {
        text += &format!("    the one    {a:<24} {x}\n    the other  {b:<24} {y}\n");
    }
    if !parting.growth.is_empty() {
        for line in growth(&parting.growth).text().lines() {
            text += &format!("    {line}\n");
        }
    }
    text
}

fn growth(growth: &[Growth]) -> Table {
    let heads = ["stage", "sample", "field", "ulps", "the one", "the other less the one"];
    let mut table = Table::new("how the difference grows (the worst field)", &heads);
    for Growth { stage, sample, worst } in growth {
        let Difference { field, decimal: [a, _], difference, ulps, .. } = worst;
        table.rows.push(vec![
            stage.clone(),
            sample.to_string(),
            field.clone(),
            ulps.to_string(),
            a.clone(),
            format!("{difference:.3e}"),
        ]);
    }
    table
}

/// What one unit in the last place does: a table for each time.
pub fn sensitivity(scene: &Scene, effects: &[Effect]) -> Vec<Table> {
    let precision = scene.navigator.precision.name();
    let quantities = [Quantity::Position, Quantity::Velocity, Quantity::Attitude];
    let heads = ["input", "its ulp", "position", "velocity", "attitude"];
    let times = effects.first().map_or(0, |effect| effect.after.len());
    let table = |i: usize| {
        let time_s = effects.first().and_then(|e| e.after.get(i)).map_or(0.0, |m| m.time_s);
        let title = format!("{}, {precision}: moved after {time_s} s by one ulp of", scene.name);
        let mut table = Table::new(&title, &heads);
        let mut worst = [0.0; 3];
        let mut row = |input: &str, ulp: String, norms: [f64; 3]| {
            let mut row = vec![input.to_owned(), ulp];
            row.extend(quantities.iter().zip(norms).map(|(q, x)| printed(&q.show(x))));
            table.rows.push(row);
        };
        for effect in effects {
            let Some(moved) = effect.after.get(i) else { continue };
            let norms = moved.norms();
            worst = std::array::from_fn(|k| f64::max(worst[k], norms[k]));
            row(&effect.input, format!("{:.1e}", effect.ulp), norms);
        }
        row("the most: digits below mean nothing", String::new(), worst);
        table
    };
    (0..times).map(table).collect()
}
